#include "report/formats/console_lines.h"

#include "report/text/plain_text.h"

#include <algorithm>
#include <string_view>

namespace report {

const char* outcome_colour(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::not_judged:
    case rules::Outcome::warned:
      break;
    case rules::Outcome::fail:
      return "\033[1;31m";
    case rules::Outcome::undecided:
      return "\033[1;33m";
    case rules::Outcome::pass:
    case rules::Outcome::waived:
      return "\033[32m";
    case rules::Outcome::nothing_asked:
      return kDim;
  }
  return "\033[1;35m";
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
  const std::size_t used = display_width(text);
  const std::string blanks(used < width ? width - used : 0, ' ');
  return to_the_right ? blanks + text : text + blanks;
}

void trim_end(std::string& text) { text.erase(text.find_last_not_of(' ') + 1); }

std::string wrapped_lines(const std::string& start, const std::string& text, std::size_t indent,
                          int terminal_width) {
  if (terminal_width <= 0) return start + text + "\n";
  constexpr std::size_t kNarrowest = 20, kSentence = 30, kLeastIndent = 2;  // columns
  const std::size_t width = std::max(static_cast<std::size_t>(terminal_width), kNarrowest);
  const std::size_t most = width > kSentence + kLeastIndent ? width - kSentence : kLeastIndent;
  const std::string blanks(std::min(indent, most), ' ');
  std::string lines = start;
  std::size_t used = display_width(start);
  bool is_first = true;  // of its line
  const auto begin_line = [&] {
    trim_end(lines);
    lines += "\n" + blanks;
    used = blanks.size();
    is_first = true;
  };
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    std::string_view word = std::string_view(text).substr(from, end - from);
    from = end + 1;
    if (word.empty() && is_first && lines.size() > start.size()) continue;
    const std::size_t blank = is_first ? 0 : 1;
    if (used + blank + display_width(word) > width && (!is_first || used > blanks.size()))
      begin_line();
    while (used + display_width(word) > width) {
      const std::size_t length = bytes_within(word, width - used);
      lines += word.substr(0, length);
      word.remove_prefix(length);
      begin_line();
    }
    lines += (is_first ? "" : " ") + std::string(word);
    used += (is_first ? 0 : 1) + display_width(word);
    is_first = false;
  }
  return lines + "\n";
}

std::string note_lines(const std::string& note, std::size_t indent, int terminal_width,
                       const char* mark) {
  constexpr std::size_t kSentence = 30, kMark = 2;
  const auto width = static_cast<std::size_t>(std::max(terminal_width, 0));
  const std::size_t most = width > kSentence + kMark ? width - kSentence - kMark : 0;
  const std::size_t own = width == 0 ? indent : std::min(indent, most);
  return wrapped_lines(std::string(own, ' ') + mark, note, own + kMark, terminal_width);
}

std::string stacked_cells(const std::vector<std::string>& cells, const std::string& colour,
                          int terminal_width) {
  std::string rest;
  for (std::size_t c = 1; c < cells.size(); ++c) {
    if (!cells[c].empty()) rest += (rest.empty() ? "" : "  ") + cells[c];
  }
  const std::string start = "  " + cells.front() + "  ";
  std::string text = wrapped_lines(start, rest, 4, terminal_width);
  if (!colour.empty()) text.replace(2, cells.front().size(), colour + cells.front() + kReset);
  return text;
}

}  // namespace report
