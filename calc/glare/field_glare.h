#pragma once
// The glare rating GR of outdoor areas and sports grounds.  [CIE 112]
//
//   GR = 27 + 24 log10(L_vl / L_ve^0.9)
//   L_vl = 10 sum of E_eye / theta^2, theta in degrees from the line of sight: the luminaires' veil
//   L_ve = 0.035 rho E_av / pi: that of the field, as of a diffuse surface everywhere
//
// 10 is hardly noticed, 50 just admissible, 90 unbearable. Neither the text of the standard nor
// that of EN 12193 on observers was at hand: formula and numbers are those on which programs and
// handbooks agree. Where they leave a choice, the interval holds all readings:
//   - eyes look in eight directions, 45 degrees apart; or in 24, as associations require;
//   - luminaires count up to 60 degrees from the line of sight, as in threshold increments; or all
//     in front of the eye;
//   - nearer to it than 1.5 degrees they count as at 1.5 degrees; or as they are.
// Luminaires are points here, and nothing hides them: possible obstacles make the lower end open.

#include "calc/base/field.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

inline constexpr double kFieldEye_m = 1.5;     // above the field
inline constexpr double kFieldLook_deg = 2.0;  // below the horizon

// Most eyes times luminaires, because more take minutes before anything is judged.
inline constexpr double kMostFieldPairs = 5.0e6;

// Returns the highest veiling luminance of new luminaires, cd/m2, for eyes above these points of a
// level field; 0 without light. along: the field's first axis, horizontal, unit: the first
// direction of view. scene: null, or one of the project's.
Estimate field_veiling(const Project& project, const Space& space, const LightScene* scene,
                       const std::vector<glm::dvec3>& points_m, const glm::dvec3& along);

// Returns GR; negative infinity without a veil. average_lx > 0: mean illuminance of the field;
// reflectance: of it, (0, 1].
double field_glare(double veiling_cd_m2, double average_lx, double reflectance);

}  // namespace calc
