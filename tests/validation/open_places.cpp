#include "tests/validation/open_places.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace validation {

using namespace cli::selftest;

namespace {

constexpr int kGauss = 4;

struct Place1D {
  double at, weight;
};

struct Special {
  double at, finest;
};

void add_cells(double low, double high, const std::vector<Special>& specials,
               std::vector<Place1D>& places) {
  double allowed = std::numeric_limits<double>::infinity();
  for (const Special& s : specials) {
    const double distance = std::max({low - s.at, s.at - high, 0.0});
    allowed = std::min(allowed, s.finest + 0.5 * distance);
  }
  if (high - low > allowed) {
    const double middle = 0.5 * (low + high);
    add_cells(low, middle, specials, places);
    add_cells(middle, high, specials, places);
    return;
  }
  const GaussRule rule = gauss_rule(kGauss);
  for (std::size_t k = 0; k < rule.at.size(); ++k) {
    places.push_back({low + rule.at[k] * (high - low), rule.weight[k] * (high - low)});
  }
}

std::vector<Place1D> places_along(const glm::dvec3& corner, const glm::dvec3& side,
                                  const std::vector<HotSpot>& hot, double edge_m, double rim_m) {
  const double length = glm::length(side);
  std::vector<Special> specials;
  for (const HotSpot& spot : hot) {
    specials.push_back({glm::dot(spot.position_m - corner, side) / length, spot.finest_m});
  }
  if (edge_m > 0.0) {
    specials.push_back({0.0, edge_m});
    specials.push_back({length, edge_m});
  }
  std::vector<Place1D> places;
  add_cells(rim_m, length - rim_m, specials, places);
  if (rim_m > 0.0) {
    places.push_back({0.5 * rim_m, rim_m});
    places.push_back({length - 0.5 * rim_m, rim_m});
  }
  return places;
}

}  // namespace

std::vector<Triangle> split_triangle(const Triangle& whole, int levels) {
  std::vector<Triangle> parts{whole};
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : parts) {
      const glm::dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    parts = std::move(finer);
  }
  return parts;
}

double Places::sum_m2() const { return std::accumulate(area_m2.begin(), area_m2.end(), 0.0); }

void Places::add(const Places& more) {
  point.insert(point.end(), more.point.begin(), more.point.end());
  area_m2.insert(area_m2.end(), more.area_m2.begin(), more.area_m2.end());
}

Places places_on(const Rectangle& rectangle, const std::vector<HotSpot>& hot, double edge_m,
                 double rim_m) {
  Places places;
  const glm::dvec3 u = glm::normalize(rectangle.u), v = glm::normalize(rectangle.v);
  const std::vector<Place1D> along_v =
      places_along(rectangle.corner, rectangle.v, hot, edge_m, rim_m);
  for (const Place1D& s : places_along(rectangle.corner, rectangle.u, hot, edge_m, rim_m)) {
    for (const Place1D& t : along_v) {
      places.point.push_back({rectangle.corner + s.at * u + t.at * v, rectangle.normal});
      places.area_m2.push_back(s.weight * t.weight);
    }
  }
  return places;
}

Places places_on_polygon(const std::vector<glm::dvec3>& corners, int levels) {
  Places places;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Triangle whole{corners[0], corners[k], corners[k + 1]};
    const glm::dvec3 across = glm::cross(whole[1] - whole[0], whole[2] - whole[0]);
    const std::vector<Triangle> parts = split_triangle(whole, levels);
    for (const Triangle& part : parts) {
      for (std::size_t i = 0; i < 3; ++i) {
        places.point.push_back(
            {(part[0] + part[1] + part[2] + 3.0 * part[i]) / 6.0, glm::normalize(across)});
        places.area_m2.push_back(glm::length(across) / 6.0 / static_cast<double>(parts.size()));
      }
    }
  }
  return places;
}

Places places_on_disc(const glm::dvec3& centre_m, double radius_m, const glm::dvec3& normal,
                      int rings, int around) {
  Places places;
  const glm::dvec3 aside = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, aside)), v = glm::cross(normal, u);
  const GaussRule rule = gauss_rule(rings);
  for (std::size_t k = 0; k < rule.at.size(); ++k) {
    const double r = radius_m * std::sqrt(rule.at[k]);
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * calc::kPi * (i + 0.5) / around;
      places.point.push_back(
          {centre_m + r * calc::cos(angle) * u + r * calc::sin(angle) * v, normal});
      places.area_m2.push_back(calc::kPi * radius_m * radius_m * rule.weight[k] / around);
    }
  }
  return places;
}

}  // namespace validation
