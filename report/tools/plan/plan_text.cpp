#include "calc/proofs/skips.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cli {
namespace {

std::string count_text(double count) {
  return report::format_count(static_cast<std::uint64_t>(std::llround(count)));
}

std::string bytes_text(double bytes) {
  if (bytes < 1.0e6) return fmt::format("{:.0f} kB", std::ceil(bytes / 1.0e3));
  return fmt::format("{:.{}f} MB", bytes / 1.0e6, bytes < 1.0e7 ? 1 : 0);
}

std::string seconds_text(double seconds) { return fmt::format("{:.3g} s", seconds); }

// Columns in a monospaced font: blanks in front up to the width.
std::string right(const std::string& text, std::size_t width) {
  const std::size_t used = report::display_width(text);
  return std::string(used < width ? width - used : 0, ' ') + text;
}

std::string plane_line(const calc::PlanePlan& plane, std::size_t luminaires) {
  std::string text =
      fmt::format("    plane {}: {} points, direct light from {} of {} luminaires",
                  report::printable(plane.plane_id), plane.points, plane.luminaires, luminaires);
  if (plane.is_exact) return text + ", no reflected light: exact in one pass\n";
  if (plane.seeing_points == 0) return text + ", no reflected light\n";
  if (plane.seeing_points == plane.points) return text + ", reflected light\n";
  return text + fmt::format(", reflected light at {} points\n", plane.seeing_points);
}

std::string decision_line(const calc::SkipDecision& decision, const check::SpacePlan& space) {
  std::string why = decision.why;
  if (decision.body && !space.obstacle.empty()) {
    why += fmt::format(" of '{}'", report::printable(space.obstacle));
  }
  const std::size_t planes = space.plan.planes.size();
  if (!decision.planes.empty() && decision.planes.size() < planes) {
    why += fmt::format(" (complete for {}", decision.planes.size() == 1 ? "plane" : "planes");
    for (std::size_t p = 0; p < decision.planes.size(); ++p) {
      why += (p == 0 ? " " : ", ") + report::printable(decision.planes[p]);
    }
    why += ")";
  }
  return fmt::format("      {:<15} {}\n", calc::name_of(decision.skip), why);
}

std::string decisions(const check::SpacePlan& space, calc::SkipState state, const char* heading) {
  std::string lines;
  for (const calc::SkipDecision& decision : space.plan.skips) {
    if (decision.state == state) lines += decision_line(decision, space);
  }
  return lines.empty() ? "" : fmt::format("    {}\n", heading) + lines;
}

std::string prediction_table(const calc::ScenePlan& plan, const calc::RadiositySettings& settings) {
  const calc::Prediction& first = plan.first_look;
  const calc::Prediction& last = plan.last_look;
  const bool is_sampled = plan.looks > 0;
  constexpr std::size_t kLabel = 22, kNumber = 18;
  std::string text =
      fmt::format("    predicted on {} thread{}", plan.threads, plan.threads == 1 ? "" : "s");
  if (is_sampled) {
    text += fmt::format(
        ": first sampling round with {} light paths per replicate, and at most {} round{} with {}",
        settings.first_paths, plan.looks, plan.looks == 1 ? "" : "s", settings.max_paths);
  }
  text += "\n";
  const auto row = [&](const char* label, const std::string& a, const std::string& b) {
    text += fmt::format("      {:<{}}", label, kLabel) + right(a, kNumber);
    if (is_sampled) text += right(b, kNumber);
    text += "\n";
  };
  const auto count_row = [&](const char* label, double a, double b) {
    if (a > 0.0 || b > 0.0) row(label, count_text(a), count_text(b));
  };
  count_row("rays to luminaires", first.work.direct_rays, last.work.direct_rays);
  count_row("light paths", first.work.light_paths, last.work.light_paths);
  count_row("rays of light paths", first.work.pool_rays, last.work.pool_rays);
  count_row("connections", first.work.connection_rays, last.work.connection_rays);
  count_row("near-field rays", first.work.near_rays, last.work.near_rays);
  row("time", seconds_text(first.seconds.total()), seconds_text(last.seconds.total()));
  row("memory", bytes_text(first.bytes), bytes_text(last.bytes));
  return text;
}

std::string space_text(const check::SpacePlan& space, const calc::RadiositySettings& settings) {
  const std::string& title = space.name.empty() ? space.id : space.name;
  std::string text =
      fmt::format("  {}: {} triangles, {} luminaire{}\n", report::printable(title), space.triangles,
                  space.plan.luminaires, space.plan.luminaires == 1 ? "" : "s");
  if (space.plan.planes.empty()) return text + "    no plane: nothing to calculate\n";
  for (std::size_t p = 0; p < space.plan.planes.size(); ++p) {
    text += plane_line(space.plan.planes[p], space.plan.luminaires);
    text += fmt::format("      grid: {}\n", report::printable(space.rule_of_grid[p]));
  }
  for (const calc::Message& note : space.notes) {
    text += "    " + report::printable(note.english()) + "\n";
  }
  text += decisions(space, calc::SkipState::applies, "omitted");
  text += decisions(space, calc::SkipState::not_proved, "not omitted: no proof");
  text +=
      decisions(space, calc::SkipState::while_calculating, "omitted if the calculation proves it");
  text += decisions(space, calc::SkipState::not_needed, "nothing to omit");
  text += decisions(space, calc::SkipState::forbidden, "not omitted: not allowed");
  return text + prediction_table(space.plan, settings);
}

std::string comparison_row(const char* label, const std::string& predicted,
                           const std::string& truth, double ratio) {
  const std::string shown = std::isfinite(ratio) ? fmt::format("{:.2f}", ratio) : "";
  return fmt::format("  {:<22}", label) + right(predicted, 16) + right(truth, 16) +
         right(shown, 16) + "\n";
}

}  // namespace

