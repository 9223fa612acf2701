#include "report/html/page/html_markup.h"
#include "report/html/page/html_tool_page.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"
#include "report/tools/advise/advice.h"
#include "report/tools/advise/advice_words.h"
#include "report/tools/advise/ceiling_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace cli {
namespace {

using report::escape_html;

// Maps of a room: of so many requirements, and types.
constexpr std::size_t kMostMaps = 3;

constexpr const char* kAdviceStyle = R"css(
.lead { font-size: 1.12rem; line-height: 1.4; max-width: 46rem; margin: 0 0 1rem; }
.ceiling { margin: .8rem 0 1.6rem; } .ceiling .map { display: block; max-width: 100%; height: auto; }
.map text { font-family: inherit; text-anchor: middle; } .map .number { font-size: 11px; font-weight: 700; fill: #000; }
.map .walls { fill: none; stroke: var(--wall); stroke-width: 2.5; stroke-linejoin: round; }
.map .there { fill: none; stroke: #191d21; stroke-width: 1.8; } .map .halo { fill: none; stroke: #fff; stroke-width: 4; }
.map .together { fill: none; stroke: #191d21; stroke-width: 2.4; } .map .around { fill: none; stroke: #fff; stroke-width: 5; }
.map .best { fill: #fff; stroke: #191d21; stroke-width: 2; }
ul.plain { margin: .4rem 0 1.2rem; padding-left: 1.2rem; }
pre.same { font-size: .82rem; }
)css";

std::string words(const std::string& text) { return escape_html(text); }

std::string badge(rules::Verdict verdict) { return report::badge(report::Texts(), verdict); }

std::string groups_table(const SceneAdvice& advice) {
  std::string html =
      "<table><thead><tr><th>Group</th><th class=\"num\">Luminaires</th><th class=\"num\">Now</th>"
      "<th class=\"num\">Advised</th></tr></thead><tbody>\n";
  for (const AdvisedGroup& group : advice.groups) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td>"
        "<td class=\"num\">{}</td></tr>\n",
        words(name_of_group(group.group)), group.luminaires, level_words(group.now),
        level_words(group.level));
  }
  return report::scroll_box("Levels of groups", html + "</tbody></table>\n");
}

std::string requirements_table(const SceneAdvice& advice) {
  const bool has_levels = advice.has_levels();
  std::string html = fmt::format(
      "<table><thead><tr><th>Requirement</th><th class=\"num\">Now</th><th>Verdict now</th>{}</tr>"
      "</thead><tbody>\n",
      has_levels ? "<th class=\"num\">With these levels</th><th>Verdict with them</th>" : "");
  for (const AdvisedRequirement& one : advice.requirements) {
    html += fmt::format("<tr><th scope=\"row\">{}{}</th><td class=\"num\">{}</td><td>{}</td>",
                        words(requirement_words(one)),
                        one.not_searched.empty()
                            ? ""
                            : fmt::format("<span class=\"note\">not part of the search: {}</span>",
                                          words(one.not_searched.english())),
                        words(value_words(one.before)), badge(one.before.verdict));
    if (has_levels) {
      // What no luminaire gives is not green.
      html +=
          fmt::format("<td class=\"num\">{}</td><td>{}</td>", words(value_words(one.after)),
                      advice.outcome == AdviceOutcome::levels ? badge(one.after.verdict)
                                                              : words(verdict_words(advice, one)));
    }
    html += "</tr>\n";
  }
  return report::scroll_box("Requirements", html + "</tbody></table>\n");
}

std::string list_of(const std::vector<std::string>& items) {
  std::string html = "<ul class=\"plain\">";
  for (const std::string& one : items) html += "<li>" + words(one) + "</li>";
  return html + "</ul>\n";
}

std::string limits_list(const SceneAdvice& advice) {
  if (advice.limits.empty()) return "";
  std::vector<std::string> items;
  for (const AdvisedLimit& limit : advice.limits) {
    const std::string shares = share_words(advice, limit);
    items.push_back(fmt::format(
        "{}: {}{}{}", requirement_words(advice.requirements[limit.requirement]),
        cost_words(limit.cost_per_percent, advice.unit),
        limit.place_m ? "; least room at " + report::format_position(*limit.place_m) : "",
        shares.empty() ? "" : "; " + shares));
  }
  return "<h3>Limits that decide, and what each would save if 1 % looser</h3>\n" + list_of(items);
}

std::string scene_html(const SceneAdvice& advice) {
  std::string html = fmt::format("<h2>{}</h2>\n<p class=\"lead\">{}</p>\n",
                                 words(scene_words(advice.scene)), words(outcome_words(advice)));
  if (advice.has_levels()) {
    html += fmt::format("<p>{}</p>\n", words(cost_sentence(advice)));
    if (const std::string note = unit_note(advice.unit); !note.empty()) {
      html += fmt::format("<p>{}</p>\n", note);
    }
    html += groups_table(advice);
    if (const std::string left = left_alone_words(advice); !left.empty()) {
      html += "<p class=\"quiet\">" + words(left) + "</p>\n";
    }
    if (!advice.raised_for.empty()) {
      std::vector<std::string> items;
      for (const std::size_t i : advice.raised_for) {
        items.push_back(requirement_words(advice.requirements[i]));
      }
      html += fmt::format("<p>{}</p>\n", kRaised) + list_of(items);
    }
  }
  if (!advice.contradicting.empty()) {
    std::vector<std::string> items;
    for (const std::size_t i : advice.contradicting) {
      items.push_back(fmt::format("{}: {} now", requirement_words(advice.requirements[i]),
                                  value_words(advice.requirements[i].before)));
    }
    html += "<p>" + words(contradiction_words(advice)) + ":</p>\n" + list_of(items);
  }
  if (!advice.aggregates_not_met.empty()) {
    html += "<p>Not met with these levels:</p>\n" + list_of(advice.aggregates_not_met);
  }
  return html + limits_list(advice) + "<h3>Requirements</h3>\n" + requirements_table(advice);
}

// Beside pictures, all that the text says: said once, there.
std::string same_text(const std::string& text) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!lines.empty() || end > begin) lines += words(text.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return "<pre class=\"same\">" + lines + "</pre>\n";
}

std::string maps_of(const RoomPlaces& room) {
  std::string html;
  const std::size_t requirements = std::min(kMostMaps, room.requirements.size());
  bool is_all = requirements == room.requirements.size();
  for (std::size_t r = 0; r < requirements; ++r) {
    const RoomRequirement& one = room.requirements[r];
    std::vector<std::string> types = types_on_map(room, r);
    if (types.size() > kMostMaps) {
      is_all = false;
      types.resize(kMostMaps);
    }
    for (const std::string& type : types) {
      html += fmt::format("<h3>{}: {}, now {}. What one {} more adds, lx</h3>\n", words(one.plane),
                          words(asked_words(one.before.requirement)),
                          words(value_words(one.before)), words(type)) +
              ceiling_map(room, r, type);
    }
  }
  if (!is_all)
    html += "<p class=\"quiet\">Further requirements and types are in the JSON output.</p>\n";
  return html;
}

std::string places_html(const RoomPlaces& room) {
  std::string html = fmt::format("<h2>{}, {}: where one more luminaire helps</h2>\n",
                                 words(scene_words(room.scene)), words(room.space));
  if (room.problem.empty() && !room.places.empty()) {
    html +=
        "<p class=\"quiet\">Every square is a free place. Crosses are existing luminaires, numbers "
        "the best places for one more, diamonds places that are sufficient together. Gains are "
        "values without their intervals; the title of each square has those. The results of checks "
        "are below.</p>\n" +
        maps_of(room);
  }
  return html;
}

}  // namespace

