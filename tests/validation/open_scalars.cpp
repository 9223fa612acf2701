#include "tests/validation/open_scalars.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/scene/prepared_scene.h"
#include "tests/validation/open_grid.h"
#include "tests/validation/open_places.h"
#include "tests/validation/open_scene.h"
#include "tests/validation/open_sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace validation {

using namespace cli::selftest;

namespace {

// Relative: quadrature over points, and interpolation in photometric tables.
constexpr double kDirectKnownTo = 5e-4, kTotalKnownTo = 1e-3;
constexpr double kWidest = 0.2;

bool starts_with(const std::string& text, const std::string& with) {
  return text.rfind(with, 0) == 0;
}

std::optional<double> rho_of(const std::string& name) {
  double rho = 0.0;
  return std::sscanf(name.c_str(), "rho=%lf", &rho) == 1 ? std::optional(rho) : std::nullopt;
}

// About the same number of reflections whatever is absorbed.
std::uint64_t paths_for(double absorbed) {
  const double wanted = std::clamp(4096.0 * absorbed, 16.0, 1024.0);
  return std::uint64_t{1} << static_cast<int>(calc::log2(wanted));
}

bool is_direct(const Row& row) {
  return starts_with(row.at("quantity"), "average direct") ||
         row.at("quantity") == "flux on all faces" || row.at("quantity") == "form factor";
}

Part part_of(const Row& row) {
  if (is_direct(row)) return Part::direct;
  return row.at("quantity").find("indirect") != std::string::npos ? Part::indirect : Part::total;
}

bool is_part_of(const std::string& surface, const std::string& name) {
  if (name == "all" || name == "sum" || name == "face" || rho_of(name)) return true;
  return surface == name || (name == "walls" && starts_with(surface, "wall"));
}

class Scalars {
 public:
  Scalars(const Row& row, const Tables& tables, const Effort& effort)
      : row_(row), id_(row.at("case_id")), tables_(tables), effort_(effort) {}

  ScalarResult run() {
    const std::vector<Row> rows = rows_of(tables_.scalars, id_);
    if (starts_with(id_, "FF-")) {
      form_factors(rows);
    } else if (starts_with(id_, "SPH-")) {
      spheres(rows);
    } else if (starts_with(id_, "SPOT-")) {
      circles(rows);
    } else {
      averages(rows);
      grids(rows);
    }
    return std::move(out_);
  }

 private:
  void add(const Row& row, const Solution& solution, const std::vector<double>& weights, Part part,
           double known_to) {
    const std::string& table = row.at("value_linear_table");
    out_.result.add_sum(solution, row.at("name") + ": " + row.at("quantity"), row.at("unit"),
                        weights, number(row, table.empty() ? "value" : "value_linear_table"),
                        known_to, kWidest, part);
    if (solution.problem.empty()) out_.printed.push_back(row.at("printed"));
  }

  void leave_out(const Row& row, const std::string& why) {
    out_.left_out.push_back(row.at("name") + ": " + row.at("quantity") + ": " + why);
  }

  static std::vector<double> times(std::vector<double> weights, double factor) {
    for (double& w : weights) w *= factor;
    return weights;
  }

  Places places_of(const Row& surface, double edge_share, double rim_m) const {
    const std::vector<glm::dvec3> corners = corners_of(surface);
    const std::optional<Rectangle> face = rectangle_of(corners);
    if (!face) return places_on_polygon(corners, 4);
    std::vector<HotSpot> hot;
    for (const glm::dvec3& lamp : lamps_of(id_, tables_)) {
      const double height_m = std::abs(glm::dot(lamp - face->corner, face->normal));
      if (height_m > 1e-6) hot.push_back({lamp, height_m});
    }
    return places_on(*face, hot, edge_share * std::min(glm::length(face->u), glm::length(face->v)),
                     rim_m);
  }

