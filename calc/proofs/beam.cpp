#include "calc/proofs/beam.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>

namespace calc {
namespace {

// Directions are rounded to float when they become rays (6e-8), and an arc cosine near 0 loses half
// its digits.
constexpr double kAngleSlack_rad = 1.0e-6;
// 90 degrees from a file, in radians.
constexpr double kHalfSpaceSlack_rad = 1.0e-9;

// Planes (C) x gammas as cells; an axial table is one cell all the way round.
class Cells {
 public:
  explicit Cells(const PhotometricWeb& web) : web_(web), c_rad_(web.c_rad()) {
    if (web.is_axial()) c_rad_.push_back(2.0 * kPi);
    for (const double gamma : web.gamma_rad()) {
      sin_.push_back(calc::sin(gamma));
      cos_.push_back(calc::cos(gamma));
    }
  }

  std::size_t planes() const { return c_rad_.size() - 1; }
  std::size_t gammas() const { return web_.gamma_rad().size() - 1; }
  double from_c_rad(std::size_t plane) const { return c_rad_[plane]; }
  double to_c_rad(std::size_t plane) const { return c_rad_[plane + 1]; }

  // Sum of the cell's corners; > 0 exactly if some direction in it is lit.
  double light(std::size_t plane, std::size_t gamma) const {
    const std::size_t next = web_.is_axial() ? 0 : plane + 1;
    return web_.table_cd(plane, gamma) + web_.table_cd(plane, gamma + 1) +
           web_.table_cd(next, gamma) + web_.table_cd(next, gamma + 1);
  }

  // Least cosine between the axis and a direction in a lit cell. On a cell the cosine is
  //   sin g A cos(C - phi) - a_z cos g,
  // least in C where cos(C - phi) is, whatever g is (sin g >= 0); then in g at an end or where its
  // derivative vanishes.
  double least_cosine(const glm::dvec3& axis) const {
    const double across = calc::hypot(axis.x, axis.y);
    const double phi = calc::atan2(axis.y, axis.x);
    double least = 1.0;
    for (std::size_t p = 0; p < planes(); ++p) {
      const double side = across * least_cosine_between(from_c_rad(p) - phi, to_c_rad(p) - phi);
      const double turning_rad = calc::atan2(side, -axis.z) + kPi;  // in [0, 2 pi]
      for (std::size_t g = 0; g < gammas(); ++g) {
        if (light(p, g) <= 0.0) continue;
        least = std::min(
            {least, side * sin_[g] - axis.z * cos_[g], side * sin_[g + 1] - axis.z * cos_[g + 1]});
        if (turning_rad >= web_.gamma_rad()[g] && turning_rad <= web_.gamma_rad()[g + 1]) {
          least = std::min(least, -calc::hypot(side, axis.z));
        }
      }
    }
    return std::max(least, -1.0);
  }

  glm::dvec3 mean_direction() const {
    glm::dvec3 sum(0.0);
    for (std::size_t p = 0; p < planes(); ++p) {
      const double c = 0.5 * (from_c_rad(p) + to_c_rad(p)), width = to_c_rad(p) - from_c_rad(p);
      const glm::dvec3 outward(calc::cos(c), calc::sin(c), 0.0);
      for (std::size_t g = 0; g < gammas(); ++g) {
        const double solid_angle = width * (cos_[g] - cos_[g + 1]);
        const double s = 0.5 * (sin_[g] + sin_[g + 1]), z = 0.5 * (cos_[g] + cos_[g + 1]);
        sum += light(p, g) * solid_angle * (s * outward - glm::dvec3(0.0, 0.0, z));
      }
    }
    return sum;
  }

  // First and last gamma of any lit cell.
  std::array<double, 2> gamma_range_rad() const {
    std::array<double, 2> range{kPi, 0.0};
    for (std::size_t p = 0; p < planes(); ++p) {
      for (std::size_t g = 0; g < gammas(); ++g) {
        if (light(p, g) <= 0.0) continue;
        range[0] = std::min(range[0], web_.gamma_rad()[g]);
        range[1] = std::max(range[1], web_.gamma_rad()[g + 1]);
      }
    }
    return range;
  }

 private:
  static double least_cosine_between(double from_rad, double to_rad) {
    const double half_turns = std::ceil((from_rad / kPi - 1.0) / 2.0);  // first pi + 2 pi k >= from
    if (kPi * (1.0 + 2.0 * half_turns) <= to_rad) return -1.0;
    return std::min(calc::cos(from_rad), calc::cos(to_rad));
  }

