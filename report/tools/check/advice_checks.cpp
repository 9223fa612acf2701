#include "report/tools/check/advice_checks.h"

#include "report/advice/advised_levels.h"
#include "report/shell/process/interrupt.h"
#include "rules/catalogue/goal.h"

#include <optional>

namespace cli {

CheckText check_by_other_numbers(const std::string& path, const check::Run& run,
                                 Progress& progress) {
  check::Settings other = run.settings();
  other.goal = rules::Goal::verdict;
  other.by_luminaire = false;
  ++other.radiosity.seed;
  return [path, other_run = run.with_settings(other), &progress](
             const std::string& text, std::string& reason) -> std::optional<report::ProjectPart> {
    WatchedProject observer(progress, path);
    report::ProjectPart result = other_run.with_text(path, text).check(path, observer);
    progress.clear();
    if (result.is_judged) return result;
    reason = result.diagnostics.empty() ? "the changed project was not judged"
                                        : result.diagnostics.back().message;
    return std::nullopt;
  };
}

std::vector<report::LevelAdvice> advice_on(const report::ProjectPart& part,
                                           const std::string& bytes, const check::Run& run,
                                           Progress& progress) {
  const std::string& path = part.path;
  AdviceSettings settings;
  settings.confidence = run.settings().confidence;
  settings.is_stopped = interrupted;
  const auto check_light = [&](KeptLight& light) -> std::optional<report::ProjectPart> {
    check::Settings finer = run.settings();
    finer.goal = rules::Goal::accuracy;
    finer.by_luminaire = false;
    LightKeeper keeper(progress, path, light);
    report::ProjectPart result = run.with_settings(finer).check(path, keeper);
    if (!result.is_judged) return std::nullopt;
    return result;
  };
  return advised_levels({path, bytes, part}, settings, check_light,
                        check_by_other_numbers(path, run, progress));
}

}  // namespace cli
