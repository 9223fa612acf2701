#pragma once
// Places of a project's storeys in a drawing: beside each other if rooms overlap in plan, else all
// at their true places.

#include "report/document/document.h"
#include "report/html/drawings/flat_box.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns the box of everything drawn of a space at its true place; empty if there is nothing.
FlatBox drawn_box(const SpacePart& space);
FlatBox drawn_box(const ProjectPart& project);

// Lowest first.
struct DxfStorey {
  double floor_z_m = 0.0;
  FlatBox box;           // of its spaces at their true places
  double shift_m = 0.0;  // along x, in whole metres; 0: at its true place
};

class DxfStoreys {
 public:
  DxfStoreys() = default;
  // Storeys are apart if their floors differ by kStoreyStep_m and a room of one is above a room of
  // another. Rooms of one height stay together, even if they overlap. Roads and outdoor areas
  // belong to the storey with the floor nearest to their lowest plane. Rooms without a usable
  // outline belong to the storey at their height. Anything more than 10,000 km away belongs to the
  // lowest storey and takes no place.
  explicit DxfStoreys(const ProjectPart& project);

  // Returns the number of storeys that are apart; else 1.
  std::size_t count() const { return storeys_.size(); }
  bool are_apart() const { return count() > 1; }
  const DxfStorey& operator[](std::size_t storey) const { return storeys_[storey]; }
  // Returns the storey of a space of the project.
  std::size_t storey_of(const SpacePart& space) const;

  // Puts storeys that are apart beside each other: the lowest at its true place, each other to the
  // right of the storey below unless it is there already. The gap is a tenth of the largest extent
  // of a storey, 2 m at least. least_width_m: of each, for its title.
  void put_beside(double least_width_m);

  // Returns the layer for a storey: "LUX_ROOMS_S2"; the layer itself if storeys are not apart or
  // R12 has no room for the name. Storeys from the 99th on share their layers.
  std::string layer(std::string_view name, std::size_t storey) const;

 private:
  const SpacePart* first_ = nullptr;    // of the project
  std::vector<std::size_t> storey_of_;  // by space
  std::vector<DxfStorey> storeys_ = std::vector<DxfStorey>(1);
};

// Returns whether a room overlaps another room of its storey.
bool has_overlap_in_storey(const ProjectPart& project, const DxfStoreys& storeys);

}  // namespace report
