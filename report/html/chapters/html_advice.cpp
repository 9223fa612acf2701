#include "report/html/chapters/html_advice.h"

#include "report/html/page/html_markup.h"
#include "report/text/advice_words.h"
#include "report/text/markup.h"
#include "report/text/sentences.h"

#include <fmt/format.h>

namespace report {
namespace {

std::string group_table(const Texts& t, const LevelAdvice& advice, const std::string& scene) {
  std::string rows;
  for (const AdviceRow& row : advice_rows(t, advice)) {
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td>"
        "<td class=\"num\">{}</td></tr>\n",
        escape_html(row.group), row.luminaires, row.now, row.advised);
  }
  const auto head = [&](Text text) {
    return std::string("<th scope=\"col\" class=\"num\">") + t[text] + "</th>";
  };
  return scroll_box(scene, std::string("<table class=\"advice\"><caption class=\"unseen\">" +
                                       scene + "</caption><thead><tr><th scope=\"col\">") +
                               t[Text::group_column] + "</th>" + head(Text::luminaires) +
                               head(Text::advice_now) + head(Text::advice_advised) +
                               "</tr></thead><tbody>\n" + rows + "</tbody></table>");
}

std::string scene_html(const Texts& t, const ProjectPart& project, const LevelAdvice& advice) {
  const std::string scene = escape_html(advice_scene(t, advice));
  const std::string outcome = advice.outcome == AdviceOutcome::none_found
                                  ? advice_outcome(t, advice, sentence_html(t, advice.reason))
                                  : escape_html(advice_outcome(t, advice, ""));
  std::string html = fmt::format("<h4 class=\"scene\">{}</h4>\n<p>{}</p>\n", scene, outcome);
  if (!advice.groups.empty()) html += group_table(t, advice, scene);
  for (const AdviceList& list : advice_lists(t, project, advice)) {
    html += "<p>" + list.title + "</p>\n<ul>\n";
    for (const std::string& item : list.items) html += "<li>" + escape_html(item) + "</li>\n";
    html += "</ul>\n";
  }
  return html;
}

}  // namespace

std::string html_advice(const Texts& t, const ProjectPart& project, std::size_t index) {
  if (!has_advice(project)) return {};
  std::string html = fmt::format("<h3 id=\"advice{}\">{}</h3>\n", index + 1, t[Text::advice_title]);
  if (project.advice->empty()) {
    return html + "<p class=\"quiet\">" + t[Text::advice_nothing] + "</p>\n";
  }
  html += std::string("<p class=\"quiet\">") + t[Text::advice_caption] + "</p>\n";
  for (const LevelAdvice& one : *project.advice) html += scene_html(t, project, one);
  return html;
}

}  // namespace report
