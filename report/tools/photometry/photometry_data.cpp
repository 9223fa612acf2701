// The JSON and CSV of `luxgate photometry`; keys and columns are described in photometry.md.

#include "calc/base/units.h"
#include "report/text/csv_field.h"
#include "report/text/json_layout.h"
#include "report/text/number_format.h"
#include "report/tools/photometry/photometry.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <initializer_list>

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

double rounded_degrees(double rad) {
  return std::round(calc::degrees_from_radians(rad) * 1.0e9) / 1.0e9;
}

Json if_stated(double value) { return value > 0.0 ? Json(value) : Json(nullptr); }

Json width_json(PlanePair pair, const calc::BeamWidth& width) {
  Json json = {{"planes", plane_pair_name(pair)},
               {"lobes", width.lobes},
               {"lobe_deg", rounded_degrees(width.lobe_rad)},
               {"span_deg", rounded_degrees(width.span_rad)},
               {"from_deg", rounded_degrees(width.from_rad)},
               {"to_deg", rounded_degrees(width.to_rad)}};
  return json;
}

Json opening_json(const calc::LuminousOpening& opening) {
  return {{"shape", opening_shape_name(opening.shape)},
          {"along_c0_m", opening.along_c0_m},
          {"along_c90_m", opening.along_c90_m},
          {"height_m", opening.height_m},
          {"longer_side", longer_side_name(longer_side(opening))}};
}

Json table_json(const calc::PhotometricWeb& web) {
  const bool is_lateral = web.axis() == calc::TableAxis::lateral;
  Json json = {{"axis", is_lateral ? "C90-C270" : "vertical"},
               {"c_planes", web.is_axial() ? 1 : web.c_rad().size() - 1},
               {"gamma_angles", web.gamma_rad().size()},
               {"gamma_first_deg", rounded_degrees(web.gamma_rad().front())},
               {"gamma_last_deg", rounded_degrees(web.gamma_rad().back())}};
  if (is_lateral) {
    const LateralAngles angles = lateral_angles(web);
    json.update({{"v_first_deg", angles.v_first_deg},
                 {"v_last_deg", angles.v_last_deg},
                 {"h_first_deg", angles.h_first_deg},
                 {"h_last_deg", angles.h_last_deg}});
  }
  return json;
}

Json lamp_tilt_json(const std::optional<calc::LampTilt>& tilt) {
  if (!tilt) return nullptr;
  Json angles = Json::array();
  for (const double rad : tilt->angle_rad) angles.push_back(rounded_degrees(rad));
  return {{"geometry", tilt->geometry}, {"angles_deg", angles}, {"factors", tilt->factor}};
}

Json light_json(const calc::PhotometricWeb& web, const PhotometryFacts& facts) {
  const calc::PhotometrySource& source = web.source();
  const double flux = web.flux_lm();
  Json json = {{"format", source.format},
               {"luminaire", source.luminaire_name},
               {"manufacturer", source.manufacturer},
               {"flux_lm", flux},
               {"stated_flux_lm", if_stated(source.stated_flux_lm)},
               {"rated_lamp_flux_lm", if_stated(source.rated_lamp_flux_lm)},
               {"light_output_ratio", nullptr},
               {"input_power_w", if_stated(source.input_power_w)},
               {"power_rule", source.power_rule},
               {"efficacy_lm_per_w", nullptr},
               {"downward_share", facts.downward_share},
               {"maximum",
                {{"intensity_cd", facts.peak.intensity_cd},
                 {"c_deg", rounded_degrees(facts.peak.c_rad)},
                 {"gamma_deg", rounded_degrees(facts.peak.gamma_rad)}}}};
  if (source.rated_lamp_flux_lm > 0.0) {
    json["light_output_ratio"] = flux / source.rated_lamp_flux_lm;
  }
  if (source.input_power_w > 0.0) json["efficacy_lm_per_w"] = flux / source.input_power_w;
  json["beam_50_percent"] = Json::array();
  json["field_10_percent"] = Json::array();
  for (const PlanePair pair : {kC0C180, kC90C270}) {
    json["beam_50_percent"].push_back(width_json(pair, facts.beam[pair]));
    json["field_10_percent"].push_back(width_json(pair, facts.field[pair]));
  }
  json["symmetry"] = {
      {"exact", symmetry_name(calc::symmetry_within(facts.symmetry, calc::kExactSymmetry))},
      {"axial_difference", facts.symmetry.axial},
      {"c0_c180_difference", facts.symmetry.c0_c180},
      {"c90_c270_difference", facts.symmetry.c90_c270}};
  json["table"] = table_json(web);
  json["cubic"] = nullptr;
  if (facts.interpolation) {
    json["cubic"] = {{"largest_difference", facts.interpolation->largest_share},
                     {"flux_difference", facts.interpolation->flux_share}};
  }
  json["opening"] = opening_json(web.opening());
  json["axis_rule"] = source.axis_rule;
  json["applied_factors"] = source.applied_factors;
  json["lamp_tilt"] = lamp_tilt_json(source.lamp_tilt);
  return json;
}

