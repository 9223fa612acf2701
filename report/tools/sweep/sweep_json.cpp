#include "calc/base/names.h"
#include "report/text/json_keys.h"
#include "report/text/json_layout.h"
#include "report/tools/sweep/sweep_table.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace cli {
namespace {

using SweepJson = report::KeyedJson;

using report::at_least_type;
using report::described_key;
using report::JsonKeys;
using report::list_of_keys;
using report::number_or_null_type;
using report::object_key;
using report::object_of_keys;
using report::one_of_names;
using report::schema_of_keys;
using report::type_of;

JsonKeys margin_keys(const SweepRow& row) {
  const calc::Estimate margin = row.margin.value_or(calc::Estimate{});
  return {{"value", margin.value, number_or_null_type()},
          {"low", margin.low, number_or_null_type()},
          {"high", margin.high, number_or_null_type()},
          {"plane", row.plane, type_of("string")},
          {"requirement", row.requirement, type_of("string")}};
}

JsonKeys row_keys(const SweepRow& row, const Sweep& sweep) {
  SweepJson values = SweepJson::object();
  for (std::size_t v = 0; v < row.values.size(); ++v) values[sweep.vary[v].path] = row.values[v];
  const JsonKeys margin = margin_keys(row);
  return {
      {"variant", row.variant + 1, at_least_type("integer", 1)},
      {"values",
       std::move(values),
       {{"type", "object"},
        {"description", "By path, as the project file would have them."},
        {"additionalProperties", type_of("string")}}},
      {"verdict", calc::name_of(row.outcome), one_of_names<rules::Outcome>()},
      {"margin",
       row.margin ? object_of_keys(margin) : SweepJson(),
       {{"description",
         "The smallest over all requirements that count, relative to the limit, > 0 is good; each "
         "end on its own; an end that is open is null. plane and requirement have the smallest "
         "value. null: something is not judged, or nothing has a margin."},
        {"oneOf", {schema_of_keys(margin), type_of("null")}}}},
      {"without_margin", row.without_margin,
       described_key(
           at_least_type("integer", 0),
           "Requirements that count and have no margin: limits of 0, aggregates and classes.")},
      {"power_w", row.power_w,
       described_key(at_least_type("number", 0), "Installed, of luminaires whose power is known.")},
      {"luminaires_without_power", row.without_power, at_least_type("integer", 0)},
      {"price", row.price ? SweepJson(*row.price) : SweepJson(),
       described_key(
           {{"type", {"number", "null"}}, {"minimum", 0}},
           "Sum over all luminaires with a price, in the project's own currency; null: none "
           "does.")},
      {"luminaires_without_price", row.without_price, at_least_type("integer", 0)},
      {"warnings", row.warnings, at_least_type("integer", 0)},
      {"rows_in_part", row.rows_in_part,
       described_key(at_least_type("integer", 0),
                     "Rows of a standard that are judged in part only.")},
      {"waived", row.waived,
       described_key(at_least_type("integer", 0),
                     "Requirements that do not count since they are waived.")},
      {"passed_beyond_limit", row.passed_beyond_limit,
       described_key(at_least_type("integer", 0),
                     "Requirements that pass by a tolerance or rounding of their rule pack.")},
      {"front", calc::name_of(row.pareto),
       described_key(
           one_of_names<ParetoPlace>(),
           "on: no other variant that passes has as large a margin at less of front_of, or a "
           "larger one at as much; perhaps: others have, but none with its whole interval.")},
      {"reason", row.reason, described_key(type_of("string"), "Why it is not judged."), false,
       !row.reason.empty()}};
}

JsonKeys vary_keys(const Vary& vary) {
  return {{"path", vary.path, type_of("string")},
          {"values", vary.values, list_of_keys(type_of("string"))}};
}

JsonKeys set_keys(const check::SetValue& set) {
  return {{"path", set.path, type_of("string")}, {"value", set.value, type_of("string")}};
}

JsonKeys provenance_keys(const report::Provenance& provenance) {
  return {
      {"program_version", provenance.program_version, type_of("string")},
      {"command", provenance.command_line, type_of("string")},
      {"judged_on", provenance.judged_on,
       described_key(type_of("string"), "YYYY-MM-DD; empty where no verdict depends on the day.")},
      {"seed", provenance.seed, at_least_type("integer", 0)},
      {"confidence", provenance.confidence, type_of("number")},
      {"goal", calc::name_of(provenance.goal), one_of_names<rules::Goal>()},
      {"tolerance", provenance.tolerance, type_of("number")},
      {"backend", provenance.backend, type_of("string")},
      {"numbers_version", provenance.numbers_version, at_least_type("integer", 0)},
      {"same_bits", calc::name_of(provenance.same_bits), one_of_names<report::SameBits>()}};
}

JsonKeys count_keys(const Sweep& sweep) {
  const OutcomeCounts counts = count_outcomes(sweep.rows);
  const SweepJson count = at_least_type("integer", 0);
  return {{"variants", sweep.rows.size(), count},
          {"pass", counts.pass, count},
          {"fail", counts.fail, count},
          {"undecided", counts.undecided, count},
          {"not_judged", counts.not_judged, count},
          {"others", counts.others, count}};
}

JsonKeys sweep_keys(const Sweep& sweep) {
  SweepJson vary = SweepJson::array(), set = SweepJson::array(), variants = SweepJson::array();
  for (const Vary& one : sweep.vary) vary.push_back(object_of_keys(vary_keys(one)));
  for (const check::SetValue& one : sweep.set) set.push_back(object_of_keys(set_keys(one)));
  for (const SweepRow& row : sweep.rows) variants.push_back(object_of_keys(row_keys(row, sweep)));
  return {{"format", "luxgate-sweep", {{"const", "luxgate-sweep"}}},
          {"format_version", 1, {{"const", 1}}},
          object_key("provenance", provenance_keys(sweep.provenance)),
          {"project", sweep.project, type_of("string")},
          {"set", std::move(set),
           described_key(list_of_keys(schema_of_keys(set_keys({}))),
                         "Values of --set, in all variants.")},
          {"vary", std::move(vary), list_of_keys(schema_of_keys(vary_keys({})))},
          {"front_of", calc::name_of(sweep.front_of),
           described_key(one_of_names<FrontOf>(),
                         "The quantity that margins are compared with on the front.")},
          object_key("counts", count_keys(sweep)),
          {"notes", sweep_notes(sweep),
           described_key(list_of_keys(type_of("string")), "Notes about all variants.")},
          {"variants", std::move(variants),
           described_key(list_of_keys(schema_of_keys(row_keys({}, {}))),
                         "All combinations, the last of vary "
                         "fastest.")}};
}

}  // namespace

std::string render_sweep_json(const Sweep& sweep) {
  return report::json_layout(object_of_keys(sweep_keys(sweep)));
}

std::string sweep_schema() {
  return report::json_layout(report::schema_of_file("luxgate sweep", sweep_keys({})));
}

}  // namespace cli
