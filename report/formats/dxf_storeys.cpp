#include "report/formats/dxf_storeys.h"

#include "report/document/storeys.h"
#include "report/formats/dxf_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace report {
namespace {

// Whether a box can be laid out: a file may hold any numbers.
bool is_near(const FlatBox& box) {
  constexpr double kFarthest_m = 1e7;
  return !box.is_empty() && box.low.x >= -kFarthest_m && box.low.y >= -kFarthest_m &&
         box.high.x <= kFarthest_m && box.high.y <= kFarthest_m;
}

void add_box(const FlatBox& other, FlatBox& box) {
  if (other.is_empty()) return;
  box.add(other.low);
  box.add(other.high);
}

// Of a room from a mesh file no floor is known but its lowest line.
double floor_of(const SpacePart& space) {
  if (!space.footprint_m.empty() || space.surface_lines_m.empty()) return space.floor_z_m;
  double lowest_m = space.surface_lines_m.front().z;
  for (const glm::dvec3& end : space.surface_lines_m) lowest_m = std::min(lowest_m, end.z);
  return lowest_m;
}

// Of the height; below all storeys it is the lowest one.
std::size_t storey_at(const std::vector<DxfStorey>& storeys, double floor_z_m) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < storeys.size(); ++i) {
    if (storeys[i].floor_z_m <= floor_z_m) at = i;
  }
  return at;
}

// The storey on whose floor roads and outdoor areas are.
std::size_t ground_storey(const ProjectPart& project, const std::vector<std::size_t>& outdoors,
                          const std::vector<DxfStorey>& storeys) {
  std::optional<double> lowest_m;
  for (const std::size_t space : outdoors) {
    for (const PlanePart& plane : project.spaces[space].planes)
      lowest_m = std::min(lowest_m.value_or(plane.grid.origin_m.z), plane.grid.origin_m.z);
  }
  if (!lowest_m) return 0;
  const auto nearest =
      std::min_element(storeys.begin(), storeys.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.floor_z_m - *lowest_m) < std::abs(b.floor_z_m - *lowest_m);
      });
  return static_cast<std::size_t>(nearest - storeys.begin());
}

// Whether a room of one storey lies above a room of another (is_other), or of its own.
bool any_overlap(const ProjectPart& project, const std::vector<std::size_t>& storey_of,
                 bool is_other) {
  const std::vector<SpacePart>& spaces = project.spaces;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((storey_of[i] != storey_of[k]) == is_other && overlap_in_plan(spaces[i], spaces[k]))
        return true;
    }
  }
  return false;
}

}  // namespace

FlatBox drawn_box(const SpacePart& space) {
  FlatBox box;
  for (const glm::dvec2& corner : space.footprint_m) box.add(corner);
  for (const LuminaireMark& mark : space.luminaires) {
    box.add(mark.position_m);
    for (const glm::dvec2& corner : mark.outline_m) box.add(corner);
  }
  for (const glm::dvec3& end : space.surface_lines_m) box.add(end);
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) {
      for (const glm::dvec2& end : line) box.add(end);
    }
  }
  for (const PlanePart& plane : space.planes) add_box(drawn_box(plane), box);
  return box;
}

FlatBox drawn_box(const ProjectPart& project) {
  FlatBox box;
  for (const SpacePart& space : project.spaces) add_box(drawn_box(space), box);
  return box;
}

DxfStoreys::DxfStoreys(const ProjectPart& project)
    : first_(project.spaces.data()), storey_of_(project.spaces.size(), 0) {
  const Storeys found = storeys_of(project);
  if (found.list.empty()) return;
  storeys_.clear();
  for (const Storey& storey : found.list) {
    if (storeys_.empty() || storey.floor_z_m - storeys_.back().floor_z_m >= kStoreyStep_m)
      storeys_.push_back({storey.floor_z_m, {}, 0.0});
    for (const std::size_t room : storey.rooms) storey_of_[room] = storeys_.size() - 1;
  }
  for (const auto* rooms : {&found.overlapping, &found.without_outline}) {
    for (const std::size_t room : *rooms)
      storey_of_[room] = storey_at(storeys_, floor_of(project.spaces[room]));
  }
  const std::size_t ground = ground_storey(project, found.outdoors, storeys_);
  for (const std::size_t space : found.outdoors) storey_of_[space] = ground;
  if (storeys_.size() > 1 && !any_overlap(project, storey_of_, true)) {
    storeys_.resize(1);
    std::fill(storey_of_.begin(), storey_of_.end(), 0);
  }
  for (std::size_t i = 0; i < project.spaces.size(); ++i) {
    const FlatBox box = drawn_box(project.spaces[i]);
    if (is_near(box)) {
      add_box(box, storeys_[storey_of_[i]].box);
    } else {
      storey_of_[i] = 0;
    }
  }
}

std::size_t DxfStoreys::storey_of(const SpacePart& space) const {
  return storey_of_[static_cast<std::size_t>(&space - first_)];
}

void DxfStoreys::put_beside(double least_width_m) {
  constexpr double kShare = 0.1, kLeast_m = 2.0;
  double largest_m = 0.0;
  for (const DxfStorey& storey : storeys_) {
    if (!storey.box.is_empty()) largest_m = std::max(largest_m, storey.box.longest());
  }
  const double gap_m = std::max(kLeast_m, kShare * largest_m);
  std::optional<double> right_m;
  for (DxfStorey& storey : storeys_) {
    if (storey.box.is_empty()) continue;
    const double left_m = storey.box.low.x;
    // Whole metres, so that it is easy to move the storey back.
    if (right_m) storey.shift_m = std::max(0.0, std::ceil(*right_m + gap_m - left_m));
    right_m = std::max(storey.box.high.x, left_m + least_width_m) + storey.shift_m;
  }
}

std::string DxfStoreys::layer(std::string_view name, std::size_t storey) const {
  constexpr std::size_t kMostBytes = 31, kMostStoreys = 99;
  if (!are_apart()) return std::string(name);
  const std::string whole = fmt::format("{}_S{}", name, std::min(storey + 1, kMostStoreys));
  return whole.size() <= kMostBytes ? whole : std::string(name);
}

bool has_overlap_in_storey(const ProjectPart& project, const DxfStoreys& storeys) {
  std::vector<std::size_t> storey_of;
  for (const SpacePart& space : project.spaces) storey_of.push_back(storeys.storey_of(space));
  return any_overlap(project, storey_of, false);
}

}  // namespace report
