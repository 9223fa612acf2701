#include "report/html/chapters/html_maintenance.h"

#include "report/html/page/html_markup.h"
#include "report/text/factor_words.h"
#include "report/text/markup.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace report {
namespace {

// What is to be done, as the project states it; what it does not state is said.
std::string plan_table(const Texts& t, const calc::MaintenancePlan& plan) {
  if (plan.is_empty())
    return std::string("<p class=\"quiet\">") + t[Text::maintenance_not_stated] + "</p>\n";
  const auto months = [&](const std::optional<double>& every) {
    if (!every) return std::string(t[Text::not_stated]);
    if (*every == 1.0) return std::string(t[Text::every_month]);
    return t.say<Text::every_months>(format_shortest(t, *every));
  };
  const auto hours = [&](const std::optional<double>& time_h) {
    return time_h ? format_shortest(t, *time_h) + " h" : std::string(t[Text::not_stated]);
  };
  const std::string environment =
      plan.environment.empty() ? t[Text::not_stated] : escape_html(plan.environment);
  std::string rows = fact(t[Text::environment], environment) +
                     fact(t[Text::clean_luminaires], months(plan.clean_luminaires_months)) +
                     fact(t[Text::clean_surfaces], months(plan.clean_surfaces_months)) +
                     fact(t[Text::replace_lights], hours(plan.replace_lights_h)) +
                     fact(t[Text::hours_of_use], hours(plan.use_h));
  if (!plan.instructions.empty())
    rows += fact(t[Text::maintenance_instructions], escape_html(plan.instructions));
  return std::string("<table class=\"facts\"><caption>") + t[Text::maintenance_stated] +
         "</caption><tbody>\n" + rows + "</tbody></table>\n";
}

std::string type_row(const Texts& t, const LuminaireRow& row) {
  const auto cell = [&](const std::optional<double>& factor) {
    return "<td class=\"num\">" + (factor ? format_limit(t, *factor, "") : "") + "</td>";
  };
  const calc::MaintenanceFactor& factor = row.maintenance;
  return fmt::format(
      "<tr><th scope=\"row\">{}<span class=\"note\">{}</span></th><td "
      "class=\"num\">{}</td>{}{}{}{}<td class=\"num strong\">{}{}</td></tr>\n",
      escape_html(row.type_id), escape_html(row.name), row.count, cell(factor.llmf),
      cell(factor.lsf), cell(factor.lmf), cell(factor.rsmf),
      factor_words(t, row.maintenance_factor),
      factor.is_stated ? ""
                       : std::string("<span class=\"note\">") + t[Text::not_stated] + "</span>");
}

}  // namespace

std::string html_maintenance(const Texts& t, const ProjectPart& project, std::size_t index) {
  if (project.luminaires.empty()) return {};
  std::string rows;
  for (const LuminaireRow& row : project.luminaires) rows += type_row(t, row);
  const auto head = [](const char* words) {
    return std::string("<th scope=\"col\" class=\"num\">") + words + "</th>";
  };
  const char* title = t[Text::maintenance_plan];
  return fmt::format("<h3 id=\"maintenance{}\">{}</h3>\n<p>{}</p>\n", index + 1, title,
                     t[Text::maintenance_meaning]) +
         scroll_box(title, std::string("<table><caption>") + t[Text::maintenance_caption] +
                               "</caption><thead><tr><th scope=\"col\">" + t[Text::type] + "</th>" +
                               head(t[Text::count]) + head(t[Text::llmf]) + head(t[Text::lsf]) +
                               head(t[Text::lmf]) + head(t[Text::rsmf]) +
                               head(t[Text::maintenance_factor]) + "</tr></thead><tbody>\n" + rows +
                               "</tbody></table>") +
         plan_table(t, project.maintenance_plan);
}

}  // namespace report
