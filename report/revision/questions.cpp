#include "report/revision/questions.h"

#include "calc/base/names.h"
#include "calc/scene/polygon.h"
#include "report/text/number_format.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace report {
namespace {

constexpr double kSameShare = 1e-9;  // of numbers that were calculated, not written

bool is_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= kSameShare * std::max(std::abs(a), std::abs(b));
}

class Questions {
 public:
  explicit Questions(RevisionPlace place) : place_(std::move(place)) {}

  void add(QuestionChange change, QuestionPart part, std::string before, std::string after,
           const std::string& item = "") {
    ChangedQuestion question{change, part, place_, std::move(before), std::move(after)};
    if (!item.empty()) question.place.item = item;
    list_.push_back(std::move(question));
  }
  // Nothing where they are the same.
  void exchange(QuestionPart part, const std::string& before, const std::string& after) {
    if (before != after) add(QuestionChange::exchanged, part, before, after);
  }
  // A number of which more asks for more, or for less.
  void compare(QuestionPart part, double before, double after, bool more_is_stricter,
               const std::string& before_words, const std::string& after_words,
               const std::string& item = "") {
    if (is_same(before, after)) return;
    const bool is_known = std::isfinite(before) && std::isfinite(after);
    const bool is_stricter = (after > before) == more_is_stricter;
    add(!is_known     ? QuestionChange::exchanged
        : is_stricter ? QuestionChange::stricter
                      : QuestionChange::weaker,
        part, before_words, after_words, item);
  }
  std::vector<ChangedQuestion> take() { return std::move(list_); }

 private:
  RevisionPlace place_;
  std::vector<ChangedQuestion> list_;
};

// Something that lasts up to a day and lets a requirement go.
void compare_leave(Questions& questions, QuestionPart part,
                   const std::optional<calc::Waiver>& before,
                   const std::optional<calc::Waiver>& after, const std::string& item = "") {
  const auto words = [](const std::optional<calc::Waiver>& leave) {
    return leave ? rules::waiver_words(*leave) : std::string();
  };
  if (words(before) == words(after)) return;
  QuestionChange change = QuestionChange::exchanged;
  if (!before || (after && after->until > before->until)) change = QuestionChange::weaker;
  if (before && (!after || after->until < before->until)) change = QuestionChange::stricter;
  questions.add(change, part, words(before), words(after), item);
}

