#include "report/revision/questions.h"

#include "calc/base/names.h"
#include "calc/base/text.h"
#include "report/revision/question_list.h"
#include "report/text/number_format.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace report {
namespace {

// Something that lasts up to a day and lets a requirement go.
void compare_leave(QuestionList& questions, QuestionPart part,
                   const std::optional<calc::Waiver>& before,
                   const std::optional<calc::Waiver>& after, const std::string& item = "") {
  const auto words = [](const std::optional<calc::Waiver>& leave) {
    return leave ? rules::waiver_words(*leave).english() : std::string();
  };
  if (words(before) == words(after)) return;
  QuestionChange change = QuestionChange::exchanged;
  if (!before || (after && after->until > before->until)) change = QuestionChange::weaker;
  if (before && (!after || after->until < before->until)) change = QuestionChange::stricter;
  questions.add(change, part, words(before), words(after), item);
}

void compare_severities(QuestionList& questions, rules::Severity before, rules::Severity after) {
  const auto rank = [](rules::Severity severity) {
    return severity == rules::Severity::shall          ? 2
           : severity == rules::Severity::in_aggregate ? 1
                                                       : 0;
  };
  questions.compare(QuestionPart::severity, rank(before), rank(after), true,
                    std::string(calc::name_of(before)), std::string(calc::name_of(after)));
}

std::string limit_words(const rules::Requirement& requirement) {
  return format_required({requirement.limit, requirement.comparison}, rules::unit_of(requirement));
}

void compare_limits(QuestionList& questions, const rules::Requirement& before,
                    const rules::Requirement& after) {
  const bool is_lower = rules::is_lower_limit(after.comparison);
  if (rules::is_lower_limit(before.comparison) != is_lower) {
    return questions.add(QuestionChange::exchanged, QuestionPart::quantity, limit_words(before),
                         limit_words(after));
  }
  if (!is_same_number(before.limit, after.limit)) {
    return questions.compare(QuestionPart::limit, before.limit, after.limit, is_lower,
                             limit_words(before), limit_words(after));
  }
  if (before.comparison == after.comparison) return;
  const bool allows_limit = after.comparison == rules::Comparison::at_least ||
                            after.comparison == rules::Comparison::at_most;
  questions.add(allows_limit ? QuestionChange::weaker : QuestionChange::stricter,
                QuestionPart::limit, limit_words(before), limit_words(after));
}

bool is_same_point(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
  return a.has_value() == b.has_value() && (!a || is_same_place(*a, *b));
}

std::string exact_words(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", format_shortest(v.x), format_shortest(v.y),
                     format_shortest(v.z));
}

// With what the words of reports round or leave out.
std::string exact_quantity(const rules::Requirement& requirement) {
  std::string words = quantity_words(requirement);
  const auto [point_m, facing] = rules::argument_of<rules::PointOfValue>(requirement);
  if (point_m) words += ", exactly " + exact_words(*point_m);
  if (facing) words += ", facing " + exact_words(*facing);
  if (requirement.any_one_unit_out) words += " with any one luminaire out";
  return words;
}

