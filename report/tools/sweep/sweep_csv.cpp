#include "calc/base/names.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"
#include "report/tools/sweep/sweep_table.h"

#include <fmt/format.h>

namespace cli {

std::string render_sweep_csv(const Sweep& sweep) {
  std::string csv = "variant";
  for (const Vary& vary : sweep.vary) csv += "," + report::csv_field(vary.path);
  csv +=
      ",verdict,margin,margin_low,margin_high,plane,requirement,without_margin,power_w,"
      "luminaires_without_power,price,luminaires_without_price,warnings,rows_in_part,waived,"
      "passed_beyond_limit,front,front_of,reason\r\n";
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
    csv += fmt::format(",{},{},{},{},{}", report::csv_field(row.plane),
                       report::csv_field(row.requirement), row.without_margin,
                       report::format_shortest(row.power_w), row.without_power);
    csv += fmt::format(",{},{}", row.price ? report::format_shortest(*row.price) : "",
                       row.without_price);
    csv += fmt::format(",{},{},{},{}", row.warnings, row.rows_in_part, row.waived,
                       row.passed_beyond_limit);
    csv += fmt::format(",{},{},{}\r\n", calc::name_of(row.pareto), calc::name_of(sweep.front_of),
                       report::csv_field(row.reason));
  }
  return csv;
}

}  // namespace cli
