#pragma once
// The light on a straight, flat road by EN 13201-3:2015 / CIE 140: luminance as drivers see it,
// glare and the light beside the carriageway. Only luminaires and the road: nothing reflects,
// nothing obstructs.
//
// Frame of a road, right-handed: x along it in the direction of traffic of lanes that are not
// oncoming, y across it to the left of that direction, z up. y = 0 is the right edge of the
// carriageway, y = width its left one; the field is 0 <= x <= spacing, between two luminaires of
// one row. A lane with oncoming traffic is judged by an eye that looks to -x.
//
// The text of the standard was not at hand; rules are those on which public programs and papers
// agree. Where they differ, an Estimate's value is the reading named first here, and low to high
// are the hull of all readings:
//   - the eye is 60 m before x = 0; or before the first points (Lav, Uo, Ul, and TI by its Lav);
//   - TI omits luminaires above a plane through the eye, which rises by 20 degrees along the road;
//     or those at more than 20 degrees of elevation;
//   - TI's eye starts before the first luminaire: of the row with the least shift, and of rows
//     side by side the worst; or of any other row. Its start depends on the height of that row;
//   - illuminance counts luminaires within 5 H along and across; or around the point (REI).

#include "calc/base/field.h"
#include "calc/photometry/web.h"
#include "calc/road/r_table.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace calc {

// A row of equal luminaires at x = shift + k * spacing for all whole k.
struct RoadRow {
  const PhotometricWeb* web = nullptr;
  double factor = 1.0;       // of its intensities, new: flux, dimming; >= 0, times them <= 1e30 cd
  double maintenance = 1.0;  // (0, 1]
  double height_m = 0.0;  // of the photometric centre above the road; above 1.5, the eye's, to 1000
  double y_m = 0.0;       // within 1e4
  double shift_m = 0.0;   // [0, spacing)
  // Columns: C0, C90 and -axis, orthonormal, as Luminaire::world_from_luminaire.
  glm::dmat3 road_from_luminaire{1.0};
};

struct RoadLayout {
  double spacing_m = 0.0;  // 1 to 10 000; of every row. The time taken grows with 500 m / spacing
  double width_m = 0.0;    // above 0, to 1000
  int lanes = 0;           // 1 to 100, equally wide
  std::vector<bool> is_oncoming;  // one per lane, from the right edge
  const RTable* table = nullptr;
  double q0 = 0.0;  // of this road's surface, (0, 1]: scales the table by q0 / table->q0
  // Width beside an edge, in (0, width]: by the standard one lane, less where there is less space.
  // nullopt: there is none to judge.
  std::optional<double> right_strip_m, left_strip_m;
  std::vector<RoadRow> rows;  // the result does not depend on their order, but for rounding
};

// The points at all pairs of x and y.
struct RoadGrid {
  std::vector<double> x_m, y_m;  // ascending

  std::size_t along() const { return x_m.size(); }
  std::size_t across() const { return y_m.size(); }
};

struct RoadObserver {
  int lane = 0;  // 0 = at the right edge
  bool is_oncoming = false;
  glm::dvec3 eye_m{0.0};  // 60 m before its end of the field
  // Maintained luminance over the whole carriageway: the mean, and the least by the mean. nullopt:
  // the road is dark.
  Estimate average_cd_m2;
  std::optional<Estimate> uo;
  // The least by the largest luminance on the lane's middle line; nullopt: that line is dark.
  std::optional<Estimate> ul;
  // For new luminaires: the highest veiling luminance of its series, and its TI. nullopt: the mean
  // luminance is not above 0.05 cd/m^2, where the formula ends.
  Estimate veiling_cd_m2;
  std::optional<Estimate> ti_percent;
  std::vector<double> cd_m2;  // [across][along] of RoadLight::grid, maintained; value's reading
};

struct RoadLight {
  RoadGrid grid;                        // of luminance
  std::vector<RoadObserver> observers;  // one per lane, from the right edge; the worst counts
  // Maintained mean illuminance of the strip outside an edge over that of a strip of the same width
  // inside (REI, EIR). nullopt: no strip is required, or the inner one is dark.
  std::optional<Estimate> right_ratio, left_ratio;
};

// Returns the light. Violations of the limits above are bugs (callers check what users write):
// throws std::logic_error, as do the next two functions.
RoadLight road_light(const RoadLayout& layout);

// Returns rows of points along the road for luminance, three to a lane.
RoadGrid road_luminance_grid(const RoadLayout& layout);

// The luminaires that count for illuminance: 5 H along and across, or within a circle of 5 H.
enum class RoadReach { square, circle };

// Maintained horizontal illuminance at 0 m of a strip at any place, from_y < to_y, both within 1e4:
// at least three rows of points and at most 1.5 m between them. [across][along]
struct RoadIlluminance {
  RoadGrid grid;
  std::vector<double> lx;

  double mean_lx() const;
};
RoadIlluminance road_illuminance(const RoadLayout& layout, double from_y_m, double to_y_m,
                                 RoadReach reach = RoadReach::square);

// --- single steps, for tests and explanations; these check nothing ------------------------------

struct RoadLevel {
  double maintained = 0.0, initial = 0.0;
};
// Returns a point's luminance for an eye that looks along +x; both in plan, at different places.
RoadLevel road_luminance_cd_m2(const RoadLayout& layout, const glm::dvec2& point_m,
                               const glm::dvec2& eye_m);
// Returns the maintained, horizontal illuminance at 0 m.
double road_point_illuminance_lx(const RoadLayout& layout, const glm::dvec2& point_m,
                                 RoadReach reach = RoadReach::square);

// Veiling luminance of new luminaires, for an eye of 23 years that looks along +x and 1 degree
// down, by the kind of screening.
struct RoadVeiling {
  double by_plane_cd_m2 = 0.0, by_elevation_cd_m2 = 0.0;
};
RoadVeiling road_veiling(const RoadLayout& layout, const glm::dvec3& eye_m);

// Returns TI (2015 edition) for new luminaires. nullopt: the mean is not above 0.05 cd/m^2.
std::optional<double> threshold_increment_percent(double veiling_cd_m2, double average_cd_m2);

}  // namespace calc
