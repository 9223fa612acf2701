#include "report/tools/help/option_table.h"

#include "report/shell/command/help_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace cli {
namespace {

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// Ours, so that nothing in it is a spreadsheet's formula by a stranger's will.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string row_of(const Topic& topic, const Option& option) {
  const std::string value = option.may_have_value ? "[=ID,...]" : option.value_name;
  const std::string fields[] = {option.long_name(),
                                topic.line,
                                option.short_name(),
                                value,
                                fmt::format("{}", fmt::join(option.words(), " ")),
                                option.repeats ? "yes" : "no",
                                in_one_line(option.help)};
  std::string row;
  for (const std::string& field : fields) {
    row += (row.empty() ? "" : ",") + quoted(field);
  }
  return row + "\r\n";
}

}  // namespace

std::string option_table(const std::vector<Command>& commands) {
  std::vector<std::pair<std::string, std::string>> rows;  // with the option's name
  for (const Topic& topic : all_topics(commands)) {
    for (const Option& option : topic.about->options) {
      rows.emplace_back(option.long_name(), row_of(topic, option));
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text = "option,command,short,value,words,repeats,meaning\r\n";
  for (const auto& [name, row] : rows) text += row;
  return text;
}

}  // namespace cli
