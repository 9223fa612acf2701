#include "calc/radiosity/ugr_table.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/radiosity/glare.h"
#include "calc/radiosity/mean_luminance.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

struct Room {
  double x, y;  // in H
};
constexpr std::array<Room, 19> kRooms{{{2, 2},
                                       {2, 3},
                                       {2, 4},
                                       {2, 6},
                                       {2, 8},
                                       {2, 12},
                                       {4, 2},
                                       {4, 3},
                                       {4, 4},
                                       {4, 6},
                                       {4, 8},
                                       {4, 12},
                                       {8, 4},
                                       {8, 6},
                                       {8, 8},
                                       {8, 12},
                                       {12, 4},
                                       {12, 6},
                                       {12, 8}}};

// Flux of the luminaire that falls directly on each surface, as shares of all.
struct Shares {
  double floor = 0.0, walls = 0.0, ceiling = 0.0;
};

// The light below the horizon in small pieces of the sphere, along C0 and C90.
struct Pieces {
  struct Piece {
    double along_c0, along_c90;  // tan(gamma) times the cosine and sine of C: how far from below
    double flux_lm;
  };
  std::vector<Piece> downward;
  double down_lm = 0.0, all_lm = 0.0;
};

Pieces pieces_of(const PhotometricWeb& web) {
  constexpr int kPlanes = 180, kZones = 180;  // 2 degrees of C, half a degree of gamma
  Pieces pieces;
  pieces.downward.reserve(std::size_t{kPlanes} * kZones);
  for (int zone = 0; zone < kZones; ++zone) {
    const double low = 0.5 * kPi * zone / kZones, high = 0.5 * kPi * (zone + 1) / kZones;
    const double gamma = 0.5 * (low + high);
    const double solid_angle = (calc::cos(low) - calc::cos(high)) * 2.0 * kPi / kPlanes;
    const double tangent = calc::sin(gamma) / calc::cos(gamma);
    for (int plane = 0; plane < kPlanes; ++plane) {
      const double c = 2.0 * kPi * (plane + 0.5) / kPlanes;
      const double flux = web.intensity_cd(c, gamma) * solid_angle;
      pieces.down_lm += flux;
      pieces.downward.push_back(
          {tangent * std::abs(calc::cos(c)), tangent * std::abs(calc::sin(c)), flux});
    }
  }
  pieces.all_lm = pieces.down_lm + web.zonal_flux_lm(0.5 * kPi, kPi);
  return pieces;
}

// Of luminaires that stand evenly and densely under a ceiling of X by Y: a ray that ends `a` and
// `b` beside where it began meets the floor from that share of the places.
Shares shares_of(const Pieces& pieces, const Room& room, UgrView view) {
  const bool is_crosswise = view == UgrView::crosswise;
  double floor_lm = 0.0;
  for (const Pieces::Piece& piece : pieces.downward) {
    const double along_y = is_crosswise ? piece.along_c0 : piece.along_c90;
    const double along_x = is_crosswise ? piece.along_c90 : piece.along_c0;
    floor_lm += piece.flux_lm * std::max(0.0, 1.0 - along_x / room.x) *
                std::max(0.0, 1.0 - along_y / room.y);
  }
  Shares shares;
  shares.floor = floor_lm / pieces.all_lm;
  shares.walls = (pieces.down_lm - floor_lm) / pieces.all_lm;
  shares.ceiling = 1.0 - pieces.down_lm / pieces.all_lm;
  return shares;
}