  // Averages over surfaces, for every reflectance that rows name.
  void averages(const std::vector<Row>& rows) {
    std::vector<Row> wanted;
    for (const Row& row : rows) {
      const std::string& quantity = row.at("quantity");
      if (quantity.find("lumped") != std::string::npos) {
        leave_out(row, "a number of solvers with one value a surface, not of the room");
      } else if (starts_with(quantity, "average") || quantity == "flux on all faces" ||
                 quantity == "form factor") {
        wanted.push_back(row);
      }
    }
    while (!wanted.empty()) {
      const auto same = [&](const Row& row) {
        return rho_of(row.at("name")) == rho_of(wanted[0].at("name")) &&
               is_direct(row) == is_direct(wanted[0]);
      };
      const auto rest = std::stable_partition(wanted.begin(), wanted.end(), same);
      std::vector<Row> group(wanted.begin(), rest);
      wanted.erase(wanted.begin(), rest);
      averages_of_one_room(group);
    }
  }

  void averages_of_one_room(const std::vector<Row>& rows) {
    // Direct light alone: nothing reflects.
    const std::optional<double> rho =
        is_direct(rows[0]) ? std::optional(0.0) : rho_of(rows[0].at("name"));
    const Scene scene = open_scene(id_, tables_, rho);
    // No point too close to the surface around the corner.
    const double rim_m =
        2.2 * calc::prepare_scene(scene.project(), scene.project().spaces[0]).ray_offset_m();
    Places all;
    std::vector<std::pair<std::string, std::size_t>> ends;
    double exitance = 0.0, largest_rho = rho.value_or(0.0);
    for (const Row& surface : rows_of(tables_.surfaces, id_)) {
      exitance = std::max(exitance, number(surface, "exitance_lm_m2"));
      if (!rho) largest_rho = std::max(largest_rho, number(surface, "reflectance"));
    }
    for (const Row& surface : rows_of(tables_.surfaces, id_)) {
      all.add(places_of(surface, exitance > 0.0 ? 0.25 : 0.0, rim_m));
      ends.emplace_back(surface.at("surface"), all.point.size());
    }
    Effort effort = effort_;
    effort.paths = paths_for(1.0 - largest_rho);
    const Solution solution = solve(scene, all.point, effort);
    for (const Row& row : rows) {
      std::vector<double> weights(all.point.size(), 0.0);
      double area_m2 = 0.0;
      for (std::size_t s = 0, first = 0; s < ends.size(); first = ends[s].second, ++s) {
        const bool counts = row.at("quantity") == "form factor"
                                ? ends[s].first == "floor"
                                : is_part_of(ends[s].first, row.at("name"));
        for (std::size_t i = first; counts && i < ends[s].second; ++i) {
          weights[i] = all.area_m2[i];
          area_m2 += all.area_m2[i];
        }
      }
      double scale = 1.0 / area_m2;
      if (row.at("quantity") == "flux on all faces") scale = 1.0;
      if (row.at("quantity") == "form factor") scale /= exitance;
      add(row, solution, times(weights, scale), part_of(row),
          is_direct(row) ? kDirectKnownTo : kTotalKnownTo);
    }
  }

  // A shines, B is black; two cases have no tables.
  void form_factors(const std::vector<Row>& rows) {
    if (id_ == "FF-O9") {  // discs of radius 1 m, 1 m apart
      Scene scene;
      scene.add_luminaire(lambert_web(1.0, {calc::OpeningShape::disk, 2.0, 2.0, 0.0}), {0, 0, 1});
      return factor_of_disc(rows, scene, calc::kPi);
    }
    if (id_ == "FF-O10") {  // a sphere of .25 m, its centre .5 m above a disc of 1 m
      Scene scene;
      scene.add_luminaire(isotropic_web(1.0, {calc::OpeningShape::ellipsoid, 0.5, 0.5, 0.5}),
                          {0, 0, 0.5});
      return factor_of_disc(rows, scene, 4.0 * calc::kPi);
    }
    const std::vector<Row> surfaces = rows_of(tables_.surfaces, id_);
    if (surfaces.size() != 2) throw NotCovered("no two surfaces A and B");
    const Scene scene = open_scene(id_, tables_, std::nullopt);
    const std::vector<glm::dvec3> a = corners_of(surfaces[0]), b = corners_of(surfaces[1]);
    const bool touch = std::any_of(a.begin(), a.end(), [&](const glm::dvec3& corner) {
      return std::find(b.begin(), b.end(), corner) != b.end();
    });
    const Places places = places_of(surfaces[1], touch ? 1.0 / 32.0 : 0.25, 0.0);
    const double emitted_lm =
        number(surfaces[0], "exitance_lm_m2") * places_on_polygon(a, 0).sum_m2();
    const Solution solution = solve(scene, places.point, effort_);
    for (const Row& row : rows) {
      const double scale = row.at("quantity") == "form factor" ? 1.0 / emitted_lm
                           : starts_with(row.at("name"), "E_") ? 1.0 / places.sum_m2()
                                                               : 1.0;
      add(row, solution, times(places.area_m2, scale), Part::direct, kDirectKnownTo);
    }
  }

