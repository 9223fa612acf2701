#include "report/html/page/html_tool_page.h"

#include "report/html/page/html_style.h"
#include "report/text/markup.h"

#include <fmt/format.h>

namespace report {

std::string tool_page_start(const Texts& t, const ToolPage& page) {
  const std::string eyebrow = "luxgate · " + page.eyebrow;
  const std::string& head = page.head.empty() ? eyebrow : page.head;
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
             "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
             "name=\"color-scheme\" content=\"light dark\"/>\n<meta "
             "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
             "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\"/>\n"
             "<title>{} – {}</title>\n<style>\n",
             t.language_tag(), page.title, escape_html(page.eyebrow)) +
         html_style() + page.style +
         page_rules(t, page.paper, {head, "", page.foot}, page.has_cover) +
         fmt::format(
             "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#main\">{}</a>\n<header>\n"
             "{}<p class=\"eyebrow\">{}</p>\n<h1>{}</h1>\n",
             t[Text::skip_to_results], page.has_cover ? "<div class=\"cover\">\n" : "",
             escape_html(eyebrow), page.title);
}

std::string tool_page_end(const std::string& footer) {
  return "</main>\n<footer><p>" + footer + "</p></footer>\n</body>\n</html>\n";
}

}  // namespace report
