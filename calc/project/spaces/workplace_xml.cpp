#include "calc/project/spaces/workplace_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/plane_area.h"
#include "calc/project/spaces/upright_task.h"
#include "calc/project/spaces/waiver_attributes.h"
#include "calc/scene/polygon.h"
#include "calc/scene/zone_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

// Of a counter-clockwise area, less what may come from rounding; 0 of no area.
double area_outside_m2(const std::vector<glm::dvec2>& corners, const RoomShell& room) {
  if (corners.empty()) return 0.0;
  double outside_m2 = 0.0;
  for (const auto& piece : pieces_outside(corners, room.footprint_m)) {
    outside_m2 += signed_area(piece);
  }
  constexpr double kRounding = 1.0e-6;  // of the area: corners written to be on a wall
  return outside_m2 <= kRounding * signed_area(corners) ? 0.0 : outside_m2;
}

class WorkplaceReader {
 public:
  WorkplaceReader(ProjectContext& context, const PlaneSurroundings& around, const Space& space,
                  FormerIds& former)
      : context_(context), around_(around), space_(space), former_(former) {}

  // Of a <workplace>, or the first copy of a <workplace-grid>.
  Workplace read(ElementReader& reader) {
    reader.allow_children(kWorkplaceElement);  // those of a grid, too
    Workplace workplace;
    workplace.where = reader.where();
    workplace.id = reader.id();
    workplace.was = former_.read(reader, workplace.id);
    workplace.name = reader.text_or("name", "");
    workplace.tags = read_tags(reader);
    workplace.element = reader.element();
    workplace.task_m = read_area(reader);
    workplace.height_m = read_height(reader);
    workplace.upright = read_upright_task(context_, reader, around_);
    workplace.is_task_place_unknown = read_task_place(reader);
    workplace.front_wall = read_front_wall(reader);
    add_room(workplace);
    for (const XmlElement& child : reader.element().children) {
      if (child.name == "zone" || child.name == "without") read_zone(child, workplace);
    }
    return workplace;
  }

 private:
  // Who gives an area says where the task is.
  bool read_task_place(ElementReader& reader) const {
    const bool is_grid = reader.element().name != "workplace";  // which does not have it
    if (is_grid || !reader.has(kTaskPlaceName)) return false;
    reader.choice(kTaskPlaceName, kTaskPlaceType.words);
    for (const char* area : {"size", "footprint", "wall", "face"}) {
      if (!reader.has(area)) continue;
      reader.report(DiagnosticId::attribute_without_meaning, reader.where(kTaskPlaceName),
                    reader.element().name, kTaskPlaceName, area);
    }
    return true;
  }

  std::optional<std::size_t> read_front_wall(ElementReader& reader) const {
    if (!reader.has("front-wall")) return std::nullopt;
    const int number = reader.integer("front-wall", 1);
    if (!around_.room_is_good || around_.room == nullptr || number < 1) return std::nullopt;
    const std::size_t count = around_.room->corners_m.size();
    if (static_cast<std::size_t>(number) <= count) return static_cast<std::size_t>(number - 1);
    reader.report(DiagnosticId::number_out_of_range, reader.where("front-wall"), "front-wall",
                  reader.element().name, reader.text("front-wall"),
                  fmt::format("the number of a wall of the room, 1 to {}", count));
    return std::nullopt;
  }

  // What planes are measured from. Nothing without a good room, which then has its own message.
  void add_room(Workplace& workplace) const {
    if (!around_.room_is_good || around_.room == nullptr) return;
    const RoomPlan& room = *around_.room;
    workplace.ceiling = horizontal_area(room, room.height_m, false);
    for (std::size_t i = 0; i < room.corners_m.size(); ++i) {
      workplace.walls.push_back(rectangle_area(room.wall(i)));
    }
  }

  void read_zone(const XmlElement& element, Workplace& workplace) {
    ElementReader reader(element, context_.diagnostics);
    ZoneText zone;
    const bool is_left_out = element.name == "without";
    const ElementRow& row = is_left_out ? kWithoutElement : kZoneElement;
    reader.allow_children(row);
    reader.allow_attributes(row);
    zone.where = element.where;
    zone.role = reader.id("role");
    zone.role_where = reader.where("role");
    if (is_left_out) {
      zone.left_out = read_waiver(reader);
    } else {
      zone.because = reader.text_or("because", "");
      read_changes(reader, zone);
    }
    const auto twice = [&](const ZoneText& other) { return other.role == zone.role; };
    const auto first = std::find_if(workplace.zones.begin(), workplace.zones.end(), twice);
    if (first != workplace.zones.end() && !zone.role.empty()) {
      reader.report(DiagnosticId::duplicate_id, zone.role_where, "zone", zone.role,
                    first->where.line);
    }
    workplace.zones.push_back(std::move(zone));
  }

