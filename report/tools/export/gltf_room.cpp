#include "report/tools/export/gltf_room.h"

#include "calc/base/elementary.h"
#include "gpu/raster/room_drawing.h"
#include "report/document/program_version.h"
#include "report/images/png.h"
#include "report/images/room_picture.h"
#include "report/text/plain_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace cli::gltf {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the format [glTF, 3.6, 3.7].
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;
constexpr int kLines = 1;
constexpr std::size_t kWord = 4;

// z up, y to the north becomes y up, z to the south.
glm::vec3 turned(const glm::vec3& p) { return {p.x, p.z, -p.y}; }

// What viewers multiply: light, where colours of pictures are numbers of sRGB [IEC 61966-2-1].
float linear(std::uint8_t value) {
  const double c = value / 255.0;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : calc::pow((c + 0.055) / 1.055, 2.4));
}

class GlbWriter {
 public:
  // bytes: a multiple of four is made of them.
  std::size_t add_view(std::string_view bytes, int target = 0) {
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + kWord - 1) / kWord * kWord, '\0');
    views_.push_back(std::move(view));
    return views_.size() - 1;
  }

  std::size_t add_floats(std::span<const float> values, std::size_t components,
                         bool has_bounds = false) {
    static constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    std::string bytes;
    for (const float value : values) append(bytes, std::bit_cast<std::uint32_t>(value));
    Json accessor = {{"bufferView", add_view(bytes, kVertices)},
                     {"componentType", kFloat},
                     {"count", values.size() / components},
                     {"type", kTypes[components - 1]}};
    if (has_bounds) {
      std::vector<double> low(components, std::numeric_limits<double>::max());
      std::vector<double> high(components, std::numeric_limits<double>::lowest());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = static_cast<double>(values[i]);
        low[i % components] = std::min(low[i % components], value);
        high[i % components] = std::max(high[i % components], value);
      }
      accessor["min"] = low;
      accessor["max"] = high;
    }
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }

  std::size_t add_places(std::span<const glm::vec3> places_m) {
    std::vector<float> values;
    for (const glm::vec3& place : places_m) {
      const glm::vec3 p = turned(place);
      values.insert(values.end(), {p.x, p.y, p.z});
    }
    return add_floats(values, 3, true);
  }

  std::size_t add_indices(std::span<const std::uint32_t> indices) {
    std::string bytes;
    for (const std::uint32_t index : indices) append(bytes, index);
    accessors_.push_back({{"bufferView", add_view(bytes, kIndices)},
                          {"componentType", kUnsignedInt},
                          {"count", indices.size()},
                          {"type", "SCALAR"}});
    return accessors_.size() - 1;
  }

  std::size_t add_material(Json material) {
    material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
    materials_.push_back(std::move(material));
    return materials_.size() - 1;
  }

  void add_node(const std::string& name, Json primitive) {
    meshes_.push_back({{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
    nodes_.push_back({{"name", name}, {"mesh", meshes_.size() - 1}});
  }

  void add_texture(const std::string& png) {
    json_["images"] = Json::array({{{"bufferView", add_view(png)}, {"mimeType", "image/png"}}});
    json_["textures"] = Json::array({{{"source", 0}}});
  }

  std::string finish(const std::string& name, Json extras) {
    Json all = {
        {"asset", {{"version", "2.0"}, {"generator", "luxgate " + report::program_version()}}},
        {"extensionsUsed", Json::array({"KHR_materials_unlit"})},
        {"scene", 0}};
    Json nodes = Json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) nodes.push_back(i);
    all["scenes"] =
        Json::array({{{"name", name}, {"nodes", std::move(nodes)}, {"extras", std::move(extras)}}});
    all["nodes"] = std::move(nodes_);
    all["meshes"] = std::move(meshes_);
    all["materials"] = std::move(materials_);
    all.update(json_);
    all["accessors"] = std::move(accessors_);
    all["bufferViews"] = std::move(views_);
    all["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    std::string text = all.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + kWord - 1) / kWord * kWord, ' ');
    constexpr std::size_t kHeader = 12, kChunk = 8;
    std::string file = "glTF";
    append(file, 2);
    append(file, size32(kHeader + 2 * kChunk + text.size() + bytes_.size()));
    append(file, size32(text.size()));
    file += "JSON" + text;
    append(file, size32(bytes_.size()));
    file += std::string("BIN\0", 4) + bytes_;
    return file;
  }

 private:
  static std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

  // Little-endian, whatever the processor.
  static void append(std::string& bytes, std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(static_cast<unsigned char>(word >> shift & 0xFFU));
  }

  std::string bytes_;
  Json json_ = Json::object(), nodes_ = Json::array(), meshes_ = Json::array(),
       materials_ = Json::array(), accessors_ = Json::array(), views_ = Json::array();
};

void add_surfaces(GlbWriter& writer, const calc::LitSurfaces& light,
                  const report::ColourScale& scale) {
  if (light.triangle.empty()) return;
  std::vector<float> colours;
  for (const float lx : light.lx) {
    const report::Rgb colour = report::cividis(static_cast<double>(lx) / scale.high());
    colours.insert(colours.end(), {linear(colour.r), linear(colour.g), linear(colour.b)});
  }
  std::vector<std::uint32_t> indices;
  for (const glm::uvec3& t : light.triangle) indices.insert(indices.end(), {t.x, t.y, t.z});
  writer.add_node("surfaces", {{"attributes",
                                {{"POSITION", writer.add_places(light.position_m)},
                                 {"COLOR_0", writer.add_floats(colours, 3)},
                                 {"_ILLUMINANCE_LX", writer.add_floats(light.lx, 1)}}},
                               {"indices", writer.add_indices(indices)},
                               {"material", writer.add_material({{"name", "illuminance"}})}});
}

// Points as a small octahedron.
void add_luminaires(GlbWriter& writer, const calc::PreparedScene& scene) {
  constexpr double kPoint_m = 0.04;
  constexpr std::array<glm::uvec3, 8> kOctahedron{glm::uvec3(0, 2, 4), {2, 1, 4}, {1, 3, 4},
                                                  {3, 0, 4},           {2, 0, 5}, {1, 2, 5},
                                                  {3, 1, 5},           {0, 3, 5}};
  std::vector<glm::vec3> places_m;
  std::vector<std::uint32_t> indices;
  for (const calc::PlacedLuminaire& luminaire : scene.luminaires) {
    const auto first = static_cast<std::uint32_t>(places_m.size());
    if (luminaire.opening.shape == calc::OpeningShape::point) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
          glm::dvec3 tip = luminaire.position_m;
          tip[axis] += side * kPoint_m;
          places_m.emplace_back(tip);
        }
      }
      for (const glm::uvec3& t : kOctahedron)
        indices.insert(indices.end(), {first + t.x, first + t.y, first + t.z});
      continue;
    }
    const std::vector<glm::dvec3> rim_m = gpu::opening_rim_m(luminaire);
    places_m.insert(places_m.end(), rim_m.begin(), rim_m.end());
    for (std::uint32_t k = 2; k < rim_m.size(); ++k)
      indices.insert(indices.end(), {first, first + k - 1, first + k});
  }
  if (indices.empty()) return;
  writer.add_node(
      "luminaires",
      {{"attributes", {{"POSITION", writer.add_places(places_m)}}},
       {"indices", writer.add_indices(indices)},
       {"material",
        writer.add_material({{"name", "openings"},
                             {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.95, 0.6, 1.0}}}},
                             {"doubleSided", true}})}});
}

