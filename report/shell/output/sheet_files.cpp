#include "report/shell/output/sheet_files.h"

#include "calc/base/diagnostics.h"
#include "calc/base/file_hash.h"
#include "calc/base/file_reader.h"
#include "calc/base/units.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_hermite.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;

// Of the highest value of a curve: digits that a result file leaves out.
constexpr double kSameCurve = 1e-4;
constexpr double kSameFlux = 1e-4;

double sum_cd(const calc::LuminaireLight& light, double c_rad, double gamma_rad) {
  if (light.emitters.size() == 1) return light.emitters[0].web.intensity_cd(c_rad, gamma_rad);
  const std::array<double, 3> towards = calc::direction_of({c_rad, gamma_rad});
  double cd = 0.0;
  for (const calc::EmitterLight& emitter : light.emitters) {
    const glm::dvec3 own =
        glm::transpose(emitter.place.turn) * glm::dvec3(towards[0], towards[1], towards[2]);
    cd += emitter.web.intensity_cd({own.x, own.y, own.z});
  }
  return cd;
}

bool is_curve(const calc::LuminaireLight& light, double c_rad, double scale,
              const std::vector<double>& curve_cd) {
  if (curve_cd.size() != 2 * report::kPolarHalfSteps + 1) return false;
  const double highest = *std::max_element(curve_cd.begin(), curve_cd.end());
  for (int step = -report::kPolarHalfSteps; step <= report::kPolarHalfSteps; ++step) {
    const double gamma = calc::radians_from_degrees(std::abs(step) * report::kPolarStep_deg);
    const double cd = scale * sum_cd(light, step < 0 ? c_rad + calc::kPi : c_rad, gamma);
    const double expected = curve_cd[static_cast<std::size_t>(step + report::kPolarHalfSteps)];
    if (!(std::abs(cd - expected) <= kSameCurve * highest)) return false;
  }
  return true;
}

bool is_light_of(const report::LuminaireRow& row, const calc::LuminaireLight& light) {
  const calc::PhotometrySource& source = light.emitters[0].web.source();
  std::string name = source.luminaire_name;
  if (light.emitters.size() > 1) name += fmt::format(" ({} emitters)", light.emitters.size());
  if (name != row.name || source.manufacturer != row.maker ||
      source.article_number != row.article_number || source.lamp != row.lamp ||
      source.colour_temperature != row.colour_temperature ||
      source.colour_rendering != row.colour_rendering) {
    return false;
  }
  const double flux_lm = light.flux_lm();
  const bool is_flux_known = row.file_flux_lm > 0.0;
  if (is_flux_known && std::abs(flux_lm - row.file_flux_lm) > kSameFlux * flux_lm) return false;
  // Results of early versions have no curves.
  if (row.c0_cd.empty() && row.c90_cd.empty()) return is_flux_known;
  const double scale = row.flux_lm / flux_lm;
  return is_curve(light, 0.0, scale, row.c0_cd) &&
         is_curve(light, 0.5 * calc::kPi, scale, row.c90_cd);
}

// Every light that a project can take from such a file, in the file's order.
std::vector<calc::PhotometryOptions> choices_of(const std::string& bytes) {
  constexpr int kMostLampSets = 20;
  std::vector<calc::PhotometryOptions> choices{{}};
  for (calc::PhotometryOptions& choice : calc::photometry_choices(bytes))
    choices.push_back(std::move(choice));
  if (choices.size() > 1) return choices;
  for (int set = 1; set <= kMostLampSets; ++set) {
    calc::PhotometryOptions choice;
    choice.lamp_set = set;
    choices.push_back(std::move(choice));
  }
  return choices;
}

calc::LuminaireLight cubic(calc::LuminaireLight light) {
  for (calc::EmitterLight& emitter : light.emitters)
    emitter.web = calc::hermite_refined(emitter.web);
  return light;
}

