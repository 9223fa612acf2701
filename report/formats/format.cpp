#include "report/formats/format.h"

#include "report/formats/ci_annotations.h"
#include "report/formats/csv.h"
#include "report/formats/junit.h"
#include "report/formats/markdown.h"
#include "report/formats/sarif.h"
#include "report/html/html.h"
#include "report/result_file/json.h"

#include <algorithm>

namespace report {
namespace {

using Style = const FormatStyle&;
using Doc = const Document&;

constexpr Format kFormats[] = {
    {"text", "", "",
     [](Doc document, Style s) { return render_text(document, s.terminal, s.texts); }},
    {"csv", "", "results.csv", [](Doc document, Style) { return render_results_csv(document); }},
    {"points-csv", "", "points.csv",
     [](Doc document, Style) { return render_points_csv(document); }},
    {"json", "", "result.json", [](Doc document, Style) { return render_json(document); }},
    {"html", "", "report.html",
     [](Doc document, Style s) { return render_html(document, s.texts); }, true},
    {"junit", "", "", [](Doc document, Style) { return render_junit(document); }},
    {"sarif", "problems", "",
     [](Doc document, Style) { return render_sarif(document, SarifContent::problems); }},
    {"sarif-all", "passes too", "",
     [](Doc document, Style) { return render_sarif(document, SarifContent::all); }},
    {"github", "", "", [](Doc document, Style) { return render_github(document); }},
    {"gitlab", "", "", [](Doc document, Style) { return render_gitlab(document); }},
    {"markdown", "", "", [](Doc document, Style s) { return render_markdown(document, s.texts); }}};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* find_format(std::string_view name) {
  const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const Format& format) { return format.name == name; });
  return found == std::end(kFormats) ? nullptr : found;
}

}  // namespace report
