#include "report/html/chapters/html_method.h"

#include "report/text/markup.h"
#include "report/text/one_source_note.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

namespace report {
namespace {

constexpr std::array kTerms{std::pair{Text::term_illuminance, Text::term_illuminance_is},
                            std::pair{Text::term_maintained, Text::term_maintained_is},
                            std::pair{Text::term_interval, Text::term_interval_is},
                            std::pair{Text::term_uniformity, Text::term_uniformity_is},
                            std::pair{Text::term_ugr, Text::term_ugr_is},
                            std::pair{Text::term_cylindrical, Text::term_cylindrical_is},
                            std::pair{Text::term_task, Text::term_task_is}};

constexpr std::array kVerdicts{std::pair{Text::verdict_pass, Text::verdict_pass_is},
                               std::pair{Text::verdict_fail, Text::verdict_fail_is},
                               std::pair{Text::verdict_undecided, Text::verdict_undecided_is},
                               std::pair{Text::verdict_not_judged, Text::verdict_not_judged_is},
                               std::pair{Text::waived, Text::waived_is}};

template <class Table>
std::string list(const Texts& t, Text title, const Table& table) {
  std::string html = fmt::format("<h3>{}</h3>\n<dl class=\"terms\">\n", t[title]);
  for (const auto& [name, meaning] : table)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", t[name], t[meaning]);
  return html + "</dl>\n";
}

}  // namespace

std::string html_method(const Texts& t, const DocumentEnd& end, const Footnotes& footnotes,
                        const ClientMethod* client) {
  std::string html = fmt::format(
      "<section aria-labelledby=\"method\" class=\"method\"><h2 "
      "id=\"method\">{}</h2>\n",
      t[Text::method_title]);
  const Text points = client == nullptr ? Text::method_points : Text::method_points_client;
  for (const Text words : {Text::method_light, points, Text::method_without})
    html += fmt::format("<p>{}</p>\n", t[words]);
  if (client != nullptr && client->has_pictures)
    html += fmt::format("<p>{}</p>\n", t[Text::method_pictures]);
  if (client != nullptr && client->has_rendered)
    html += fmt::format("<p>{}</p>\n", t[Text::rendered_caption]);
  html += fmt::format("<p>{}</p>\n",
                      t.say<Text::method_interval>(format_percent(t, end.provenance.confidence)));
  const std::string note = one_source_note(t, end.totals.one_source_rows);
  return html + list(t, Text::method_verdicts, kVerdicts) + list(t, Text::method_terms, kTerms) +
         footnotes.list() + (note.empty() ? "" : "<p>" + escape_html(note) + "</p>\n") +
         "</section>\n";
}

}  // namespace report