// Fewer rooms than before are an easier question, or may be; what the project states of those that
// are still there is a part of it.
void compare_rooms(QuestionList& questions, const rules::AggregateFinding& before,
                   const rules::AggregateFinding& after) {
  const auto missing = [](const rules::AggregateFinding& of, const rules::AggregateFinding& in) {
    std::vector<std::string> names;
    for (const rules::AggregateMember& member : of.members) {
      const bool is_there = std::any_of(in.members.begin(), in.members.end(),
                                        [&](const auto& one) { return one.name == member.name; });
      if (!is_there) names.push_back(member.name);
    }
    return names;
  };
  constexpr std::size_t kMostNamed = 4;
  const std::vector<std::string> gone = missing(before, after), added = missing(after, before);
  // A room that is better than the others were, as far as that was known, makes up for what they
  // take.
  const bool was_known = before.verdict != rules::Verdict::not_judged;
  const auto& sum = before.sum->measured.value;
  const bool is_diluted =
      std::any_of(after.members.begin(), after.members.end(), [&](const auto& m) {
        const bool is_new = std::find(added.begin(), added.end(), m.name) != added.end();
        const bool is_lower = rules::is_lower_limit(after.sum->requirement.comparison);
        return is_new && (!was_known || !m.value || (is_lower ? *m.value > sum : *m.value < sum));
      });
  if (!gone.empty()) {
    questions.add(QuestionChange::weaker, QuestionPart::aggregate,
                  calc::list_names(gone, kMostNamed), "");
  }
  if (!added.empty()) {
    questions.add(is_diluted ? QuestionChange::exchanged : QuestionChange::stricter,
                  QuestionPart::aggregate, "", calc::list_names(added, kMostNamed));
  }
  for (const rules::AggregateMember& is : after.members) {
    for (const rules::AggregateMember& was : before.members) {
      if (was.name != is.name) continue;
      questions.exchange(QuestionPart::energy, was.stated.english(), is.stated.english(), is.name);
    }
  }
}

// What a field is stated to be is compared with all that is stated, and what is known of the space
// is no part of the question.
bool is_same_argument(const rules::Requirement& before, const rules::Requirement& after) {
  using rules::argument_of;
  const auto was = argument_of<rules::PointOfValue>(before);
  const auto is = argument_of<rules::PointOfValue>(after);
  return is_same_point(was.point_m, is.point_m) && is_same_point(was.facing, is.facing) &&
         argument_of<rules::Percentile>(before) == argument_of<rules::Percentile>(after) &&
         argument_of<rules::ValueRange>(before) == argument_of<rules::ValueRange>(after) &&
         argument_of<rules::HeightRange>(before) == argument_of<rules::HeightRange>(after);
}

// What is looked at.
void compare_quantities(QuestionList& questions, const rules::Requirement& before,
                        const rules::Requirement& after) {
  const bool is_same = before.metric == after.metric && before.derived == after.derived &&
                       before.any_one_unit_out == after.any_one_unit_out &&
                       is_same_argument(before, after);
  if (is_same) return;
  const std::string was = quantity_words(before), is = quantity_words(after);
  questions.add(QuestionChange::exchanged, QuestionPart::quantity,
                was == is ? exact_quantity(before) : was, was == is ? exact_quantity(after) : is);
}

// A mask's name is nothing where it is known what it does.
void compare_masks(QuestionList& questions, const rules::Requirement& before,
                   const rules::Requirement& after) {
  const auto words = [](const rules::Requirement& requirement) {
    if (requirement.mask.id.empty()) return std::string("all points");
    return requirement.mask_words.empty() ? requirement.mask.id : requirement.mask_words.english();
  };
  const bool is_unknown = before.mask_words.empty() != after.mask_words.empty() &&
                          before.mask.id == after.mask.id;  // results of earlier versions
  if (!is_unknown) questions.exchange(QuestionPart::mask, words(before), words(after));
}

std::string light_of(const rules::Requirement& requirement) {
  std::string words(calc::name_of(requirement.state));
  if (!requirement.scene.empty()) words += ", scene " + requirement.scene;
  return words + (requirement.direct_only ? ", direct light only" : "");
}

// Of the standard's scale; "modified" asks for at least as much as "required".
int level_rank(const rules::RowLevel& level) { return level.is_modified ? 1 : level.steps; }

void compare_rules(QuestionList& questions, const rules::Requirement& before,
                   const rules::Requirement& after) {
  const auto words = [](const rules::RuleOrigin& origin) {
    if (origin.pack.empty()) return std::string();
    return fmt::format("{} {} {}", origin.pack, origin.row, origin.check);
  };
  if (words(before.origin) != words(after.origin)) {
    const bool is_own_now = after.origin.pack.empty();
    return questions.add(is_own_now ? QuestionChange::weaker : QuestionChange::exchanged,
                         QuestionPart::rule, words(before.origin), words(after.origin));
  }
  questions.compare(QuestionPart::rule, level_rank(before.origin.level),
                    level_rank(after.origin.level), true, rules::level_name(before.origin.level),
                    rules::level_name(after.origin.level));
}