std::string render_plan_text(const std::vector<check::ProjectPlan>& projects,
                             const calc::RadiositySettings& settings,
                             const check::BackendChoice& backend,
                             const check::DrawingChoice& pictures) {
  std::string text;
  for (const check::ProjectPlan& project : projects) {
    text += report::printable_path(project.path);
    if (!project.name.empty()) text += ": " + report::printable(project.name);
    text += "\n";
    if (project.spaces.empty() && !project.is_planned) text += "  not planned: see the errors\n";
    for (const check::SpacePlan& space : project.spaces) text += space_text(space, settings);
    text += "\n";
  }
  return text + check::backend_line(backend) + check::pictures_line(pictures);
}

std::string explain_cost(const std::string& path, const std::string& space_id,
                         const calc::PreparedScene& scene,
                         const std::vector<calc::PlaneTask>& tasks,
                         const calc::RadiositySettings& settings,
                         const calc::SpaceSolution& solution) {
  const calc::ScenePlan plan = calc::make_scene_plan(scene, tasks, settings);
  std::vector<std::uint64_t> paths;
  calc::Work truth;
  for (const calc::PlaneField& field : solution.fields) {
    const calc::SolveCounters& counters = field.counters;
    paths.push_back(counters.paths / static_cast<std::uint64_t>(settings.replicates));
    truth.light_paths = std::max(truth.light_paths, static_cast<double>(counters.paths));
    truth.direct_rays += static_cast<double>(counters.direct_rays);
    truth.connection_rays += static_cast<double>(counters.connection_rays);
    truth.near_rays += static_cast<double>(counters.near_rays);
  }
  truth.pool_rays = static_cast<double>(solution.pool_rays);
  const calc::Prediction predicted = calc::predict(plan.workload, paths, settings, plan.threads);

  std::string text =
      fmt::format("{}, {}: cost", report::printable_path(path), report::printable(space_id)) +
      "\n" + fmt::format("  {:<22}{:>16}{:>16}{:>16}\n", "", "predicted", "true", "true/predicted");
  const auto counts = [&](const char* label, double p, double t) {
    if (p > 0.0 || t > 0.0) text += comparison_row(label, count_text(p), count_text(t), t / p);
  };
  const auto times = [&](const char* label, double p, double t) {
    if (p > 0.0 || t > 0.0) text += comparison_row(label, seconds_text(p), seconds_text(t), t / p);
  };
  counts("rays to luminaires", predicted.work.direct_rays, truth.direct_rays);
  counts("light paths", predicted.work.light_paths, truth.light_paths);
  counts("rays of light paths", predicted.work.pool_rays, truth.pool_rays);
  counts("connections", predicted.work.connection_rays, truth.connection_rays);
  counts("near-field rays", predicted.work.near_rays, truth.near_rays);
  const calc::SolveTimes& true_s = solution.times;
  times("prepare", predicted.seconds.prepare, true_s.build_s);
  times("direct light", predicted.seconds.direct, true_s.direct_s);
  times("light paths", predicted.seconds.pool, true_s.pool_s);
  times("connections", predicted.seconds.connect, true_s.connect_s);
  times("near field", predicted.seconds.near_field, true_s.near_s);
  times("in all", predicted.seconds.total(),
        true_s.build_s + true_s.direct_s + true_s.pool_s + true_s.connect_s + true_s.near_s);
  return text;
}

}  // namespace cli
