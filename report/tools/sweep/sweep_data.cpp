#include "calc/base/names.h"
#include "report/text/csv_field.h"
#include "report/text/json_layout.h"
#include "report/text/number_format.h"
#include "report/tools/sweep/sweep_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cli {
namespace {

using SweepJson = nlohmann::ordered_json;

SweepJson number_or_null(double value) {
  return std::isfinite(value) ? SweepJson(value) : SweepJson();
}

SweepJson row_json(const SweepRow& row, const Sweep& sweep) {
  SweepJson values = SweepJson::object();
  for (std::size_t v = 0; v < sweep.vary.size(); ++v) values[sweep.vary[v].path] = row.values[v];
  SweepJson json{{"variant", row.variant + 1},
                 {"values", std::move(values)},
                 {"verdict", calc::name_of(row.outcome)},
                 {"margin", nullptr}};
  if (row.margin) {
    json["margin"] = {{"value", number_or_null(row.margin->value)},
                      {"low", number_or_null(row.margin->low)},
                      {"high", number_or_null(row.margin->high)},
                      {"plane", row.plane},
                      {"requirement", row.requirement}};
  }
  json["without_margin"] = row.without_margin;
  json["power_w"] = row.power_w;
  json["luminaires_without_power"] = row.without_power;
  json["warnings"] = row.warnings;
  json["rows_in_part"] = row.rows_in_part;
  json["front"] = pareto_words(row.pareto);
  if (!row.reason.empty()) json["reason"] = row.reason;
  return json;
}

}  // namespace

std::string render_sweep_csv(const Sweep& sweep) {
  std::string csv = "variant";
  for (const Vary& vary : sweep.vary) csv += "," + report::csv_field(vary.path);
  csv +=
      ",verdict,margin,margin_low,margin_high,plane,requirement,without_margin,power_w,"
      "luminaires_without_power,warnings,rows_in_part,front,reason\r\n";
  for (const SweepRow& row : sweep.rows) {
    csv += std::to_string(row.variant + 1);
    for (const std::string& value : row.values) csv += "," + report::csv_field(value);
    csv += fmt::format(",{}", calc::name_of(row.outcome));
    if (row.margin) {
      csv += fmt::format(",{},{},{}", report::format_shortest(row.margin->value),
                         report::format_shortest(row.margin->low),
                         report::format_shortest(row.margin->high));
    } else {
      csv += ",,,";
    }
    csv += fmt::format(",{},{},{},{},{},{},{},{},{}\r\n", report::csv_field(row.plane),
                       report::csv_field(row.requirement), row.without_margin,
                       report::format_shortest(row.power_w), row.without_power, row.warnings,
                       row.rows_in_part, pareto_words(row.pareto), report::csv_field(row.reason));
  }
  return csv;
}

std::string render_sweep_json(const Sweep& sweep) {
  const report::Provenance& provenance = sweep.provenance;
  SweepJson vary = SweepJson::array(), set = SweepJson::array(), variants = SweepJson::array();
  for (const Vary& one : sweep.vary) {
    vary.push_back({{"path", one.path}, {"values", one.values}});
  }
  for (const check::SetValue& one : sweep.set) {
    set.push_back({{"path", one.path}, {"value", one.value}});
  }
  for (const SweepRow& row : sweep.rows) variants.push_back(row_json(row, sweep));
  const OutcomeCounts counts = count_outcomes(sweep.rows);
  return report::json_layout({{"format", "luxgate-sweep"},
                              {"format_version", 1},
                              {"provenance",
                               {{"program_version", provenance.program_version},
                                {"command", provenance.command_line},
                                {"judged_on", provenance.judged_on},
                                {"seed", provenance.seed},
                                {"confidence", provenance.confidence},
                                {"goal", calc::name_of(provenance.goal)},
                                {"tolerance", provenance.tolerance},
                                {"backend", provenance.backend},
                                {"numbers_version", provenance.numbers_version},
                                {"same_bits", calc::name_of(provenance.same_bits)}}},
                              {"project", sweep.project},
                              {"set", std::move(set)},
                              {"vary", std::move(vary)},
                              {"counts",
                               {{"variants", sweep.rows.size()},
                                {"pass", counts.pass},
                                {"fail", counts.fail},
                                {"undecided", counts.undecided},
                                {"not_judged", counts.not_judged},
                                {"others", counts.others}}},
                              {"notes", sweep_notes(sweep)},
                              {"variants", std::move(variants)}});
}

}  // namespace cli
