#include "report/formats/format.h"

#include "report/formats/ci_annotations.h"
#include "report/formats/csv.h"
#include "report/formats/dxf.h"
#include "report/formats/junit.h"
#include "report/formats/markdown.h"
#include "report/formats/pdf.h"
#include "report/formats/sarif.h"
#include "report/formats/xlsx.h"
#include "report/html/client/client_page.h"
#include "report/html/page/html.h"
#include "report/result_file/json.h"

#include <algorithm>

namespace report {
namespace {

using Style = const FormatStyle&;
using Frame = const DocumentFrame&;
using Place = const SpillPlace&;

constexpr Format kFormats[] = {
    {"text", "", "",
     [](Frame frame, Place place, Style s) {
       return text_writer(frame, place, s.terminal, s.texts);
     }},
    {"csv", "", "results.csv",
     [](Frame frame, Place place, Style) { return results_csv_writer(frame, place); }},
    {"points-csv", "", "points.csv",
     [](Frame frame, Place place, Style) { return points_csv_writer(frame, place); }},
    {"luminaires-csv", "", "luminaires.csv",
     [](Frame frame, Place place, Style) { return luminaires_csv_writer(frame, place); }},
    {"xlsx", "a workbook", "",
     [](Frame frame, Place place, Style s) {
       return xlsx_writer(frame, place, s.texts, s.page.paper);
     }},
    {"json", "", "result.json",
     [](Frame frame, Place place, Style) { return json_writer(frame, place); }},
    {"html", "", "report.html",
     [](Frame frame, Place place, Style s) {
       return s.page.detail == Detail::client ? client_writer(frame, place, s.texts, s.page)
                                              : html_writer(frame, place, s.texts, "", s.page);
     },
     true},
    {"pdf", "the HTML, printed by Chromium", "",
     [](Frame frame, Place place, Style s) {
       return pdf_writer(frame, place, s.texts, s.page, s.printer);
     },
     false, true},
    {"dxf", "a drawing for CAD", "",
     [](Frame frame, Place place, Style s) { return dxf_writer(frame, place, s.texts, s.page); }},
    {"junit", "", "", [](Frame frame, Place place, Style) { return junit_writer(frame, place); }},
    {"sarif", "problems", "",
     [](Frame frame, Place place, Style) {
       return sarif_writer(frame, place, SarifContent::problems);
     }},
    {"sarif-all", "passes too", "",
     [](Frame frame, Place place, Style) { return sarif_writer(frame, place, SarifContent::all); }},
    {"github", "", "", [](Frame frame, Place place, Style) { return github_writer(frame, place); }},
    {"gitlab", "", "", [](Frame frame, Place place, Style) { return gitlab_writer(frame, place); }},
    {"markdown", "", "",
     [](Frame frame, Place place, Style s) { return markdown_writer(frame, place, s.texts); }}};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* find_format(std::string_view name) {
  const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const Format& format) { return format.name == name; });
  return found == std::end(kFormats) ? nullptr : found;
}

std::string Format::render(const Document& document, const FormatStyle& style) const {
  return render_whole(document, [&](const DocumentFrame& frame, const SpillPlace& place) {
    return writer(frame, place, style);
  });
}

}  // namespace report
