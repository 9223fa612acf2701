#pragma once
// A standard as data: the requirements of its rows on the parts of a room. README.md describes the
// file; everything here is as written there, with numbers in base units (lx, m, W/m2, ...).

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/scene/project.h"
#include "calc/scene/receiver_kernel.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/mask.h"
#include "rules/catalogue/policy.h"
#include "rules/catalogue/requirement.h"
#include "rules/catalogue/unit.h"
#include "rules/pack/expression.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

// How well a number is known, best first.
enum class Trust {
  confirmed,      // two or more independent public sources, or public law as printed
  single_source,  // one public source
  unverified,     // from memory, or doubtful
};
// For results: "", "one public source", "unverified requirement"; and behind a name, in brackets.
// Reports say the first once, see report/text/one_source_note.h, and the other at each requirement.
calc::Message trust_remark(Trust trust);
calc::Message with_trust(const calc::Message& name, Trust trust);

// The reason why a row has no value of a parameter.
enum class NoValue {
  not_specified,   // the row requires nothing
  not_applicable,  // it makes no sense there
  unknown,         // the standard has a value, this pack does not
};

}  // namespace rules

namespace calc {
template <>
struct EnumNames<rules::NoValue> {
  static constexpr EnumName<rules::NoValue> list[] = {
      {rules::NoValue::not_specified, "not-specified"},
      {rules::NoValue::not_applicable, "not-applicable"},
      {rules::NoValue::unknown, "unknown"}};
};
}  // namespace calc

namespace rules {

// A place where numbers were found.
struct RuleSource {
  std::string id, note, address;
};

// A column of the rows, or a fact that the project states.
struct RuleName {
  std::string id;
  Unit unit{"none", Dimension::plain, 1.0};
  std::string meaning;
  calc::SourceLocation where;
};

struct RuleValue {
  std::string parameter;
  std::optional<double> required;  // empty: none, see why
  std::optional<double> modified;  // at level "modified", where it differs
  NoValue why = NoValue::not_specified;
  Trust trust = Trust::confirmed;
  calc::SourceLocation where;
};

struct RuleRow {
  std::string ref;      // "34.2", unique in the pack
  std::string name;     // use of the space, in own words
  std::string name_de;  // the same for readers of the German edition; "" = none
  Trust trust = Trust::confirmed;
  std::vector<std::string> sources;
  std::string note;
  std::vector<RuleValue> values;
  struct Heights {
    double lowest_m, highest_m;
  };
  std::optional<Heights> task_heights_m;  // where they are not those of the plane's role
  std::string task_orientation;           // "": that of the plane's role
  calc::SourceLocation where;

  const RuleValue* find_value(std::string_view parameter) const;
  bool has_modified_level() const;
};

// The direction of upright planes and rows, as packs name it.
inline constexpr std::string_view kUpright = "vertical";

enum class TableMatch { exact, next_lower, next_higher, linear };

}  // namespace rules

namespace calc {
template <>
struct EnumNames<rules::TableMatch> {
  static constexpr EnumName<rules::TableMatch> list[] = {
      {rules::TableMatch::exact, "exact"},
      {rules::TableMatch::next_lower, "next-lower"},
      {rules::TableMatch::next_higher, "next-higher"},
      {rules::TableMatch::linear, "linear"}};
};
}  // namespace calc

namespace rules {
struct RuleTable {
  struct Entry {
    double key = 0.0;
    std::optional<double> value;  // empty: the key itself
  };
  std::string id;
  Unit key_unit{"none", Dimension::plain, 1.0}, value_unit{"none", Dimension::plain, 1.0};
  TableMatch match = TableMatch::exact;
  Trust trust = Trust::confirmed;
  bool has_trust = false;      // stated in the pack
  std::vector<Entry> entries;  // keys ascending
  calc::SourceLocation where;
};

// A scale of preferred values, ascending.
struct RuleScale {
  std::string id;
  Unit unit{"none", Dimension::plain, 1.0};
  std::vector<double> values;
  // The parameter whose required value a project may move along the scale by this many steps, with
  // a reason; "": none.
  std::string parameter;
  int most_down = 0, most_up = 0;
  Trust trust = Trust::confirmed;  // of that
  calc::SourceLocation where;
};

// The quantity of a check. The points of a plane can measure the first seven.
struct Quantity {
  const char* name;
  Dimension dimension;
  std::optional<calc::ReceiverKernel> kernel;  // empty: not measured on planes
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;
  // A metric of the space that a plane is in; any plane there will do.
  std::optional<Metric> of_space = {};
};
const Quantity* quantity_from_name(std::string_view name);  // nullptr if there is none
calc::Names quantity_names();

enum class LightSources { all, electric, emergency, daylight };

}  // namespace rules

