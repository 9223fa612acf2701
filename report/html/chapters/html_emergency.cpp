#include "report/html/chapters/html_emergency.h"

#include "report/html/chapters/html_findings.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace report {
namespace {

// Luminaires of the room that are lit in the scene.
std::size_t lit_luminaires(const ProjectPart& project, const SpacePart& space,
                           const std::string& scene_id) {
  const auto scene = std::find_if(project.scenes.begin(), project.scenes.end(),
                                  [&](const SceneRow& row) { return row.id == scene_id; });
  const auto is_lit = [&](const LuminaireMark& mark) {
    return scene == project.scenes.end() || level_of(*scene, mark.group) > 0.0;
  };
  return static_cast<std::size_t>(
      std::count_if(space.luminaires.begin(), space.luminaires.end(), is_lit));
}

// With everything that must be read with the verdict.
std::string requirement_html(const Texts& t, const PlanePart& plane, const rules::Finding& finding,
                             const Footnotes& footnotes) {
  std::string html = escape_html(quantity_words(t, finding.requirement, plane.kernel)) +
                     html_finding_notes(t, finding, footnotes);
  if (!finding.reason.empty())
    html += "<span class=\"note\">" + sentence_html(t, finding.reason) + "</span>";
  return html;
}

}  // namespace

std::string html_emergency(const Texts& t, const ProjectPart& project, std::size_t index,
                           const std::string& folder, const Footnotes& footnotes) {
  std::string rows;
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    for (std::size_t k = 0; k < space.planes.size(); ++k) {
      const PlanePart& plane = space.planes[k];
      for (const rules::Finding& finding : plane.findings) {
        const rules::Requirement& asked = finding.requirement;
        if (asked.state != rules::LightState::end_of_duration) continue;
        const Threshold threshold{asked.limit, asked.comparison};
        const char* unit = rules::unit_of(asked);
        const bool is_judged = finding.verdict != rules::Verdict::not_judged;
        rows += fmt::format(
            "<tr><th scope=\"row\"><a href=\"{}\">{}</a><span class=\"note\">{}</span></th><td>{}"
            "</td><td>{}</td><td class=\"num\">{}</td><td "
            "class=\"num\">{}</td><td class=\"num strong\">{}</td><td>{}</td></tr>\n",
            plane_href({index, s, k}, folder), escape_html(plane_name(t, space, plane)),
            escape_html(title_of(space.name, space.id)),
            requirement_html(t, plane, finding, footnotes),
            asked.scene.empty() ? t[Text::full_output] : escape_html(asked.scene),
            lit_luminaires(project, space, asked.scene),
            escape_html(format_required(t, threshold, unit)),
            is_judged ? format_measured(t, finding.measured, unit, threshold) : "",
            html_verdict(t, plane, finding));
      }
    }
  }
  if (rows.empty()) return {};
  const char* title = t[Text::emergency];
  return fmt::format("<h3 id=\"emergency{}\">{}</h3>\n", index + 1, title) +
         scroll_box(title,
                    fmt::format("<table class=\"emergency\"><caption>{}</caption><thead><tr><th "
                                "scope=\"col\">{}</th><th scope=\"col\">{}</th><th "
                                "scope=\"col\">{}</th><th scope=\"col\" class=\"num\">{}</th><th "
                                "scope=\"col\" class=\"num\">{}</th><th scope=\"col\" "
                                "class=\"num\">{}</th><th scope=\"col\">{}</th></tr></thead>"
                                "<tbody>\n{}</tbody></table>",
                                t[Text::emergency_caption], t[Text::plane], t[Text::requirement],
                                t[Text::light_scene], t[Text::luminaires_lit], t[Text::required],
                                t[Text::measured], t[Text::verdict], rows));
}

}  // namespace report
