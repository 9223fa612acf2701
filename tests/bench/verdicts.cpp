// What a verdict costs beside numbers that are accurate everywhere, and how often it is wrong.
#include "calc/radiosity/sampling/phase_timer.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/stop_rule.h"
#include "tests/bench/experiments.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace bench {
namespace {

struct Quantity {
  rules::Metric metric;
  const char* name;
  double truth;
};

std::vector<Quantity> quantities(const Truth& truth) {
  double sum = 0.0, least = 1e300;
  for (std::size_t i = 0; i < truth.direct_lx.size(); ++i) {
    const double total = truth.direct_lx[i] + truth.indirect_lx[i];
    sum += total;
    least = std::min(least, total);
  }
  const double mean = sum / static_cast<double>(truth.direct_lx.size());
  return {{rules::Metric::average, "average", mean},
          {rules::Metric::minimum, "minimum", least},
          {rules::Metric::uniformity_min_avg, "Uo", least / mean}};
}

struct Judged {
  rules::Verdict verdict = rules::Verdict::not_judged;
  double seconds = 0.0;
  std::vector<std::size_t> active_points;  // per look
};

Judged judge(const BenchScene& scene, const Options& options, const Quantity& quantity,
             double limit, std::uint64_t seed) {
  rules::Requirement requirement;
  requirement.metric = quantity.metric;
  requirement.limit = limit;
  requirement.state = rules::LightState::initial;
  const rules::StopRule rule;
  calc::RadiositySettings settings;
  settings.first_paths = options.min_paths;
  settings.max_paths = options.max_paths;
  settings.replicates = options.replicates;
  settings.seed = seed;
  settings.jobs = options.threads.back();
  const auto gatherer = calc::make_cpu_gatherer();
  const double begin_s = calc::now_s();
  const calc::SpaceSolution solution = calc::solve_illuminance(
      scene.scene, {{"plane", &scene.grid}}, settings, 0.95, *gatherer,
      [&](std::size_t, const calc::PlaneField& field, calc::Look) {
        rules::LookJudgement answer = rules::judge_look(rule, {requirement}, scene.grid, field, {});
        return calc::LookAnswer{answer.finished, std::move(answer.active)};
      },
      {});
  Judged judged;
  judged.seconds = calc::now_s() - begin_s;
  const calc::PlaneField& field = solution.fields.front();
  judged.verdict =
      rules::judge_plane({requirement}, scene.grid, field, {}, rule.confidence).front().verdict;
  judged.active_points = field.counters.active_points;
  return judged;
}

std::string looks_text(const std::vector<std::size_t>& active) {
  std::string text;
  for (const std::size_t points : active)
    text += (text.empty() ? "" : " ") + std::to_string(points);
  return text;
}

// Time until the mean over points of the total's half-width is 0.1 %; by slope from the largest
// size if that is not enough.
double seconds_everywhere(const BenchScene& scene, const Truth& truth, const Options& options) {
  constexpr double kWanted = 1e-3;
  std::vector<double> errors, seconds;
  for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 2) {
    const Run run = run_core(scene, {calc::Method::light_pool, paths, options.replicates,
                                     options.seed, options.threads.back(), 0.0});
    errors.push_back(errors_of(run.field, truth).total);
    seconds.push_back(run.seconds);
    if (errors.back() < kWanted) break;
  }
  return look_up(errors, seconds, kWanted).y;
}

void print_cost(const BenchScene& scene, const Truth& truth, const Options& options) {
  const double everywhere_s = seconds_everywhere(scene, truth, options);
  Table table(
      fmt::format("{}: {} points; 0.1 % RMS everywhere takes {} s", scene.name, scene.points(),
                  number(everywhere_s)),
      {"quantity", "limit off by %", "verdict", "s", "share of everywhere", "points per look"});
  for (const Quantity& quantity : quantities(truth)) {
    for (const double off : {-0.10, -0.05, -0.02, -0.01, 0.01, 0.02, 0.05, 0.10}) {
      const Judged judged =
          judge(scene, options, quantity, (1.0 + off) * quantity.truth, options.seed);
      table.add({quantity.name, fmt::format("{:+.0f}", 100.0 * off),
                 rules::verdict_name(judged.verdict), number(judged.seconds),
                 number(judged.seconds / everywhere_s), looks_text(judged.active_points)});
    }
  }
  table.print();
}

void print_wrong(const BenchScene& scene, const Truth& truth, const Options& options, int seeds) {
  Table table(fmt::format("{}: verdicts of {} seeds, at most 5 % may be wrong", scene.name, seeds),
              {"quantity", "limit off by %", "wrong", "undecided", "right"});
  for (const Quantity& quantity : quantities(truth)) {
    for (const double off : {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05}) {
      int wrong = 0, undecided = 0;
      for (int k = 0; k < seeds; ++k) {
        const rules::Verdict verdict = judge(scene, options, quantity, (1.0 + off) * quantity.truth,
                                             options.seed + 1000 + static_cast<std::uint64_t>(k))
                                           .verdict;
        const rules::Verdict right = off < 0.0 ? rules::Verdict::pass : rules::Verdict::fail;
        if (verdict == rules::Verdict::undecided) {
          ++undecided;
        } else if (verdict != right) {
          ++wrong;
        }
      }
      table.add({quantity.name, fmt::format("{:+.0f}", 100.0 * off), std::to_string(wrong),
                 std::to_string(undecided), std::to_string(seeds - wrong - undecided)});
    }
  }
  table.print();
}

}  // namespace

void run_verdicts(const Options& options) {
  const int seeds = options.names.size() > 1 ? std::atoi(options.names[1].c_str()) : 0;
  const std::string name = options.names.empty() ? "office" : options.names[0];
  const BenchScene scene = make_scene(find_room(name));
  const Truth truth = find_truth(scene, options);
  if (seeds == 0) {
    print_cost(scene, truth, options);
  } else {
    print_wrong(scene, truth, options, seeds);
  }
}

}  // namespace bench