namespace calc {
template <>
struct EnumNames<rules::LightSources> {
  static constexpr EnumName<rules::LightSources> list[] = {
      {rules::LightSources::all, "all"},
      {rules::LightSources::electric, "electric"},
      {rules::LightSources::emergency, "emergency"},
      {rules::LightSources::daylight, "daylight"}};
};
}  // namespace calc

namespace rules {

// Another limit of a check for a special place that a workplace states, see SpecialPlace. For an
// unknown task place it replaces the usual limit; for other walls only if it is easier.
struct RuleSpecial {
  calc::SpecialPlace place = calc::SpecialPlace::none;
  double limit = 0.0;             // base units of what the check limits
  std::vector<std::string> rows;  // for which; none: all
  Trust trust = Trust::confirmed;
  std::string note;
  calc::SourceLocation where;
};

struct RuleCheck {
  std::string id;      // unique in the pack
  std::string role;    // part of the room: "task", "surround", "route", ...
  std::string clause;  // within the standard; "" = the row's ref
  Severity severity = Severity::shall;
  const Quantity* quantity = nullptr;
  Metric metric = Metric::average;
  double percent = 0.0;  // of Metric::percentile
  ValueRange range;      // of Metric::share, base units; of has_mounting_heights(), metres
  Mask mask;
  LightState state = LightState::maintained;
  LightSources sources = LightSources::all;
  bool direct_only = false;
  bool any_one_unit_out = false;
  bool is_level_only = false;  // says nothing of stairs and ramps
  Comparison comparison = Comparison::at_least;
  Expression limit;
  std::string limit_text;
  calc::SourceLocation limit_where;
  Trust trust = Trust::confirmed;  // of what the check says itself, row values and tables apart
  bool has_trust = false;          // stated in the pack
  std::string note;
  // Another check that requires the same in another way. It is enough to meet either. "" = none.
  std::string instead_of;
  std::vector<RuleSpecial> specials;  // one for a place at most
  calc::SourceLocation where;

  // Returns the special limit for this place and row (row null: none chosen); null if there is
  // none.
  const RuleSpecial* find_special(calc::SpecialPlace place, const RuleRow* row) const;

