#include "calc/meshes/gbxml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"
#include "calc/meshes/mesh_builder.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kMaxCoordinate_m = 1.0e9;

std::string_view local_name(std::string_view name) { return name.substr(name.rfind(':') + 1); }

// Children with the name, whatever its prefix.
class Children {
 public:
  Children(const pugi::xml_node& parent, std::string_view name) {
    for (const pugi::xml_node& child : parent.children()) {
      if (child.type() == pugi::node_element && local_name(child.name()) == name) {
        list_.push_back(child);
      }
    }
  }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  bool empty() const { return list_.empty(); }
  const pugi::xml_node& front() const { return list_.front(); }

 private:
  std::vector<pugi::xml_node> list_;
};

std::optional<double> metres_per_length_unit(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 8> kUnits{
      {{"Kilometers", 1000.0},
       {"Meters", 1.0},
       {"Centimeters", kMetresPerCentimetre},
       {"Millimeters", kMetresPerMillimetre},
       {"Miles", 5280.0 * kMetresPerFoot},
       {"Yards", 3.0 * kMetresPerFoot},
       {"Feet", kMetresPerFoot},
       {"Inches", kMetresPerInch}}};
  for (const auto& [name, metres] : kUnits) {
    if (name == unit) return metres;
  }
  return std::nullopt;
}

class BuildingReader {
 public:
  BuildingReader(std::string_view bytes, const std::string& name, Diagnostics& diagnostics)
      : name_(name), diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (bytes[i] == '\n') line_end_.push_back(i);
    }
  }

  std::optional<GbxmlBuilding> run(const pugi::xml_node& root) {
    const std::string_view unit = root.attribute("lengthUnit").value();
    const std::optional<double> metres = metres_per_length_unit(unit);
    if (!metres) {
      report(root,
             fmt::format("lengthUnit '{}' is unknown; allowed: Kilometers, Meters, Centimeters, "
                         "Millimeters, Miles, Yards, Feet or Inches",
                         shorten_utf8(unit, 40)));
      return std::nullopt;
    }
    metres_per_unit_ = *metres;
    building_.file = name_;
    for (const pugi::xml_node& campus : Children(root, "Campus")) {
      for (const pugi::xml_node& building : Children(campus, "Building")) {
        for (const pugi::xml_node& space : Children(building, "Space")) add_space(space);
      }
      for (const pugi::xml_node& surface : Children(campus, "Surface")) add_surface(surface);
    }
    if (failed_) return std::nullopt;
    return std::move(building_);
  }

 private:
  void add_space(const pugi::xml_node& space) {
    const Children names(space, "Name");
    const std::string name = names.empty() ? "" : std::string(trim(names.front().child_value()));
    const std::string id = space.attribute("id").value();
    std::vector<glm::dvec3> floor;
    if (!Children(space, "PlanarGeometry").empty()) floor = corners_of(space, id);
    building_.space.push_back({id, name, std::move(floor)});
  }

  void add_surface(const pugi::xml_node& node) {
    GbxmlSurface surface;
    surface.id = node.attribute("id").value();
    surface.type = node.attribute("surfaceType").value();
    surface.line = line_of(node);
    for (const pugi::xml_node& side : Children(node, "AdjacentSpaceId")) {
      surface.side.push_back(
          {side.attribute("spaceIdRef").value(), side.attribute("surfaceType").value()});
    }
    if (surface.side.empty()) return;  // shades and the like: no room sees them
    surface.corner_m = corners_of(node, surface.id);
    for (const pugi::xml_node& child : Children(node, "Opening")) {
      GbxmlOpening opening;
      opening.id = child.attribute("id").value();
      opening.type = child.attribute("openingType").value();
      opening.line = line_of(child);
      opening.corner_m = corners_of(child, opening.id);
      surface.opening.push_back(std::move(opening));
    }
    building_.surface.push_back(std::move(surface));
  }

  // Of PlanarGeometry/PolyLoop; without the first corner again at the end, as some write it.
  std::vector<glm::dvec3> corners_of(const pugi::xml_node& node, const std::string& id) {
    std::vector<glm::dvec3> corners;
    const Children planar(node, "PlanarGeometry");
    const Children loop(planar.empty() ? pugi::xml_node() : planar.front(), "PolyLoop");
    if (loop.empty()) {
      report(node, fmt::format("'{}' has no PlanarGeometry with a PolyLoop", shorten_utf8(id, 60)));
      return corners;
    }
    for (const pugi::xml_node& point : Children(loop.front(), "CartesianPoint")) {
      const std::optional<glm::dvec3> corner = read_point(point);
      if (!corner) return {};
      corners.push_back(*corner);
    }
    if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() > kMaxFaceCorners) {
      report(node, fmt::format("'{}' has {} corners; at most {} are read", shorten_utf8(id, 60),
                               corners.size(), kMaxFaceCorners));
      return {};
    }
    return corners;
  }

  std::optional<glm::dvec3> read_point(const pugi::xml_node& point) {
    std::vector<double> numbers;
    for (const pugi::xml_node& coordinate : Children(point, "Coordinate")) {
      const std::string_view text = trim(coordinate.child_value());
      const std::optional<double> number = parse_number(text);
      if (!number || std::abs(*number) * metres_per_unit_ > kMaxCoordinate_m) {
        report(coordinate, fmt::format("the coordinate '{}' is not a number up to {:g} m",
                                       shorten_utf8(text, 40), kMaxCoordinate_m));
        return std::nullopt;
      }
      numbers.push_back(*number * metres_per_unit_);
    }
    if (numbers.size() == 3) return glm::dvec3(numbers[0], numbers[1], numbers[2]);
    report(point, fmt::format("a point has {} coordinates; 3 are needed", numbers.size()));
    return std::nullopt;
  }

  int line_of(const pugi::xml_node& node) const {
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    const auto before = std::lower_bound(line_end_.begin(), line_end_.end(), at);
    return static_cast<int>(before - line_end_.begin()) + 1;
  }

  // The first ten of them.
  void report(const pugi::xml_node& node, const std::string& what) {
    constexpr int kMostErrors = 10;
    if (++failed_ > kMostErrors) return;
    diagnostics_.report(DiagnosticId::gbxml_broken, {name_, line_of(node), 0}, what);
  }

  const std::string& name_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> line_end_;
  double metres_per_unit_ = 1.0;
  int failed_ = 0;
  GbxmlBuilding building_;
};

}  // namespace

