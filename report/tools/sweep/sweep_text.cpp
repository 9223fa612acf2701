#include "report/text/plain_text.h"
#include "report/text/words.h"
#include "report/tools/sweep/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

constexpr std::size_t kMostRowsOfText = 200;

using TextCells = std::vector<std::string>;

std::string aligned_rows(const std::vector<TextCells>& table) {
  std::vector<std::size_t> width(table.front().size());
  for (const TextCells& cells : table) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      width[c] = std::max(width[c], report::display_width(cells[c]));
    }
  }
  std::string text;
  for (const TextCells& cells : table) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      line += cells[c] + std::string(width[c] - report::display_width(cells[c]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string render_sweep_text(const Sweep& sweep) {
  const bool is_long = sweep.rows.size() > kMostRowsOfText;
  std::vector<TextCells> table(1);
  table[0].emplace_back("no.");
  for (const Vary& vary : sweep.vary) table[0].push_back(report::printable(vary.path));
  for (const char* word : {"verdict", "smallest margin", "of", "power"}) {
    table[0].emplace_back(word);
  }
  const bool with_price = has_prices(sweep);
  if (with_price) table[0].emplace_back("price");
  table[0].push_back(fmt::format("front of {}", calc::name_of(sweep.front_of)));
  std::size_t left_out = 0;
  const SweepRow* example = nullptr;
  for (const SweepRow& row : sweep.rows) {
    if (row.pareto == ParetoPlace::on && example == nullptr) example = &row;
    if (is_long && (row.pareto == ParetoPlace::off || table.size() > kMostRowsOfText)) {
      ++left_out;
      continue;
    }
    TextCells cells{std::to_string(row.variant + 1)};
    for (const std::string& value : row.values) cells.push_back(report::printable(value));
    cells.push_back(fmt::format("{} {}", report::outcome_symbol(row.outcome),
                                report::outcome_words(row.outcome)));
    cells.push_back(margin_words(row));
    cells.push_back(report::printable(row.reason.empty() ? requirement_words(row) : row.reason));
    cells.push_back(power_words(row));
    if (with_price) cells.push_back(price_words(row));
    cells.emplace_back(row.pareto == ParetoPlace::off ? "" : calc::name_of(row.pareto));
    table.push_back(std::move(cells));
  }
  std::string text = aligned_rows(table);
  if (left_out > 0) {
    text += fmt::format(
        "{} variants that are not on the front are not listed; --format csv=FILE has all\n",
        left_out);
  }
  text += fmt::format("{} variants: {}\n", sweep.rows.size(), count_outcomes(sweep.rows).words());
  for (const std::string& note : sweep_notes(sweep)) text += report::printable(note) + "\n";
  if (example != nullptr) {
    text += fmt::format("Variant {} alone: {}\n", example->variant + 1,
                        report::printable(check_command(sweep, *example)));
  }
  return text;
}

}  // namespace cli