void compare_policies(QuestionList& questions, const rules::DecisionPolicy& before,
                      const rules::DecisionPolicy& after) {
  const std::string was = rules::policy_text(before), is = rules::policy_text(after);
  const bool is_rounded_alike = before.compares_rounded == after.compares_rounded &&
                                (!after.compares_rounded || before.rounding == after.rounding);
  const bool is_looser = (after.compares_rounded && !before.compares_rounded) ||
                         after.tolerance > before.tolerance || after.guard < before.guard;
  const bool is_tighter = (before.compares_rounded && !after.compares_rounded) ||
                          after.tolerance < before.tolerance || after.guard > before.guard;
  if (is_looser || is_tighter) {
    return questions.add(is_looser ? QuestionChange::weaker : QuestionChange::stricter,
                         QuestionPart::policy, was, is);
  }
  if (!is_rounded_alike) questions.add(QuestionChange::exchanged, QuestionPart::policy, was, is);
}

void compare_deviations(QuestionList& questions, const rules::Requirement& before,
                        const rules::Requirement& after) {
  const auto stated = [](const rules::Requirement& requirement, rules::FitAspect aspect) {
    for (const rules::Deviation& deviation : requirement.deviations) {
      if (deviation.aspect == aspect) return deviation.stated;
    }
    return std::optional<calc::Waiver>();
  };
  for (const auto& row : calc::EnumNames<rules::FitAspect>::list) {
    compare_leave(questions, QuestionPart::deviation, stated(before, row.value),
                  stated(after, row.value));
  }
}

// What of a row is asked for, by role.
bool is_asked(const rules::RoleCoverage& role) { return rules::is_of_findings(role.state); }

std::string row_name(const rules::RowCoverage& row) {
  return row.workplace.empty() ? row.clause.english() : row.workplace;
}

void compare_left_out(QuestionList& questions, const rules::RoleCoverage& before,
                      const rules::RoleCoverage& after) {
  const auto zones = match_parts(before.left_out, after.left_out,
                                 [](const rules::LeftOutZone& zone) { return zone.zone; });
  for (const PartPair<rules::LeftOutZone>& pair : zones) {
    std::optional<calc::Waiver> was, is;
    if (pair.before != nullptr) was = pair.before->by;
    if (pair.after != nullptr) is = pair.after->by;
    compare_leave(questions, QuestionPart::role, was, is,
                  pair.after != nullptr ? pair.after->zone : pair.before->zone);
  }
}

void compare_rows(QuestionList& questions, const rules::RowCoverage& before,
                  const rules::RowCoverage& after) {
  // Results of earlier versions have the text alone.
  const std::string was = before.clause.english(), is = after.clause.english();
  if (was != is) {
    questions.add(QuestionChange::exchanged, QuestionPart::rule, was, is, row_name(after));
  }
  const auto roles = match_parts(before.roles, after.roles,
                                 [](const rules::RoleCoverage& role) { return role.role; });
  for (const PartPair<rules::RoleCoverage>& pair : roles) {
    if (pair.before == nullptr || pair.after == nullptr) continue;  // other rows have other roles
    const std::string item = row_name(after) + ", " + pair.after->role;
    if (is_asked(*pair.before) != is_asked(*pair.after)) {
      questions.add(is_asked(*pair.after) ? QuestionChange::stricter : QuestionChange::weaker,
                    QuestionPart::role, std::string(calc::name_of(pair.before->state)),
                    std::string(calc::name_of(pair.after->state)), item);
    }
    compare_left_out(questions, *pair.before, *pair.after);
  }
}

// "4000 lm", and what the file says where that is something else.
std::string stated_words(const std::string& words, double stated, double of_file,
                         const std::string& file_words) {
  return of_file > 0.0 && !is_same_number(stated, of_file)
             ? fmt::format("{} (the file says {})", words, file_words)
             : words;
}

