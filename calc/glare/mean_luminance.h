#pragma once
// The mean luminance of a luminaire: its intensity over the area of its opening as seen from far
// away, L = I / A.  [EN 12464-1, luminances of luminaires; CIE 190]

#include "calc/photometry/web.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

namespace calc {

class MeanLuminance {
 public:
  // web: must outlive this. A flat opening counts with its sides, however low: the calculation of
  // light takes it as flat (calc/CONVENTIONS.md), but from the side they are much of the area.
  explicit MeanLuminance(const PhotometricWeb& web);

  // Returns false for a point, which has no area.
  bool has_area() const { return luminaire_.opening.shape != OpeningShape::point; }
  // Returns the area, m2, 0 edge-on. towards: unit, in the frame of web.h.
  double area_m2(const glm::dvec3& towards) const;
  double intensity_cd(const glm::dvec3& towards) const;
  // Returns the luminance; not a number without area.
  double luminance_cd_m2(double c_rad, double gamma_rad) const;

 private:
  PlacedLuminaire luminaire_;
};

}  // namespace calc
