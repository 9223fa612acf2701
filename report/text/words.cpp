#include "report/text/words.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/document/one_source.h"
#include "report/text/clause_words.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <utility>
#include <variant>

namespace report {
namespace {

constexpr double kStraight = 1e-6;  // of a direction cosine

// "share of points from 300 to 500 lx"
// Of the luminaires that count; "" = all.
std::string mounting_words(const Texts& t, const rules::HeightRange& range) {
  const bool has_to = std::isfinite(range.to_m);
  const std::string to = has_to ? format_shortest(t, range.to_m) : "";
  if (range.from_m > 0.0 && has_to) {
    return ", " + t.say<Text::mounted_between>(format_shortest(t, range.from_m), to);
  }
  if (has_to) return ", " + t.say<Text::mounted_below>(to);
  if (range.from_m > 0.0) {
    return ", " + t.say<Text::mounted_from>(format_shortest(t, range.from_m));
  }
  return {};
}

std::string range_words(const Texts& t, const rules::ValueRange& range,
                        calc::DerivedQuantity derived) {
  std::string words = t[Text::share];
  if (range.from > 0.0) words += " " + t.say<Text::range_from>(format_shortest(t, range.from));
  if (std::isfinite(range.to)) words += " " + t.say<Text::range_to>(format_shortest(t, range.to));
  const std::string unit = calc::unit_of(derived);
  return unit.empty() ? words : words + " " + unit;
}

struct MetricText {
  rules::Metric metric;
  Text text;
};
constexpr std::array kMetricTexts{
#define TEXT(id, text)
#define METRIC_TEXT(id, text) MetricText{rules::Metric::id, Text::id},
#include "report/text/english.def"
#undef TEXT
};

constexpr Text metric_text(rules::Metric metric) {
  return std::find_if(kMetricTexts.begin(), kMetricTexts.end(),
                      [metric](const MetricText& known) { return known.metric == metric; })
      ->text;
}
static_assert(kMetricTexts.size() == rules::kMetrics.size() &&
                  std::all_of(rules::kMetrics.begin(), rules::kMetrics.end(),
                              [](const rules::MetricRow& row) {
                                return std::count_if(kMetricTexts.begin(), kMetricTexts.end(),
                                                     [&row](const MetricText& known) {
                                                       return known.metric == row.metric;
                                                     }) == 1;
                              }),
              "every statistic has its METRIC_TEXT");

// A quantity by itself, after "average", and as the values of a plane.
struct QuantityTexts {
  Text alone, of, of_plane;
};

QuantityTexts quantity_texts(calc::ReceiverKernel kernel, calc::DerivedQuantity derived) {
  switch (derived) {
    case calc::DerivedQuantity::none:
      break;
    case calc::DerivedQuantity::ugr:
      return {Text::ugr, Text::of_ugr, Text::initial_ugr};
    case calc::DerivedQuantity::modelling:
      return {Text::modelling, Text::of_modelling, Text::maintained_modelling};
    case calc::DerivedQuantity::four_planes:
      return {Text::four_planes, Text::of_four_planes, Text::maintained_four_planes};
  }
  switch (kernel) {
    case calc::ReceiverKernel::planar:
      break;
    case calc::ReceiverKernel::cylindrical:
      return {Text::cylindrical, Text::of_cylindrical, Text::maintained_cylindrical};
    case calc::ReceiverKernel::semicylindrical:
      return {Text::semicylindrical, Text::of_semicylindrical, Text::maintained_semicylindrical};
    case calc::ReceiverKernel::hemispherical:
      return {Text::hemispherical, Text::of_hemispherical, Text::maintained_hemispherical};
    case calc::ReceiverKernel::scalar:
      return {Text::scalar, Text::of_scalar, Text::maintained_scalar};
  }
  return {Text::illuminance, Text::of_illuminance, Text::maintained_illuminance};
}

}  // namespace

const char* outcome_symbol(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::not_judged:
      break;
    case rules::Outcome::warned:
      return "!";
    case rules::Outcome::fail:
      return "✗";
    case rules::Outcome::undecided:
      return "?";
    case rules::Outcome::pass:
    case rules::Outcome::waived:
      return "✓";
    case rules::Outcome::nothing_asked:
      return "○";
  }
  return "–";
}

