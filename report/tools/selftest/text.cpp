#include "report/text/plain_text.h"
#include "report/tools/selftest/run_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

using Row = std::vector<std::string>;

std::string aligned(const std::vector<Row>& rows, const std::vector<bool>& is_left) {
  std::vector<std::size_t> width(is_left.size(), 0);
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      width[c] = std::max(width[c], report::display_width(row[c]));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string gap(width[c] - report::display_width(row[c]), ' ');
      line += (c == 0 ? "" : "  ") + (is_left[c] ? row[c] + gap : gap + row[c]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Row number_cells(const JudgedNumber& n) {
  const std::string unit = n.measured.unit.empty() ? "" : " " + n.measured.unit;
  return {value_words(n.measured.exact) + unit, value_words(n.stated.value), interval_words(n),
          deviation_words(n)};
}

std::string refusals(const JudgedCase& item) {
  std::string text;
  for (const Refused& refused : item.result.refused) {
    text += fmt::format("      {}: {}\n", refused.what,
                        refused.said.empty() ? "NOT refused" : report::printable(refused.said));
  }
  return text;
}

std::string coloured(const std::string& text, const TextStyle& style) {
  if (!style.is_coloured) return text;
  std::string painted;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    const std::string line = text.substr(begin, end - begin);
    const bool is_bad =
        line.find("OUT") != std::string::npos || line.find("TOO VAGUE") != std::string::npos;
    painted += is_bad ? "\x1b[31m" + line.substr(0, line.size() - 1) + "\x1b[0m\n" : line;
    begin = end;
  }
  return painted;
}

std::string kind_text(const RunResult& result, const std::string& kind, const TextStyle& style) {
  std::vector<Row> rows;
  std::string after;
  Row head = {"case", "numbers", "exact", "ours", "95 % interval", "deviation"};
  if (style.has_timing) head.insert(head.end(), {"time", "rays"});
  head.push_back("verdict");
  rows.push_back(head);
  const auto timed = [&](Row& row, const JudgedCase* item) {
    if (!style.has_timing) return;
    row.push_back(item != nullptr ? fmt::format("{:.2f} s", item->seconds) : "");
    row.push_back(item != nullptr
                      ? fmt::format("{:.3g} M", 1e-6 * static_cast<double>(item->result.rays))
                      : "");
  };
  for (const JudgedCase& item : result.cases) {
    if (item.test.kind != kind) continue;
    Row row = {item.test.name, std::to_string(item.numbers.size() + item.result.refused.size())};
    const JudgedNumber* worst = item.worst();
    const Row cells = worst != nullptr && !style.shows_all ? number_cells(*worst) : Row(4);
    row.insert(row.end(), cells.begin(), cells.end());
    timed(row, &item);
    row.push_back(verdict_name(item.verdict));
    rows.push_back(row);
    if (style.shows_all) {
      for (const JudgedNumber& n : item.numbers) {
        Row line = {"  " + n.measured.what, ""};
        const Row values = number_cells(n);
        line.insert(line.end(), values.begin(), values.end());
        timed(line, nullptr);
        line.push_back(verdict_name(n.verdict));
        rows.push_back(line);
      }
    }
    if (!item.result.problem.empty()) {
      after += fmt::format("    {}: {}\n", item.test.name, item.result.problem);
    }
    if (!item.result.refused.empty()) after += refusals(item);
  }
  if (rows.size() == 1) return "";
  std::vector<bool> is_left(rows[0].size(), false);
  is_left.front() = is_left.back() = true;
  return aligned(rows, is_left) + after;
}

}  // namespace

int RunResult::wrong() const {
  return static_cast<int>(std::count_if(cases.begin(), cases.end(), [](const JudgedCase& item) {
    return item.verdict == Verdict::wrong || item.verdict == Verdict::too_vague;
  }));
}

int RunResult::numbers() const {
  std::size_t sum = 0;
  for (const JudgedCase& item : cases) sum += item.numbers.size() + item.result.refused.size();
  return static_cast<int>(sum);
}

int RunResult::sampled() const {
  int sum = 0;
  for (const JudgedCase& item : cases) {
    for (const JudgedNumber& n : item.numbers) sum += n.is_sampled() ? n.seeds : 0;
  }
  return sum;
}

int RunResult::held() const {
  int sum = 0;
  for (const JudgedCase& item : cases) {
    for (const JudgedNumber& n : item.numbers) sum += n.is_sampled() ? n.held : 0;
  }
  return sum;
}

const JudgedNumber* RunResult::least_held(std::string* of_case) const {
  const JudgedNumber* least = nullptr;
  for (const JudgedCase& item : cases) {
    for (const JudgedNumber& n : item.numbers) {
      if (seeds == 1 || !n.is_sampled() || (least != nullptr && n.held >= least->held)) continue;
      least = &n;
      *of_case = item.test.name;
    }
  }
  return least;
}

std::string seeds_words(const RunResult& result) {
  if (result.seeds == 1) return fmt::format("seed {}", result.seed);
  return fmt::format("seeds {} to {}", result.seed,
                     result.seed + static_cast<std::uint64_t>(result.seeds) - 1);
}

std::string coverage_words(const RunResult& result) {
  std::string text = fmt::format("{} sampled numbers: {} lie in their stated 95 % interval",
                                 result.sampled(), result.held());
  if (result.seeds == 1) return text;
  text += fmt::format(" ({:.1f} %)", 100.0 * result.held() / std::max(1, result.sampled()));
  std::string of_case;
  const JudgedNumber* least = result.least_held(&of_case);
  if (least == nullptr) return text;
  return text + fmt::format("; least often {} of {}: {} of {}", least->measured.what, of_case,
                            least->held, least->seeds);
}

std::string value_words(double value) { return fmt::format("{:.6g}", value + 0.0); }

std::string deviation_words(const JudgedNumber& n) {
  const double d = n.deviation();
  if (n.measured.exact == 0.0) return fmt::format("{:.2g}", d + 0.0);
  if (d == 0.0) return "0 %";
  return fmt::format("{:+.2g} %", 100.0 * d);
}

std::string interval_words(const JudgedNumber& n) {
  if (!n.is_sampled()) return "exact";
  return fmt::format("{:.5g} – {:.5g}", n.stated.low, n.stated.high);
}

std::string render_list(const std::vector<SelftestCase>& cases) {
  std::vector<Row> rows;
  for (const SelftestCase& item : cases) {
    rows.push_back({item.kind, item.name, item.title, "[" + item.source + "]"});
  }
  return aligned(rows, {true, true, true, true});
}

std::string render_text(const RunResult& result, const TextStyle& style) {
  std::string text;
  for (const Kind& kind : kinds()) {
    const std::string table = kind_text(result, kind.name, style);
    if (!table.empty()) text += fmt::format("{} ({})\n{}\n", kind.title, kind.name, table);
  }
  double seconds = 0.0;
  for (const JudgedCase& item : result.cases) seconds += item.seconds;
  const int wrong = result.wrong();
  text +=
      fmt::format("{} cases, {} numbers, {}{}: {}\n", result.cases.size(), result.numbers(),
                  seeds_words(result), style.has_timing ? fmt::format(", {:.1f} s", seconds) : "",
                  wrong == 0 ? "all right" : fmt::format("{} OUT", wrong));
  text += fmt::format(
      "{}.\n'in' is judged at a level that\n"
      "all numbers together miss in fewer than one of a thousand seeds. Each line shows the "
      "number\n"
      "that is furthest off; --all shows the others.\n",
      coverage_words(result));
  return coloured(text, style);
}

}  // namespace cli::selftest
