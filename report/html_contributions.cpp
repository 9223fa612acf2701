#include "report/html_contributions.h"

#include "report/html_markup.h"
#include "report/number_format.h"

#include <fmt/format.h>

#include <string_view>

namespace report {
namespace {

std::string row(const PlanePart& plane, const LuminaireShare& share, std::string_view name) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num strong\">{}</td><td class=\"num quiet\">{}</td>"
      "<td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num quiet\">{}</td></tr>\n",
      name, format_measured(share.average_lx, "lx"), format_cell_lx(share.direct_lx),
      format_share(share.average_lx.value / plane.average_lx.value),
      format_measured(share.minimum_lx, "lx"), format_cell_lx(share.minimum_direct_lx));
}

// "panel at (1.00, 2.00, 2.80)", or its id; its group below.
std::string name_of(const LuminaireShare& share) {
  const std::string place = "at " + format_position(share.position_m);
  std::string name =
      share.id.empty() ? escape_html(share.type_id) + " " + place : escape_html(share.id);
  std::string note = share.id.empty() ? "" : escape_html(share.type_id) + " " + place;
  if (!share.group.empty())
    note += (note.empty() ? "" : ", ") + ("group " + escape_html(share.group));
  return note.empty() ? name : name + "<span class=\"note\">" + note + "</span>";
}

}  // namespace

std::string html_contributions(const PlanePart& plane) {
  const LuminaireShares& shares = plane.by_luminaire;
  if (shares.largest.empty()) return {};
  std::string rows;
  for (const LuminaireShare& share : shares.largest) rows += row(plane, share, name_of(share));
  if (shares.others > 0) rows += row(plane, shares.rest, fmt::format("{} others", shares.others));
  return "<details class=\"list\"><summary>Light by luminaire</summary>\n" +
         scroll_box(
             "Light by luminaire",
             "<table><caption>Maintained, each luminaire alone at full output; minimum: at " +
                 format_position(shares.minimum_at_m) +
                 ", where the plane's lies</caption><thead><tr><th scope=\"col\">From</th>"
                 "<th scope=\"col\" class=\"num\">Average</th>"
                 "<th scope=\"col\" class=\"num\">direct, lx</th>"
                 "<th scope=\"col\" class=\"num\">share</th>"
                 "<th scope=\"col\" class=\"num\">At the minimum</th>"
                 "<th scope=\"col\" class=\"num\">direct, lx</th></tr></thead><tbody>\n" +
                 rows + "</tbody></table>") +
         "</details>\n";
}

}  // namespace report
