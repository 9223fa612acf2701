#include "calc/project/spaces/planes_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/plane_area.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr double kPerpendicularCosine = 1.0e-6;
constexpr double kParallelSine = 1.0e-9;
constexpr double kHorizontalSine = 1.0e-6;

// The attributes that tell the forms apart.
constexpr std::array<std::string_view, 6> kForms{"height", "origin",    "points",
                                                 "on",     "on-top-of", "file"};

GridRule read_grid_rule(ProjectContext& context, ElementReader& reader) {
  for (const std::string_view name : {"count", "spacing"}) {
    if (!reader.has("rounding") || !reader.has(name)) continue;
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("rounding"),
                  reader.element().name, "rounding", name);
  }
  GridByRule by_rule;
  by_rule.rounding = reader.value_or("rounding", GridRounding::nearest);
  if (!reader.exclude("count", "spacing")) return by_rule;
  if (reader.has("count")) {
    const std::vector<int> count =
        reader.integers("count", 2, "2 whole numbers (along u and v)", 1);
    const double points = static_cast<double>(count[0]) * static_cast<double>(count[1]);
    constexpr double kMostPoints = 1.0e6;
    if (points > kMostPoints) {
      reader.report(DiagnosticId::number_out_of_range, reader.where("count"), "count",
                    reader.element().name, fmt::format("{} x {}", count[0], count[1]),
                    fmt::format("at most {:.0f} points", kMostPoints));
    }
    return GridByCount{count[0], count[1]};
  }
  if (!reader.has("spacing")) return by_rule;
  const std::vector<double> spacing =
      reader.number_groups("spacing", 1, 1, 2, "1 or 2 numbers (along u and v)", kPositive);
  if (spacing.empty()) return by_rule;
  return GridBySpacing{
      spacing.front() * context.metres_per_unit, spacing.back() * context.metres_per_unit, {}};
}

class PlaneReader {
 public:
  PlaneReader(ProjectContext& context, ElementReader& reader, const PlaneSurroundings& around)
      : context_(context), reader_(reader), around_(around) {}

  std::optional<PlaneArea> read() {
    const std::string_view form = find_form();
    if (form.empty()) return std::nullopt;
    if (around_.source != RoomSource::prism && !fits_room_of_file(form)) return std::nullopt;
    if ((form == "height" || form == "on") && around_.room == nullptr) {
      reader_.report(DiagnosticId::room_only, reader_.where(form), form);
      return std::nullopt;
    }
    if (form != "points") refuse_holes();
    if (form == "file") return read_point_list();
    std::optional<PlanarArea> area = read_area(form);
    const double margin_m =
        reader_.number_or("margin", kNonNegative, 0.0) * context_.metres_per_unit;
    const GridRule grid = read_grid_rule(context_, reader_);
    if (!area) return std::nullopt;
    area->margin_m = margin_m;
    area->grid = grid;
    return *area;
  }

 private:
  bool fits_room_of_file(std::string_view form) {
    const bool is_mesh = around_.source == RoomSource::mesh;
    const DiagnosticId id = is_mesh ? DiagnosticId::mesh_room_plane : DiagnosticId::gbxml_plane;
    if (form == "on") {
      reader_.report(id, reader_.where(form), form,
                     is_mesh ? "the walls of a mesh room have no numbers; use 'points'"
                             : "the walls of a gbXML room have no numbers; use 'points'");
      return false;
    }
    if (form == "height" && around_.room == nullptr && around_.room_is_good) {
      reader_.report(
          id, reader_.where(form), form,
          is_mesh ? "the lowest faces of this mesh are not one level polygon without holes, or "
                    "other faces that look up are above them; use 'points'"
                  : "this gbXML room states no outline, and its floor is not one flat polygon; use "
                    "'points'");
    }
    return form != "height" || around_.room != nullptr;
  }

