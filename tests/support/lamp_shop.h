#pragma once
// Luminaires of every kind that light paths start from.

#include "calc/base/units.h"
#include "calc/photometry/web.h"
#include "calc/radiosity/sampling/random.h"
#include "tests/support/scenes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_support {

// Planes of unlike width and light, one of them dark, gammas from `first_gamma` on.
inline calc::PhotometricWeb crooked_web(calc::LuminousOpening opening,
                                        calc::TableAxis axis = calc::TableAxis::vertical,
                                        double first_gamma = 0.0, double least_cd = 0.0) {
  const std::vector<double> c{0.0, 0.4, 1.5, 3.0, 3.1, 5.0, 2.0 * calc::kPi};
  std::vector<double> gamma;
  for (int k = 0; k <= 9; ++k) {
    gamma.push_back(std::min(calc::kPi, first_gamma + (calc::kPi - first_gamma) * k * k / 81.0));
  }
  std::vector<double> cd;
  for (std::size_t plane = 0; plane < c.size(); ++plane) {
    for (std::size_t g = 0; g < gamma.size(); ++g) {
      const std::size_t p = plane + 1 == c.size() ? 0 : plane;
      const double u = calc::RandomKey(17).with(p).with(g).uniform();
      cd.push_back(p == 2 || g == 4 ? 0.0 : least_cd + (100.0 - least_cd) * u * u);
    }
  }
  return calc::PhotometricWeb::make(c, gamma, cd, opening, {}, axis);
}

// With so much light at the least where there is any, crooked light has no beams that want small
// parts of an opening (calc::has_fine_beams()).
inline constexpr double kNoBeams_cd = 90.0;

// Eight openings under eight webs, to be hung up where there is room.
inline std::vector<calc::PhotometricWeb> lamp_shop(double least_cd = 0.0) {
  using Shape = calc::OpeningShape;
  using Axis = calc::TableAxis;
  std::vector<calc::PhotometricWeb> webs;
  const auto crooked = [least_cd](calc::LuminousOpening opening, Axis axis = Axis::vertical,
                                  double first_gamma = 0.0) {
    return crooked_web(opening, axis, first_gamma, least_cd);
  };
  webs.push_back(lambert_web(300.0, 18));
  webs.push_back(lambert_web(300.0, 1, {Shape::rectangle, 0.5, 0.3, 0.0}));
  webs.push_back(crooked({Shape::disk, 0.4, 0.2, 0.0}));
  webs.push_back(crooked({Shape::box, 0.3, 0.2, 0.1}));
  webs.push_back(crooked({Shape::cylinder, 0.2, 0.3, 0.15}, Axis::lateral));
  webs.push_back(crooked({Shape::cylinder_c0, 0.4, 0.2, 0.1}));
  webs.push_back(crooked({Shape::cylinder_c90, 0.1, 0.3, 0.2}, Axis::lateral, 0.3));
  // A table that begins so late has light in a ring, which is a beam.
  webs.push_back(
      crooked({Shape::ellipsoid, 0.3, 0.1, 0.2}, Axis::vertical, least_cd > 0.0 ? 0.3 : 1.2));
  return webs;
}

// Turned about all axes.
inline glm::dmat3 tilted_axes(double a, double b) {
  const glm::dmat3 about_z{
      {std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}};
  const glm::dmat3 about_x{
      {1, 0, 0}, {0, std::cos(b), std::sin(b)}, {0, -std::sin(b), std::cos(b)}};
  return about_z * about_x;
}

// A hall with boxes and a sphere, every lamp of the shop hung up in it, in two channels.
struct LampHall {
  std::vector<calc::PhotometricWeb> webs;
  calc::PreparedScene scene;

  explicit LampHall(double reflectance = 0.6, bool is_open = false, double least_cd = 0.0)
      : webs(lamp_shop(least_cd)) {
    scene.channels = {{"", 1.0}, {"second", 0.8}};
    if (is_open) {
      add_quad(scene, {-4, -3, 0}, {8, 0, 0}, {0, 6, 0}, reflectance);
      add_quad(scene, {-4, -3, 0}, {0, 6, 0}, {0, 0, 3}, reflectance);
    } else {
      add_box(scene, {-4, -3, 0}, {8, 6, 3.5}, reflectance);
    }
    add_box(scene, {-3, -2, 0}, {1, 1.5, 0.8}, 0.3);
    add_box(scene, {1, 1, 0.2}, {0.8, 0.6, 1.4}, 0.0);
    add_sphere(scene, 0.4, 2, 0.8);
    for (std::size_t k = 0; k < webs.size(); ++k) {
      const auto x = static_cast<double>(k % 4), y = static_cast<double>(k / 4);
      add_luminaire(scene, webs[k], {2.0 * x - 3.0, 3.0 * y - 1.5, 2.6});
      calc::PlacedLuminaire& lamp = scene.luminaires.back();
      lamp.channel = k % 3 == 0 ? 1u : 0u;
      lamp.flux_scale = 0.7 + 0.1 * static_cast<double>(k);
      if (k > 1) lamp.world_from_luminaire = tilted_axes(0.3 * static_cast<double>(k), 0.4);
    }
    set_extent(scene);
  }
};

}  // namespace test_support
