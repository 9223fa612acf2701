#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/converge/converge_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {
namespace {

// Right-aligned columns, the first one left.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> heads) { rows_.push_back(std::move(heads)); }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  std::string text() const {
    std::vector<std::size_t> width(rows_.front().size(), 0);
    for (const auto& row : rows_) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        width[c] = std::max(width[c], display_width(row[c]));
      }
    }
    std::string text;
    for (const auto& row : rows_) {
      std::string line = "  ";
      for (std::size_t c = 0; c < row.size(); ++c) {
        const std::string gap(width[c] - display_width(row[c]), ' ');
        line += c == 0 ? row[c] + gap : "  " + gap + row[c];
      }
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string curve_text(const ConvergeMethod& method, const ConvergeCurve& curve) {
  TextTable table({"paths", "time", "rays/point", "light rays", "RMS", "worst point", "average",
                   "Uo", "held", "average held"});
  for (std::size_t k = 0; k < method.steps.size(); ++k) {
    const ConvergeStep& step = method.steps[k];
    const auto& errors = curve.errors[k];
    table.add({count_words(static_cast<double>(step.paths)), time_words(step.seconds),
               count_words(step.rays_per_point),
               step.light_rays > 0.0 ? count_words(step.light_rays) : "–", error_words(errors[0]),
               error_words(errors[1]), error_words(errors[2]), error_words(errors[3]),
               coverage_words(curve.coverage[k]), coverage_words(curve.average_coverage[k])});
  }
  std::string slopes;
  for (std::size_t m = 0; m < kConvergeMetrics; ++m) {
    slopes +=
        fmt::format("{} {} {}", m == 0 ? "" : ",", converge_metric_name(kAllConvergeMetrics[m]),
                    slope_words(curve.slopes[m].over_time));
  }
  return fmt::format("{} ({})\n{}  slopes over time:{}; RMS over rays {}\n", method.title,
                     method.name, table.text(), slopes, slope_words(curve.slopes[0].over_rays));
}

std::string targets_text(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::vector<std::string> heads{"time to an RMS error of"};
  for (const double target : kConvergeTargets) heads.push_back(format_percent(target));
  TextTable table(heads);
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    std::vector<std::string> row{document.methods[m].name};
    for (const ConvergeTarget& target : plane.curves[m].targets) row.push_back(time_words(target));
    table.add(std::move(row));
  }
  return table.text();
}

std::string phases_text(const ConvergeDocument& document) {
  const std::vector<ConvergePhase> phases = shown_phases(document);
  std::vector<std::string> heads{"phases", "paths"};
  for (const ConvergePhase& phase : phases) heads.emplace_back(phase.title);
  heads.emplace_back("all");
  TextTable table(heads);
  for (const ConvergeMethod& method : document.methods) {
    const ConvergeStep& step = method.steps.back();
    std::vector<std::string> row{method.name, count_words(static_cast<double>(step.paths))};
    for (const ConvergePhase& phase : phases)
      row.push_back(phase_words(step.phases.*phase.seconds));
    row.push_back(time_words(step.seconds));
    table.add(std::move(row));
  }
  return table.text();
}

}  // namespace

std::string render_converge_text(const ConvergeDocument& document) {
  std::string text = fmt::format(
      "{}, space '{}': error of the {} illuminance, {} replicates, {} seeds from {}\n"
      "reference: {}\n{} triangles, {} luminaires; read in {}, prepared in {}\n",
      printable(document.project.empty() ? document.path : document.project),
      printable(document.space_id), document.part, document.replicates, document.seeds,
      document.first_seed, printable(document.reference), document.triangles, document.luminaires,
      time_words(document.load_s), time_words(document.prepare_s));
  if (!document.opengl.empty()) text += "OpenGL: " + printable(opengl_words({}, document)) + "\n";
  for (const ConvergePlane& plane : document.planes) {
    text += fmt::format(
        "\nPlane '{}': {} points, average {:.4g} lx, minimum {:.4g} lx, Uo {:.3f}; reference "
        "{}\n\n",
        printable(plane.id), plane.points, plane.average_lx, plane.minimum_lx, plane.uo,
        plane.reference_error > 0.0
            ? fmt::format("known to {} (RMS)", error_words(plane.reference_error))
            : "exact");
    for (std::size_t m = 0; m < document.methods.size(); ++m) {
      text += curve_text(document.methods[m], plane.curves[m]) + "\n";
    }
    text += targets_text(document, plane);
  }
  return text + "\n" + phases_text(document) +
         "\n< smaller than the reference's error   ~ extrapolated   – not known or not "
         "applicable\n";
}

}  // namespace report
