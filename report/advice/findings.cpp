#include "report/advice/findings.h"

#include "report/text/clause_words.h"
#include "report/text/words.h"
#include "rules/catalogue/metric.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

namespace cli {

const rules::Finding& finding_at(const report::ProjectPart& part, const FindingPlace& where) {
  return part.spaces[where.space].planes[where.plane].findings[where.finding];
}

std::vector<FindingPlace> counted_findings(const report::ProjectPart& part) {
  std::vector<FindingPlace> counted;
  for (std::size_t s = 0; s < part.spaces.size(); ++s) {
    for (std::size_t p = 0; p < part.spaces[s].planes.size(); ++p) {
      for (std::size_t f = 0; f < part.spaces[s].planes[p].findings.size(); ++f) {
        if (rules::counts(rules::outcome_of(finding_at(part, {s, p, f})))) {
          counted.push_back({s, p, f});
        }
      }
    }
  }
  return counted;
}

std::string finding_words(const report::ProjectPart& part, const FindingPlace& where) {
  const report::SpacePart& space = part.spaces[where.space];
  const report::PlanePart& plane = space.planes[where.plane];
  return fmt::format("{}, {}: {}", report::title_of(space.name, space.id),
                     report::title_of(plane.name, plane.id),
                     report::quantity_words(finding_at(part, where).requirement));
}

bool is_of_points(const rules::Requirement& requirement) {
  return !rules::is_about_space(requirement.metric);
}

bool hangs_on_levels(const rules::Requirement& requirement) {
  return !rules::is_of_space(requirement.metric) || rules::is_of_space_in_scene(requirement.metric);
}

PassCount count_all(const report::ProjectPart& part) {
  PassCount count;
  for (const FindingPlace& where : counted_findings(part)) count.add(finding_at(part, where));
  return count;
}

bool is_judged_by_light(const rules::Requirement& requirement) {
  return !requirement.any_one_unit_out && is_of_points(requirement);
}

std::vector<std::string> not_met_findings(const report::ProjectPart& part) {
  std::vector<std::string> words;
  for (const FindingPlace& where : counted_findings(part)) {
    const rules::Verdict verdict = finding_at(part, where).verdict;
    if (verdict == rules::Verdict::pass) continue;
    words.push_back(fmt::format("{} ({})", finding_words(part, where), calc::name_of(verdict)));
  }
  for (const rules::AggregateFinding& finding : part.aggregates) {
    if (!rules::counts(rules::outcome_of(finding)) || finding.verdict == rules::Verdict::pass) {
      continue;
    }
    words.push_back(fmt::format(
        "{} ({})", finding.clause.empty() ? finding.id : report::clause_words({}, finding),
        calc::name_of(finding.verdict)));
  }
  return words;
}

std::vector<std::string> broken_findings(const report::ProjectPart& before,
                                         const report::ProjectPart& after) {
  std::vector<std::string> broken;
  for (const FindingPlace& where : counted_findings(before)) {
    const rules::Finding& then = finding_at(after, where);
    if (finding_at(before, where).verdict != rules::Verdict::pass ||
        then.verdict == rules::Verdict::pass) {
      continue;
    }
    broken.push_back(
        fmt::format("{} ({})", finding_words(before, where), calc::name_of(then.verdict)));
  }
  for (std::size_t a = 0; a < before.aggregates.size(); ++a) {
    const rules::AggregateFinding& finding = before.aggregates[a];
    if (!rules::counts(rules::outcome_of(finding)) || finding.verdict != rules::Verdict::pass) {
      continue;
    }
    const bool is_kept = a < after.aggregates.size() && after.aggregates[a].id == finding.id &&
                         after.aggregates[a].verdict == rules::Verdict::pass;
    if (!is_kept)
      broken.push_back(finding.clause.empty() ? finding.id : report::clause_words({}, finding));
  }
  return broken;
}

}  // namespace cli
