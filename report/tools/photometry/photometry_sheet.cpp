#include "report/tools/photometry/photometry_sheet.h"

#include "report/html/chapters/sheet_body.h"
#include "report/html/page/html_style.h"
#include "report/text/markup.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace cli {
namespace {

using report::Text;

// All of it on one page of paper.
constexpr const char* kOnePage = R"css(
@media print {
  h1 { font-size: 1.5rem; } h2 { margin-top: 3mm; padding-top: 1.5mm; font-size: 1rem; border-top-width: 1px; margin-bottom: 1mm; }
}
)css";

}  // namespace

std::string render_photometry_sheet(const report::Texts& t, const PhotometryFile& file,
                                    const std::string& sha256, report::Paper paper) {
  const report::SheetLight light{*file.web,
                                 file.web->flux_lm(),
                                 file.web->source().input_power_w,
                                 1,
                                 std::filesystem::path(file.path).filename().string(),
                                 sha256};
  const std::string name = report::sheet_name(light);
  const std::string title = report::escape_html(name);
  const report::PageWords words{"", "", name};
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
      "name=\"color-scheme\" content=\"light dark\"/>\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\"/>\n<title>{}</title>\n"
      "<style>\n",
      t.language_tag(), title);
  html +=
      report::html_style() + report::sheet_style() + kOnePage + report::page_rules(t, paper, words);
  html += fmt::format(
      "</style>\n</head>\n<body>\n<header>\n<p class=\"eyebrow\">luxgate · {}</p>\n<h1>{}</h1>\n"
      "</header>\n<main id=\"main\">\n",
      t[Text::sheet_title], title);
  html += report::sheet_body(t, light);
  return html + "</main>\n<footer><p>" + t[Text::sheet_footer] +
         "</p></footer>\n</body>\n</html>\n";
}

}  // namespace cli