std::string flux_words(const LuminaireRow& row) {
  const std::string file = format_lumens(row.file_flux_lm) + " lm";
  return stated_words(format_lumens(row.flux_lm) + " lm", row.flux_lm, row.file_flux_lm, file);
}

std::string power_words(const LuminaireRow& row) {
  if (!(row.power_w > 0.0)) return "no power stated";
  const std::string file = format_watts(row.file_power_w) + " W";
  return stated_words(format_watts(row.power_w) + " W", row.power_w, row.file_power_w, file);
}

// What a project says beside the photometry: by which factor it is another number than the file's,
// or the number itself where the file has none.
double by_hand(double stated, double of_file) { return of_file > 0.0 ? stated / of_file : stated; }

// Whether the two can be compared by that: both by a factor, or the file is the same one.
bool is_by_hand(const LuminaireRow& before, const LuminaireRow& after, double file_before,
                double file_after) {
  const bool has_file = file_before > 0.0;
  if (has_file != (file_after > 0.0)) return false;
  return has_file || before.sha256 == after.sha256;
}

void compare_luminaires(QuestionList& questions, const LuminaireRow& before,
                        const LuminaireRow& after) {
  const bool is_other_type = before.type_id != after.type_id;
  const auto words = [&](const LuminaireRow& row, const std::string& text) {
    return is_other_type ? row.type_id + ": " + text : text;
  };
  questions.compare(QuestionPart::maintenance_factor, before.maintenance_factor,
                    after.maintenance_factor, false,
                    words(before, format_shortest(before.maintenance_factor)),
                    words(after, format_shortest(after.maintenance_factor)), after.type_id);
  if (is_by_hand(before, after, before.file_flux_lm, after.file_flux_lm)) {
    questions.compare(QuestionPart::flux, by_hand(before.flux_lm, before.file_flux_lm),
                      by_hand(after.flux_lm, after.file_flux_lm), false,
                      words(before, flux_words(before)), words(after, flux_words(after)),
                      after.type_id);
  }
  if (is_by_hand(before, after, before.file_power_w, after.file_power_w)) {
    questions.compare(QuestionPart::power, by_hand(before.power_w, before.file_power_w),
                      by_hand(after.power_w, after.file_power_w), true,
                      words(before, power_words(before)), words(after, power_words(after)),
                      after.type_id);
  }
}

using LuminairePair = std::pair<const LuminaireRow*, const LuminaireRow*>;

const LuminaireRow* row_of(const ProjectPart& project, const std::string& type_id) {
  const auto found = std::find_if(project.luminaires.begin(), project.luminaires.end(),
                                  [&](const LuminaireRow& row) { return row.type_id == type_id; });
  return found == project.luminaires.end() ? nullptr : &*found;
}

// Of all parts that are called the same or have the same photometry, and types that hang where
// others were, by themselves or nearest to them; each two once.
std::vector<LuminairePair> paired_luminaires(const ProjectPart& before, const ProjectPart& after) {
  std::set<std::pair<std::string, std::string>> known;
  std::vector<LuminairePair> pairs;
  for (const PartPair<LuminaireRow>& pair : match_luminaires(before.luminaires, after.luminaires)) {
    if (pair.before == nullptr || pair.after == nullptr) continue;
    known.emplace(pair.before->type_id, pair.after->type_id);
    pairs.emplace_back(pair.before, pair.after);
  }
  for (const PartPair<SpacePart>& room : match_rooms(before, after)) {
    if (room.before == nullptr || room.after == nullptr) continue;
    for (const auto& [was, is] : match_marks(room.before->luminaires, room.after->luminaires)) {
      if (was == nullptr || is == nullptr) continue;
      if (!known.emplace(was->type_id, is->type_id).second) continue;
      const LuminairePair pair{row_of(before, was->type_id), row_of(after, is->type_id)};
      if (pair.first != nullptr && pair.second != nullptr) pairs.push_back(pair);
    }
  }
  return pairs;
}

