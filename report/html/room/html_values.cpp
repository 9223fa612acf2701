#include "report/html/room/html_values.h"

#include "report/document/shown_plane.h"
#include "report/html/page/html_markup.h"
#include "report/images/heatmap.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/point_thresholds.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostValues = 2500;  // of a plane; longer tables are for the CSV file
constexpr int kColumnsOnPaper = 18;

std::string matrix_caption(const Texts& t, const PlanePart& plane) {
  const std::string words = values_words(t, plane);
  return plane.grid.route ? t.say<Text::route_matrix_caption>(words)
                          : t.say<Text::matrix_caption>(words);
}

// What stands above the columns and before the rows: of a route the stations along its line and
// the distances from it, as if it were straight.
struct MatrixHeads {
  std::vector<double> u_m, v_m;
};

MatrixHeads matrix_heads(const calc::SensorGrid& grid) {
  MatrixHeads heads;
  if (grid.route) {
    const calc::RouteCells cells = grid.route->cells(grid.rows);
    for (int column = 0; column < grid.columns; ++column)
      heads.u_m.push_back(cells.station_m(column));
    for (int row = 0; row < grid.rows; ++row) heads.v_m.push_back(cells.offset_m(row));
    return heads;
  }
  for (int column = 0; column < grid.columns; ++column)
    heads.u_m.push_back((column + 0.5) * grid.spacing_u_m);
  for (int row = 0; row < grid.rows; ++row) heads.v_m.push_back((row + 0.5) * grid.spacing_v_m);
  return heads;
}

// Values as they lie in the plane: rows from large v to small, as in the drawing; columns from
// first up to, and without, end.
std::string value_matrix(const Texts& t, const PlanePart& plane, int first, int end) {
  const calc::SensorGrid& grid = plane.grid;
  const Thresholds thresholds = point_thresholds(plane);
  std::map<std::pair<int, int>, calc::Estimate> value_of_cell;
  for (const PointRow& point : plane.points)
    value_of_cell[{point.row, point.column}] = point.measured;
  std::string html = "<table class=\"matrix\"><caption>" + matrix_caption(t, plane) +
                     "</caption><thead><tr><th scope=\"col\">v \\ u</th>";
  const MatrixHeads heads = matrix_heads(grid);
  for (int column = first; column < end; ++column) {
    html += fmt::format("<th scope=\"col\">{}</th>",
                        format_metres(t, heads.u_m[static_cast<std::size_t>(column)]));
  }
  html += "</tr></thead><tbody>\n";
  for (int row = grid.rows - 1; row >= 0; --row) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>",
                        with_minus(format_metres(t, heads.v_m[static_cast<std::size_t>(row)])));
    for (int column = first; column < end; ++column) {
      const auto found = value_of_cell.find({row, column});
      html += found == value_of_cell.end()
                  ? "<td></td>"
                  : "<td>" + escape_html(cell_words(t, plane, found->second, thresholds)) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>";
}

std::string value_list(const Texts& t, const PlanePart& plane) {
  std::string html = "<table class=\"findings points\"><caption>" +
                     t.say<Text::list_caption>(state_plane_words(t, plane)) +
                     "</caption><thead><tr>" +
                     fmt::format(
                         "<th scope=\"col\">{}</th><th scope=\"col\" class=\"num\">{}</th>"
                         "<th scope=\"col\" class=\"num\">{}</th><th scope=\"col\" "
                         "class=\"num\">{}</th><th scope=\"col\" class=\"num\">{}</th><th "
                         "scope=\"col\" class=\"num\">{}</th></tr></thead><tbody>\n",
                         t[Text::point], t[Text::position_m], t[Text::normal], t[Text::value],
                         t[Text::direct_light], t[Text::indirect_light]);
  const Thresholds thresholds = point_thresholds(plane);
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    const PointRow& point = plane.points[i];
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num quiet\">{}</td>"
        "<td class=\"num strong\">{}</td><td class=\"num part\">{} lx</td><td class=\"num "
        "part\">{} "
        "lx</td></tr>\n",
        i + 1, with_minus(format_position(t, point.position_m)),
        with_minus(format_position(t, point.normal)),
        escape_html(value_words(t, plane, point.measured, thresholds)),
        format_cell(t, point.direct_lx), format_cell(t, point.indirect_lx));
  }
  return html + "</tbody></table>";
}

// Whether its tables may stand beside those of other planes: what stands so is never cut between
// pages, and longer than a page it would lose its end.
bool is_small_on_paper(const PlanePart& plane) {
  constexpr int kMostRows = 25;
  return plane.grid.columns <= kColumnsOnPaper && plane.grid.rows <= kMostRows;
}

// Of values as tables that paper holds.
std::string annex_of_plane(const Texts& t, const SpacePart& space, const PlanePart& own_plane) {
  const ShownPlane shown(own_plane);
  const PlanePart& plane = *shown;
  std::string html = fmt::format("<h3>{} <span class=\"quiet\">{}</span></h3>\n",
                                 escape_html(plane_name(t, space, plane)),
                                 escape_html(title_of(space.name, space.id)));
  if (const std::string words = other_light_words(t, plane); !words.empty())
    html += "<p class=\"message\">" + escape_html(words) + "</p>\n";
  const int columns = plane.grid.columns;
  const int parts = (columns + kColumnsOnPaper - 1) / kColumnsOnPaper;
  for (int part = 0; part < parts; ++part) {
    // Parts of about the same width.
    html += value_matrix(t, plane, columns * part / parts, columns * (part + 1) / parts) + "\n";
  }
  return html;
}

}  // namespace

std::string html_values(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  if (plane.points.size() > kMostValues) {
    return "<p class=\"elsewhere\">" + t.say<Text::values_in_csv>(plane.points.size()) + "</p>\n";
  }
  const bool is_list = !has_cells(plane);
  return fmt::format(
      "<details class=\"{}\"{}><summary>{}</summary>\n{}</details>\n", is_list ? "list" : "grid",
      is_list ? " open=\"open\"" : "", t.say<Text::values_at_points>(plane.points.size()),
      scroll_box(t.say<Text::values_of>(escape_html(plane_name(t, space, plane))),
                 is_list ? value_list(t, plane) : value_matrix(t, plane, 0, plane.grid.columns)));
}

bool AnnexPlane::has_table() const { return plane->is_computed && has_cells(*plane); }

std::string html_annex(const Texts& t, const std::vector<AnnexPlane>& planes, Annex annex,
                       std::string_view id) {
  if (annex == Annex::never) return {};
  std::size_t values = 0;
  for (const AnnexPlane& one : planes) values += one.has_table() ? one.plane->points.size() : 0;
  if (values == 0) return {};
  const bool is_left_out = annex == Annex::automatic && values > kMostAnnexValues;
  std::string html =
      fmt::format("<section class=\"annex\" aria-labelledby=\"{0}\"><h2 id=\"{0}\">{1}</h2>\n", id,
                  t[Text::annex]);
  if (is_left_out) {
    html += "<p>" + t.say<Text::annex_left_out>(format_count(values), "--annex always") + "</p>\n";
  } else {
    for (const AnnexPlane& one : planes)
      html += one.has_table() ? fmt::format("<div class=\"values{}\">{}</div>\n",
                                            is_small_on_paper(*one.plane) ? " beside" : "",
                                            annex_of_plane(t, *one.space, *one.plane))
                              : "";
  }
  return html + "</section>\n";
}

}  // namespace report
