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

// Among whom a plane shares its colours.
enum class ScaleSharing { project, room, plane };

// A plane's own scale, with its limits where these do not squeeze the colours.
ColourScale own_scale(const PlanePart& plane);

struct PlaneScale {
  ColourScale scale;
  ScaleSharing among = ScaleSharing::plane;  // plane: it is the plane's own
};
// "One colour scale for all planes of the project."
std::string_view sharing_words(const Texts& t, ScaleSharing sharing);

// Planes share a scale that are of one unit: bands of equal width, or classes (make_class_scale())
// where those give the plane that has the fewest colours more of them; finer classes where it would
// be of one colour all the same. What is far below the
// brightest of them (less than a tenth, as emergency light is of a workplace's) would be of one
// colour, and has a scale of its own.
class ColourScales {
 public:
  ColourScales() = default;  // every plane has its own
  ColourScales(const ProjectPart& project, ScaleSharing sharing,
               ColourMap map = ColourMap::cividis);

  // space, plane: of the project. The plane has cells, and all values.
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
