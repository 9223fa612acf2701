#include "report/tools/rules/project_effect.h"

#include "calc/store/memory_store.h"
#include "report/check/run.h"
#include "report/revision/matching.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/number_format.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/watched_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kMostStoreBytes = std::size_t{1} << 30;

// With rows by other names; a row of one of these names that is none of them is gone.
rules::RulePack renamed(rules::RulePack pack, const rules::RowNames& names) {
  const auto is_taken = [&](const std::string& ref) {
    return std::any_of(names.begin(), names.end(),
                       [&](const auto& entry) { return entry.second == ref; });
  };
  std::erase_if(pack.rows, [&](const rules::RuleRow& row) {
    return is_taken(row.ref) && !names.contains(row.ref);
  });
  const auto rename = [&](std::string& ref) {
    if (const auto found = names.find(ref); found != names.end()) ref = found->second;
  };
  for (rules::RuleRow& row : pack.rows) rename(row.ref);
  for (rules::RuleClass& item : pack.classes) {
    std::erase_if(item.rows,
                  [&](const std::string& ref) { return is_taken(ref) && !names.contains(ref); });
    for (std::string& ref : item.rows) rename(ref);
  }
  return pack;
}

// What a finding is, of whichever of the two packs.
struct Asked {
  std::string place, id;
  JudgedLimit judged;
  std::string key;          // of the same requirement with the other pack
  bool is_of_pack = false;  // of aggregates: their checks are
};

std::string verdict_words(rules::Verdict verdict, bool is_waived) {
  const std::string words = verdict_name(verdict);
  return is_waived ? words + ", waived" : words;
}

class AskedOf {
 public:
  explicit AskedOf(const ComparedPacks& compared) : compared_(compared) {}

  std::vector<Asked> list(const report::ProjectPart& project) const {
    std::vector<Asked> asked;
    for (const report::SpacePart& space : project.spaces) {
      for (const report::PlanePart& plane : space.planes) {
        for (const rules::Finding& finding : plane.findings) asked.push_back(of(plane, finding));
      }
    }
    for (const rules::AggregateFinding& finding : project.aggregates) {
      const std::string& place = finding.plane_id.empty() ? finding.space_id : finding.plane_id;
      asked.push_back({place,
                       finding.id,
                       {"", verdict_words(finding.verdict, finding.is_waived)},
                       fmt::format("{} {} {}", calc::name_of(finding.kind), place, finding.id)});
    }
    return asked;
  }

 private:
  // Ids of requirements are numbered where a statistic repeats: one more changes those of others.
  Asked of(const report::PlanePart& plane, const rules::Finding& finding) const {
    const rules::Requirement& requirement = finding.requirement;
    const rules::RuleOrigin& origin = requirement.origin;
    const std::string limit =
        report::format_required({requirement.limit, requirement.comparison}, unit_of(requirement));
    Asked asked{
        plane.id, requirement.id, {limit, verdict_words(finding.verdict, finding.is_waived)}, ""};
    if (requirement.severity != rules::Severity::shall) {
      asked.judged.severity = calc::name_of(requirement.severity);
    }
    asked.is_of_pack =
        origin.pack == compared_.before.full_id() || origin.pack == compared_.after.full_id();
    if (origin.pack.empty()) {
      asked.key = fmt::format("{} {} {} {}", plane.id, calc::name_of(requirement.metric), limit,
                              requirement.scene);
    } else {
      asked.id = origin.check;
      asked.key = fmt::format("{} {} {} {}", plane.id, origin.pack, origin.check, origin.row);
    }
    return asked;
  }

  const ComparedPacks& compared_;
};

}  // namespace

std::vector<rules::RulePack> packs_with(bool is_after, const ComparedPacks& compared,
                                        const std::vector<rules::RulePack>& loaded) {
  const rules::RulePack& before = compared.before;
  const rules::RulePack& after = compared.after;
  const std::string first = before.full_id(), second = after.full_id();
  std::vector<rules::RulePack> packs;
  for (const rules::RulePack& pack : loaded) {
    if (pack.full_id() != first && pack.full_id() != second) packs.push_back(pack);
  }
  rules::RowNames back;
  for (const auto& [from, to] : compared.rows) back[to] = from;
  const auto add = [&](const rules::RulePack& as, rules::RulePack pack) {
    pack.id = as.id;
    pack.edition = as.edition;
    pack.status = as.status;
    packs.push_back(std::move(pack));
  };
  add(before, is_after ? renamed(after, back) : before);
  if (first == second) return packs;
  add(after, is_after ? after : renamed(before, compared.rows));
  // They are one pack: an id without an edition is not ambiguous because both are in force.
  const bool are_of_one_id = before.id == after.id;
  if (are_of_one_id && before.status == "published" && after.status == "published") {
    packs.back().status = "superseded";
  }
  return packs;
}

ProjectEffect effect_on(const report::ProjectPart& before, const report::ProjectPart& after,
                        const ComparedPacks& compared) {
  ProjectEffect effect;
  effect.project = after.path;
  effect.before = report::outcome_of(before);
  effect.after = report::outcome_of(after);
  const AskedOf asked(compared);
  const std::vector<Asked> was = asked.list(before), is = asked.list(after);
  const auto key = [](const Asked& one) -> const std::string& { return one.key; };
  for (const auto& pair : report::match_parts(was, is, key)) {
    const Asked& any = pair.before != nullptr ? *pair.before : *pair.after;
    effect.asked += any.is_of_pack || (pair.after != nullptr && pair.after->is_of_pack) ? 1 : 0;
    const bool is_same = pair.before != nullptr && pair.after != nullptr &&
                         pair.before->judged.limit == pair.after->judged.limit &&
                         pair.before->judged.verdict == pair.after->judged.verdict &&
                         pair.before->judged.severity == pair.after->judged.severity;
    if (is_same) continue;
    ChangedVerdict changed{any.place, any.id, std::nullopt, std::nullopt};
    if (pair.before != nullptr) changed.before = pair.before->judged;
    if (pair.after != nullptr) changed.after = pair.after->judged;
    effect.changed.push_back(std::move(changed));
  }
  return effect;
}

std::optional<ProjectEffect> check_with_both(const CheckOptions& check, const RunContext& context,
                                             const ComparedPacks& compared) {
  watch_for_interrupt();
  const calc::DiskFileReader files(check.input.allowed);
  std::optional<check::Run> run = open_run_or_print(check, context, files);
  if (!run) return std::nullopt;
  // Light that both need is calculated once.
  run = run->with_light_in(std::make_shared<calc::MemoryStore>(kMostStoreBytes));
  Progress progress(progress_style(check.output, context.environment),
                    context.environment.stderr_columns);
  progress.expect(2);
  std::vector<report::ProjectPart> parts;
  for (const bool is_after : {false, true}) {
    WatchedProject observer(progress, check.input.projects.front());
    parts.push_back(run->with_packs(packs_with(is_after, compared, run->packs()))
                        .check(check.input.projects.front(), observer));
    progress.done(parts.back().path);
    if (interrupted()) return std::nullopt;
    if (!parts.back().is_judged) {
      progress.clear();
      tell("With {}:\n", (is_after ? compared.after : compared.before).full_id());
      print_diagnostics(parts.back().diagnostics, false);
      return std::nullopt;
    }
  }
  progress.clear();
  return effect_on(parts.front(), parts.back(), compared);
}

}  // namespace cli
