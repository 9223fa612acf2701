#include "report/html/page/html_markup.h"

#include "report/html/page/html_pages.h"
#include "report/text/markup.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>

namespace report {

std::string with_minus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) {
    text.replace(at, 1, "−");
  }
  return text;
}

std::string badge(const Texts& t, rules::Verdict verdict, bool counts) {
  return fmt::format(
      "<span class=\"badge {}{}\"><span class=\"sign\" aria-hidden=\"true\">{}</span>{}</span>",
      calc::name_of(verdict), counts ? "" : " free", verdict_symbol(verdict),
      verdict_words(t, verdict));
}

std::string badge_of(const Texts& t, const rules::Requirement& requirement, rules::Verdict verdict,
                     bool counts) {
  if (!is_outside_advice(requirement, verdict)) return badge(t, verdict, counts);
  return fmt::format(
      "<span class=\"badge free advice\"><span class=\"sign\" "
      "aria-hidden=\"true\">{}</span>{}</span>",
      outcome_symbol(rules::Outcome::nothing_asked), t[Text::advice_outside]);
}

std::string plane_anchor(PlaneIndex index) {
  return fmt::format("p{}s{}k{}", index.project + 1, index.space + 1, index.plane + 1);
}

std::string space_anchor(std::size_t project, std::size_t space) {
  return fmt::format("p{}s{}", project + 1, space + 1);
}

std::string page_name(PlaneIndex index) {
  const std::size_t part = index.plane / kPlanesPerPage;
  const std::string room = fmt::format("p{}s{}", index.project + 1, index.space + 1);
  return part == 0 ? room + ".html" : fmt::format("{}-{}.html", room, part + 1);
}

std::string url_name(const std::string& file_name) {
  std::string name;
  for (const char c : file_name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_' || c == '~';
    if (is_plain) {
      name += c;
    } else {
      name += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return name;
}

std::string plane_href(PlaneIndex index, std::string_view folder) {
  const std::string anchor = "#" + plane_anchor(index);
  return folder.empty() ? anchor : fmt::format("{}/{}{}", folder, page_name(index), anchor);
}

std::string scroll_box(std::string_view label, std::string_view table) {
  return scroll_box_start(label) + std::string(table) + kScrollBoxEnd;
}

std::string scroll_box_start(std::string_view label) {
  return fmt::format("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">",
                     label);
}

std::string fact(std::string_view name, std::string_view value) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, value);
}

std::string outcome_badge(const Texts& t, rules::Outcome outcome) {
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    if (rules::outcome_of(verdict) == outcome) return badge(t, verdict);
  }
  return fmt::format("<span class=\"badge free\">{} {}</span>", outcome_symbol(outcome),
                     escape_html(outcome_words(t, outcome)));
}

}  // namespace report
