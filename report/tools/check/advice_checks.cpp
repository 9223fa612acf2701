#include "report/tools/check/advice_checks.h"

#include "report/advice/advised_levels.h"
#include "report/advice/changed_project.h"
#include "report/shell/interrupt.h"
#include "report/tools/check/checked_document.h"
#include "rules/catalogue/goal.h"

#include <optional>

namespace cli {

CheckText check_by_other_numbers(const std::string& path, const check::Context& context,
                                 Progress& progress) {
  return [path, &settings = context.settings, &files = context.files, &packs = context.packs,
          &stages = context.stages, store = context.store, at_once = context.spaces_at_once,
          &progress](const std::string& text,
                     std::string& reason) -> std::optional<report::ProjectPart> {
    const ChangedProject changed(files, path, text);
    check::Settings other = settings;
    other.goal = rules::Goal::verdict;
    other.by_luminaire = false;
    ++other.radiosity.seed;
    WatchedProject observer(progress, path);
    report::ProjectPart result =
        check_safely(path, {other, changed, packs, stages, observer, nullptr, store, at_once});
    progress.clear();
    if (result.is_judged) return result;
    reason = result.diagnostics.empty() ? "the changed project was not judged"
                                        : result.diagnostics.back().message;
    return std::nullopt;
  };
}

std::vector<report::LevelAdvice> advice_on(const report::ProjectPart& part,
                                           const std::string& bytes, const check::Context& context,
                                           Progress& progress) {
  const std::string& path = part.path;
  AdviceSettings settings;
  settings.confidence = context.settings.confidence;
  settings.is_stopped = interrupted;
  const auto check_light = [&](KeptLight& light) -> std::optional<report::ProjectPart> {
    check::Settings finer = context.settings;
    finer.goal = rules::Goal::accuracy;
    finer.by_luminaire = false;
    LightKeeper keeper(progress, path, light);
    report::ProjectPart result =
        check_safely(path, {finer, context.files, context.packs, context.stages, keeper, nullptr,
                            context.store, context.spaces_at_once});
    if (!result.is_judged) return std::nullopt;
    return result;
  };
  return advised_levels({path, bytes, part}, settings, check_light,
                        check_by_other_numbers(path, context, progress));
}

}  // namespace cli