  // Of the light of a lamp of that flux, the share that falls on a disc of 1 m below it.
  void factor_of_disc(const std::vector<Row>& rows, const Scene& scene, double flux_lm) {
    const Places places = places_on_disc({0, 0, 0}, 1.0, kUp, 16, 32);
    const Solution solution = solve(scene, places.point, effort_);
    for (const Row& row : rows) {
      add(row, solution, times(places.area_m2, 1.0 / flux_lm), Part::direct, kDirectKnownTo);
    }
  }

  // Flux in circles about the foot of a lamp.
  void circles(const std::vector<Row>& rows) {
    const Scene scene = open_scene(id_, tables_, std::nullopt);
    for (const Row& row : rows) {
      double radius_m = 0.0;
      if (std::sscanf(row.at("name").c_str(), "r=%lf", &radius_m) != 1) {
        leave_out(row, "no radius");
        continue;
      }
      const Places places = places_on_disc({0, 0, 0}, radius_m, kUp, 48, 16);
      // The table of a narrow beam is coarser than its formula.
      add(row, solve(scene, places.point, effort_), places.area_m2, Part::direct, 2e-3);
    }
  }

  void spheres(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      const std::optional<SphereCase> sphere =
          sphere_case(row.at("name"), row.at("quantity"), tables_);
      if (!sphere) {
        leave_out(row, "no such sphere");
        continue;
      }
      Effort effort = effort_;
      effort.paths = paths_for(1.0 - sphere->largest_rho);
      const Solution solution = solve(sphere->scene, sphere->places.point, effort);
      add(row, solution, times(sphere->places.area_m2, 1.0 / sphere->places.sum_m2()), Part::total,
          sphere->known_to);
      if (solution.problem.empty()) out_.result.measured.back().what += sphere->note;
    }
  }

  void grids(const std::vector<Row>& rows) {
    std::string last;
    std::optional<GridCase> grid;
    Solution solution;
    for (const Row& row : rows) {
      if (starts_with(row.at("quantity"), "average") || row.at("quantity") == "flux on all faces" ||
          row.at("quantity") == "form factor" || row.at("name") == "everywhere") {
        continue;
      }
      if (!grid || row.at("name") != last) {
        grid = grid_case(row_, row, tables_);
        last = row.at("name");
        if (grid) {
          Effort effort = effort_;
          effort.paths = 2048;
          solution = solve(open_scene(id_, tables_, std::nullopt), grid->places.point, effort);
        }
      }
      if (!grid) {
        leave_out(row, "not what luxgate calculates");
      } else if (row.at("quantity") == "true area average") {
        add(row, solution, times(grid->places.area_m2, 1.0 / grid->places.sum_m2()), Part::total,
            kDirectKnownTo);
      } else {
        out_.result.note(solution);
        if (!solution.problem.empty()) continue;
        out_.result.measured.push_back(grid_statistic(row, *grid, solution));
        out_.result.measured.back().widest = kWidest;
        out_.printed.push_back(row.at("printed"));
      }
    }
  }

  const Row& row_;
  const std::string& id_;
  const Tables& tables_;
  const Effort& effort_;
  ScalarResult out_;
};

}  // namespace

ScalarResult run_scalars(const Row& row, const Tables& tables, const Effort& effort) {
  return Scalars(row, tables, effort).run();
}

}  // namespace validation
