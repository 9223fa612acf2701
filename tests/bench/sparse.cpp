// How often intervals hold the truth where a point's light is a few large samples: corners, dark
// halls, facades in the open, light through a hole. With and without the room that an upper end
// leaves for samples that were not drawn, see rules/measure/replicate_sample.h.
#include "calc/base/statistics.h"
#include "rules/measure/replicate_sample.h"
#include "tests/bench/experiments.h"
#include "tests/bench/table.h"
#include "tests/support/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {
namespace {

using namespace test_support;

constexpr double kLevel = 0.025;  // of each end

struct Family {
  std::string name;
  calc::PreparedScene scene;
  calc::SensorGrid grid;
};

void add_point(Family& family, const glm::dvec3& position_m, const glm::dvec3& normal) {
  family.grid.position_m.push_back(position_m);
  family.grid.normal.push_back(glm::normalize(normal));
}

constexpr glm::dvec3 kUp(0, 0, 1), kDown(0, 0, -1), kWest(-1, 0, 0);

Family cube_corner(const calc::PhotometricWeb& all_round) {
  Family family{"corner of a cube", {}, {}};
  add_box(family.scene, {0, 0, 0}, {4, 4, 4}, 0.5);
  add_luminaire(family.scene, all_round, {2, 2, 2});
  for (const double off_m : {0.001, 0.01, 0.1}) {
    add_point(family, glm::dvec3(off_m), kUp);
    add_point(family, glm::dvec3(off_m), kWest);
  }
  add_point(family, {2, 2, 0}, kUp);
  return family;
}

Family ceiling_corner(const calc::PhotometricWeb& down) {
  Family family{"ceiling of a room", {}, {}};
  add_box(family.scene, {0, 0, 0}, {6, 4, 2.8}, 0.7);
  add_luminaire(family.scene, down, {3, 2, 2.79});
  add_point(family, {0.001, 0.001, 2.799}, kDown);
  add_point(family, {0.001, 0.001, 2.799}, kWest);
  add_point(family, {0.001, 2, 2.799}, kDown);
  add_point(family, {1, 1, 2.8}, kDown);
  add_point(family, {3, 2, 0.75}, kUp);
  return family;
}

Family dark_hall(const calc::PhotometricWeb& down) {
  Family family{"dark hall", {}, {}};
  add_box(family.scene, {0, 0, 0}, {40, 20, 8}, 0.1);
  for (int k = 0; k < 8; ++k) {
    add_luminaire(family.scene, down, {5.0 + 10.0 * (k % 4), k < 4 ? 5.0 : 15.0, 7.5});
  }
  add_point(family, {20, 10, 1.5}, {1, 0, 0});
  add_point(family, {20, 10, 4}, kDown);
  add_point(family, {3, 3, 0.05}, kDown);
  add_point(family, {1, 1, 1}, kDown);
  add_point(family, {0.1, 10, 4}, {1, 0, 0});
  add_point(family, {20, 10, 0.8}, kUp);
  return family;
}

Family open_facade(const calc::PhotometricWeb& all_round) {
  Family family{"facade in the open", {}, {}};
  add_quad(family.scene, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0.2);
  add_quad(family.scene, {-5, 5, 0}, {10, 0, 0}, {0, 0, 6}, 0.4);
  add_luminaire(family.scene, all_round, {0, -20, 10});
  add_luminaire(family.scene, all_round, {40, 0, 10});
  add_point(family, {0, 0, 3}, kDown);
  add_point(family, {0, 4, 1.5}, {0, 1, 0});
  add_point(family, {0, 4.9, 0.01}, {0, 1, 0});
  add_point(family, {3, 2, 1}, kDown);
  add_point(family, {0, -4, 0.5}, {1, 1, -1});
  return family;
}

Family far_patch(const calc::PhotometricWeb& all_round) {
  Family family{"small patch in the open", {}, {}};
  add_quad(family.scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0.3);
  add_quad(family.scene, {-1, 1, 0}, {2, 0, 0}, {0, 0, 2}, 0.5);
  add_luminaire(family.scene, all_round, {0, -15, 12});
  add_point(family, {0, 0, 1}, kDown);
  add_point(family, {0, 0.5, 0.5}, {0, 1, 0});
  add_point(family, {0, 0.9, 0.1}, {0, 1, 0});
  add_point(family, {2, 0, 1}, kWest);
  return family;
}

// A wall across the room, with a hole of 0.1 x 0.1 m.
Family behind_a_hole(const calc::PhotometricWeb& all_round) {
  Family family{"behind a hole of 0.1 m", {}, {}};
  add_box(family.scene, {0, 0, 0}, {6, 3, 2.5}, 0.5);
  add_quad(family.scene, {3, 0, 0}, {0, 1.5, 0}, {0, 0, 2.5}, 0.5);
  add_quad(family.scene, {3, 1.6, 0}, {0, 1.4, 0}, {0, 0, 2.5}, 0.5);
  add_quad(family.scene, {3, 1.5, 0}, {0, 0.1, 0}, {0, 0, 1.2}, 0.5);
  add_quad(family.scene, {3, 1.5, 1.3}, {0, 0.1, 0}, {0, 0, 1.2}, 0.5);
  add_luminaire(family.scene, all_round, {1, 0.7, 1.8});
  add_point(family, {4.5, 1, 0.75}, kUp);
  add_point(family, {5.5, 2.5, 0.75}, kUp);
  add_point(family, {5.9, 1.5, 1.2}, kWest);
  add_point(family, {3.2, 0.3, 0.3}, kUp);
  return family;
}

Family large_panel(const calc::PhotometricWeb& panel) {
  Family family{"under a panel of 40 x 40 m", {}, {}};
  add_box(family.scene, {0, 0, 0}, {40, 40, 1}, 0.5);
  add_luminaire(family.scene, panel, {20, 20, 0.99});
  add_point(family, {20, 20, 0.1}, kUp);
  add_point(family, {1, 1, 0.1}, kUp);
  add_point(family, {0.01, 20, 0.5}, {1, 0, 0});
  add_point(family, {20, 20, 0.5}, kDown);
  return family;
}

// Of one end: how many intervals it spoils.
struct Ends {
  double below = 0.0, above_plain = 0.0, above = 0.0;
  double half_plain = 0.0, half = 0.0;  // sums of half widths over the truth
  double runs = 0.0;
};

void add_run(Ends& ends, const calc::PlaneField& field, std::size_t point, double truth_lx) {
  const calc::ReplicateMean mean = calc::replicate_mean(replicates_at(field, point));
  const double t = rules::one_sided_t(field.replicates, kLevel);
  const double variance = mean.standard_error * mean.standard_error;
  const double sample = field.largest_sample_lx.empty() ? 0.0 : field.largest_sample_lx[point];
  const double low = mean.mean - t * mean.standard_error;
  const double high_plain = mean.mean + t * mean.standard_error;
  const double high = mean.mean + t * std::sqrt(rules::variance_with(variance, sample));
  ends.below += truth_lx < low ? 1.0 : 0.0;
  ends.above_plain += truth_lx > high_plain ? 1.0 : 0.0;
  ends.above += truth_lx > high ? 1.0 : 0.0;
  ends.half_plain += 0.5 * (high_plain - low) / truth_lx;
  ends.half += 0.5 * (high - low) / truth_lx;
  ends.runs += 1.0;
}

struct Exact {
  std::vector<double> lx;
  double worst_error = 0.0;  // standard error over value
};

Exact find_exact(const Family& family, const Options& options) {
  const calc::SpaceSolution run =
      solve_with_paths(family.scene, family.grid, options.seed + 999998, options.reference_paths,
                       options.reference_replicates);
  Exact exact;
  for (std::size_t i = 0; i < family.grid.position_m.size(); ++i) {
    const calc::ReplicateMean mean = calc::replicate_mean(replicates_at(run.fields[0], i));
    exact.lx.push_back(mean.mean);
    exact.worst_error = std::max(exact.worst_error, mean.standard_error / mean.mean);
  }
  return exact;
}

std::vector<std::string> row_of(const Family& family, std::uint64_t paths, const Exact& exact,
                                const std::vector<Ends>& points) {
  Ends all;
  double worst_plain = 0.0, worst = 0.0;
  for (const Ends& e : points) {
    all.below += e.below, all.above_plain += e.above_plain, all.above += e.above;
    all.half_plain += e.half_plain, all.half += e.half, all.runs += e.runs;
    worst_plain = std::max(worst_plain, e.above_plain / e.runs);
    worst = std::max(worst, e.above / e.runs);
  }
  return {family.name,
          fmt::format("{}", paths),
          percent(exact.worst_error),
          percent(all.below / all.runs),
          percent(all.above_plain / all.runs),
          percent(worst_plain),
          percent(all.above / all.runs),
          percent(worst),
          percent(all.half_plain / all.runs),
          percent(all.half / all.runs)};
}

}  // namespace