  // Reports none or several.
  std::string_view find_form() {
    std::string_view found;
    for (const std::string_view form : kForms) {
      if (!reader_.has(form)) continue;
      if (!found.empty() && !reader_.exclude(found, form)) return {};
      found = form;
    }
    const bool has_side = reader_.has("u") || reader_.has("v");
    if (found.empty() && has_side) found = "origin";
    if (found.empty()) {
      reader_.report(DiagnosticId::missing_form, reader_.where(), "plane",
                     around_.room != nullptr
                         ? "one of 'height', 'origin' with 'u' and 'v', 'points', 'on', "
                           "'on-top-of' or 'file'"
                         : "one of 'origin' with 'u' and 'v', 'points', 'on-top-of' or 'file'");
    } else if (found != "origin" && has_side) {
      const std::string_view side = reader_.has("u") ? "u" : "v";
      reader_.report(DiagnosticId::attribute_without_meaning, reader_.where(side), "plane", side,
                     found);
    }
    return found;
  }

  std::optional<PlanarArea> read_area(std::string_view form) {
    if (form == "height") return read_height();
    if (form == "origin") return read_rectangle();
    if (form == "points") return read_polygon();
    if (form == "on") return read_room_surface();
    return read_box_top();
  }

  std::optional<PlanarArea> read_height() {
    const double height = reader_.number("height", kNonNegative) * context_.metres_per_unit;
    if (!reader_.ok() || !around_.room_is_good) return std::nullopt;
    const RoomPlan& room = *around_.room;
    if (height >= room.height_m) {
      reader_.report(DiagnosticId::number_out_of_range, reader_.where("height"), "height", "plane",
                     reader_.text("height"),
                     fmt::format("a number from 0 to below the room's height {:.10g}",
                                 room.height_m / context_.metres_per_unit));
      return std::nullopt;
    }
    return horizontal_area(room, height, true);
  }

  std::optional<PlanarArea> read_rectangle() {
    const glm::dvec3 origin = read_point_m(context_, reader_, "origin") + around_.origin_m;
    const glm::dvec3 u = read_point_m(context_, reader_, "u");
    const glm::dvec3 v = read_point_m(context_, reader_, "v");
    if (!reader_.ok()) return std::nullopt;
    const double lengths = glm::length(u) * glm::length(v);
    if (!(glm::length(glm::cross(u, v)) > kParallelSine * lengths)) {
      reader_.report(DiagnosticId::parallel_vectors, reader_.where("u"), "u", "v", "plane");
      return std::nullopt;
    }
    const double cosine = glm::dot(u, v) / lengths;
    if (std::abs(cosine) > kPerpendicularCosine) {
      reader_.report(DiagnosticId::not_perpendicular, reader_.where("u"),
                     degrees_from_radians(calc::acos(cosine)));
      return std::nullopt;
    }
    return rectangle_area({origin, u, v});
  }

  std::optional<PlanarArea> read_polygon() {
    const std::vector<glm::dvec3> corners = read_corners(reader_);
    if (corners.empty()) return std::nullopt;
    const std::vector<glm::dvec3> outline = mended_outline(reader_, "points", corners);
    std::optional<PlanarArea> area;
    if (!outline.empty()) area = polygon_area(outline);
    if (!area) {
      reader_.report(DiagnosticId::not_simple_polygon, reader_.where("points"), "points", "plane",
                     "lie in one plane and ");
      return std::nullopt;
    }
    for (const XmlElement& child : reader_.element().children) {
      if (child.name == "hole") read_hole(child, *area);
    }
    return area;
  }

  void read_hole(const XmlElement& element, PlanarArea& area) {
    ElementReader reader(element, context_.diagnostics);
    reader.allow(kHoleElement);
    const std::vector<glm::dvec3> corners = read_corners(reader);
    if (corners.empty()) return;
    std::vector<glm::dvec2> outline;
    for (const glm::dvec3& corner : corners) {
      if (!lies_in_area(area, corner)) {
        const glm::dvec3 written = (corner - around_.origin_m) / context_.metres_per_unit;
        reader.report(DiagnosticId::hole_outside_plane, reader.where("points"),
                      fmt::format("{:.10g}", written.x), fmt::format("{:.10g}", written.y),
                      fmt::format("{:.10g}", written.z));
        return;
      }
      outline.push_back(area_coordinates(area, corner));
    }
    outline = mended_outline(reader, "points", outline);
    if (outline.empty()) {
      reader.report(DiagnosticId::not_simple_polygon, reader.where("points"), "points", "hole", "");
      return;
    }
    area.holes_m.push_back(std::move(outline));
  }