// What a type that nothing was before stands beside: the same photometry, or else its own file,
// with the largest maintenance factor that there was.
LuminaireRow as_before(const LuminaireRow& row, const ProjectPart& before) {
  LuminaireRow was = row;
  if (row.file_flux_lm > 0.0) was.flux_lm = row.file_flux_lm;
  if (row.file_power_w > 0.0) was.power_w = row.file_power_w;
  double highest = 0.0;
  for (const LuminaireRow& other : before.luminaires) {
    highest = std::max(highest, other.maintenance_factor);
    if (other.sha256 != row.sha256) continue;
    was = other;
    was.type_id = row.type_id;
    return was;
  }
  if (highest > 0.0) was.maintenance_factor = highest;
  return was;
}

// Less than before is no promise of a type that was not there: only what says more by hand counts.
std::vector<ChangedQuestion> compare_added_luminaires(const ProjectPart& before,
                                                      const ProjectPart& after,
                                                      const std::vector<LuminairePair>& pairs,
                                                      const RevisionPlace& place) {
  QuestionList questions(place);
  if (before.luminaires.empty()) return {};  // results of earlier versions
  for (const LuminaireRow& row : after.luminaires) {
    const bool is_paired = std::any_of(pairs.begin(), pairs.end(),
                                       [&](const auto& pair) { return pair.second == &row; });
    if (!is_paired) compare_luminaires(questions, as_before(row, before), row);
  }
  std::vector<ChangedQuestion> added = questions.take();
  std::erase_if(added, [](const auto& one) { return one.change == QuestionChange::stricter; });
  return added;
}

}  // namespace

std::vector<ChangedQuestion> compare_settings(const Provenance& before, const Provenance& after) {
  QuestionList questions{RevisionPlace{}};
  questions.compare(QuestionPart::confidence, before.confidence, after.confidence, true,
                    format_percent(before.confidence), format_percent(after.confidence));
  questions.compare(QuestionPart::accuracy, before.tolerance, after.tolerance, false,
                    format_percent(before.tolerance), format_percent(after.tolerance));
  questions.compare(QuestionPart::accuracy, before.replicates, after.replicates, true,
                    fmt::format("{} replicates", before.replicates),
                    fmt::format("{} replicates", after.replicates));
  const auto paths = [](const Provenance& of) {
    return fmt::format("at most {} paths per replicate", of.max_paths);
  };
  questions.compare(QuestionPart::accuracy, static_cast<double>(before.max_paths),
                    static_cast<double>(after.max_paths), true, paths(before), paths(after));
  const auto method = [](const Provenance& of) {
    return of.method.empty() ? std::string("as by default") : of.method;
  };
  questions.exchange(QuestionPart::method, method(before), method(after));
  if (before.goal != after.goal) {
    questions.add(
        after.goal == rules::Goal::verdict ? QuestionChange::weaker : QuestionChange::stricter,
        QuestionPart::accuracy, std::string(calc::name_of(before.goal)),
        std::string(calc::name_of(after.goal)));
  }
  return questions.take();
}

std::vector<ChangedQuestion> compare_project_question(const ProjectPart& before,
                                                      const ProjectPart& after,
                                                      const RevisionPlace& place) {
  QuestionList questions(place);
  const std::vector<LuminairePair> pairs = paired_luminaires(before, after);
  for (const auto& [was, is] : pairs) compare_luminaires(questions, *was, *is);
  std::vector<ChangedQuestion> all = questions.take();
  for (ChangedQuestion& added : compare_added_luminaires(before, after, pairs, place)) {
    all.push_back(std::move(added));
  }
  return all;
}

