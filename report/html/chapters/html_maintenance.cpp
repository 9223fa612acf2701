#include "report/html/chapters/html_maintenance.h"

#include "report/html/page/html_markup.h"
#include "report/text/factor_words.h"
#include "report/text/markup.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

using Part = std::optional<double> calc::MaintenanceFactor::*;
constexpr std::array<std::pair<Text, Part>, 4> kParts{
    {{Text::llmf, &calc::MaintenanceFactor::llmf},
     {Text::lsf, &calc::MaintenanceFactor::lsf},
     {Text::lmf, &calc::MaintenanceFactor::lmf},
     {Text::rsmf, &calc::MaintenanceFactor::rsmf}}};

// The parts that some type states: a column that is empty for all of them tells nothing.
std::vector<std::pair<Text, Part>> stated_parts(const ProjectPart& project) {
  std::vector<std::pair<Text, Part>> stated;
  for (const auto& part : kParts) {
    if (std::any_of(
            project.luminaires.begin(), project.luminaires.end(),
            [&](const LuminaireRow& row) { return (row.maintenance.*part.second).has_value(); }))
      stated.push_back(part);
  }
  return stated;
}

std::string type_row(const Texts& t, const LuminaireRow& row,
                     const std::vector<std::pair<Text, Part>>& parts) {
  const calc::MaintenanceFactor& factor = row.maintenance;
  std::string cells;
  for (const auto& [name, part] : parts) {
    const std::optional<double>& value = factor.*part;
    cells += "<td class=\"num\">" + (value ? format_limit(t, *value, "") : "") + "</td>";
  }
  return fmt::format(
      "<tr><th scope=\"row\">{}<span class=\"note\">{}</span></th><td "
      "class=\"num\">{}</td>{}<td class=\"num strong\">{}{}</td></tr>\n",
      escape_html(row.type_id), escape_html(row.name), row.count, cells,
      factor_words(t, row.maintenance_factor),
      factor.is_stated ? ""
                       : std::string("<span class=\"note\">") + t[Text::not_stated] + "</span>");
}

}  // namespace

std::string html_maintenance(const Texts& t, const ProjectPart& project, std::size_t index) {
  if (project.luminaires.empty()) return {};
  std::string rows;
  const std::vector<std::pair<Text, Part>> parts = stated_parts(project);
  for (const LuminaireRow& row : project.luminaires) rows += type_row(t, row, parts);
  const auto head = [](const char* words) {
    return std::string("<th scope=\"col\" class=\"num\">") + words + "</th>";
  };
  std::string heads = head(t[Text::count]);
  for (const auto& [name, part] : parts) heads += head(t[name]);
  const char* title = t[Text::maintenance_plan];
  return fmt::format("<h3 id=\"maintenance{}\">{}</h3>\n<p>{}</p>\n", index + 1, title,
                     t[Text::maintenance_meaning]) +
         scroll_box(title, std::string("<table><caption>") + t[Text::maintenance_caption] +
                               "</caption><thead><tr><th scope=\"col\">" + t[Text::type] + "</th>" +
                               heads + head(t[Text::maintenance_factor]) +
                               "</tr></thead><tbody>\n" + rows + "</tbody></table>") +
         plan_table(t, project.maintenance_plan);
}

}  // namespace report