const char* verdict_symbol(rules::Verdict verdict) {
  return outcome_symbol(rules::outcome_of(verdict));
}

const char* outcome_words(const Texts& t, rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::not_judged:
      break;
    case rules::Outcome::warned:
      return t[Text::outcome_warned];
    case rules::Outcome::fail:
      return t[Text::verdict_fail];
    case rules::Outcome::undecided:
      return t[Text::verdict_undecided];
    case rules::Outcome::pass:
      return t[Text::verdict_pass];
    case rules::Outcome::waived:
      return t[Text::waived];
    case rules::Outcome::nothing_asked:
      return t[Text::outcome_nothing_asked];
  }
  return t[Text::verdict_not_judged];
}

const char* verdict_words(const Texts& t, rules::Verdict verdict) {
  return outcome_words(t, rules::outcome_of(verdict));
}

namespace {

// Not maintained: what it is stands beside it.
bool is_shown_in_other_state(const PlanePart& plane) {
  return plane.asked_light && plane.asked_light->is_shown &&
         plane.asked_light->state != rules::LightState::maintained;
}

}  // namespace

const char* light_state_words(const Texts& t, rules::LightState state) {
  switch (state) {
    case rules::LightState::maintained:
      return t[Text::state_maintained];
    case rules::LightState::initial:
      return t[Text::state_initial];
    case rules::LightState::end_of_duration:
      break;
  }
  return t[Text::state_end_of_duration];
}

const char* plane_words(const Texts& t, calc::ReceiverKernel kernel,
                        calc::DerivedQuantity derived) {
  return t[quantity_texts(kernel, derived).alone];
}

const char* of_plane_words(const Texts& t, const PlanePart& plane) {
  return t[quantity_texts(plane.kernel, plane.derived).of];
}

std::string state_plane_words(const Texts& t, const PlanePart& plane) {
  if (is_shown_in_other_state(plane)) return t.say<Text::shown_quantity>(plane_words(t, plane));
  return t[quantity_texts(plane.kernel, plane.derived).of_plane];
}

std::string values_words(const Texts& t, const PlanePart& plane) {
  std::string words = state_plane_words(t, plane);
  if (*plane_unit(plane) != '\0') words += std::string(" ") + t[Text::in_lx];
  return words;
}

const char* state_words(const Texts& t, const PlanePart& plane) {
  if (is_shown_in_other_state(plane)) return light_state_words(t, plane.asked_light->state);
  return t[plane.derived == calc::DerivedQuantity::ugr ? Text::initial : Text::maintained];
}

const char* value_key(calc::DerivedQuantity derived) {
  if (derived == calc::DerivedQuantity::ugr) return "ugr";
  return derived == calc::DerivedQuantity::modelling ? "modelling" : "illuminance_lx";
}

std::string quantity_words(const Texts& t, const rules::Requirement& requirement) {
  const rules::MetricArguments& arguments = requirement.arguments;
  if (const auto* of = std::get_if<rules::Percentile>(&arguments)) {
    return t.say<Text::percentile>(format_shortest(t, of->percent));
  }
  if (const auto* range = std::get_if<rules::ValueRange>(&arguments)) {
    return range_words(t, *range, requirement.derived);
  }
  if (const auto* at = std::get_if<rules::PointOfValue>(&arguments); at && at->point_m) {
    const std::string place = format_position(t, *at->point_m);
    return at->facing ? t.say<Text::value_at_facing>(place, format_position(t, *at->facing))
                      : t.say<Text::value_at>(place);
  }
  return t[metric_text(requirement.metric)] +
         mounting_words(t, rules::argument_of<rules::HeightRange>(requirement));
}

std::string quantity_words(const Texts& t, const rules::Requirement& requirement,
                           calc::ReceiverKernel kernel) {
  const std::string words = quantity_words(t, requirement);
  if (rules::is_of_space(requirement.metric)) return words;
  if (kernel == calc::ReceiverKernel::planar &&
      requirement.derived == calc::DerivedQuantity::none) {
    return words;
  }
  return words + " " + t[quantity_texts(kernel, requirement.derived).of];
}

