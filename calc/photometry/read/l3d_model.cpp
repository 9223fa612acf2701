#include "calc/photometry/read/l3d_model.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/photometry/read/xml_query.h"
#include "calc/photometry/read/zip_archive.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace calc {
namespace {

constexpr double kFarthest_m = 1000.0;

// Stops the reading; never leaves this file.
class BadModel : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

double coordinate(const XmlElement& element, const char* name, double most) {
  const std::string text = attribute_of(element, name);
  const std::optional<double> value = parse_number(text);
  if (value && std::abs(*value) <= most) return *value;
  throw BadModel(fmt::format("line {}: {}=\"{}\" of <{}> is not a number up to {:g}",
                             element.where.line, name, text, element.name, most));
}

glm::dvec3 vector_in(const XmlElement& parent, std::string_view name, double most) {
  const XmlElement* element = child_of(parent, name);
  if (element == nullptr) return glm::dvec3(0.0);
  return {coordinate(*element, "x", most), coordinate(*element, "y", most),
          coordinate(*element, "z", most)};
}

// Exact for quarter turns.
std::pair<double, double> cos_and_sin(double deg) {
  const double quarters = deg / 90.0;
  if (quarters != std::floor(quarters)) {
    return {calc::cos(radians_from_degrees(deg)), calc::sin(radians_from_degrees(deg))};
  }
  constexpr double kCos[] = {1.0, 0.0, -1.0, 0.0};
  const auto turn = static_cast<int>(std::fmod(quarters, 4.0) + 4.0) % 4;
  return {kCos[turn], kCos[(turn + 3) % 4]};
}

glm::dmat3 about(int axis, double deg) {
  const auto [c, s] = cos_and_sin(deg);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  glm::dmat3 turn(1.0);
  turn[next][next] = c;
  turn[next][last] = s;
  turn[last][next] = -s;
  turn[last][last] = c;
  return turn;
}

glm::dmat3 turn_in(const XmlElement& parent, std::string_view name) {
  const glm::dvec3 deg = vector_in(parent, name, 360.0 * 1000.0);
  return about(2, deg.z) * about(0, deg.x) * about(1, deg.y);
}

EmitterPlace placed_in(const EmitterPlace& outer, const XmlElement& part) {
  return {outer.position_m + outer.turn * vector_in(part, "Position", kFarthest_m),
          outer.turn * turn_in(part, "Rotation")};
}

class StructureReader {
 public:
  std::map<std::string, EmitterPlace> read(const XmlElement& structure) {
    read_geometries(structure, {});
    return std::move(places_);
  }

 private:
  void read_geometries(const XmlElement& parent, const EmitterPlace& outer) {
    for (const XmlElement* geometry : children_of(parent, "Geometry")) {
      const EmitterPlace place = placed_in(outer, *geometry);
      if (const XmlElement* objects = child_of(*geometry, "LightEmittingObjects")) {
        read_objects(*objects, place);
      }
      if (const XmlElement* joints = child_of(*geometry, "Joints")) read_joints(*joints, place);
    }
  }

  void read_objects(const XmlElement& objects, const EmitterPlace& outer) {
    for (const XmlElement* object : children_of(objects, "LightEmittingObject")) {
      const std::string name = attribute_of(*object, "partName");
      if (!places_.try_emplace(name, placed_in(outer, *object)).second) {
        throw BadModel(fmt::format("it has two emitting objects '{}'", name));
      }
    }
  }

  void read_joints(const XmlElement& joints, const EmitterPlace& outer) {
    for (const XmlElement* joint : children_of(joints, "Joint")) {
      EmitterPlace place = placed_in(outer, *joint);
      place.turn = place.turn * turn_in(*joint, "DefaultRotation");
      if (const XmlElement* inner = child_of(*joint, "Geometries")) read_geometries(*inner, place);
    }
  }

  std::map<std::string, EmitterPlace> places_;
};

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& each : diagnostics.all()) {
    if (each.severity() == Severity::error) return each.message;
  }
  return "";
}

}  // namespace

std::optional<std::map<std::string, EmitterPlace>> read_l3d_places(std::string_view bytes,
                                                                   std::string& problem) {
  Diagnostics own;  // the light does not need the model: no errors of the file
  std::optional<ZipArchive> archive = ZipArchive::open(bytes, "l3d", own);
  std::optional<std::string> text = archive ? archive->read("structure.xml") : std::nullopt;
  const std::optional<XmlElement> root =
      text ? parse_xml(std::move(*text), "structure.xml", own, XmlText::keep) : std::nullopt;
  if (!root) {
    problem = first_error(own);
    return std::nullopt;
  }
  const XmlElement* structure = child_of(*root, "Structure");
  if (structure == nullptr) {
    problem = "its structure.xml has no <Structure>";
    return std::nullopt;
  }
  try {
    return StructureReader().read(*structure);
  } catch (const BadModel& bad) {
    problem = bad.what();
    return std::nullopt;
  }
}

}  // namespace calc