  // Returns the arguments of a requirement with this metric, as far as the check states them.
  MetricArguments arguments_of(Metric measured) const;
  // Returns whether the quantity is about the space and counts luminaires by their height.
  bool has_mounting_heights() const {
    return quantity->of_space && rules::has_mounting_heights(*quantity->of_space);
  }
  Dimension dimension() const { return is_ratio(metric) ? Dimension::plain : quantity->dimension; }
};

// Combines the verdicts of several checks or places.
struct RuleAggregate {
  std::string id;
  std::string clause;  // within the standard; "" = the row's ref
  Severity severity = Severity::shall;
  AggregateRule rule = AggregateRule::all;
  AggregateOver over = AggregateOver::checks;
  int count = 0;         // of at_least
  double share = 0.0;    // of share, (0, 1]
  bool by_area = false;  // of share over planes or rooms
  std::vector<std::string> checks;
  Trust trust = Trust::confirmed;
  std::string note;
  calc::SourceLocation where;
};

// Rows as classes, the best first; a class is reached if all of its checks pass.
struct RuleClass {
  std::string id;
  std::vector<std::string> rows, checks;
  calc::SourceLocation where;
};

// The spacing of the points of a plane.
struct RuleGrid {
  std::string id;
  std::optional<calc::GridRule> rule;  // empty: the project's own; spacing: along u = longer side
  calc::GridCounts least{1, 1};        // of a spacing: along the longer and the shorter side
  Trust trust = Trust::confirmed;
  std::string note;
};
std::string grid_text(const RuleGrid& grid);  // "p = 0.2 * 5^log10 d, ..., rounding nearest"

// The area that a workplace makes for a role.
enum class ZoneArea {
  none,           // nothing
  task,           // the task area: as given, or the whole room
  band,           // a band around another zone
  task_and_band,  // the task area with the band around it
  walls,          // every wall by itself
  ceiling,
};

struct RulePlane {
  std::string role, orientation, grid, mask, note;
  bool has_heights = false;
  bool are_heights_usual = false;          // "usually", in words
  double lowest_m = 0.0, highest_m = 0.0;  // above the floor
  ZoneArea area = ZoneArea::none;
  std::string around;              // role inside a band, which workplaces make only as an area
  std::string holds;               // role whose zone lies in this one
  double width_m = 0.0;            // of a band; of task_and_band: of the band around the task
  std::optional<double> height_m;  // of a workplace's plane; empty: that of the task
  double margin_m = 0.0;           // left out along walls, along all edges of walls and ceilings
  double narrow_m = 0.0;           // a room less wide than that has
  double narrow_share = 0.0;       // this share of its width for a margin, if that is less
  double missing_share = 0.1;      // of the points, that bodies or walls may take
};

// Returns the direction of planes of a role, for a row (may be null): the row's direction, if the
// role is that of the task or a band in its plane.
std::string orientation_of(const RulePlane& plane, const RuleRow* row);

// Returns the heights above the floor of planes of a role, for a row (may be null). These are the
// row's task heights if the role is the task, a band at the task's height, or upright without its
// own heights. Empty: any height, as for the task of a row that faces another way than the role and
// has no heights.
std::optional<RuleRow::Heights> heights_of(const RulePlane& plane, const RuleRow* row);

// Returns the width of the margin along the walls of a room of this width.
double margin_in_room_m(const RulePlane& plane, double width_m);

struct RulePack {
  std::string id;            // "en12464-1"
  std::string edition;       // "2021"
  std::string title;         // "EN 12464-1"
  std::string version;       // of the pack itself
  std::string kind;          // "standard", "law", ...
  std::string status;        // "published", ...
  std::string jurisdiction;  // "EU"
  std::string licence;       // "public", "internal", "user-supplied"
  std::string licence_note;
  std::string role;          // of a plane that names none
  std::string file;          // as named by the user; "built in"
  bool is_built_in = false;  // it comes with luxgate, else the user supplies it
  std::vector<RuleSource> sources;
  std::vector<RuleName> parameters, facts;
  DecisionPolicy policy;
  std::vector<RuleTable> tables;
  std::vector<RuleScale> scales;
  std::vector<Mask> masks;
  std::vector<RuleGrid> grids;
  std::vector<RulePlane> planes;
  std::vector<RuleRow> rows;
  std::vector<RuleCheck> checks;
  std::vector<RuleAggregate> aggregates;
  std::vector<RuleClass> classes;

  std::string full_id() const { return id + ":" + edition; }
  // Return nullptr if there is none.
  const RuleRow* find_row(std::string_view ref) const;
  const RuleCheck* find_check(std::string_view check_id) const;
  const RuleTable* find_table(std::string_view table_id) const;
  const RuleScale* find_scale(std::string_view scale_id) const;
  const RuleScale* find_scale_of(std::string_view parameter_id) const;
  // Returns "required" and the levels of level_names() that change a value of the row.
  calc::Names levels_of(const RuleRow& row) const;
  const RuleName* find_parameter(std::string_view parameter_id) const;
  const RuleName* find_fact(std::string_view fact_id) const;
  const RuleGrid* find_grid(std::string_view grid_id) const;
  const RulePlane* find_plane(std::string_view role) const;  // the first of the role
  std::vector<std::string> roles() const;                    // in order of the checks, each once
};

// Reads a pack from XML text. `file` is used in messages. Anything unknown, repeated or out of
// range is an error, as are formulas with unfitting units or cycles. All errors are reported, and
// the result is empty exactly if there was one.
std::optional<RulePack> parse_rule_pack(std::string_view xml, const std::string& file,
                                        calc::Diagnostics& diagnostics);

// Returns the packs that are part of the program (rules/packs/*.xml).
std::vector<RulePack> builtin_rule_packs();

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::Trust> {
  static constexpr EnumName<rules::Trust> list[] = {{rules::Trust::confirmed, "confirmed"},
                                                    {rules::Trust::single_source, "single-source"},
                                                    {rules::Trust::unverified, "unverified"}};
};

}  // namespace calc