// What arrives at the walls after reflections, as a share of all flux.
double indirect_on_walls(const Shares& direct, const Room& room, const UgrReflectances& rho) {
  const double floor_area = room.x * room.y, wall_area = 2.0 * (room.x + room.y);
  const double opposite = opposite_rectangles_share(room.x, room.y);  // floor to ceiling
  const double to_walls = 1.0 - opposite;
  const double from_walls = to_walls * floor_area / wall_area;  // to floor, and to ceiling
  const double between_walls = 1.0 - 2.0 * from_walls;
  // Arriving flux: f = direct_f + rho_w from_walls w + rho_c opposite c, and so on. Floor and
  // ceiling from w:
  //   f - rho_c opposite c = a,  c - rho_f opposite f = b
  // are linear in w; what remains is one equation for w.
  const double det = 1.0 - rho.floor * rho.ceiling * opposite * opposite;
  const auto floor_of = [&](double a, double b) { return (a + rho.ceiling * opposite * b) / det; };
  const auto ceiling_of = [&](double a, double b) { return (b + rho.floor * opposite * a) / det; };
  const double floor_0 = floor_of(direct.floor, direct.ceiling);
  const double ceiling_0 = ceiling_of(direct.floor, direct.ceiling);
  const double per_w = rho.walls * from_walls;
  const double floor_1 = floor_of(per_w, per_w), ceiling_1 = ceiling_of(per_w, per_w);
  const double at_0 = to_walls * (rho.floor * floor_0 + rho.ceiling * ceiling_0);
  const double at_1 = to_walls * (rho.floor * floor_1 + rho.ceiling * ceiling_1);
  const double walls = (direct.walls + at_0) / (1.0 - rho.walls * between_walls - at_1);
  return walls - direct.walls;
}

// Sum of L^2 w / p^2 with H = 1: cd^2 sr / m^4 times H^2.
double sources(const MeanLuminance& luminaire, const Room& room, double spacing, UgrView view) {
  const glm::dvec3 look(0.0, 1.0, 0.0);
  double sum = 0.0;
  for (double along = 0.5 * spacing; along < room.y; along += spacing) {
    for (double across = 0.5 * spacing; across < 0.5 * room.x; across += spacing) {
      for (const double side : {-across, across}) {
        const std::optional<double> index = guth_index({side, along, 1.0}, look);
        if (!index) continue;
        // Towards the eye, in the luminaire's axes: C0 is turned to it where it is crosswise.
        const glm::dvec3 to_eye = view == UgrView::crosswise ? glm::dvec3(along, side, -1.0)
                                                             : glm::dvec3(side, along, -1.0);
        const double r2 = glm::dot(to_eye, to_eye);
        const glm::dvec3 out = to_eye / std::sqrt(r2);
        const double cd = luminaire.intensity_cd(out);
        const double area_m2 = luminaire.area_m2(out);
        if (!(area_m2 > 0.0)) continue;
        sum += cd * cd / (area_m2 * r2 * *index * *index);
      }
    }
  }
  return sum;
}

}  // namespace

double opposite_rectangles_share(double x, double y) {
  const double x1 = std::sqrt(1.0 + x * x), y1 = std::sqrt(1.0 + y * y);
  const double sum = calc::log(x1 * y1 / std::sqrt(1.0 + x * x + y * y)) +
                     x * y1 * calc::atan(x / y1) + y * x1 * calc::atan(y / x1) - x * calc::atan(x) -
                     y * calc::atan(y);
  return 2.0 * sum / (kPi * x * y);
}

std::optional<std::vector<UgrRow>> ugr_table(const PhotometricWeb& web, double spacing_per_h) {
  const MeanLuminance luminaire(web);
  if (!luminaire.has_area()) return std::nullopt;
  const Pieces pieces = pieces_of(web);
  std::vector<UgrRow> table;
  for (const Room& room : kRooms) {
    UgrRow row{room.x, room.y, {}};
    const double luminaires = room.x * room.y / (spacing_per_h * spacing_per_h);
    const double wall_area = 2.0 * (room.x + room.y);
    for (const UgrView view : {UgrView::crosswise, UgrView::endwise}) {
      const double sum = sources(luminaire, room, spacing_per_h, view);
      const Shares direct = shares_of(pieces, room, view);
      for (std::size_t k = 0; k < kUgrReflectances.size(); ++k) {
        const double walls_lx = luminaires * pieces.all_lm / wall_area *
                                indirect_on_walls(direct, room, kUgrReflectances[k]);
        const double background = walls_lx / kPi;
        row.ugr[static_cast<std::size_t>(view)][k] =
            sum > 0.0 && background > 0.0 ? 8.0 * calc::log10(0.25 * sum / background)
                                          : std::numeric_limits<double>::quiet_NaN();
      }
    }
    table.push_back(row);
  }
  return table;
}

const UgrRow& ugr_reference_row(const std::vector<UgrRow>& table) {
  return *std::find_if(table.begin(), table.end(),
                       [](const UgrRow& row) { return row.x_per_h == 4.0 && row.y_per_h == 8.0; });
}

}  // namespace calc