void compare_severities(Questions& questions, rules::Severity before, rules::Severity after) {
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

void compare_limits(Questions& questions, const rules::Requirement& before,
                    const rules::Requirement& after) {
  const bool is_lower = rules::is_lower_limit(after.comparison);
  if (rules::is_lower_limit(before.comparison) != is_lower) {
    return questions.add(QuestionChange::exchanged, QuestionPart::quantity, limit_words(before),
                         limit_words(after));
  }
  if (!is_same(before.limit, after.limit)) {
    return questions.compare(QuestionPart::limit, before.limit, after.limit, is_lower,
                             limit_words(before), limit_words(after));
  }
  if (before.comparison == after.comparison) return;
  const bool allows_limit = after.comparison == rules::Comparison::at_least ||
                            after.comparison == rules::Comparison::at_most;
  questions.add(allows_limit ? QuestionChange::weaker : QuestionChange::stricter,
                QuestionPart::limit, limit_words(before), limit_words(after));
}

// What is looked at, in the words of reports, with all that they leave out.
std::string quantity_of(const rules::Requirement& requirement) {
  std::string words = quantity_words(requirement);
  if (requirement.metric == rules::Metric::share) {
    words += fmt::format(" from {} to {}", format_shortest(requirement.range.from),
                         std::isfinite(requirement.range.to) ? format_shortest(requirement.range.to)
                                                             : std::string("any"));
  }
  if (requirement.facing) words += " facing " + format_position(*requirement.facing);
  if (requirement.any_one_unit_out) words += " with any one luminaire out";
  return words;
}

std::string light_of(const rules::Requirement& requirement) {
  std::string words(calc::name_of(requirement.state));
  if (!requirement.scene.empty()) words += ", scene " + requirement.scene;
  return words + (requirement.direct_only ? ", direct light only" : "");
}

// Of the standard's scale; "modified" asks for at least as much as "required".
int level_rank(const rules::RowLevel& level) { return level.is_modified ? 1 : level.steps; }

void compare_rules(Questions& questions, const rules::Requirement& before,
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

void compare_policies(Questions& questions, const rules::DecisionPolicy& before,
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

void compare_deviations(Questions& questions, const rules::Requirement& before,
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

struct PlaneShape {
  std::vector<glm::dvec3> corner_m;
  double area_m2 = 0.0;
  double width_m = 0.0;  // of routes
};

PlaneShape shape_of(const PlanePart& plane) {
  PlaneShape shape;
  const calc::SensorGrid& grid = plane.grid;
  if (grid.route) {
    shape.corner_m = grid.route->line.corner_m;
    shape.width_m = grid.route->line.width_m;
    for (std::size_t k = 1; k < shape.corner_m.size(); ++k) {
      shape.area_m2 += shape.width_m * glm::length(shape.corner_m[k] - shape.corner_m[k - 1]);
    }
    return shape;
  }
  const auto add = [&](const std::vector<glm::dvec2>& outline) {
    for (const glm::dvec2& corner : outline) {
      shape.corner_m.push_back(grid.origin_m + corner.x * grid.u + corner.y * grid.v);
    }
  };
  add(plane.outline_m);
  shape.area_m2 = std::abs(calc::signed_area(plane.outline_m));
  for (const std::vector<glm::dvec2>& hole : plane.holes_m) {
    add(hole);
    shape.area_m2 -= std::abs(calc::signed_area(hole));
  }
  if (!shape.corner_m.empty()) return shape;
  for (const PointRow& point : plane.points) shape.corner_m.push_back(point.position_m);
  return shape;
}

bool is_same(const PlaneShape& a, const PlaneShape& b) {
  if (a.corner_m.size() != b.corner_m.size() || !is_same(a.width_m, b.width_m)) return false;
  for (std::size_t k = 0; k < a.corner_m.size(); ++k) {
    if (!is_same_place(a.corner_m[k], b.corner_m[k])) return false;
  }
  return true;
}

std::string shape_words(const PlaneShape& shape) {
  std::string words;
  if (shape.area_m2 > 0.0) words = fmt::format("{:.4g} m2 ", shape.area_m2);
  if (!shape.corner_m.empty()) words += "from " + format_position(shape.corner_m.front());
  return words;
}

// Whether the area is the same, so that its points can be compared.
bool compare_areas(Questions& questions, const PlanePart& before, const PlanePart& after) {
  const PlaneShape was = shape_of(before), is = shape_of(after);
  if (is_same(was, is)) return true;
  constexpr double kSmaller = 1.0 - 1e-6;
  const bool is_smaller =
      is.area_m2 < kSmaller * was.area_m2 || is.corner_m.size() < was.corner_m.size();
  questions.add(is_smaller ? QuestionChange::weaker : QuestionChange::exchanged, QuestionPart::area,
                shape_words(was), shape_words(is));
  return false;
}

std::string facing_words(const glm::dvec3& normal) {
  return fmt::format("facing ({:.3g} {:.3g} {:.3g})", normal.x, normal.y, normal.z);
}

// Of the first point that faces another way.
void compare_facing(Questions& questions, const PlanePart& before, const PlanePart& after) {
  constexpr double kSameWay = 1e-6;
  if (before.points.empty() || before.points.size() != after.points.size()) return;
  for (std::size_t k = 0; k < before.points.size(); ++k) {
    if (glm::length(before.points[k].normal - after.points[k].normal) <= kSameWay) continue;
    return questions.add(QuestionChange::exchanged, QuestionPart::area,
                         facing_words(before.points[k].normal),
                         facing_words(after.points[k].normal));
  }
}

std::string grid_words(const PlanePart& plane) {
  if (plane.grid.columns == 0) return fmt::format("{} points", plane.points.size());
  return fmt::format("{} x {} points", plane.grid.columns, plane.grid.rows);
}

void compare_grids(Questions& questions, const PlanePart& before, const PlanePart& after) {
  const auto cells = [](const PlanePart& plane) {
    return plane.grid.columns == 0
               ? static_cast<double>(plane.points.size())
               : static_cast<double>(plane.grid.columns) * static_cast<double>(plane.grid.rows);
  };
  if (cells(before) == cells(after)) {
    questions.exchange(QuestionPart::grid, grid_words(before), grid_words(after));
  }
  questions.compare(QuestionPart::grid, cells(before), cells(after), true, grid_words(before),
                    grid_words(after));
}

// What of a row is asked for, by role.
bool is_asked(const rules::RoleCoverage& role) { return rules::is_of_findings(role.state); }

std::string row_name(const rules::RowCoverage& row) {
  return row.workplace.empty() ? row.clause : row.workplace;
}

void compare_left_out(Questions& questions, const rules::RoleCoverage& before,
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

void compare_rows(Questions& questions, const rules::RowCoverage& before,
                  const rules::RowCoverage& after) {
  if (before.clause != after.clause) {
    questions.add(QuestionChange::exchanged, QuestionPart::rule, before.clause, after.clause,
                  row_name(after));
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

std::string watts_words(const LuminaireRow& row) {
  return row.power_w > 0.0 ? format_watts(row.power_w) + " W" : std::string("no power stated");
}

}  // namespace

bool is_same_area(const PlanePart& before, const PlanePart& after) {
  return is_same(shape_of(before), shape_of(after));
}

std::vector<ChangedQuestion> compare_settings(const Provenance& before, const Provenance& after) {
  Questions questions{RevisionPlace{}};
  questions.compare(QuestionPart::confidence, before.confidence, after.confidence, true,
                    format_percent(before.confidence), format_percent(after.confidence));
  questions.compare(QuestionPart::accuracy, before.tolerance, after.tolerance, false,
                    format_percent(before.tolerance), format_percent(after.tolerance));
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
  Questions questions(place);
  const auto types = match_luminaires(before.luminaires, after.luminaires);
  for (const PartPair<LuminaireRow>& pair : types) {
    if (pair.before == nullptr || pair.after == nullptr) continue;
    const LuminaireRow &was = *pair.before, &is = *pair.after;
    questions.compare(QuestionPart::maintenance_factor, was.maintenance_factor,
                      is.maintenance_factor, false, format_shortest(was.maintenance_factor),
                      format_shortest(is.maintenance_factor), is.type_id);
    if (was.sha256 != is.sha256) continue;  // another luminaire: its lumens are its own
    questions.compare(QuestionPart::flux, was.flux_lm, is.flux_lm, false,
                      format_lumens(was.flux_lm) + " lm", format_lumens(is.flux_lm) + " lm",
                      is.type_id);
    if (was.power_w != is.power_w) {
      const bool is_less = is.power_w < was.power_w;
      questions.add(is_less ? QuestionChange::weaker : QuestionChange::stricter,
                    QuestionPart::power, watts_words(was), watts_words(is), is.type_id);
    }
  }
  return questions.take();
}

std::vector<ChangedQuestion> compare_room_question(const SpacePart& before, const SpacePart& after,
                                                   const RevisionPlace& place) {
  Questions questions(place);
  const auto rows = match_parts(before.coverage, after.coverage, row_name);
  for (const PartPair<rules::RowCoverage>& pair : rows) {
    if (pair.after == nullptr) {
      questions.add(QuestionChange::weaker, QuestionPart::rule, pair.before->clause, "",
                    row_name(*pair.before));
    } else if (pair.before == nullptr) {
      questions.add(QuestionChange::stricter, QuestionPart::rule, "", pair.after->clause,
                    row_name(*pair.after));
    } else {
      compare_rows(questions, *pair.before, *pair.after);
    }
  }
  return questions.take();
}

std::vector<ChangedQuestion> compare_plane_question(const PlanePart& before, const PlanePart& after,
                                                    const RevisionPlace& place) {
  Questions questions(place);
  questions.exchange(QuestionPart::quantity, plane_words(before), plane_words(after));
  if (!before.is_computed || !after.is_computed) return questions.take();  // no grid to compare
  const bool is_same_area = compare_areas(questions, before, after);
  questions.compare(QuestionPart::margin, before.grid.margin_m, after.grid.margin_m, false,
                    format_metres(before.grid.margin_m) + " m",
                    format_metres(after.grid.margin_m) + " m");
  if (is_same_area) {
    compare_facing(questions, before, after);
    compare_grids(questions, before, after);
  }
  questions.compare(QuestionPart::lost_points, static_cast<double>(before.grid.dropped.size()),
                    static_cast<double>(after.grid.dropped.size()), false,
                    fmt::format("{}", before.grid.dropped.size()),
                    fmt::format("{}", after.grid.dropped.size()));
  return questions.take();
}

std::vector<ChangedQuestion> compare_requirement(const rules::Requirement& before,
                                                 const rules::Requirement& after,
                                                 const RevisionPlace& place) {
  Questions questions(place);
  questions.exchange(QuestionPart::quantity, quantity_of(before), quantity_of(after));
  compare_limits(questions, before, after);
  questions.exchange(QuestionPart::light, light_of(before), light_of(after));
  compare_severities(questions, before.severity, after.severity);
  compare_rules(questions, before, after);
  compare_leave(questions, QuestionPart::waiver, before.waiver, after.waiver);
  compare_deviations(questions, before, after);
  compare_policies(questions, before.policy, after.policy);
  questions.exchange(QuestionPart::mask, before.mask.id, after.mask.id);
  return questions.take();
}

std::vector<ChangedQuestion> compare_aggregate(const rules::AggregateFinding& before,
                                               const rules::AggregateFinding& after,
                                               const RevisionPlace& place) {
  Questions questions(place);
  const auto rule = [](const rules::AggregateFinding& finding) {
    return fmt::format("{} of {}{} {}", calc::name_of(finding.rule), calc::name_of(finding.over),
                       finding.by_area ? " by area" : "", finding.asked);
  };
  questions.exchange(QuestionPart::rule, rule(before), rule(after));
  questions.compare(QuestionPart::limit, before.share, after.share, true,
                    format_percent(before.share), format_percent(after.share));
  questions.compare(QuestionPart::limit, before.count, after.count, true,
                    fmt::format("{}", before.count), fmt::format("{}", after.count));
  questions.compare(QuestionPart::aggregate, static_cast<double>(before.members.size()),
                    static_cast<double>(after.members.size()), true,
                    fmt::format("{} members", before.members.size()),
                    fmt::format("{} members", after.members.size()));
  compare_severities(questions, before.severity, after.severity);
  return questions.take();
}

}  // namespace report