  const PhotometricWeb& web_;
  std::vector<double> c_rad_, sin_, cos_;
};

// A plane through the opening's centre with the unit normal: do all corners lie behind it?
bool all_behind(const PlacedLuminaire& luminaire, std::span<const glm::dvec3> corners,
                const glm::dvec3& normal, double clearance_m) {
  const double limit_m =
      glm::dot(normal, luminaire.position_m) - opening_support_m(luminaire, normal) - clearance_m;
  return std::all_of(corners.begin(), corners.end(),
                     [&](const glm::dvec3& c) { return glm::dot(normal, c) <= limit_m; });
}

struct PolarCorner {
  double along_m, across_m, angle_rad;
};

// Searches planes tangent to a cone narrower than a half-space. Every plane tried is verified, so
// that the choice of those tried proves nothing by itself; it holds the ends of every corner's
// range of tangent planes that have it behind, and thus an end of the common range, if there is
// one.
bool tangent_plane_separates(const Beam& beam, const PlacedLuminaire& luminaire,
                             std::span<const glm::dvec3> corners, double side_m) {
  const double angle = beam.half_angle_rad + kAngleSlack_rad;
  const double sine = calc::sin(angle), cosine = calc::cos(angle);
  const glm::dvec3 aside = std::abs(beam.axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(beam.axis, aside));
  const glm::dvec3 y = glm::cross(beam.axis, x);
  const auto separates = [&](double phi) {
    const glm::dvec3 normal = sine * beam.axis + cosine * (calc::cos(phi) * x + calc::sin(phi) * y);
    return all_behind(luminaire, corners, normal, side_m);
  };

  const double opening_m = 0.5 * glm::length(luminaire.opening.size_m());
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : corners) middle += corner - luminaire.position_m;
  if (separates(calc::atan2(-glm::dot(middle, y), -glm::dot(middle, x)))) return true;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 d = corner - luminaire.position_m;
    const double along_m = glm::dot(d, beam.axis);
    const double across_m = calc::hypot(glm::dot(d, x), glm::dot(d, y));
    // sine * along + cosine * across * cos(phi - phi_k) <= -clear
    const double needed = -(sine * along_m + side_m + opening_m);
    if (needed < -cosine * across_m) return false;  // no tangent plane has it behind
    if (needed >= cosine * across_m) continue;      // every one has
    const double phi_k = calc::atan2(glm::dot(d, y), glm::dot(d, x));
    const double range_end = calc::acos(needed / (cosine * across_m));
    constexpr double kNudge_rad = 1.0e-9;
    if (separates(phi_k + range_end + kNudge_rad) || separates(phi_k - range_end - kNudge_rad)) {
      return true;
    }
  }
  return false;
}

bool lies_in_dark_cone(const Beam& beam, const PlacedLuminaire& luminaire,
                       std::span<const glm::dvec3> corners, double side_m) {
  const double angle = kPi - beam.half_angle_rad - kAngleSlack_rad;
  if (!(angle > 0.0)) return false;
  const double opening_m = 0.5 * glm::length(luminaire.opening.size_m());
  const double sine = calc::sin(angle), cosine = calc::cos(angle);
  return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
    const glm::dvec3 d = corner - luminaire.position_m;
    const double along_m = -glm::dot(d, beam.axis);
    const double across_m = glm::length(glm::cross(d, beam.axis));
    return along_m * sine - across_m * cosine >= opening_m + side_m;
  });
}

}  // namespace

namespace {

// In the frame of the table.
Beam beam_about_table(const PhotometricWeb& web) {
  const Cells cells(web);
  const auto [first_rad, last_rad] = cells.gamma_range_rad();
  Beam beam{{0.0, 0.0, -1.0}, last_rad};
  if (kPi - first_rad < beam.half_angle_rad) beam = {{0.0, 0.0, 1.0}, kPi - first_rad};
  if (web.is_axial()) return beam;

  const glm::dvec3 mean = cells.mean_direction();
  if (!(glm::length(mean) > 0.0)) return beam;
  const glm::dvec3 axis = glm::normalize(mean);
  const double half_angle_rad = calc::acos(cells.least_cosine(axis)) + kAngleSlack_rad;
  // A symmetric beam's mean is a pole up to rounding: the pole itself is then the better axis.
  if (half_angle_rad < beam.half_angle_rad) beam = {axis, half_angle_rad};
  return beam;
}

}  // namespace

Beam beam_of(const PhotometricWeb& web) {
  Beam beam = beam_about_table(web);
  const auto axis = web.from_table({beam.axis.x, beam.axis.y, beam.axis.z});
  beam.axis = {axis[0], axis[1], axis[2]};
  return beam;
}

std::vector<Beam> beams_of(const PreparedScene& scene) {
  std::map<const PhotometricWeb*, Beam> beam_of_web;
  std::vector<Beam> beams;
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    const auto [entry, is_new] = beam_of_web.try_emplace(luminaire.web);
    if (is_new) entry->second = beam_of(*luminaire.web);
    beams.push_back(
        {luminaire.world_from_luminaire * entry->second.axis, entry->second.half_angle_rad});
  }
  return beams;
}

bool beam_misses(const Beam& beam, const PlacedLuminaire& luminaire,
                 std::span<const glm::dvec3> corners, const BeamClearance& clearance) {
  if (beam.half_angle_rad > 0.5 * kPi + kHalfSpaceSlack_rad) {
    return lies_in_dark_cone(beam, luminaire, corners, clearance.side_m);
  }
  if (all_behind(luminaire, corners, beam.axis, clearance.plane_m)) return true;
  if (beam.half_angle_rad > 0.5 * kPi - 2.0 * kAngleSlack_rad) return false;
  return tangent_plane_separates(beam, luminaire, corners, clearance.side_m);
}

double opening_support_m(const PlacedLuminaire& luminaire, const glm::dvec3& direction) {
  const glm::dvec3 along = glm::abs(glm::transpose(luminaire.world_from_luminaire) * direction);
  return 0.5 * glm::dot(along, luminaire.opening.size_m());
}

}  // namespace calc
