// Convergence as CSV and JSON.

#include "report/text/csv_field.h"
#include "report/text/json_layout.h"
#include "report/text/number_format.h"
#include "report/tools/converge/converge_document.h"
#include "report/tools/converge/converge_words.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json optional_number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string cell(double value) { return format_shortest(value); }

Json phases_json(const ConvergePhases& phases) {
  Json json = Json::object();
  for (const ConvergePhase& phase : all_phases()) {
    json[std::string(phase.key)] = phases.*phase.seconds;
  }
  return json;
}

Json coverage_json(const ConvergeCoverage& coverage) {
  return {{"held", coverage.held}, {"tried", coverage.tried}};
}

Json curve_json(const ConvergeMethod& method, const ConvergeCurve& curve) {
  Json steps = Json::array();
  for (std::size_t k = 0; k < method.steps.size(); ++k) {
    Json step{{"paths", method.steps[k].paths}};
    for (std::size_t m = 0; m < kConvergeMetrics; ++m) {
      const ConvergeError& e = curve.errors[k][m];
      step[std::string(converge_metric_name(kAllConvergeMetrics[m]))] = {
          {"error", number(e.value)},
          {"lowest", number(e.low)},
          {"highest", number(e.high)},
          {"below_reference", e.is_below}};
    }
    step["coverage_of_points"] = coverage_json(curve.coverage[k]);
    step["coverage_of_average"] = coverage_json(curve.average_coverage[k]);
    steps.push_back(std::move(step));
  }
  Json slopes = Json::object();
  for (std::size_t m = 0; m < kConvergeMetrics; ++m) {
    slopes[std::string(converge_metric_name(kAllConvergeMetrics[m]))] = {
        {"over_time", optional_number(curve.slopes[m].over_time)},
        {"over_rays", optional_number(curve.slopes[m].over_rays)}};
  }
  Json targets = Json::array();
  for (std::size_t t = 0; t < kConvergeTargets.size(); ++t) {
    targets.push_back({{"rms", kConvergeTargets[t]},
                       {"seconds", optional_number(curve.targets[t].seconds)},
                       {"extrapolated", curve.targets[t].is_extrapolated}});
  }
  return {{"method", method.name}, {"steps", steps}, {"slopes", slopes}, {"time_to", targets}};
}

Json method_json(const ConvergeMethod& method) {
  Json steps = Json::array();
  for (const ConvergeStep& step : method.steps) {
    steps.push_back({{"paths", step.paths},
                     {"seconds", step.seconds},
                     {"phases", phases_json(step.phases)},
                     {"light_rays", step.light_rays},
                     {"rays_per_point", step.rays_per_point}});
  }
  return {{"method", method.name}, {"title", method.title}, {"steps", steps}};
}

}  // namespace

std::string render_converge_csv(const ConvergeDocument& document) {
  std::string csv = "space,plane,method,paths,replicates,seeds,seconds";
  for (const ConvergePhase& phase : all_phases()) csv += "," + std::string(phase.key);
  csv += ",light_rays,rays_per_point";
  for (const ConvergeMetric metric : kAllConvergeMetrics) {
    const std::string name(converge_metric_name(metric));
    csv += "," + name + "," + name + "_lowest," + name + "_highest," + name + "_below_reference";
  }
  csv += ",coverage_of_points,coverage_of_average\r\n";
  for (const ConvergePlane& plane : document.planes) {
    for (std::size_t m = 0; m < document.methods.size(); ++m) {
      const ConvergeMethod& method = document.methods[m];
      for (std::size_t k = 0; k < method.steps.size(); ++k) {
        const ConvergeStep& s = method.steps[k];
        csv += csv_field(document.space_id) + "," + csv_field(plane.id) + "," + method.name + "," +
               std::to_string(s.paths) + "," + std::to_string(document.replicates) + "," +
               std::to_string(document.seeds);
        csv += "," + cell(s.seconds);
        for (const ConvergePhase& phase : all_phases()) csv += "," + cell(s.phases.*phase.seconds);
        csv += "," + cell(s.light_rays) + "," + cell(s.rays_per_point);
        for (const ConvergeError& e : plane.curves[m].errors[k]) {
          csv += "," + cell(e.value) + "," + cell(e.low) + "," + cell(e.high) + "," +
                 (e.is_below ? "1" : "0");
        }
        for (const ConvergeCoverage& c :
             {plane.curves[m].coverage[k], plane.curves[m].average_coverage[k]}) {
          csv += "," + (c.tried > 0 ? cell(c.share()) : std::string());
        }
        csv += "\r\n";
      }
    }
  }
  return csv;
}

std::string render_converge_json(const ConvergeDocument& document) {
  Json json{{"luxgate_convergence", 1},
            {"program", document.program},
            {"project", document.project},
            {"path", document.path},
            {"space", document.space_id},
            {"opengl", document.opengl.empty() ? Json() : Json(document.opengl)},
            {"part", document.part},
            {"reference", document.reference},
            {"replicates", document.replicates},
            {"seeds", document.seeds},
            {"first_seed", document.first_seed},
            {"clamp_per_m2", document.clamp_per_m2},
            {"triangles", document.triangles},
            {"luminaires", document.luminaires},
            {"load_s", document.load_s},
            {"prepare_s", document.prepare_s},
            {"reference_s", document.reference_s}};
  json["methods"] = Json::array();
  for (const ConvergeMethod& method : document.methods) {
    json["methods"].push_back(method_json(method));
  }
  json["planes"] = Json::array();
  for (const ConvergePlane& plane : document.planes) {
    Json curves = Json::array();
    for (std::size_t m = 0; m < document.methods.size(); ++m) {
      curves.push_back(curve_json(document.methods[m], plane.curves[m]));
    }
    json["planes"].push_back({{"plane", plane.id},
                              {"points", plane.points},
                              {"average_lx", plane.average_lx},
                              {"minimum_lx", plane.minimum_lx},
                              {"uo", plane.uo},
                              {"reference_rms", plane.reference_error},
                              {"curves", curves}});
  }
  return json_layout(json);
}

}  // namespace report