  void read_changes(ElementReader& reader, ZoneText& zone) {
    zone.height_m = read_height(reader);
    if (const auto margin = reader.optional_number("margin", kNonNegative)) {
      zone.margin_m = *margin * context_.metres_per_unit;
    }
    zone.area_m = read_area(reader);
    const GridText grid = read_grid(context_, reader);
    if (grid.is_given) zone.grid = grid.rule;
    const bool changes = zone.height_m || zone.margin_m || zone.grid || reader.has("size") ||
                         reader.has("footprint");
    if (changes || !reader.ok()) return;
    reader.report(
        DiagnosticId::missing_form, reader.where(), "zone",
        "at least one attribute that changes it: 'height', 'margin', 'origin' and 'size', "
        "'footprint', 'count', 'spacing' or 'rounding'");
  }

  std::optional<double> read_height(ElementReader& reader) {
    const std::optional<double> height = reader.optional_number("height", kNonNegative);
    if (!height || !around_.room_is_good || around_.room == nullptr) return std::nullopt;
    const double room_height = around_.room->height_m / context_.metres_per_unit;
    if (*height < room_height) return *height * context_.metres_per_unit;
    reader.report(DiagnosticId::number_out_of_range, reader.where("height"), "height",
                  reader.element().name, reader.text("height"),
                  fmt::format("a number from 0 to below the room's height {:.10g}", room_height));
    return std::nullopt;
  }

  // origin and size, or footprint, or nothing. Empty after errors, too.
  std::vector<glm::dvec2> read_area(ElementReader& reader) {
    if (!reader.exclude("size", "footprint") || !reader.require_together("origin", "size")) {
      return {};
    }
    std::vector<glm::dvec2> corners;
    const char* name = "footprint";
    if (reader.has("size")) {
      name = "size";
      const std::vector<double> at = reader.numbers("origin", 2, "2 numbers (x y)");
      const std::vector<double> size =
          reader.numbers("size", 2, "2 numbers above 0 (along x and y)", kPositive);
      const glm::dvec2 low(at[0], at[1]), side(size[0], size[1]);
      corners = {low, {low.x + side.x, low.y}, low + side, {low.x, low.y + side.y}};
    } else if (reader.has("footprint")) {
      const std::vector<double> numbers =
          reader.number_groups("footprint", 2, 3, kZoneCornerLimit,
                               fmt::format("3 to {} corners of 2 numbers (x y)", kZoneCornerLimit));
      for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        corners.emplace_back(numbers[i], numbers[i + 1]);
      }
    }
    if (corners.empty() || !reader.ok() || !space_.shell) return {};
    for (glm::dvec2& corner : corners) {
      corner = corner * context_.metres_per_unit + glm::dvec2(around_.origin_m);
    }
    corners = mended_outline(reader, name, corners);
    if (corners.empty()) {
      reader.report(DiagnosticId::not_simple_polygon, reader.where(name), name,
                    reader.element().name, "");
      return {};
    }
    if (signed_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
    check_within_room(reader, name, corners);
    return corners;
  }

  void check_within_room(ElementReader& reader, const char* name,
                         const std::vector<glm::dvec2>& corners) {
    const double outside_m2 = area_outside_m2(corners, *space_.shell);
    if (outside_m2 == 0.0) return;
    const double whole_m2 = signed_area(corners);
    reader.report(DiagnosticId::area_outside_room, reader.where(name), name, reader.element().name,
                  outside_m2, whole_m2, space_.id);
  }

  ProjectContext& context_;
  const PlaneSurroundings& around_;
  const Space& space_;
  FormerIds& former_;
};

// What a <workplace-grid> adds.
struct Copies {
  int columns = 1, rows = 1;
  glm::dvec2 step_m{0.0};
};

// More than any room needs.
constexpr double kMostCopies = 4000.0;

