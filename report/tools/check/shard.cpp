#include "report/tools/check/shard.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/store/entry_folder.h"
#include "report/check/check_project.h"
#include "report/check/set_values.h"
#include "report/check/units.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/store_words.h"
#include "report/tools/check/watched_project.h"
#include "report/tools/plan/units_list.h"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cli {
namespace {

// As the file of --units lists them, or by a plan of all projects. Empty after an error, which has
// been printed. What cannot be read has no units: that is told, but ends no shard, as the others
// go on and the closing job judges it.
std::optional<std::vector<check::Unit>> all_units(const CheckOptions& options,
                                                  const check::Run& run,
                                                  const calc::FileReader& files) {
  const calc::RadiositySettings& radiosity = options.settings.radiosity;
  if (options.batch.units_file.empty()) {
    const std::vector<check::ProjectPlan> plans = run.plan(options.input.projects);
    for (const check::ProjectPlan& plan : plans) {
      if (!plan.is_planned) print_diagnostics(plan.diagnostics, true);
    }
    return units_of(plans, radiosity);
  }
  std::string problem;
  std::optional<std::vector<check::Unit>> units =
      read_units(options.batch.units_file, files, problem);
  if (units) {
    const std::set<std::string> given(options.input.projects.begin(), options.input.projects.end());
    for (const check::Unit& unit : *units) {
      if (given.contains(unit.project)) continue;
      problem = fmt::format("'{}' is not among the projects of this command", unit.project);
      break;
    }
  }
  if (problem.empty()) return units;
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::units_not_readable, {options.batch.units_file, 0, 0},
                     problem);
  print_diagnostics(diagnostics.all(), true);
  return std::nullopt;
}

struct ProjectShare {
  std::string path;
  std::vector<check::Unit> units;
};

// Projects in the order of their first units.
std::vector<ProjectShare> own_share(const std::vector<check::Unit>& units,
                                    const BatchShare& share) {
  const std::vector<std::size_t> shard = check::shards_of(units, share.count);
  std::vector<ProjectShare> own;
  std::map<std::string, std::size_t> place;
  for (std::size_t u = 0; u < units.size(); ++u) {
    if (shard[u] + 1 != share.number) continue;
    const auto [known, is_new] = place.try_emplace(units[u].project, own.size());
    if (is_new) own.push_back({units[u].project, {}});
    own[known->second].units.push_back(units[u]);
  }
  return own;
}

}  // namespace

ExitCode run_shard(const CheckOptions& asked, const RunContext& context) {
  CheckOptions options = asked;
  if (!enter_sandbox_or_print(options, context)) return kNotJudged;
  watch_for_interrupt();
  const ProjectReader disk(asked.input);
  const check::SetReader files(disk, asked.input.projects, asked.set);
  if (!check_values_or_print(asked.input, asked.set, "set", disk)) return kNotJudged;
  std::optional<check::Run> run = open_run_or_print(options, context, files);
  if (!run) return kNotJudged;
  const auto units = all_units(options, *run, files);
  if (!units) return kNotJudged;
  const std::vector<ProjectShare> own = own_share(*units, options.batch.share);

  const auto folder = std::make_shared<calc::EntryFolder>(options.store);
  run = run->with_light_in(folder);
  Progress progress(progress_style(options.output, context.environment),
                    context.environment.stderr_columns);
  progress.expect(own.size());
  std::vector<calc::Diagnostics> told(own.size());
  calc::LookCounts looks;
  std::mutex looks_mutex;
  bool is_good = true;
  std::size_t done = 0;
  const auto work = [&](std::size_t p) {
    WatchedProject observer(progress, own[p].path);
    told[p] = run->light(own[p].path, own[p].units, observer);
    const std::scoped_lock lock(looks_mutex);
    looks.read += observer.looks().read;
    looks.computed += observer.looks().computed;
  };
  const auto deliver = [&](std::size_t p) {
    if (interrupted()) return;
    progress.aside([&] { print_diagnostics(told[p].all(), true); });
    is_good = is_good && !told[p].has_errors();
    done += told[p].has_errors() ? 0 : own[p].units.size();
    progress.done(own[p].path);
  };
  check::in_order(own.size(), run->concurrency(), work, deliver, [] { return !interrupted(); });
  progress.clear();
  calc::StoreTroubles troubles = folder->troubles();
  const bool is_kept = is_light_kept_or_print(options.store, troubles);
  troubles.not_written.clear();
  print_troubles(options.store, troubles);
  if (interrupted()) {
    tell(
        "luxgate: interrupted; finished light is in the result cache, and the same command "
        "continues\n");
    return kInterrupted;
  }
  if (!options.output.quiet && is_kept) {
    tell("luxgate: shard {}/{}: {} of {} jobs; {} sampling rounds computed, {} in the cache\n",
         options.batch.share.number, options.batch.share.count, done, units->size(), looks.computed,
         looks.read);
  }
  return is_good && is_kept ? kAllMet : kNotJudged;
}

}  // namespace cli