const char* comparison_sign(rules::Comparison comparison) {
  switch (comparison) {
    case rules::Comparison::at_least:
      return "≥";
    case rules::Comparison::at_most:
      return "≤";
    case rules::Comparison::more_than:
      return ">";
    case rules::Comparison::less_than:
      return "<";
  }
  return "";
}

std::string scene_words(const Texts& t, const rules::Requirement& requirement) {
  std::string text;
  if (requirement.state != rules::LightState::maintained) {
    text += std::string(", ") + light_state_words(t, requirement.state);
  }
  if (!requirement.scene.empty()) text += ", " + t.say<Text::scene>(printable(requirement.scene));
  return text;
}

namespace {

bool leaves_points_out(const PlanePart& plane) {
  return std::any_of(plane.findings.begin(), plane.findings.end(),
                     [&](const rules::Finding& finding) {
                       const rules::Mask& mask = finding.requirement.mask;
                       return !rules::is_of_space(finding.requirement.metric) &&
                              (!mask.id.empty() || !mask.operations.empty());
                     });
}

}  // namespace

std::string asked_light_words(const Texts& t, const AskedLight& light) {
  std::string words;
  const auto add = [&](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  add(light.scene.empty() ? t[Text::full_output] : t.say<Text::scene>(printable(light.scene)));
  if (light.state != rules::LightState::maintained) add(light_state_words(t, light.state));
  if (light.direct_only) add(t[Text::note_direct_only]);
  return words;
}

std::string other_light_words(const Texts& t, const PlanePart& plane) {
  if (plane.asked_light && plane.asked_light->is_shown)
    return t.say<Text::asked_light>(asked_light_words(t, *plane.asked_light)) +
           (leaves_points_out(plane) ? std::string(" ") + t[Text::asked_light_masked] : "");
  std::vector<std::string> lights;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& asked = finding.requirement;
    if (asked.scene.empty() && !asked.direct_only) continue;
    if (rules::is_of_space(asked.metric)) continue;
    std::string words = asked.scene.empty() ? "" : t.say<Text::scene>(printable(asked.scene));
    if (asked.direct_only)
      words += (words.empty() ? "" : ", ") + std::string(t[Text::note_direct_only]);
    if (std::find(lights.begin(), lights.end(), words) == lights.end()) lights.push_back(words);
  }
  std::string all;
  for (const std::string& light : lights) all += (all.empty() ? "" : "; ") + light;
  return all.empty() ? "" : t.say<Text::other_light>(all);
}

namespace {

// "surround, wall (window wall)"; "" if no role is in one of the states.
std::string roles_in(const Texts& t, const rules::RowCoverage& row,
                     std::initializer_list<rules::RoleState> states) {
  std::string words;
  for (const rules::RoleCoverage& role : row.roles) {
    if (std::find(states.begin(), states.end(), role.state) == states.end()) continue;
    words += (words.empty() ? "" : ", ") + role_words(t, role.role);
    if (!role.words.empty()) words += " (" + printable(sentence(t, role.words)) + ")";
  }
  return words;
}

}  // namespace

