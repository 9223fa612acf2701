#include "report/formats/console.h"
#include "report/formats/markdown.h"
#include "report/result_file/json_writer.h"
#include "report/text/csv_field.h"
#include "report/text/json_layout.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/compare/comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace report {
namespace {

std::string point_words(const ComparedPoint& p) {
  return fmt::format(
      "{}: {:.5g} lx and {:.5g} lx, difference {:+.3g} lx ({}), combined interval ±{:.2g} lx",
      format_position(p.position_m), p.a.lx, p.b.lx, p.difference_lx(),
      p.b.lx != 0.0 ? signed_percent(p.difference_lx() / p.b.lx) : "–", p.interval_lx());
}

std::string average_words(const ComparedPlane& plane) {
  const std::optional<double> interval = plane.average_interval_lx();
  if (!interval)
    return "not judged: its interval is not known, and points do not show a common bias";
  return fmt::format(
      "combined interval ±{:.2g} lx, {}", *interval,
      plane.is_average_beyond ? "BEYOND the allowed difference" : "within the allowed difference");
}

}  // namespace

std::string comparison_headline(const Comparison& comparison) {
  if (comparison.is_alike()) return "Alike";
  if (comparison.are_values_alike()) return "REQUIREMENTS OR VERDICTS DIFFER";
  return comparison.lacks > 0 ? "DIFFERENT; some values are on one side only" : "DIFFERENT";
}

std::string signed_percent(double share) {
  return std::isfinite(share) ? fmt::format("{:+.2f} %", 100.0 * share + 0.0) : "–";
}

std::string render_comparison_text(const Comparison& comparison, std::size_t worst) {
  std::string text =
      fmt::format("A  {}\nB  {}\n", printable(comparison.name_a), printable(comparison.name_b));
  if (comparison.revised) text += "\n" + render_revision_text({}, *comparison.revised, false);
  for (const ComparedPlane& plane : comparison.planes) {
    text += fmt::format(
        "\nPlane {}, {} points\n"
        "  average  A {:.5g} lx, B {:.5g} lx: A - B = {} of B's average\n"
        "           {}\n"
        "  Uo       A {:.3f}, B {:.3f}\n"
        "  RMS      {} of B's average\n"
        "  within the combined {} interval: {} of {} points; beyond the allowed difference: {}\n",
        printable(plane.id), plane.points.size(), plane.average_a_lx, plane.average_b_lx,
        signed_percent(plane.bias), average_words(plane), plane.uo_a, plane.uo_b,
        signed_percent(plane.rms).substr(1), format_percent(comparison.confidence), plane.held,
        plane.points.size(), plane.beyond);
    if (worst > 0) text += "  furthest apart:\n";
    for (const std::size_t i : worst_points(plane, worst)) {
      text += "    " + point_words(plane.points[i]) + "\n";
    }
  }
  text += "\n";
  for (const std::string& note : comparison.notes) text += "Note: " + printable(note) + "\n";
  text += fmt::format(
      "{}: {} of {} points and {} of {} averages differ by more than their intervals (times "
      "{:.2f}, "
      "so\nthat all of them together do so by chance in 1 of 20 comparisons){}\n",
      comparison_headline(comparison), comparison.beyond(), comparison.points(),
      comparison.averages_beyond(), comparison.averages_judged(), comparison.widening,
      comparison.tolerance > 0.0 ? fmt::format(" and {} of B", format_percent(comparison.tolerance))
                                 : "");
  return text;
}