// One web for all emitters: sampled, without an opening.
calc::PhotometricWeb sum_of(const calc::LuminaireLight& light) {
  if (light.emitters.size() == 1) return light.emitters[0].web;
  constexpr int kPlanes = 72, kAngles = 72;
  std::vector<double> c_rad, gamma_rad, cd;
  for (int plane = 0; plane <= kPlanes; ++plane) c_rad.push_back(2.0 * calc::kPi * plane / kPlanes);
  for (int angle = 0; angle <= kAngles; ++angle) gamma_rad.push_back(calc::kPi * angle / kAngles);
  for (int plane = 0; plane <= kPlanes; ++plane) {
    for (const double gamma : gamma_rad)
      cd.push_back(sum_cd(light, c_rad[static_cast<std::size_t>(plane % kPlanes)], gamma));
  }
  calc::PhotometrySource source = light.emitters[0].web.source();
  source.rated_lamp_flux_lm = 0.0;
  for (const calc::EmitterLight& emitter : light.emitters) {
    const double rated_lm = emitter.web.source().rated_lamp_flux_lm;
    if (!(rated_lm > 0.0)) {
      source.rated_lamp_flux_lm = 0.0;
      break;
    }
    source.rated_lamp_flux_lm += rated_lm;
  }
  return calc::PhotometricWeb::make(std::move(c_rad), std::move(gamma_rad), std::move(cd), {},
                                    std::move(source));
}

std::optional<report::SheetLight> find_light(const std::string& bytes, const std::string& folder,
                                             const std::string& path,
                                             const report::LuminaireRow& row) {
  const calc::DiskFileReader files;
  for (calc::PhotometryOptions& choice : choices_of(bytes)) {
    choice.read_companion = [&](const std::string& name) -> std::optional<std::string> {
      calc::FileContent content =
          files.read_within(folder, (fs::path(path).parent_path() / name).string());
      if (!content.ok()) return std::nullopt;
      return std::move(content.bytes);
    };
    calc::Diagnostics unsaid;  // what is wrong with a choice: it is not the one
    std::optional<calc::LuminaireLight> light =
        calc::parse_luminaire_light(bytes, path, unsaid, choice);
    if (!light) {
      if (choice.lamp_set > 0) break;  // there are no more
      continue;
    }
    if (!is_light_of(row, *light)) {
      light = cubic(std::move(*light));
      if (!is_light_of(row, *light)) continue;
    }
    const std::string file_name = fs::path(row.photometry_file).filename().string();
    return report::SheetLight{sum_of(*light),         light->flux_lm(), light->power_w(),
                              light->emitters.size(), file_name,        row.sha256};
  }
  return std::nullopt;
}

}  // namespace

void SheetFiles::see(const report::ProjectPart& project, const std::string& result) {
  std::set<std::string> wanted;
  for (const report::LuminaireRow& row : project.luminaires) wanted.insert(row.sha256);
  const fs::path own = fs::path(project.path).parent_path();
  std::vector<fs::path> folders{own};
  if (!result.empty()) {  // it may have been moved with its project
    const fs::path beside = fs::path(result).parent_path();
    folders.push_back(beside / own);
    folders.push_back(beside);
  }
  for (const calc::InputFile& input : project.inputs) {
    if (input.sha256.empty() || !wanted.contains(input.sha256)) continue;
    std::vector<SheetPlace>& places = places_[input.sha256];
    for (const fs::path& folder : folders) {
      SheetPlace place{folder.empty() ? "." : folder.string(),
                       (folder / input.path).lexically_normal().string()};
      if (std::find(places.begin(), places.end(), place) == places.end())
        places.push_back(std::move(place));
    }
  }
}

std::variant<report::SheetLight, report::Text> SheetFiles::light_of(
    const report::LuminaireRow& row) const {
  const auto places = places_.find(row.sha256);
  if (row.sha256.empty() || places == places_.end()) return report::Text::sheet_no_file;
  bool is_other = false;
  for (const auto& [folder, file] : places->second) {
    const calc::FileContent content = calc::DiskFileReader().read_within(folder, file);
    if (!content.ok()) continue;
    if (calc::sha256_hex(content.bytes) != row.sha256) {
      is_other = true;
      continue;
    }
    std::optional<report::SheetLight> light = find_light(content.bytes, folder, file, row);
    if (!light) return report::Text::sheet_other_light;
    return std::move(*light);
  }
  return is_other ? report::Text::sheet_other_file : report::Text::sheet_not_found;
}

}  // namespace cli