bool is_gbxml(std::string_view bytes) { return has_first_element(bytes, "gbXML"); }

std::optional<GbxmlBuilding> parse_gbxml(std::string bytes, const std::string& name,
                                         Diagnostics& diagnostics) {
  if (!check_file_kind(bytes, name, FileUse::gbxml, diagnostics, looks_like_xml(bytes))) {
    return std::nullopt;
  }
  std::optional<std::string> decoded = decoded_xml(std::move(bytes), name, diagnostics);
  if (!decoded) return std::nullopt;
  bytes = std::move(*decoded);
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8);
  BuildingReader reader(bytes, name, diagnostics);
  if (!result) {
    const auto before =
        bytes.begin() +
        std::min<std::ptrdiff_t>(result.offset, static_cast<std::ptrdiff_t>(bytes.size()));
    const auto line = std::count(bytes.begin(), before, '\n') + 1;
    diagnostics.report(DiagnosticId::gbxml_broken, SourceLocation{name, static_cast<int>(line), 0},
                       result.description());
    return std::nullopt;
  }
  const pugi::xml_node root = document.document_element();
  if (local_name(root.name()) != "gbXML") {
    diagnostics.report(DiagnosticId::gbxml_broken, SourceLocation{name, 0, 0},
                       fmt::format("its root element is <{}>", shorten_utf8(root.name(), 40)));
    return std::nullopt;
  }
  return reader.run(root);
}

}  // namespace calc