std::string render_comparison_markdown(const Comparison& comparison, std::size_t worst) {
  std::string text = fmt::format(
      "### luxgate compare: {}\n\n{} beside {}: {} of {} points and {} of {} averages are beyond "
      "the allowed difference\n",
      comparison_headline(comparison), escape_markdown(comparison.name_a),
      escape_markdown(comparison.name_b), comparison.beyond(), comparison.points(),
      comparison.averages_beyond(), comparison.averages_judged());
  if (comparison.revised) text += render_revision_markdown({}, *comparison.revised);
  if (!comparison.planes.empty()) {
    text +=
        "\n<details>\n<summary>Values by plane</summary>\n\n| plane | points | average A, lx | "
        "average B, lx | A - B | Uo A | Uo B | beyond |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const ComparedPlane& plane : comparison.planes) {
      text += fmt::format("| {} | {} | {:.5g} | {:.5g} | {} | {:.3f} | {:.3f} | {} |\n",
                          escape_markdown(plane.id), plane.points.size(), plane.average_a_lx,
                          plane.average_b_lx, signed_percent(plane.bias), plane.uo_a, plane.uo_b,
                          plane.beyond + (plane.is_average_beyond ? 1 : 0));
    }
    for (const ComparedPlane& plane : comparison.planes) {
      if (plane.beyond == 0 || worst == 0) continue;
      text += fmt::format("\nFurthest apart on {}:\n\n", escape_markdown(plane.id));
      for (const std::size_t i : worst_points(plane, worst)) {
        text += "- " + escape_markdown(point_words(plane.points[i])) + "\n";
      }
    }
    text += "\n</details>\n";
  }
  if (!comparison.notes.empty()) text += "\n";
  for (const std::string& note : comparison.notes) text += "- " + escape_markdown(note) + "\n";
  return text;
}

std::string render_comparison_csv(const Comparison& comparison) {
  std::string csv =
      "plane,column,row,x_m,y_m,z_m,a_lx,a_half_width_lx,b_lx,b_half_width_lx,difference_lx,"
      "difference_share,combined_half_width_lx\n";
  for (const ComparedPlane& plane : comparison.planes) {
    for (const ComparedPoint& p : plane.points) {
      csv += csv_field(plane.id) + fmt::format(",{},{}", p.column, p.row);
      for (const double value :
           {p.position_m.x, p.position_m.y, p.position_m.z, p.a.lx, p.a.half_width_lx, p.b.lx,
            p.b.half_width_lx, p.difference_lx(),
            p.b.lx != 0.0 ? p.difference_lx() / p.b.lx : std::nan(""), p.interval_lx()}) {
        csv += "," + format_shortest(value);
      }
      csv += "\n";
    }
  }
  return csv;
}

std::string render_comparison_json(const Comparison& comparison) {
  using Json = nlohmann::ordered_json;
  Json planes = Json::array();
  for (const ComparedPlane& plane : comparison.planes) {
    Json rows = Json::array();
    for (const ComparedPoint& p : plane.points) {
      rows.push_back({p.column, p.row, p.position_m.x, p.position_m.y, p.position_m.z, p.a.lx,
                      p.a.half_width_lx, p.b.lx, p.b.half_width_lx});
    }
    planes.push_back(
        {{"id", plane.id},
         {"average_a_lx", plane.average_a_lx},
         {"average_b_lx", plane.average_b_lx},
         {"uo_a", plane.uo_a},
         {"uo_b", plane.uo_b},
         {"average_interval_lx",
          plane.average_interval_lx() ? Json(*plane.average_interval_lx()) : Json(nullptr)},
         {"is_average_beyond", plane.is_average_beyond},
         {"bias", plane.bias},
         {"rms", plane.rms},
         {"held", plane.held},
         {"beyond", plane.beyond},
         {"points",
          {{"columns",
            {"column", "row", "x_m", "y_m", "z_m", "a_lx", "a_half_width_lx", "b_lx",
             "b_half_width_lx"}},
           {"rows", rows}}}});
  }
  return json_layout(
      {{"format", "luxgate-comparison"},
       {"format_version", 1},
       {"a", comparison.name_a},
       {"b", comparison.name_b},
       {"confidence", comparison.confidence},
       {"tolerance", comparison.tolerance},
       {"widening", comparison.widening},
       {"points", comparison.points()},
       {"beyond", comparison.beyond()},
       {"averages_judged", comparison.averages_judged()},
       {"averages_beyond", comparison.averages_beyond()},
       {"alike", comparison.is_alike()},
       {"lacks", comparison.lacks},
       {"revision", comparison.revised ? json_of(*comparison.revised->revision) : Json()},
       {"notes", comparison.notes},
       {"planes", planes}});
}

}  // namespace report