std::string coverage_words(const Texts& t, const rules::RowCoverage& row) {
  using enum rules::RoleState;
  const std::string title =
      (row.workplace.empty() ? "" : printable(row.workplace) + ", ") +
      clause_words(t, row.clause, rules::source_of_pack(row.is_user_supplied));
  const auto end = [&](const std::string& words) { return words.empty() ? "" : "; " + words; };
  const auto said = [&](const std::string& roles, auto say) {
    return roles.empty() ? std::string() : say(roles);
  };
  const std::string asked =
      roles_in(t, row, {met, failed, undecided, not_judged, waived, asked_in_part});
  std::string words = !row.is_whole() && asked.empty()  ? t.say<Text::row_not_asked>(title)
                      : !row.is_whole()                 ? t.say<Text::row_in_part>(title, asked)
                      : row.is_met() && !row.asks_all() ? t.say<Text::row_possible_is_met>(title)
                      : row.is_met()                    ? t.say<Text::row_is_met>(title)
                      : row.is_accepted()               ? t.say<Text::row_is_accepted>(title)
                      : row.has_exceptions() || !row.asks_all() ? t.say<Text::row_is_not_met>(title)
                                                                : t.say<Text::row_is_asked>(title);
  if (row.is_whole()) {
    std::string waived_roles, zones;
    const auto add = [&t](const std::string& role, std::string& list) {
      list += (list.empty() ? "" : ", ") + printable(role_words(t, role));
    };
    for (const rules::RoleCoverage& role : row.roles) {
      if (role.state == waived) add(role.role, waived_roles);
      for (const rules::LeftOutZone& zone : role.left_out) add(zone.zone, zones);
    }
    words += end(
        said(waived_roles, [&](const auto& roles) { return t.say<Text::roles_waived>(roles); }));
    words +=
        end(said(zones, [&](const auto& roles) { return t.say<Text::roles_left_out>(roles); }));
  }
  words += end(said(roles_in(t, row, {never_asked, left_out_ended}),
                    [&](const auto& roles) { return t.say<Text::roles_never_asked>(roles); }));
  words += end(said(roles_in(t, row, {not_possible}),
                    [&](const auto& roles) { return t.say<Text::roles_not_possible>(roles); }));
  return words;
}

namespace {

const char* rounding_words(const Texts& t, rules::Rounding rounding) {
  switch (rounding) {
    case rules::Rounding::half_up:
      return t[Text::policy_half_up];
    case rules::Rounding::half_even:
      return t[Text::policy_half_even];
    case rules::Rounding::down:
      break;
  }
  return t[Text::policy_down];
}

// As rules::policy_text(), in the reader's language.
std::string policy_words(const Texts& t, const rules::DecisionPolicy& policy) {
  const auto percent = [&t](double share) { return t.number(fmt::format("{:g}", 100.0 * share)); };
  std::string text = policy.compares_rounded
                         ? t.say<Text::policy_rounded>(rounding_words(t, policy.rounding),
                                                       policy.illuminance_digits,
                                                       policy.ratio_digits, policy.other_digits)
                         : t[Text::policy_unrounded];
  text += ", ";
  text += policy.tolerance == 0.0
              ? t[Text::policy_no_tolerance]
              : t.say<Text::policy_tolerance>(percent(policy.tolerance), policy.tolerance_reason);
  if (policy.guard > 0.0) text += ", " + t.say<Text::policy_guard>(percent(policy.guard));
  return text;
}

const char* aspect_words(const Texts& t, rules::FitAspect aspect) {
  switch (aspect) {
    case rules::FitAspect::orientation:
      return t[Text::aspect_orientation];
    case rules::FitAspect::place:
      return t[Text::aspect_place];
    case rules::FitAspect::height:
      return t[Text::aspect_height];
    case rules::FitAspect::grid:
      return t[Text::aspect_grid];
    case rules::FitAspect::margin:
      return t[Text::aspect_margin];
    case rules::FitAspect::points:
      break;
  }
  return t[Text::aspect_points];
}

}  // namespace

bool is_outside_advice(const rules::Requirement& requirement, rules::Verdict verdict) {
  return requirement.severity == rules::Severity::advice && verdict == rules::Verdict::fail;
}

