#pragma once
// The mean luminance of a luminaire: its intensity over the area of its opening as seen from far
// away, L = I / A.  [EN 12464-1, luminances of luminaires; CIE 190]

#include "calc/photometry/web.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

namespace calc {

class MeanLuminance {
 public:
  // web: must outlive this. A flat opening counts with its sides, however low they are: light is
  // calculated as flat there (calc/CONVENTIONS.md), but seen from the side they are much of the
  // area.
  explicit MeanLuminance(const PhotometricWeb& web);

  // False of a point, which has none.
  bool has_area() const { return luminaire_.opening.shape != OpeningShape::point; }
  // towards: unit, in the frame of web.h; m2, 0 edge-on.
  double area_m2(const glm::dvec3& towards) const;
  double intensity_cd(const glm::dvec3& towards) const;
  // Not a number without area.
  double luminance_cd_m2(double c_rad, double gamma_rad) const;

 private:
  PlacedLuminaire luminaire_;
};

}  // namespace calc
