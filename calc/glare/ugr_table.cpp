#include "calc/glare/ugr_table.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/glare/position_index.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

constexpr int kPlanes = 180, kZones = 180;  // 2 degrees of C, half a degree of gamma

// From an eye that looks along y to a luminaire: its C0-C180 points to the eye where it is looked
// at crosswise, its C90-C270 where it is endwise.
glm::dmat3 room_from_luminaire(UgrView view) {
  constexpr glm::dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
  return view == UgrView::crosswise ? glm::dmat3(-kY, kX, kZ) : glm::dmat3(-kX, -kY, kZ);
}

}  // namespace

double opposite_rectangles_share(double x, double y) {
  const double x1 = std::sqrt(1.0 + x * x), y1 = std::sqrt(1.0 + y * y);
  const double sum = calc::log(x1 * y1 / std::sqrt(1.0 + x * x + y * y)) +
                     x * y1 * calc::atan(x / y1) + y * x1 * calc::atan(y / x1) - x * calc::atan(x) -
                     y * calc::atan(y);
  return 2.0 * sum / (kPi * x * y);
}

UgrLuminaire::UgrLuminaire(const PhotometricWeb& web, const glm::dmat3& room_from_luminaire)
    : luminance_(web), luminaire_from_room_(glm::transpose(room_from_luminaire)) {
  downward_.reserve(std::size_t{kPlanes} * kZones);
  for (int zone = 0; zone < kZones; ++zone) {
    const double low = 0.5 * kPi * zone / kZones, high = 0.5 * kPi * (zone + 1) / kZones;
    const double gamma = 0.5 * (low + high);
    const double solid_angle = (calc::cos(low) - calc::cos(high)) * 2.0 * kPi / kPlanes;
    const double sine = calc::sin(gamma), cosine = calc::cos(gamma), tangent = sine / cosine;
    for (int plane = 0; plane < kPlanes; ++plane) {
      const double angle = 2.0 * kPi * (plane + 0.5) / kPlanes;
      const double x = calc::cos(angle), y = calc::sin(angle);
      const double flux =
          luminance_.intensity_cd(luminaire_from_room_ * glm::dvec3(sine * x, sine * y, -cosine)) *
          solid_angle;
      down_lm_ += flux;
      downward_.push_back({tangent * std::abs(x), tangent * std::abs(y), flux});
    }
  }
  const bool is_upside_down = room_from_luminaire[2].z < 0.0;
  all_lm_ = down_lm_ + (is_upside_down ? web.zonal_flux_lm(0.0, 0.5 * kPi)
                                       : web.zonal_flux_lm(0.5 * kPi, kPi));
}

UgrLuminaire UgrLuminaire::from_a_quarter_turn() const {
  UgrLuminaire turned = *this;
  turned.luminaire_from_room_ =
      luminaire_from_room_ * glm::dmat3({0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  for (Piece& piece : turned.downward_) std::swap(piece.across, piece.along);
  return turned;
}

UgrArray UgrLuminaire::in_room(double x_per_h, double y_per_h, double spacing_per_h) const {
  const Room room{x_per_h, y_per_h};
  // Of luminaires that stand evenly and densely: a ray that ends so far beside where it began meets
  // the floor from that share of the places.
  double floor_lm = 0.0;
  for (const Piece& piece : downward_) {
    floor_lm += piece.flux_lm * std::max(0.0, 1.0 - piece.across / room.x) *
                std::max(0.0, 1.0 - piece.along / room.y);
  }
  UgrArray array{room.x, room.y};
  if (!(all_lm_ > 0.0)) return array;
  array.flux_lm = all_lm_;
  array.to_floor = floor_lm / all_lm_;
  array.to_walls = (down_lm_ - floor_lm) / all_lm_;
  array.to_ceiling = 1.0 - down_lm_ / all_lm_;
  if (!has_area()) return array;
  const glm::dvec3 look(0.0, 1.0, 0.0);
  double sum = 0.0;
  for (double along = 0.5 * spacing_per_h; along < room.y; along += spacing_per_h) {
    for (double across = 0.5 * spacing_per_h; across < 0.5 * room.x; across += spacing_per_h) {
      for (const double side : {-across, across}) {
        const std::optional<double> index = guth_index({side, along, 1.0}, look);
        if (!index) continue;
        const glm::dvec3 to_eye(-side, -along, -1.0);
        const double r2 = glm::dot(to_eye, to_eye);
        const glm::dvec3 out = luminaire_from_room_ * (to_eye / std::sqrt(r2));
        const double cd = luminance_.intensity_cd(out);
        const double area_m2 = luminance_.area_m2(out);
        if (area_m2 > 0.0) sum += cd * cd / (area_m2 * r2 * *index * *index);
      }
    }
  }
  array.sources = sum * spacing_per_h * spacing_per_h / (room.x * room.y);
  return array;
}

double UgrArray::background(const UgrReflectances& reflectances) const {
  const double wall_area = 2.0 * (x_per_h + y_per_h);
  const Shares direct{to_floor, to_walls, to_ceiling};
  return flux_lm / wall_area * indirect_on_walls(direct, {x_per_h, y_per_h}, reflectances) / kPi;
}

double ugr_of(double sources, double background) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!(sources > 0.0)) return -kInfinite;
  if (!(background > 0.0)) return kInfinite;
  return 8.0 * calc::log10(0.25 * sources / background);
}

std::optional<std::vector<UgrRow>> ugr_table(const PhotometricWeb& web, double spacing_per_h) {
  const std::array<UgrLuminaire, kUgrViews> luminaires{
      UgrLuminaire(web, room_from_luminaire(UgrView::crosswise)),
      UgrLuminaire(web, room_from_luminaire(UgrView::endwise))};
  if (!luminaires[0].has_area()) return std::nullopt;
  std::vector<UgrRow> table;
  for (const Room& room : kRooms) {
    UgrRow row{room.x, room.y, {}};
    for (std::size_t view = 0; view < kUgrViews; ++view) {
      const UgrArray array = luminaires[view].in_room(room.x, room.y, spacing_per_h);
      for (std::size_t k = 0; k < kUgrReflectances.size(); ++k) {
        const double ugr = ugr_of(array.sources, array.background(kUgrReflectances[k]));
        row.ugr[view][k] = std::isfinite(ugr) ? ugr : std::numeric_limits<double>::quiet_NaN();
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
