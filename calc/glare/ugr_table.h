#pragma once
// The table of unified glare ratings of a type of luminaire in rooms of standard shape, in which
// makers state glare, for a regular array of it.  [CIE 117; CIE 190]
//
// A room is X (across the line of sight) by Y (along it), in multiples of H, the height of the
// luminaires above the eye. The eye is in the middle of a wall that is X long and looks along Y;
// luminaires are at half a spacing from the walls. UGR is as in glare.h:
//   - every source counts as for an eye far away, by the closed form of the position index;
//   - an opening counts with its sides (mean_luminance.h);
//   - L_b = E_w / pi with E_w the mean indirect illuminance of the walls, by the exact exchange of
//     light between three surfaces: the walls, the luminaires' plane (ceiling) and the eye's plane
//     (floor). The method chooses this: at an eye it is different, and such a table is no
//     substitute for it.
// H cancels out. Compared with tables of three luminaires by other programs this is within 0.4 of
// Relux and 0.8 of DIALux, which differ by as much from each other:
// tests/unit/calc/radiosity/ugr_table_test.

#include "calc/glare/mean_luminance.h"
#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace calc {

struct UgrReflectances {
  double ceiling, walls, floor;
};
inline constexpr std::array<UgrReflectances, 5> kUgrReflectances{
    {{0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2}, {0.3, 0.3, 0.2}}};

// The spacing of luminaires in makers' tables, in multiples of H (others: 1, as CIE 190's own
// example).
inline constexpr double kUgrSpacing = 0.25;

// A room with an even array of one luminaire: the light of each, for H = 1 m. Sum and background
// both fall with H^2, so that only their ratio counts, in a mixture of arrays, too.
struct UgrArray {
  double x_per_h = 0.0, y_per_h = 0.0;
  double sources = 0.0;                                     // sum of L^2 w / p^2, cd^2 sr / m^4
  double flux_lm = 0.0;                                     // of the luminaire
  double to_floor = 0.0, to_walls = 0.0, to_ceiling = 0.0;  // shares of it that go there directly

  // Returns L_b, cd / m^2.
  double background(const UgrReflectances& reflectances) const;
};

// A luminaire that hangs in a fixed way, seen by an eye that looks along the second axis of a
// room's frame (x across, y along, z up).
class UgrLuminaire {
 public:
  // room_from_luminaire: a rotation about z, or upside down. web must outlive this.
  UgrLuminaire(const PhotometricWeb& web, const glm::dmat3& room_from_luminaire);

  bool has_area() const { return luminance_.has_area(); }
  // Returns it as seen by an eye turned left by a right angle, with the room's frame.
  UgrLuminaire from_a_quarter_turn() const;
  // Returns the array in a room. x and y in multiples of H, > 0; spacing_per_h: of the array, in
  // (0, 2]. Without area no sources.
  UgrArray in_room(double x_per_h, double y_per_h, double spacing_per_h = kUgrSpacing) const;

 private:
  // The light below the horizon in small pieces of the sphere.
  struct Piece {
    double across, along;  // tan(gamma) times the cosine and sine of its angle in plan
    double flux_lm;
  };

  MeanLuminance luminance_;
  glm::dmat3 luminaire_from_room_;
  std::vector<Piece> downward_;
  double down_lm_ = 0.0, all_lm_ = 0.0;
};

// Returns UGR of a sum and a background: -infinity if the sum is 0, infinity if the background is.
double ugr_of(double sources, double background);

// The difference of other programs' tables from these, and from each other.
inline constexpr double kUgrTablesDiffer = 0.8;

// The eye's direction of view: along the luminaires' C0-C180 (across the longer side of most), or
// along C90-C270.
enum class UgrView : std::size_t { crosswise, endwise };
inline constexpr std::size_t kUgrViews = 2;

struct UgrRow {
  double x_per_h = 0.0, y_per_h = 0.0;
  // [view][reflectances]; not a number where no luminaire is in the field of view with an area.
  std::array<std::array<double, kUgrReflectances.size()>, kUgrViews> ugr{};
};

// Returns the 19 rooms of such tables, by X, then Y; values for the flux of the web. spacing_per_h:
// of the luminaires, in (0, 2]. Empty: the opening has no area, so that there is no luminance.
std::optional<std::vector<UgrRow>> ugr_table(const PhotometricWeb& web,
                                             double spacing_per_h = kUgrSpacing);

// Returns the row in data sheets: X = 4 H, Y = 8 H, reflectances 0.7, 0.5 and 0.2.
const UgrRow& ugr_reference_row(const std::vector<UgrRow>& table);

// Returns the share of the light from one of two equal, opposite rectangles X by Y at the distance
// 1 that reaches the other.  [closed form, e.g. Howell, C-11]
double opposite_rectangles_share(double x, double y);

}  // namespace calc