Json if_chosen(const std::string& id) { return id.empty() ? Json(nullptr) : Json(id); }

Json vector_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json together_json(const TogetherFacts& all, const std::optional<calc::EmitterPlace>& place) {
  Json json = {{"emitters", all.emitters},
               {"flux_lm", all.flux_lm},
               {"input_power_w", if_stated(all.power_w)}};
  if (place) {
    json["position_m"] = vector_json(place->position_m);
    json["axis"] = vector_json(-place->turn[2]);
    json["c0"] = vector_json(place->turn[0]);
  }
  return json;
}

Json diagnostics_json(const std::vector<calc::Diagnostic>& diagnostics) {
  Json json = Json::array();
  for (const calc::Diagnostic& entry : diagnostics) {
    const bool is_error = entry.severity() == calc::Severity::error;
    Json item = {{"severity", is_error ? "error" : "warning"},
                 {"id", calc::diagnostic_name(entry.id)},
                 {"file", entry.where.file},
                 {"line", nullptr},
                 {"message", entry.message}};
    if (entry.where.line > 0) item["line"] = entry.where.line;
    json.push_back(std::move(item));
  }
  return json;
}

Json comparison_json(const calc::WebComparison& comparison) {
  Json json = {{"flux_ratio", comparison.flux_ratio},
               {"same_light", comparison.fits.front().rms <= kSameLight},
               {"indistinguishable_turns", comparison.alike},
               {"openings", opening_relation_name(comparison.openings)},
               {"fits", Json::array()}};
  for (const calc::TurnFit& fit : comparison.fits) {
    json["fits"].push_back({{"turn_deg", 90 * fit.turn.quarters},
                            {"mirrored", fit.turn.mirrored},
                            {"rms", fit.rms},
                            {"largest", fit.largest}});
  }
  return json;
}

constexpr const char* kCsvHeader =
    "file,readable,format,luminaire,manufacturer,flux_lm,stated_flux_lm,rated_lamp_flux_lm,light_"
    "output_ratio,"
    "input_power_w,efficacy_lm_per_w,downward_share,max_cd,max_c_deg,max_gamma_deg,"
    "beam_c0_c180_deg,beam_c90_c270_deg,field_c0_c180_deg,field_c90_c270_deg,symmetry,"
    "table_axis,c_planes,gamma_angles,gamma_first_deg,gamma_last_deg,cubic_largest_difference,"
    "cubic_flux_difference,opening,opening_along_c0_m,opening_along_c90_m,"
    "opening_height_m,applied_factors,warnings,errors,variant,emitter\r\n";
constexpr std::size_t kEmptyCells = 30;  // of an unreadable file, between `readable` and `warnings`

