#include "calc/project/spaces/upright_task.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace calc {
namespace {

constexpr double kRounding_m = 1.0e-6;  // of places that are written to be on a wall

// Infinite if there is none.
double way_to_wall_m(const std::vector<glm::dvec2>& outline, glm::dvec2 place, glm::dvec2 way) {
  const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 corner = outline[i], side = outline[(i + 1) % outline.size()] - corner;
    const double slope = cross(way, side);
    if (slope == 0.0) continue;
    const double way_m = cross(corner - place, side) / slope;
    const double along_side = cross(corner - place, way) / slope;
    if (way_m >= 0.0 && along_side >= 0.0 && along_side <= 1.0) {
      nearest_m = std::min(nearest_m, way_m);
    }
  }
  return nearest_m;
}

// In plan.
struct Foot {
  explicit Foot(const UprightTask& task)
      : along(task.area.u),
        front(task.area.u.y, -task.area.u.x),
        from(task.area.origin_m),
        length_m(task.area.outline_m[1].x),
        to(from + length_m * along),
        top(glm::dvec2(task.area.v) * task.area.outline_m[2].y) {}

  glm::dvec2 along, front;
  glm::dvec2 from;
  double length_m;
  glm::dvec2 to, top;  // top: of the upper edge from the lower one
};

// A little in front of it, so that a wall that it is on is not in the way.
double way_m(const Foot& foot, const RoomShell& room, glm::dvec2 way) {
  const glm::dvec2 middle = 0.5 * (foot.from + foot.to) + 10.0 * kRounding_m * foot.front;
  return way_to_wall_m(room.footprint_m, middle, way);
}

struct Heights {
  double low_m, high_m;
};

class UprightReader {
 public:
  UprightReader(const ProjectContext& context, ElementReader& reader, const RoomPlan& room)
      : unit_m_(context.metres_per_unit), reader_(reader), room_(room) {}

  std::optional<UprightTask> on_wall() {
    const int number = reader_.integer("wall", 1);
    if (!reader_.ok()) return std::nullopt;
    const std::size_t count = room_.corners_m.size();
    const auto wall = static_cast<std::size_t>(number - 1);
    if (wall >= count) {
      out_of_range("wall", fmt::format("the number of a wall of the room, 1 to {}", count));
      return std::nullopt;
    }
    const Rectangle whole = room_.wall(wall);
    const double length_m = glm::length(whole.u_m);
    std::vector<double> along_m{0.0, length_m};
    if (reader_.has("along")) along_m = pair("along", length_m, "the wall's length");
    const std::optional<Heights> heights = read_heights(Heights{0.0, room_.height_m});
    if (along_m.empty() || !heights) return std::nullopt;
    const glm::dvec3 u = whole.u_m / length_m;
    UprightTask task =
        made(whole.origin_m + along_m[0] * u, u, along_m[1] - along_m[0], *heights, 0.0);
    task.wall = wall;
    return task;
  }

  std::optional<UprightTask> on_its_own() {
    const std::vector<double> ends = reader_.numbers("face", 4, "4 numbers (x y x y)");
    if (!reader_.has("heights")) reader_.text("heights");  // reports its absence
    const double lean_deg = reader_.number_or("lean", kLean, 0.0);
    if (!reader_.ok()) return std::nullopt;
    const std::optional<Heights> heights = read_heights({});
    if (!heights) return std::nullopt;
    const glm::dvec2 from = glm::dvec2(ends[0], ends[1]) * unit_m_ + glm::dvec2(room_.origin_m);
    const glm::dvec2 to = glm::dvec2(ends[2], ends[3]) * unit_m_ + glm::dvec2(room_.origin_m);
    const double length_m = glm::length(to - from);
    if (!(length_m > kRounding_m)) {
      out_of_range("face", "two different points");
      return std::nullopt;
    }
    UprightTask task = made(glm::dvec3(from, room_.origin_m.z),
                            glm::dvec3((to - from) / length_m, 0.0), length_m, *heights, lean_deg);
    if (lies_within(task, room_.shell())) return task;
    out_of_range("face",
                 "a face within the room that looks into the room; its ends go from left to "
                 "right as seen from the front");
    return std::nullopt;
  }

 private:
  void out_of_range(const char* name, const std::string& allowed) {
    reader_.report(DiagnosticId::number_out_of_range, reader_.where(name), name,
                   reader_.element().name, reader_.text(name), allowed);
  }

