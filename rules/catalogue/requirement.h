#pragma once
// The requirements on a plane: plain data.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/scene/receiver_kernel.h"
#include "rules/catalogue/deviation.h"
#include "rules/catalogue/mask.h"
#include "rules/catalogue/metric.h"
#include "rules/catalogue/metric_arguments.h"
#include "rules/catalogue/policy.h"
#include "rules/catalogue/row_level.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rules {

enum class Comparison { at_least, at_most, more_than, less_than };

// maintained: times the maintenance factor; initial: new installation; end_of_duration: like
// maintained, with the scene's levels at the end of a battery's duration.
enum class LightState { maintained, initial, end_of_duration };

// shall: counts for the exit code; advice is reported only; in_aggregate: counts only through the
// aggregates of its rule pack.
enum class Severity { shall, advice, in_aggregate };

// The check of a rule pack that a requirement comes from; without pack it is the project's own.
struct RuleOrigin {
  std::string pack;  // "en13201-2:2015"
  std::string check, row;
  RowLevel level{};                       // asked for
  std::map<std::string, double> facts;    // by id, in base units
  std::vector<std::string> workplaces{};  // ids of those that ask for it; none: a <require>
  bool is_weakened = false;               // its limit is easier than what the row requires
  bool is_of_own_role = true;             // of the role that the pack is about, such as the task
  bool is_user_supplied = false;  // the pack does not come with luxgate: its numbers are the user's
};

// The source of a limit's number. A clause is free text, and a user's pack may have the title of a
// standard: readers must be able to tell its numbers from the standard's own.
enum class LimitSource {
  project,   // the project itself
  pack,      // a rule pack that comes with luxgate
  user_pack  // one that the user has given
};

// Names one of a project's requirements: plane ids are unique in it.
struct RequirementName {
  std::string plane_id, id;
};

struct Requirement {
  std::string plane_id;
  std::string id;   // unique within the plane: given, or "average", "Uo", ... with "-2" for repeats
  std::string was;  // its id in earlier revisions of the project; "" = the same
  Metric metric = Metric::average;
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;  // what the plane's points measure
  MetricArguments arguments;     // of the kind that the metric's row has
  calc::Estimate of_space{};     // of a metric that is_of_space(): what it is
  calc::Message stated_words{};  // what the project states that the value rests on
  Comparison comparison = Comparison::at_least;
  double limit = 0.0;  // unit_of() this; NaN: not known, see `problem`
  LightState state = LightState::maintained;
  std::string scene;     // "" = every luminaire at full output
  calc::Message clause;  // "EN 12464-1:2021 34.2"; "" = the project's own requirement
  calc::Message note;    // what every report must say with it, e.g. "unverified requirement"; or ""
  Severity severity = Severity::shall;
  Mask mask;                      // which points of the plane count
  calc::Message mask_words{};     // of it, for reports; "" = all count, or not known
  bool direct_only = false;       // reflected light is left out
  bool any_one_unit_out = false;  // holds with any one luminaire of the scene out, see outage.h
  // Why the real light may be more than the calculated light; "" = all is calculated. Then nothing
  // passes that more light could fail.
  calc::Message missing_light{};
  // Why the real light may be less, or more or less: nothing passes at all.
  calc::Message unsure_light{};
  calc::Message problem;  // why it cannot be judged, whatever the light; "" = it can
  // Not requested by name: it is dropped if it has a problem. Results do not have it.
  bool is_optional = false;
  DecisionPolicy policy;
  std::optional<Waiver> waiver;
  std::vector<StatedDeviation> stated_deviations;  // each aspect once
  std::vector<Deviation> deviations;               // found, see rules/applicability
  RuleOrigin origin;
  calc::SourceLocation where;
};

// Returns the requirement's argument; the default if it has none of this kind.
template <class Argument>
Argument argument_of(const Requirement& requirement) {
  const auto* argument = std::get_if<Argument>(&requirement.arguments);
  return argument == nullptr ? Argument{} : *argument;
}

inline LimitSource source_of_pack(bool is_user_supplied) {
  return is_user_supplied ? LimitSource::user_pack : LimitSource::pack;
}
inline LimitSource source_of(const Requirement& requirement) {
  const RuleOrigin& origin = requirement.origin;
  return origin.pack.empty() ? LimitSource::project : source_of_pack(origin.is_user_supplied);
}

// Returns the state of light that a metric always has; empty if it can be chosen. Glare and stray
// light are worst when everything is new, and places of luminaires do not age.
inline std::optional<LightState> fixed_state(Metric metric) {
  if (is_of_road(metric) && metric != Metric::threshold_increment) return LightState::maintained;
  const bool is_new = is_of_space_in_scene(metric) || metric == Metric::glare_rating;
  return is_new ? std::optional(LightState::initial) : std::nullopt;
}

// Returns the requirement on the average of the area on which `glare` is rated: of the same row and
// plane, for the pack's own role. of_plane: all requirements of the plane; null: there is none.
const Requirement* area_of(const Requirement& glare, const std::vector<Requirement>& of_plane);

// Adds a note for every report behind the notes that are already there.
void add_note(const calc::Message& words, Requirement& requirement);

// Returns whether it is at_least or more_than.
constexpr bool is_lower_limit(Comparison comparison) {
  return comparison == Comparison::at_least || comparison == Comparison::more_than;
}
// Returns the attribute in projects and packs: "at-least", "at-most", "more-than", "less-than". In
// results calc::name_of().
const char* comparison_name(Comparison comparison);

// Returns the unit of the required value; "" also for ratings and ratios of single points.
const char* unit_of(const Requirement& requirement);
// Returns "UGR" or "GR" for glare ratings, "" otherwise. Ratings are logarithms: their differences
// mean something, their shares do not.
const char* rating_of(const Requirement& requirement);
bool is_in_lux(const Requirement& requirement);

}  // namespace rules

namespace calc {

// Names in results.
template <>
struct EnumNames<rules::Comparison> {
  static constexpr EnumName<rules::Comparison> list[] = {
      {rules::Comparison::at_least, "at_least"},
      {rules::Comparison::at_most, "at_most"},
      {rules::Comparison::more_than, "more_than"},
      {rules::Comparison::less_than, "less_than"}};
};

template <>
struct EnumNames<rules::LightState> {
  static constexpr EnumName<rules::LightState> list[] = {
      {rules::LightState::maintained, "maintained"},
      {rules::LightState::initial, "initial"},
      {rules::LightState::end_of_duration, "end-of-duration"}};
};

template <>
struct EnumNames<rules::LimitSource> {
  static constexpr EnumName<rules::LimitSource> list[] = {
      {rules::LimitSource::project, "project"},
      {rules::LimitSource::pack, "pack"},
      {rules::LimitSource::user_pack, "user-pack"}};
};

template <>
struct EnumNames<rules::Severity> {
  static constexpr EnumName<rules::Severity> list[] = {
      {rules::Severity::shall, "shall"},
      {rules::Severity::advice, "advice"},
      {rules::Severity::in_aggregate, "in-aggregate"}};
};

}  // namespace calc
