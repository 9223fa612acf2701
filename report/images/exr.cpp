#include "report/images/exr.h"

#include "calc/base/elementary.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <stdexcept>
#include <vector>

namespace report {
namespace {

enum Channel : std::size_t { kValue, kLow, kHigh, kDirect, kIndirect, kValid, kChannels };

constexpr std::array<const char*, kChannels> kNames{"illuminance_lx", "low_lx",      "high_lx",
                                                    "direct_lx",      "indirect_lx", "valid"};

// OpenEXR writes where it is told: here into a string.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}

  void write(const char bytes[], int count) override {
    const auto length = static_cast<std::size_t>(count);
    if (bytes_.size() < place_ + length) bytes_.resize(place_ + length);
    bytes_.replace(place_, length, bytes, length);
    place_ += length;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t place_ = 0;
};

using Planes = std::array<std::vector<float>, kChannels>;

Planes channel_values(const PlanePart& plane) {
  const auto columns = static_cast<std::size_t>(plane.grid.columns);
  const auto rows = static_cast<std::size_t>(plane.grid.rows);
  Planes values;
  for (std::vector<float>& channel : values) channel.assign(columns * rows, 0.0F);
  for (const PointRow& point : plane.points) {
    const std::size_t at = (rows - 1 - static_cast<std::size_t>(point.row)) * columns +
                           static_cast<std::size_t>(point.column);
    values[kValue][at] = static_cast<float>(point.measured.value);
    values[kLow][at] = static_cast<float>(point.measured.low);
    values[kHigh][at] = static_cast<float>(point.measured.high);
    values[kDirect][at] = static_cast<float>(point.direct_lx);
    values[kIndirect][at] = static_cast<float>(point.indirect_lx);
    values[kValid][at] = 1.0F;
  }
  return values;
}

void write_picture(const Imf::Header& header, int columns, int rows,
                   std::span<const char* const> names, std::span<std::vector<float>> values,
                   Imf::OStream& stream) {
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < names.size(); ++c) {
    char* first = reinterpret_cast<char*>(values[c].data());
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, first, sizeof(float),
                                      sizeof(float) * static_cast<std::size_t>(columns)));
  }
  Imf::OutputFile file(stream, header, 0);
  file.setFrameBuffer(frame);
  file.writePixels(rows);
}

// [IEC 61966-2-1]
float linear_light(std::uint8_t component) {
  const double value = static_cast<double>(component) / 255.0;
  return static_cast<float>(value <= 0.04045 ? value / 12.92
                                             : calc::pow((value + 0.055) / 1.055, 2.4));
}

}  // namespace

std::string render_exr(const Provenance& provenance, const ProjectPart& project,
                       const SpacePart& space, const PlanePart& plane) {
  const int columns = plane.grid.columns, rows = plane.grid.rows;
  if (columns <= 0 || rows <= 0)
    throw std::runtime_error("cannot encode EXR: the plane has no cells");
  try {
    Imf::Header header(columns, rows);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : kNames) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const auto attribute = [&header](const char* name, std::string_view text) {
      header.insert(name, Imf::StringAttribute(printable(text)));
    };
    attribute("luxgate.project", project.path);
    attribute("luxgate.space", space.id);
    attribute("luxgate.plane", plane.id);
    attribute("luxgate.quantity", calc::quantity_name(plane.kernel, plane.derived));
    attribute("luxgate.unit", plane_unit(plane));
    attribute("luxgate.version", provenance.program_version);
    Planes values = channel_values(plane);
    MemoryStream stream;
    write_picture(header, columns, rows, kNames, values, stream);
    return stream.bytes();
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("cannot encode EXR: ") + error.what());
  }
}

std::string render_room_exr(const std::string& project_path, const std::string& space_id,
                            const std::string& title, int width, int height,
                            const std::vector<float>& lx) {
  constexpr std::array<const char*, 2> kRoomNames{kNames[kValue], kNames[kValid]};
  try {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : kRoomNames) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    header.insert("luxgate.project", Imf::StringAttribute(printable(project_path)));
    header.insert("luxgate.space", Imf::StringAttribute(printable(space_id)));
    header.insert("luxgate.picture", Imf::StringAttribute(printable(title)));
    header.insert("luxgate.unit", Imf::StringAttribute("lx"));
    std::array<std::vector<float>, 2> values{lx, std::vector<float>(lx.size(), 1.0F)};
    for (std::size_t i = 0; i < lx.size(); ++i) {
      if (!(lx[i] < 0.0F)) continue;
      values[0][i] = values[1][i] = 0.0F;
    }
    MemoryStream stream;
    write_picture(header, width, height, kRoomNames, values, stream);
    return stream.bytes();
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("cannot encode EXR: ") + error.what());
  }
}

std::string render_colour_exr(const std::string& project_path, const std::string& space_id,
                              const std::string& title, const Raster& raster) {
  constexpr std::array<const char*, 4> kColourNames{"R", "G", "B", "A"};
  try {
    Imf::Header header(raster.width, raster.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : kColourNames) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    header.insert("luxgate.project", Imf::StringAttribute(printable(project_path)));
    header.insert("luxgate.space", Imf::StringAttribute(printable(space_id)));
    header.insert("luxgate.picture", Imf::StringAttribute(printable(title)));
    std::array<std::vector<float>, 4> values;
    for (std::size_t i = 0; i < raster.rgba.size(); i += 4) {
      const float opacity = static_cast<float>(raster.rgba[i + 3]) / 255.0F;
      for (std::size_t c = 0; c < 3; ++c) {
        values[c].push_back(opacity * linear_light(raster.rgba[i + c]));
      }
      values[3].push_back(opacity);
    }
    MemoryStream stream;
    write_picture(header, raster.width, raster.height, kColourNames, values, stream);
    return stream.bytes();
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("cannot encode EXR: ") + error.what());
  }
}

}  // namespace report