void run_sparse(const Options& options) {
  const int seeds = options.names.empty() ? 400 : std::atoi(options.names.front().c_str());
  if (seeds < 1) throw std::runtime_error("sparse: the number of seeds must be 1 or more");
  const calc::OpeningShape square = calc::OpeningShape::rectangle;
  const calc::PhotometricWeb all_round = isotropic_web(1000.0), down = lambert_web(3000.0, 45),
                             panel = lambert_web(50000.0, 90, {square, 39.9, 39.9, 0.0});
  std::vector<Family> families;
  families.push_back(cube_corner(all_round));
  families.push_back(ceiling_corner(down));
  families.push_back(dark_hall(down));
  families.push_back(open_facade(all_round));
  families.push_back(far_patch(all_round));
  families.push_back(behind_a_hole(all_round));
  families.push_back(large_panel(panel));
  Table table(fmt::format("where one sample counts much: {} seeds, {} replicates; truth beyond an "
                          "end in % (2.5 is right), half widths in %",
                          seeds, options.replicates),
              {"family", "paths", "truth's error", "below low", "above plain", "worst point",
               "above high", "worst point", "half plain", "half"});
  for (Family& family : families) {
    if (options.names.size() > 1 && family.name != options.names[1]) continue;
    set_extent(family.scene);
    const Exact exact = find_exact(family, options);
    for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 4) {
      std::vector<Ends> ends(exact.lx.size());
      for (int seed = 0; seed < seeds; ++seed) {
        const calc::SpaceSolution run =
            solve_with_paths(family.scene, family.grid, options.seed + static_cast<unsigned>(seed),
                             paths, options.replicates);
        for (std::size_t i = 0; i < ends.size(); ++i) {
          add_run(ends[i], run.fields[0], i, exact.lx[i]);
        }
      }
      table.add(row_of(family, paths, exact, ends));
    }
  }
  table.print();
}

}  // namespace bench