  // Ascending, from 0 to `most_m`; empty after an error.
  std::vector<double> pair(const char* name, double most_m, const char* what) {
    std::vector<double> ends = reader_.numbers(name, 2, "2 numbers (from, to)", kNonNegative);
    if (!reader_.ok()) return {};
    for (double& end : ends) end *= unit_m_;
    if (ends[0] < ends[1] && ends[1] <= most_m + kRounding_m) {
      return {ends[0], std::min(ends[1], most_m)};
    }
    out_of_range(name,
                 fmt::format("two ascending numbers from 0 to {} {:.10g}", what, most_m / unit_m_));
    return {};
  }

  std::optional<Heights> read_heights(std::optional<Heights> otherwise) {
    if (!reader_.has("heights")) return otherwise;
    const std::vector<double> ends = pair("heights", room_.height_m, "the room's height");
    if (ends.empty()) return std::nullopt;
    return Heights{ends[0], ends[1]};
  }

  // foot_m: on the floor, below the left end of the lower edge.
  static UprightTask made(const glm::dvec3& foot_m, const glm::dvec3& u, double length_m,
                          Heights heights, double lean_deg) {
    const double lean_rad = radians_from_degrees(lean_deg);
    const double upwards = lean_deg > 0.0 ? calc::cos(lean_rad) : 1.0;
    const double back = lean_deg > 0.0 ? calc::sin(lean_rad) : 0.0;
    const double height_m = (heights.high_m - heights.low_m) / upwards;
    UprightTask task;
    task.low_m = heights.low_m;
    task.high_m = heights.high_m;
    task.area.origin_m = foot_m + glm::dvec3(0.0, 0.0, heights.low_m);
    task.area.u = u;
    task.area.v = glm::dvec3(-back * u.y, back * u.x, upwards);
    task.area.outline_m = {{0.0, 0.0}, {length_m, 0.0}, {length_m, height_m}, {0.0, height_m}};
    return task;
  }

  double unit_m_;
  ElementReader& reader_;
  const RoomPlan& room_;
};

}  // namespace

bool lies_within(const UprightTask& task, const RoomShell& room) {
  const std::vector<glm::dvec2>& outline = room.footprint_m;
  const auto is_inside = [&](glm::dvec2 place) {
    return contains_point(outline, place) || distance_to_boundary(outline, place) <= kRounding_m;
  };
  constexpr double kStep_m = 0.01, kSame_m = 1.0e-4;
  const Foot foot(task);
  const glm::dvec2 before = 0.5 * (foot.from + foot.to) + kStep_m * foot.front;
  const double half_m = 0.5 * foot.length_m - kSame_m;
  return is_inside(foot.from) && is_inside(foot.to) && is_inside(foot.from + foot.top) &&
         is_inside(foot.to + foot.top) && contains_point(outline, before) &&
         way_m(foot, room, foot.along) >= half_m && way_m(foot, room, -foot.along) >= half_m;
}

RoomBeside room_beside(const UprightTask& task, const RoomShell& room) {
  const Foot foot(task);
  const double upwards = task.area.v.z;
  RoomBeside beside;
  beside.from_m.x = std::min(0.0, 0.5 * foot.length_m - way_m(foot, room, -foot.along));
  beside.to_m.x = std::max(foot.length_m, 0.5 * foot.length_m + way_m(foot, room, foot.along));
  beside.from_m.y = -task.low_m / upwards;
  beside.to_m.y = (room.height_m - task.low_m) / upwards;
  return beside;
}

std::optional<UprightTask> read_upright_task(const ProjectContext& context, ElementReader& reader,
                                             const PlaneSurroundings& around) {
  const bool is_on_wall = reader.has("wall"), is_on_its_own = reader.has("face");
  if (!is_on_wall && !is_on_its_own) {
    for (const char* name : {"along", "heights", "lean"}) {
      if (!reader.has(name)) continue;
      reader.report(DiagnosticId::missing_form, reader.where(name), reader.element().name,
                    fmt::format("'wall' or 'face' beside '{}'", name));
    }
    return std::nullopt;
  }
  const char* form = is_on_wall ? "wall" : "face";
  bool is_clear = reader.exclude("wall", "face");
  for (const char* other : {"size", "footprint", "height", is_on_wall ? "lean" : "along"}) {
    is_clear = reader.exclude(form, other) && is_clear;
  }
  if (!is_clear || !around.room_is_good || around.room == nullptr) return std::nullopt;
  UprightReader upright(context, reader, *around.room);
  return is_on_wall ? upright.on_wall() : upright.on_its_own();
}

}  // namespace calc