  std::optional<PlanarArea> read_room_surface() {
    if (!around_.room_is_good) return std::nullopt;
    const RoomPlan& room = *around_.room;
    std::vector<std::string> names{"floor", "ceiling"};
    for (std::size_t i = 1; i <= room.corners_m.size(); ++i)
      names.push_back(fmt::format("wall{}", i));
    const std::size_t index = reader_.choice("on", Names(names.begin(), names.end()));
    if (!reader_.ok()) return std::nullopt;
    if (index == 0) return horizontal_area(room, 0.0, true);
    if (index == 1) return horizontal_area(room, room.height_m, false);
    return rectangle_area(room.wall(index - 2));
  }

  std::optional<PlanarArea> read_box_top() {
    const std::string id = reader_.text("on-top-of");
    if (!reader_.ok()) return std::nullopt;
    const auto found = around_.box_tops.find(id);
    if (found != around_.box_tops.end()) {
      const BoxTop& top = found->second;
      return rectangle_area({top.origin_m, top.u_m, top.v_m});
    }
    if (around_.objects_are_good) report_unknown_box(id);
    return std::nullopt;
  }

  void report_unknown_box(const std::string& id) {
    // Someone who names a repeated box without its indices should be told about them.
    const std::string first = id + "[0,0,0]";
    Names known;
    for (const auto& [name, top] : around_.box_tops) known.push_back(name);
    if (around_.box_tops.contains(first)) known = {first};
    report_unknown_reference(reader_, "on-top-of", "box", id, known);
  }

  std::optional<PlaneArea> read_point_list() {
    for (const std::string_view name : {"margin", "count", "spacing", "rounding"}) {
      if (!reader_.has(name)) continue;
      reader_.report(DiagnosticId::attribute_without_meaning, reader_.where(name), "plane", name,
                     "file");
    }
    const std::string file = reader_.text("file");
    if (file.empty()) return std::nullopt;
    std::optional<PointList> list = context_.files.point_list(file, reader_.where("file"));
    if (!list) return std::nullopt;
    warn_of_unit(*list);
    for (glm::dvec3& position : list->position_m) position += around_.origin_m;
    return *list;
  }

  // Whoever writes a project in millimetres may have written such a list in millimetres, too.
  void warn_of_unit(const PointList& list) {
    if (list.names_its_unit || context_.metres_per_unit == 1.0) return;
    reader_.report(DiagnosticId::point_list_unit, reader_.where("file"), list.file,
                   context_.unit_name);
  }

  // World coordinates; empty on errors.
  std::vector<glm::dvec3> read_corners(ElementReader& reader) {
    std::vector<glm::dvec3> corners = read_corners_m(context_, reader, "points");
    for (glm::dvec3& corner : corners) corner += around_.origin_m;
    return corners;
  }

  void refuse_holes() {
    for (const XmlElement& child : reader_.element().children) {
      if (child.name == "hole") reader_.report(DiagnosticId::hole_without_points, child.where);
    }
  }

  ProjectContext& context_;
  ElementReader& reader_;
  const PlaneSurroundings& around_;
};

constexpr std::string_view kLooking = "quantity=\"semicylindrical\" or \"ugr\"";

bool is_horizontal(const glm::dvec3& unit) { return std::abs(unit.z) <= kHorizontalSine; }

// Without what the file's rounding left upright: half a cylinder that stands upright sees nothing
// from behind at all.
glm::dvec3 made_horizontal(const glm::dvec3& unit) {
  return glm::normalize(glm::dvec3(unit.x, unit.y, 0.0));
}

// Where the points of an area look, 0 if their quantity needs no such direction.
glm::dvec3 read_look(ElementReader& reader, const PlaneQuantity& quantity) {
  constexpr std::string_view kName = "direction";
  const bool looks = has_look(quantity.kernel, quantity.derived);
  if (reader.has(kName) != looks) {
    const std::string own = fmt::format("quantity=\"{}\"", quantity.name);
    reader.report(DiagnosticId::missing_partner, reader.where(looks ? "quantity" : kName), "plane",
                  looks ? std::string_view(own) : kName, looks ? kName : kLooking);
  }
  if (!reader.has(kName)) return glm::dvec3(0.0);
  const std::size_t errors = reader.diagnostics().error_count();
  const glm::dvec3 look = read_direction(reader, kName);
  if (reader.diagnostics().error_count() > errors) return glm::dvec3(0.0);
  if (is_horizontal(look)) return made_horizontal(look);
  reader.report(DiagnosticId::not_horizontal, reader.where(kName), kName, "plane",
                degrees_from_radians(calc::asin(look.z)));
  return glm::dvec3(0.0);
}

