#include "report/html/room/html_contributions.h"

#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace report {
namespace {

// One decimal: many luminaires give a hundredth each.
std::string share_text(const Texts& t, double share) {
  if (!std::isfinite(share)) return format_share(t, share);
  if (share > 0.0 && share < 0.001) return "&lt; " + t.number("0.1") + " %";
  return t.number(format_fixed(100.0 * share, 1)) + " %";
}

std::string row(const Texts& t, const PlanePart& plane, const LuminaireShare& share,
                std::string_view name) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num strong\">{}</td><td class=\"num quiet\">{}</td>"
      "<td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num quiet\">{}</td></tr>\n",
      name, format_measured(t, share.average_lx, "lx"), format_cell(t, share.direct_lx),
      share_text(t, share.average_lx.value / plane.average.value),
      format_measured(t, share.minimum_lx, "lx"), format_cell(t, share.minimum_direct_lx));
}

// "panel at (1.00, 2.00, 2.80)", or its id; its group below.
std::string name_of(const Texts& t, const LuminaireShare& share) {
  const std::string place = t.say<Text::at_place>(format_position(t, share.position_m));
  std::string name =
      share.id.empty() ? escape_html(share.type_id) + " " + place : escape_html(share.id);
  std::string note = share.id.empty() ? "" : escape_html(share.type_id) + " " + place;
  if (!share.group.empty())
    note += (note.empty() ? "" : ", ") + t.say<Text::group_of_luminaire>(escape_html(share.group));
  return note.empty() ? name : name + "<span class=\"note\">" + note + "</span>";
}

}  // namespace

std::string html_contributions(const Texts& t, const PlanePart& plane) {
  const LuminaireShares& shares = plane.by_luminaire;
  if (shares.largest.empty()) return {};
  std::string rows;
  for (const LuminaireShare& share : shares.largest)
    rows += row(t, plane, share, name_of(t, share));
  if (shares.others > 0)
    rows += row(t, plane, shares.rest, t.say<Text::other_luminaires>(shares.others));
  const std::string table = fmt::format(
      "<table><caption>{}</caption><thead><tr><th scope=\"col\">{}</th>"
      "<th scope=\"col\" class=\"num\">{}</th><th scope=\"col\" class=\"num\">{}</th>"
      "<th scope=\"col\" class=\"num\">{}</th><th scope=\"col\" class=\"num\">{}</th>"
      "<th scope=\"col\" class=\"num\">{}</th></tr></thead><tbody>\n{}</tbody></table>",
      t.say<Text::light_by_luminaire_caption>(format_position(t, shares.minimum_at_m)),
      t[Text::light_from], t[Text::average_column], t[Text::direct_lx], t[Text::share_column],
      t[Text::at_the_minimum], t[Text::direct_lx], rows);
  const char* title = t[Text::light_by_luminaire];
  return fmt::format("<details class=\"list calculated\"><summary>{}</summary>\n{}</details>\n",
                     title, scroll_box(title, table));
}

}  // namespace report
