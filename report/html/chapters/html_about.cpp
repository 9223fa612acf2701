#include "report/html/chapters/html_about.h"

#include "report/text/about_words.h"
#include "report/text/base64.h"
#include "report/text/markup.h"

#include <fmt/format.h>

namespace report {

std::string html_about(const Texts& t, const calc::AboutProject& about) {
  if (about.is_empty()) return "";
  std::string html = "<div class=\"about\">\n";
  if (!about.logo.bytes.empty()) {
    // As a picture it runs nothing and loads nothing, whatever it holds.
    html += fmt::format("<img class=\"logo\" src=\"data:image/{};base64,{}\" alt=\"{}\"/>\n",
                        about.logo.format == calc::LogoFormat::svg ? "svg+xml" : "png",
                        base64(about.logo.bytes),
                        escape_html(about.company.empty() ? t[Text::about_logo] : about.company));
  }
  std::string list;
  for (const AboutWords& one : about_words(t, about)) {
    list += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", one.name, escape_html(one.words));
  }
  if (!list.empty()) html += "<dl>\n" + list + "</dl>\n";
  return html + "</div>\n";
}

}  // namespace report
