#include "report/text/markup.h"

#include "report/text/plain_text.h"

#include <fmt/format.h>

namespace report {

std::string escape_html(std::string_view text) {
  std::string html;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string escape_markdown(std::string_view raw) {
  const std::string text = printable(raw);
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const std::string_view rest = std::string_view(text).substr(i);
    const bool is_markup = std::string_view("&<>@#\\`*_[]|~!").find(c) != std::string_view::npos;
    // Bare addresses become links.
    const bool is_address = rest.starts_with("://") || (c == '.' && escaped.ends_with("www"));
    escaped +=
        is_markup || is_address ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
  }
  return escaped;
}

}  // namespace report
