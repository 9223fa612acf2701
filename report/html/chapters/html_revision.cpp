#include "report/html/chapters/html_revision.h"

#include "report/html/drawings/html_difference.h"
#include "report/html/page/html_markup.h"
#include "report/revision/revision_tables.h"
#include "report/text/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostRows = 500;

std::string cell(const Texts& t, const RevisionTable& table, std::size_t column,
                 const std::string& text) {
  const std::string html = escape_html(text);
  const bool is_english =
      std::find(table.english.begin(), table.english.end(), column) != table.english.end();
  return "<td>" + (is_english ? t.english_html(html) : html) + "</td>";
}

std::string table_html(const Texts& t, const Document& document, const RevisionTable& table) {
  const std::string title = escape_html(table.title);
  std::string html = fmt::format(
      "<table class=\"findings\"><caption class=\"unseen\">{}</caption><thead><tr>", title);
  for (const std::string& head : table.head) {
    html += fmt::format("<th scope=\"col\">{}</th>", escape_html(head));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) html += cell(t, table, c, row[c]);
    html += "</tr>\n";
  }
  html += "</tbody></table>";
  html = scroll_box(title, html);
  // The first one's title is the section's.
  if (title != html_revision_title(t, document)) html = fmt::format("<h3>{}</h3>\n", title) + html;
  if (table.left_out > 0) {
    html += fmt::format("<p class=\"quiet\">{}</p>\n", t.say<Text::more_left_out>(table.left_out));
  }
  return html;
}

}  // namespace

std::string html_revision_title(const Texts& t, const Document& document) {
  return escape_html(t.say<Text::revision_results>(baseline_words(*document.revision)));
}

std::string html_revision(const Texts& t, const Document& document) {
  if (!document.revision) return {};
  std::string html =
      fmt::format("<section id=\"revision\"><h2>{}</h2>\n", html_revision_title(t, document));
  for (const RevisionTable& table : revision_tables(document, t, kMostRows)) {
    html += table_html(t, document, table);
  }
  html += "<ul>";
  for (const std::string& remark : revision_remarks(document, t)) {
    html += "<li>" + escape_html(remark) + "</li>";
  }
  return html + "</ul>" + html_differences(t, document) + "</section>\n";
}

}  // namespace report