void add_planes(GlbWriter& writer, const std::vector<Outline>& planes) {
  if (planes.empty()) return;
  const std::size_t material = writer.add_material(
      {{"name", "planes"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 1.0, 1.0, 1.0}}}}});
  for (const Outline& plane : planes) {
    std::vector<glm::vec3> places_m(plane.corner_m.begin(), plane.corner_m.end());
    std::vector<std::uint32_t> indices;
    const auto corners = static_cast<std::uint32_t>(places_m.size());
    for (std::uint32_t k = 0; k < corners; ++k)
      indices.insert(indices.end(), {k, (k + 1) % corners});
    writer.add_node(report::printable(plane.id),
                    {{"attributes", {{"POSITION", writer.add_places(places_m)}}},
                     {"indices", writer.add_indices(indices)},
                     {"material", material},
                     {"mode", kLines}});
  }
}

// Upright before the room, below its floor, so that it hides nothing.
void add_legend(GlbWriter& writer, const calc::PreparedScene& scene,
                const report::ColourScale& scale) {
  constexpr double kShare = 0.6, kGap = 0.04;  // of the room's width
  const report::Raster raster = report::with_legend({}, scale);
  const gpu::RoomBox box = gpu::box_of(scene);
  const glm::dvec3 size_m = box.high_m - box.low_m;
  const double width_m = kShare * std::max(size_m.x, size_m.z);
  const double height_m = width_m * raster.height / raster.width;
  const double left_m = 0.5 * (box.low_m.x + box.high_m.x - width_m);
  const double top_m = box.low_m.z - kGap * width_m, y_m = box.low_m.y;
  const std::array<glm::vec3, 4> corners_m{
      glm::vec3(glm::dvec3(left_m, y_m, top_m - height_m)),
      glm::vec3(glm::dvec3(left_m + width_m, y_m, top_m - height_m)),
      glm::vec3(glm::dvec3(left_m + width_m, y_m, top_m)),
      glm::vec3(glm::dvec3(left_m, y_m, top_m))};
  constexpr std::array kTexture{0.0F, 1.0F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.0F};
  constexpr std::array<std::uint32_t, 6> kIndex{0, 1, 2, 0, 2, 3};
  writer.add_texture(report::encode_png(raster));
  writer.add_node(
      "legend", {{"attributes",
                  {{"POSITION", writer.add_places(corners_m)},
                   {"TEXCOORD_0", writer.add_floats(kTexture, 2)}}},
                 {"indices", writer.add_indices(kIndex)},
                 {"material", writer.add_material(
                                  {{"name", "legend"},
                                   {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                   {"doubleSided", true}})}});
}

}  // namespace