std::string advice_range_words(const Texts& t, const PlanePart& plane,
                               const rules::Finding& finding) {
  const rules::Requirement& own = finding.requirement;
  const char* unit = rules::unit_of(own);
  const bool is_ratio = rules::is_ratio(own.metric);
  const auto is_lower = [](const rules::Requirement& of) {
    return rules::is_lower_limit(of.comparison);
  };
  const auto other =
      std::find_if(plane.findings.begin(), plane.findings.end(), [&](const auto& candidate) {
        const rules::Requirement& of = candidate.requirement;
        return of.severity == rules::Severity::advice && of.derived == own.derived &&
               std::string_view(rules::unit_of(of)) == unit &&
               rules::is_ratio(of.metric) == is_ratio && of.clause == own.clause &&
               of.scene == own.scene && of.state == own.state && is_lower(of) != is_lower(own) &&
               is_lower(of) == (of.limit < own.limit);
      });
  if (other == plane.findings.end()) {
    return t.say<Text::advice_limit>(format_required(t, {own.limit, own.comparison}, unit));
  }
  const double limit = other->requirement.limit;
  return t.say<Text::advice_range>(format_limit(t, std::min(limit, own.limit), ""),
                                   format_limit(t, std::max(limit, own.limit), unit));
}

std::string mask_name(const Texts& t, std::string_view id) {
  constexpr std::pair<std::string_view, Text> kMasks[] = {{"edge", Text::mask_edge},
                                                          {"wall-zone", Text::mask_wall_zone},
                                                          {"core", Text::mask_core},
                                                          {"width", Text::mask_width},
                                                          {"middle-line", Text::mask_middle_line},
                                                          {"middle-half", Text::mask_middle_half}};
  const auto* const row = std::find_if(std::begin(kMasks), std::end(kMasks),
                                       [&](const auto& known) { return known.first == id; });
  return row == std::end(kMasks) ? std::string(id) : t[row->second];
}

namespace {

// note: that of the requirement.
std::vector<NotePart> parts_after(const Texts& t, calc::Message note,
                                  const rules::Finding& finding) {
  std::vector<NotePart> parts;
  const rules::Requirement& requirement = finding.requirement;
  if (!note.empty()) parts.push_back({std::move(note), ""});
  const auto add = [&parts](std::string text) { parts.push_back({{}, std::move(text)}); };
  if (requirement.severity == rules::Severity::advice) add(t[Text::note_advice]);
  if (requirement.severity == rules::Severity::in_aggregate) add(t[Text::note_in_aggregate]);
  if (requirement.direct_only) add(t[Text::note_direct_only]);
  if (!requirement.mask.id.empty()) {
    const std::string name = mask_name(t, requirement.mask.id);
    const std::size_t points = finding.points_used;
    add(points == 0   ? t.say<Text::note_mask>(name)
        : points == 1 ? t.say<Text::note_mask_point>(name, points)
                      : t.say<Text::note_mask_points>(name, points));
    parts.back().is_mask = true;
  }
  if (!requirement.policy.is_default()) add(policy_words(t, requirement.policy));
  if (finding.by_tolerance) add(t[Text::note_tolerance]);
  for (const rules::Deviation& deviation : requirement.deviations) {
    if (!deviation.is_accepted || !deviation.stated) continue;
    add(t.say<Text::note_deviation>(aspect_words(t, deviation.aspect), sentence(t, deviation.words),
                                    printable(deviation.stated->owner), deviation.stated->until,
                                    printable(deviation.stated->reason)));
  }
  return parts;
}

std::string joined_parts(const Texts& t, const std::vector<NotePart>& parts) {
  std::string words;
  for (const NotePart& part : parts) {
    words += words.empty() ? "" : "; ";
    words += part.message.empty() ? part.text : sentence(t, part.message);
  }
  return words;
}

}  // namespace

std::vector<NotePart> note_parts(const Texts& t, const rules::Finding& finding) {
  return parts_after(t, without_one_source(finding.requirement.note), finding);
}

std::string note_words(const Texts& t, const rules::Finding& finding) {
  return joined_parts(t, note_parts(t, finding));
}

std::string marked_note_words(const rules::Finding& finding) {
  return joined_parts({}, parts_after({}, finding.requirement.note, finding));
}

std::string_view title_of(std::string_view name, std::string_view id) {
  return name.empty() ? id : name;
}

std::string role_words(const Texts& t, std::string_view role) {
  return t.language() == Language::english ? std::string(role) : role_name(t, role);
}

std::string plane_title(const Texts& t, const PlanePart& plane) {
  const std::string title(title_of(plane.name, plane.id)), role = made_role(plane);
  if (t.language() == Language::english || role.empty()) return title;
  return title.substr(0, title.size() - role.size()) + role_name(t, role);
}