std::string light_cells(const calc::PhotometricWeb& web, const PhotometryFacts& facts) {
  const calc::PhotometrySource& source = web.source();
  const double flux = web.flux_lm();
  std::string cells;
  const auto text = [&](const std::string& value) { cells += "," + report::csv_field(value); };
  const auto number = [&](double value) { cells += "," + report::format_shortest(value); };
  const auto ratio = [&](double value, double to) {
    cells += "," + (to > 0.0 ? report::format_shortest(value / to) : std::string());
  };
  text(source.format);
  text(source.luminaire_name);
  text(source.manufacturer);
  number(flux);
  ratio(source.stated_flux_lm, source.stated_flux_lm > 0.0 ? 1.0 : 0.0);
  ratio(source.rated_lamp_flux_lm, source.rated_lamp_flux_lm > 0.0 ? 1.0 : 0.0);
  ratio(flux, source.rated_lamp_flux_lm);
  ratio(source.input_power_w, source.input_power_w > 0.0 ? 1.0 : 0.0);
  ratio(flux, source.input_power_w);
  number(facts.downward_share);
  number(facts.peak.intensity_cd);
  number(rounded_degrees(facts.peak.c_rad));
  number(rounded_degrees(facts.peak.gamma_rad));
  for (const auto* widths : {&facts.beam, &facts.field}) {
    for (const calc::BeamWidth& width : *widths) number(rounded_degrees(width.span_rad));
  }
  text(symmetry_name(calc::symmetry_within(facts.symmetry, calc::kExactSymmetry)));
  text(web.axis() == calc::TableAxis::lateral ? "C90-C270" : "vertical");
  number(web.is_axial() ? 1.0 : static_cast<double>(web.c_rad().size() - 1));
  number(static_cast<double>(web.gamma_rad().size()));
  number(rounded_degrees(web.gamma_rad().front()));
  number(rounded_degrees(web.gamma_rad().back()));
  for (double calc::InterpolationDifference::*share :
       {&calc::InterpolationDifference::largest_share,
        &calc::InterpolationDifference::flux_share}) {
    text(facts.interpolation ? report::format_shortest(*facts.interpolation.*share) : "");
  }
  text(opening_shape_name(web.opening().shape));
  number(web.opening().along_c0_m);
  number(web.opening().along_c90_m);
  number(web.opening().height_m);
  text(source.applied_factors);
  return cells;
}

}  // namespace

std::string render_photometry_json(const std::vector<PhotometryFile>& files,
                                   const calc::WebComparison* comparison) {
  Json json = {{"format", "luxgate-photometry"}, {"format_version", 1}, {"files", Json::array()}};
  for (const PhotometryFile& file : files) {
    Json item = {{"path", file.path}, {"readable", file.web.has_value()}};
    item["variant"] = if_chosen(file.variant);
    item["emitter"] = if_chosen(file.emitter);
    if (file.together) item["together"] = together_json(*file.together, file.place);
    if (file.web) item["light"] = light_json(*file.web, file.facts);
    item["diagnostics"] = diagnostics_json(file.diagnostics);
    json["files"].push_back(std::move(item));
  }
  if (comparison != nullptr) json["comparison"] = comparison_json(*comparison);
  return report::json_layout(json);
}

std::string render_photometry_csv(const std::vector<PhotometryFile>& files) {
  std::string csv = kCsvHeader;
  for (const PhotometryFile& file : files) {
    csv += report::csv_field(file.path) + (file.web ? ",yes" : ",no");
    csv += file.web ? light_cells(*file.web, file.facts) : std::string(kEmptyCells, ',');
    csv += "," + std::to_string(file.count(calc::Severity::warning)) + "," +
           std::to_string(file.count(calc::Severity::error)) + "," +
           report::csv_field(file.variant) + "," + report::csv_field(file.emitter) + "\r\n";
  }
  return csv;
}

}  // namespace cli