Copies read_copies(const ProjectContext& context, ElementReader& reader) {
  const std::vector<int> count = reader.integers("repeat", 2, "2 whole numbers (along x and y)", 1);
  const std::vector<double> step = reader.numbers("step", 2, "2 numbers (x y)");
  if (!reader.has("size") && !reader.has("footprint") && !reader.has("face")) {
    reader.report(DiagnosticId::missing_form, reader.where(), "workplace-grid",
                  "the area of its first copy: 'origin' and 'size', 'footprint' or 'face'");
  }
  if (!reader.ok()) return {};
  if (static_cast<double>(count[0]) * count[1] > kMostCopies) {
    reader.report(DiagnosticId::number_out_of_range, reader.where("repeat"), "repeat",
                  "workplace-grid", reader.text("repeat"),
                  fmt::format("at most {} copies", kMostCopies));
    return {};
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (count[i] == 1 || step[i] != 0.0) continue;
    reader.report(DiagnosticId::number_out_of_range, reader.where("step"), "step", "workplace-grid",
                  0, "a distance other than 0 wherever 'repeat' is above 1");
  }
  const glm::dvec2 step_m = glm::dvec2(step[0], step[1]) * context.metres_per_unit;
  return {count[0], count[1], step_m};
}

Workplace moved(Workplace workplace, const glm::dvec2& by_m) {
  for (glm::dvec2& corner : workplace.task_m) corner += by_m;
  if (workplace.upright) workplace.upright->area.origin_m += glm::dvec3(by_m, 0.0);
  for (ZoneText& zone : workplace.zones) {
    for (glm::dvec2& corner : zone.area_m) corner += by_m;
  }
  return workplace;
}

// No copy without its area in the room; the first is checked where it is read.
void check_copy(ElementReader& reader, const Workplace& copy, const Space& space) {
  if (!space.shell) return;
  if (copy.upright && !lies_within(*copy.upright, *space.shell)) {
    reader.report(DiagnosticId::copy_face_outside_room, reader.where("step"), copy.id, space.id);
  }
  double outside_m2 = area_outside_m2(copy.task_m, *space.shell);
  for (const ZoneText& zone : copy.zones) outside_m2 += area_outside_m2(zone.area_m, *space.shell);
  if (outside_m2 == 0.0) return;
  reader.report(DiagnosticId::copy_outside_room, reader.where("step"), copy.id, outside_m2,
                space.id);
}

// The first copy is there.
void add_copies(const Copies& copies, ElementReader& reader, const Space& space,
                std::vector<Workplace>& workplaces) {
  const Workplace first = workplaces.back();
  workplaces.pop_back();
  for (int row = 0; row < copies.rows; ++row) {
    for (int column = 0; column < copies.columns; ++column) {
      const std::string index = fmt::format("[{},{}]", column, row);
      Workplace copy = moved(first, copies.step_m * glm::dvec2(column, row));
      copy.id += index;
      if (!copy.was.empty()) copy.was += index;
      if (!copy.name.empty()) copy.name += " " + index;
      copy.is_further_copy = column > 0 || row > 0;
      check_copy(reader, copy, space);
      if (!reader.ok()) copy.is_good = false;
      workplaces.push_back(std::move(copy));
      if (!reader.ok()) return;
    }
  }
}

}  // namespace

void read_workplaces(ProjectContext& context, const XmlElement& room,
                     const PlaneSurroundings& surroundings, Space& space) {
  std::map<std::string, int> line_of_id;
  FormerIds former("workplace");
  for (const XmlElement& child : room.children) {
    const bool is_grid = child.name == "workplace-grid";
    if (child.name != "workplace" && !is_grid) continue;
    ElementReader reader(child, context.diagnostics);
    Workplace workplace = WorkplaceReader(context, surroundings, space, former).read(reader);
    if (surroundings.source != RoomSource::prism) {
      reader.report(DiagnosticId::workplace_needs_room, child.where);
    }
    const auto [first, is_new] = line_of_id.try_emplace(workplace.id, child.where.line);
    if (!is_new && !workplace.id.empty()) {
      reader.report(DiagnosticId::duplicate_id, reader.where("id"), "workplace", workplace.id,
                    first->second);
    }
    const Copies copies = is_grid ? read_copies(context, reader) : Copies();
    workplace.is_good = surroundings.room_is_good && reader.ok();
    space.workplaces.push_back(std::move(workplace));
    if (is_grid && space.workplaces.back().is_good) {
      add_copies(copies, reader, space, space.workplaces);
    }
  }
  former.check(context.diagnostics);
}

}  // namespace calc
