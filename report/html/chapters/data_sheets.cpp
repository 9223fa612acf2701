#include "report/html/chapters/data_sheets.h"

#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

// A file may hold several lights, of which each type names one: what is drawn of them differs, too.
bool is_same_curve(const LuminaireRow& a, const LuminaireRow& b, const std::vector<double>& of_a,
                   const std::vector<double>& of_b) {
  constexpr double kRounding = 1e-9;
  // Types of one light may be scaled to different fluxes.
  const double most = kRounding * a.max_intensity_cd * b.flux_lm;
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                    [&](double one, double other) {
                      return std::abs(one * b.flux_lm - other * a.flux_lm) <= most;
                    });
}

// Whether one sheet is enough for both.
bool is_same_light(const LuminaireRow& a, const LuminaireRow& b) {
  return !a.sha256.empty() && a.sha256 == b.sha256 && a.name == b.name && a.lamp == b.lamp &&
         a.article_number == b.article_number && a.colour_temperature == b.colour_temperature &&
         a.colour_rendering == b.colour_rendering && a.file_flux_lm == b.file_flux_lm &&
         a.file_power_w == b.file_power_w &&
         is_same_curve(a, b, {a.max_intensity_cd}, {b.max_intensity_cd}) &&
         is_same_curve(a, b, a.c0_cd, b.c0_cd) && is_same_curve(a, b, a.c90_cd, b.c90_cd);
}

// What the project makes of it, for each type.
std::string uses(const Texts& t, const std::vector<const LuminaireRow*>& rows) {
  std::string html;
  for (const LuminaireRow* row : rows) {
    html +=
        fmt::format("{}{}: {} × {} lm, {}", html.empty() ? "" : "<br/>", escape_html(row->type_id),
                    row->count, format_lumens(t, row->told_lm()),
                    row->power_w > 0.0 ? format_watts(t, row->power_w) + " W"
                                       : t[Text::power] + std::string(" ") + t[Text::not_stated]);
  }
  return fact(t[Text::sheet_in_project], html);
}

std::string title_of_type(const LuminaireRow& row) {
  return row.name.empty() || row.name == row.type_id ? row.type_id : row.type_id + " · " + row.name;
}

}  // namespace

DataSheets data_sheets(const Texts& t, const ProjectPart& project, std::size_t index,
                       const SheetSource& source, std::size_t sheets_before) {
  constexpr std::size_t kFewSheets = 3;  // not folded on the screen
  DataSheets sheets;
  if (project.luminaires.empty()) return sheets;
  std::vector<std::vector<const LuminaireRow*>> lights;
  for (const LuminaireRow& row : project.luminaires) {
    const auto same = std::find_if(lights.begin(), lights.end(), [&](const auto& rows) {
      return is_same_light(*rows.front(), row);
    });
    if (same == lights.end()) {
      lights.push_back({&row});
    } else {
      same->push_back(&row);
    }
  }
  const std::size_t count =
      std::min(lights.size(), kMostSheets - std::min(sheets_before, kMostSheets));
  std::string left_out;
  for (std::size_t i = count; i < lights.size(); ++i) {
    for (const LuminaireRow* row : lights[i])
      left_out += (left_out.empty() ? "" : ", ") + escape_html(row->type_id);
  }
  const std::string anchor = fmt::format("datasheets{}", index + 1);
  sheets.html =
      fmt::format("<div class=\"data-sheets\">\n<h3 id=\"{}\">{}</h3>\n<p class=\"quiet\">{}</p>\n",
                  anchor, t[Text::sheets_title], t[Text::sheet_footer]);
  if (!left_out.empty()) {
    sheets.html +=
        "<p class=\"message\">" + t.say<Text::sheets_left_out>(left_out, kMostSheets) + "</p>\n";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const LuminaireRow& row = *lights[i].front();
    const DataSheets::Entry entry{fmt::format("sheet{}-{}", index + 1, i + 1), title_of_type(row)};
    sheets.html += fmt::format(
        "<details class=\"card data-sheet\"{}><summary><h4 id=\"{}\">{}</h4></summary>\n",
        count <= kFewSheets ? " open=\"\"" : "", entry.anchor, escape_html(entry.name));
    const auto light = source.light_of(row);
    if (const Text* why = std::get_if<Text>(&light)) {
      sheets.html +=
          fmt::format("<p class=\"message\">{}<span class=\"note\">{} {}</span></p>\n", t[*why],
                      escape_html(row.photometry_file), escape_html(row.sha256));
    } else {
      sheets.html += sheet_body(t, std::get<SheetLight>(light), {"h5", uses(t, lights[i]), true});
    }
    sheets.html += "</details>\n";
    sheets.entries.push_back(entry);
  }
  sheets.html += "</div>\n";
  return sheets;
}

}  // namespace report