const char* stop_words(const Texts& t, calc::StopReason stop) {
  switch (stop) {
    case calc::StopReason::exact:
      return t[Text::stop_exact];
    case calc::StopReason::decided:
      return t[Text::stop_decided];
    case calc::StopReason::accurate:
      return t[Text::stop_accurate];
    case calc::StopReason::path_limit:
      return t[Text::stop_path_limit];
    case calc::StopReason::time_limit:
      return t[Text::stop_time_limit];
    case calc::StopReason::memory_limit:
      return t[Text::stop_memory_limit];
    case calc::StopReason::endless_path:
      return t[Text::stop_endless_path];
    case calc::StopReason::interrupted:
      break;
  }
  return t[Text::stop_interrupted];
}

const char* drop_words(const Texts& t, calc::DropReason reason) {
  switch (reason) {
    case calc::DropReason::outside_area:
      return t[Text::drop_outside_area];
    case calc::DropReason::within_margin:
      return t[Text::drop_within_margin];
    case calc::DropReason::outside_room:
      return t[Text::drop_outside_room];
    case calc::DropReason::without_floor:
      return t[Text::drop_without_floor];
    case calc::DropReason::in_the_way:
      return t[Text::drop_in_the_way];
    case calc::DropReason::in_surface:
      return t[Text::drop_in_surface];
    case calc::DropReason::inside_solid:
      break;
  }
  return t[Text::drop_inside_solid];
}

std::string summary_words(const Texts& t, const Totals& totals) {
  VerdictCounts counts = totals.verdicts;
  const int not_judged_projects = totals.projects_not_judged;
  counts.not_judged -= not_judged_projects;
  const int total = counts.all();
  std::string text =
      total == 1 ? t.say<Text::one_requirement>(total) : t.say<Text::requirements>(total);
  const char* separator = t[Text::colon];
  const auto add = [&](int count, Text word) {
    if (count == 0) return;
    text += separator + t.say<Text::count_of>(count, t[word]);
    separator = ", ";
  };
  add(counts.pass, Text::verdict_pass);
  add(counts.fail, Text::verdict_fail);
  add(counts.undecided, Text::verdict_undecided);
  add(counts.not_judged, Text::verdict_not_judged);
  add(counts.waived, Text::waived);
  if (counts.deviating > 0) {
    text += separator + t.say<Text::with_deviations>(counts.deviating);
    separator = ", ";
  }
  if (totals.is_selection_empty()) {
    text += std::string(separator) + t[Text::nothing_chosen];
  } else if (totals.outcome == rules::Outcome::nothing_asked) {
    text += std::string(separator) + outcome_words(t, totals.outcome);
  }
  if (const int parts = totals.rows_in_part; parts > 0) {
    text += "; " +
            (parts == 1 ? t.say<Text::one_row_in_part>(parts) : t.say<Text::rows_in_part>(parts));
  }
  if (not_judged_projects == 1) text += "; " + t.say<Text::one_project_not_judged>(1);
  if (not_judged_projects > 1) text += "; " + t.say<Text::projects_not_judged>(not_judged_projects);
  const WarningCounts& warnings = totals.warnings;
  if (warnings.all == 1) text += ", " + t.say<Text::one_warning>(warnings.all);
  if (warnings.all > 1) text += ", " + t.say<Text::warnings>(warnings.all);
  if (warnings.strict > 0) text += t.say<Text::of_which_count>(warnings.strict);
  return text;
}

namespace {

bool is_ugr(const rules::Requirement& requirement) {
  return std::string_view(rules::rating_of(requirement)) == "UGR";
}

}  // namespace

std::string measured_words(const Texts& t, const rules::Requirement& requirement,
                           const calc::Estimate& measured) {
  const Threshold threshold{requirement.limit, requirement.comparison};
  return is_ugr(requirement) ? format_ugr(t, measured, threshold)
                             : format_measured(t, measured, rules::unit_of(requirement), threshold);
}