// Which way people go on an area; 0 if it is not said.
glm::dvec3 read_travel(ElementReader& reader) {
  constexpr std::string_view kName = "travel";
  if (!reader.has(kName)) return glm::dvec3(0.0);
  if (reader.has("file")) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where(kName), "plane", kName,
                  "file");
    return glm::dvec3(0.0);
  }
  const std::size_t errors = reader.diagnostics().error_count();
  const glm::dvec3 travel = read_direction(reader, kName);
  if (reader.diagnostics().error_count() > errors) return glm::dvec3(0.0);
  if (is_horizontal(travel)) return made_horizontal(travel);
  reader.report(DiagnosticId::not_horizontal, reader.where(kName), kName, "plane",
                degrees_from_radians(calc::asin(travel.z)));
  return glm::dvec3(0.0);
}

// The points of a list look along their normals.
void check_looks(ElementReader& reader, PointList& list) {
  const auto tilted = [&](const glm::dvec3& normal) { return !is_horizontal(normal); };
  const auto first = std::find_if(list.normal.begin(), list.normal.end(), tilted);
  if (first == list.normal.end()) {
    for (glm::dvec3& normal : list.normal) normal = made_horizontal(normal);
    return;
  }
  reader.report(DiagnosticId::point_list_not_horizontal, reader.where("file"),
                std::count_if(first, list.normal.end(), tilted), list.normal.size(), list.file,
                first->x, first->y, first->z,
                list.line[static_cast<std::size_t>(first - list.normal.begin())]);
}

// What the points measure, and where those of an area look.
void read_quantity(ElementReader& reader, CalcPlane& plane) {
  const std::size_t errors = reader.diagnostics().error_count();
  const PlaneQuantity& quantity =
      kPlaneQuantities[reader.choice_or("quantity", kPlaneQuantityType.words, 0)];
  plane.kernel = quantity.kernel;
  plane.derived = quantity.derived;
  plane.is_quantity_known = reader.diagnostics().error_count() == errors;
  if (!plane.is_quantity_known) return;  // nothing follows from it
  if (!reader.has("file")) {
    plane.direction = read_look(reader, quantity);
  } else if (reader.has("direction")) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("direction"), "plane",
                  "direction", "file");
  }
}

}  // namespace

GridText read_grid(ProjectContext& context, ElementReader& reader) {
  const bool is_given = reader.has("count") || reader.has("spacing") || reader.has("rounding");
  return {read_grid_rule(context, reader), is_given};
}

CalcPlane read_named_plane(ProjectContext& context, ElementReader& reader) {
  CalcPlane plane;
  plane.id = reader.id();
  context.planes.add(reader, plane.id, 0);
  plane.was = context.former_planes.read(reader, plane.id);
  plane.name = reader.text_or("name", "");
  plane.tags = read_tags(reader);
  plane.where = reader.where();
  for (const XmlElement& child : reader.element().children) {
    if (child.name == "require") plane.requirements.push_back({child, ""});
  }
  return plane;
}

CalcPlane read_plane(ProjectContext& context, ElementReader& reader,
                     const PlaneSurroundings& surroundings) {
  reader.allow(kPlaneElement);
  CalcPlane plane = read_named_plane(context, reader);
  auto area = PlaneReader(context, reader, surroundings).read();
  read_quantity(reader, plane);
  plane.travel = read_travel(reader);
  if (!area || !reader.ok()) return plane;
  if (reader.has("on") || reader.has("on-top-of")) context.planes_on_surfaces.insert(plane.id);
  plane.area = std::move(*area);
  auto* list = std::get_if<PointList>(&plane.area);
  if (list != nullptr && has_look(plane.kernel, plane.derived)) {
    check_looks(reader, *list);
  }
  return plane;
}

}  // namespace calc