std::string render_advice_html(const Advice& advice) {
  report::ToolPage page;
  const std::string name = report::printable(advice.project);
  page.title = words(name.substr(name.rfind('/') + 1));
  page.eyebrow = "advise";
  page.style = kAdviceStyle;
  page.foot = name;
  std::string html =
      report::tool_page_start(report::Texts(), page) + "<p class=\"quiet\">" + words(name) +
      "</p>\n<p class=\"quiet\">Changes that would make it pass, with the least power. Checks use "
      "other random numbers than the search.</p>\n</header>\n<main id=\"main\">\n";
  for (const SceneAdvice& one : advice.scenes) html += scene_html(one);
  if (!advice.not_met_besides.empty()) {
    html += "<h2>Not met, whatever the levels</h2>\n" + list_of(advice.not_met_besides);
  }
  if (advice.written) html += "<h2>Written</h2>\n" + same_text(written_words(*advice.written));
  if (advice.packages) {
    html += "<h2>Lamp packages</h2>\n" + same_text(render_package_advice_text(*advice.packages));
  }
  if (advice.rooms.places) {
    for (const RoomPlaces& room : *advice.rooms.places) html += places_html(room);
  }
  if (const std::string text = render_room_advice_text(advice.rooms); !text.empty()) {
    html += "<h2>Places, turns and surfaces as text</h2>\n" + same_text(text);
  }
  return html + report::tool_page_end("luxgate advise");
}

}  // namespace cli