double share_of_maintenance(const RoomPair& room) {
  std::set<std::string> hanging;
  for (const LuminaireMark& mark : room.after.luminaires) hanging.insert(mark.type_id);
  std::vector<LuminairePair> pairs;
  for (const PartPair<LuminaireRow>& pair :
       match_luminaires(room.project_before.luminaires, room.project_after.luminaires)) {
    pairs.emplace_back(pair.before, pair.after);
  }
  for (const auto& [was, is] : match_marks(room.before.luminaires, room.after.luminaires)) {
    if (was == nullptr || is == nullptr) continue;
    pairs.emplace_back(row_of(room.project_before, was->type_id),
                       row_of(room.project_after, is->type_id));
  }
  double share = 0.0;
  std::set<std::string> known;
  for (const auto& [was, is] : pairs) {
    if (was == nullptr || is == nullptr || !hanging.contains(is->type_id)) continue;
    if (!(was->maintenance_factor > 0.0)) return 1.0;
    share = std::max(share, is->maintenance_factor / was->maintenance_factor);
    known.insert(is->type_id);
  }
  return known.empty() || known.size() < hanging.size() ? 1.0 : std::min(share, 1.0);
}

std::vector<ChangedQuestion> compare_room_question(const SpacePart& before, const SpacePart& after,
                                                   const RevisionPlace& place) {
  QuestionList questions(place);
  const auto rows = match_renamed(before.coverage, after.coverage, row_name,
                                  [](const rules::RowCoverage& row) { return row.was; });
  for (const PartPair<rules::RowCoverage>& pair : rows) {
    if (pair.after == nullptr) {
      questions.add(QuestionChange::weaker, QuestionPart::rule, pair.before->clause.english(), "",
                    row_name(*pair.before));
    } else if (pair.before == nullptr) {
      questions.add(QuestionChange::stricter, QuestionPart::rule, "", pair.after->clause.english(),
                    row_name(*pair.after));
    } else {
      compare_rows(questions, *pair.before, *pair.after);
    }
  }
  return questions.take();
}

std::vector<ChangedQuestion> compare_requirement(const rules::Requirement& before,
                                                 const rules::Requirement& after,
                                                 const RevisionPlace& place) {
  QuestionList questions(place);
  compare_quantities(questions, before, after);
  compare_limits(questions, before, after);
  questions.exchange(QuestionPart::light, light_of(before), light_of(after));
  compare_severities(questions, before.severity, after.severity);
  compare_rules(questions, before, after);
  compare_leave(questions, QuestionPart::waiver, before.waiver, after.waiver);
  compare_deviations(questions, before, after);
  compare_policies(questions, before.policy, after.policy);
  compare_masks(questions, before, after);
  questions.exchange(
      after.metric == rules::Metric::leni ? QuestionPart::energy : QuestionPart::stated,
      before.stated_words.english(), after.stated_words.english());
  return questions.take();
}

std::vector<ChangedQuestion> compare_aggregate(const rules::AggregateFinding& before,
                                               const rules::AggregateFinding& after,
                                               const RevisionPlace& place) {
  QuestionList questions(place);
  if (before.sum && after.sum) compare_rooms(questions, before, after);
  const auto rule = [](const rules::AggregateFinding& finding) {
    return fmt::format("{} of {}{} {}", calc::name_of(finding.rule), calc::name_of(finding.over),
                       finding.by_area ? " by area" : "", finding.asked);
  };
  questions.exchange(QuestionPart::rule, rule(before), rule(after));
  questions.compare(QuestionPart::limit, before.share, after.share, true,
                    format_percent(before.share), format_percent(after.share));
  questions.compare(QuestionPart::limit, before.count, after.count, true,
                    fmt::format("{}", before.count), fmt::format("{}", after.count));
  if (before.sum && after.sum && after.kind == rules::AggregateKind::building) {
    std::vector<ChangedQuestion> all = questions.take();
    for (ChangedQuestion& of_sum :
         compare_requirement(before.sum->requirement, after.sum->requirement, place)) {
      all.push_back(std::move(of_sum));
    }
    return all;
  }
  questions.compare(QuestionPart::aggregate, static_cast<double>(before.members.size()),
                    static_cast<double>(after.members.size()), true,
                    fmt::format("{} members", before.members.size()),
                    fmt::format("{} members", after.members.size()));
  compare_severities(questions, before.severity, after.severity);
  return questions.take();
}

}  // namespace report