std::string value_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                        const Thresholds& thresholds) {
  return plane.derived == calc::DerivedQuantity::ugr
             ? format_ugr(t, value, thresholds)
             : format_measured(t, value, plane_unit(plane), thresholds);
}

std::string cell_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                       const Thresholds& thresholds) {
  const bool is_below =
      plane.derived == calc::DerivedQuantity::ugr && is_below_ugr_scale(value, thresholds);
  return is_below ? format_ugr(t, value, thresholds) : format_cell(t, value.value, thresholds);
}

bool is_below_scale(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  return is_ugr(requirement) &&
         is_below_ugr_scale(finding.measured, Threshold{requirement.limit, requirement.comparison});
}

std::string margin_words(const Texts& t, const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const std::string_view rating = rules::rating_of(requirement);
  if (rating.empty()) return format_margin(t, finding.margin);
  if (finding.margin > 0.0 && is_below_scale(finding)) {
    constexpr double kLowest = 10.0;  // of the scale
    const double to_scale = (requirement.limit - kLowest) / std::abs(requirement.limit);
    return "> " + t.number(format_rating_margin(to_scale, requirement.limit, rating));
  }
  return t.number(format_rating_margin(finding.margin, finding.requirement.limit, rating));
}

std::string close_words(const Texts& t, const rules::Finding& finding) {
  if (!finding.is_close) return {};
  return t[finding.requirement.policy.compares_rounded ? Text::close_unrounded
                                                       : Text::close_rounded];
}

std::string redaction_words(const Provenance& provenance, const Texts& t) {
  return provenance.is_redacted ? t[Text::paths_left_out] : "";
}

std::string policy_words(const Provenance& provenance, const Texts& t) {
  if (provenance.policy.empty()) return "";
  return t.say<Text::judged_by_policy>(printable(provenance.policy), provenance.policy_sha256);
}

std::string selection_words(const Provenance& provenance, const Texts& t) {
  if (provenance.selection.empty()) return "";
  return t.say<Text::judged_in_part>(printable(provenance.selection));
}

std::string provenance_remarks(const Provenance& provenance, const Texts& t) {
  std::string remarks;
  const bool is_cut_short = provenance.same_bits == SameBits::nowhere;
  for (const std::string& words :
       {selection_words(provenance, t), policy_words(provenance, t), redaction_words(provenance, t),
        is_cut_short ? std::string(t[Text::not_repeatable]) : std::string()}) {
    remarks += (remarks.empty() || words.empty() ? "" : " ") + words;
  }
  return remarks;
}

std::string looks_words(const Texts& t, const PlanePart& plane) {
  const std::size_t taken = plane.counters.active_points.size();
  return taken == 0 ? "" : t.say<Text::looks_of_planned>(taken, plane.looks_planned);
}

std::string doubt_words(const Texts& t, const PlanePart& plane) {
  std::string text;
  const auto add = [&text](const std::string& words) {
    text += (text.empty() ? "" : "; ") + words;
  };
  const std::size_t points = plane.points.size();
  if (plane.unseen_points > 0) add(t.say<Text::doubt_unseen>(plane.unseen_points, points));
  if (plane.single_sample_points > 0)
    add(t.say<Text::doubt_single>(plane.single_sample_points, points));
  return text;
}

bool is_horizontal(const glm::dvec3& normal) { return std::abs(normal.z) > 1.0 - kStraight; }

std::string orientation_words(const Texts& t, const glm::dvec3& normal) {
  if (is_horizontal(normal)) return t[normal.z > 0 ? Text::facing_up : Text::facing_down];
  if (std::abs(normal.z) < kStraight) return t.say<Text::facing_sideways>(heading_words(t, normal));
  const double tilt_deg = calc::degrees_from_radians(calc::acos(std::clamp(normal.z, -1.0, 1.0)));
  return t.say<Text::inclined>(format_fixed(t, tilt_deg, 1));
}

std::string heading_words(const Texts& t, const glm::dvec3& direction) {
  return t.number(
      fmt::format("({}, {})", format_fixed(direction.x, 2), format_fixed(direction.y, 2)));
}

}  // namespace report