report::ColourScale common_scale(const std::vector<Room>& rooms) {
  constexpr double kShownShare = 0.99;
  std::vector<std::pair<double, double>> lit;  // lx at corners, a third of the triangle's area
  double whole_m2 = 0.0;
  for (const Room& room : rooms) {
    for (const glm::uvec3& t : room.light.triangle) {
      const glm::dvec3 a(room.light.position_m[t.x]), b(room.light.position_m[t.y]),
          c(room.light.position_m[t.z]);
      const double third_m2 = glm::length(glm::cross(b - a, c - a)) / 6.0;
      for (int k = 0; k < 3; ++k) lit.emplace_back(room.light.lx[t[k]], third_m2);
      whole_m2 += 3.0 * third_m2;
    }
  }
  std::sort(lit.begin(), lit.end());
  double highest = 0.0, below_m2 = 0.0;
  for (const auto& [lx, area_m2] : lit) {
    highest = lx;
    below_m2 += area_m2;
    if (below_m2 >= kShownShare * whole_m2) break;
  }
  return report::make_colour_scale(0.0, highest);
}

std::string write_glb(const Room& room, const report::ColourScale& scale) {
  GlbWriter writer;
  add_surfaces(writer, room.light, scale);
  add_luminaires(writer, *room.scene);
  add_planes(writer, room.planes);
  add_legend(writer, *room.scene, scale);
  const glm::dvec3& origin_m = room.scene->origin_m;
  return writer.finish(report::printable(room.name.empty() ? room.id : room.name),
                       {{"space", report::printable(room.id)},
                        {"quantity", "maintained illuminance, every luminaire at full output"},
                        {"unit", "lx"},
                        {"scale", {scale.low, scale.high()}},
                        {"sampling_error_share", room.light.error_share},
                        {"origin_m", {origin_m.x, origin_m.y, origin_m.z}}});
}

}  // namespace cli::gltf
