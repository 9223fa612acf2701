#pragma once
// One colour scale for all planes of a room, or of a project, so that drawings can be compared.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/images/heatmap.h"
#include "report/text/texts.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace report {

// The planes that share their colours.
enum class ScaleSharing { project, room, plane };

// Returns a plane's own scale, with its limits unless they would compress the colours.
ColourScale own_scale(const PlanePart& plane);

struct PlaneScale {
  ColourScale scale;
  ScaleSharing among = ScaleSharing::plane;  // plane: it is the plane's own
};
// Returns "One colour scale for all planes of the project."
std::string_view sharing_words(const Texts& t, ScaleSharing sharing);

// Planes of the same unit share a scale: bands of equal width, or classes (make_class_scale()) if
// they give more colours to the plane with the fewest; finer classes if it would still have only
// one. Planes with less than a tenth of the brightest value, such as emergency light beside a
// workplace, would have one colour and get their own scale.
class ColourScales {
 public:
  ColourScales() = default;  // every plane has its own
  ColourScales(const ProjectPart& project, ScaleSharing sharing,
               ColourMap map = ColourMap::cividis);

  // Returns the scale of a plane. space, plane: of the project; the plane has cells and all values.
  PlaneScale of(const SpacePart& space, const PlanePart& plane) const;

 private:
  using Key = std::pair<std::string, std::string>;  // room, "" = all; unit
  Key key_of(const SpacePart& space, const PlanePart& plane) const;

  ScaleSharing sharing_ = ScaleSharing::plane;
  ColourMap map_ = ColourMap::cividis;
  struct Shared {
    ColourScale scale;
    double highest = 0.0;  // of all planes
  };
  std::map<Key, Shared> shared_;
};

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::ScaleSharing> {
  static constexpr EnumName<report::ScaleSharing> list[] = {
      {report::ScaleSharing::project, "project"},
      {report::ScaleSharing::room, "room"},
      {report::ScaleSharing::plane, "plane"}};
};

}  // namespace calc
