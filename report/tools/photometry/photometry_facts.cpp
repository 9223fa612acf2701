#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/units.h"
#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/read/photometry_file.h"
#include "report/tools/photometry/photometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli {
namespace {

constexpr double kLongAspect = 1.5;
constexpr double kBeamShare = 0.5, kFieldShare = 0.1;

void warn_of_opening(const PhotometryFile& file, const std::string& bytes,
                     calc::Diagnostics& diagnostics) {
  const calc::LuminousOpening& opening = file.web->opening();
  if (longer_side(opening) != LongerSide::c90_c270 || file.web->source().format == "EULUMDAT" ||
      !calc::read_lm63_header(bytes)) {
    return;
  }
  diagnostics.report(calc::DiagnosticId::photometry_across_h0, {file.path, 0, 0},
                     opening.along_c0_m, opening.along_c90_m);
}

}  // namespace

const char* plane_pair_name(PlanePair pair) { return pair == kC0C180 ? "C0-C180" : "C90-C270"; }

PhotometryFacts photometry_facts(const calc::PhotometricWeb& web) {
  PhotometryFacts facts;
  facts.peak = calc::peak_of(web);
  for (const PlanePair pair : {kC0C180, kC90C270}) {
    const double c_rad = pair == kC0C180 ? 0.0 : 0.5 * calc::kPi;
    facts.beam[pair] = calc::beam_width(web, c_rad, kBeamShare);
    facts.field[pair] = calc::beam_width(web, c_rad, kFieldShare);
  }
  facts.symmetry = calc::symmetry_fit(web);
  facts.downward_share = calc::downward_share(web);
  if (web.c_rad().size() * web.gamma_rad().size() <= kMostCompared) {
    facts.interpolation = calc::interpolation_difference(web);
  }
  return facts;
}

std::size_t PhotometryFile::count(calc::Severity severity) const {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.begin(), diagnostics.end(),
                    [&](const calc::Diagnostic& entry) { return entry.severity() == severity; }));
}

namespace {

// Reads a file once, whatever is chosen of it.
class LightReader {
 public:
  LightReader(const std::string& path, const calc::FileReader& files)
      : path_(path), files_(files), content_(files.read(path)) {}

  PhotometryFile one(const calc::PhotometryOptions& choice) const {
    calc::Diagnostics diagnostics;
    std::optional<calc::PhotometricWeb> web;
    if (is_readable(diagnostics)) {
      web =
          calc::parse_photometry(content_.bytes, path_, diagnostics, complete(choice, diagnostics));
    }
    return measured(std::move(web), choice, diagnostics);
  }

  // One entry for each emitter; an unreadable one if they cannot be taken together.
  std::vector<PhotometryFile> together(const calc::PhotometryOptions& choice) const {
    calc::Diagnostics diagnostics;
    std::optional<calc::LuminaireLight> light;
    if (is_readable(diagnostics)) {
      light = calc::parse_luminaire_light(content_.bytes, path_, diagnostics,
                                          complete(choice, diagnostics));
    }
    if (!light) return {measured(std::nullopt, choice, diagnostics)};
    const TogetherFacts facts{light->emitters.size(), light->flux_lm(), light->power_w()};
    std::vector<PhotometryFile> list;
    for (calc::EmitterLight& emitter : light->emitters) {
      calc::Diagnostics own = diagnostics;
      list.push_back(measured(std::move(emitter.web), choice, own));
      if (facts.emitters == 1) continue;
      list.back().emitter = emitter.id;
      list.back().together = facts;
      list.back().place = emitter.place;
    }
    return list;
  }

  std::vector<calc::PhotometryOptions> choices() const {
    return content_.ok() ? calc::photometry_choices(content_.bytes)
                         : std::vector<calc::PhotometryOptions>{};
  }

 private:
  bool is_readable(calc::Diagnostics& diagnostics) const {
    if (content_.ok()) return true;
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path_, 0, 0}, path_, content_.error);
    return false;
  }

  calc::PhotometryOptions complete(calc::PhotometryOptions choice,
                                   calc::Diagnostics& diagnostics) const {
    choice.read_companion = [&](const std::string& name) -> std::optional<std::string> {
      const std::size_t slash = path_.rfind('/');
      const std::string folder = slash == std::string::npos ? "" : path_.substr(0, slash + 1);
      calc::FileContent companion = files_.read(folder + name);
      if (!companion.ok()) {
        diagnostics.report(calc::DiagnosticId::file_not_readable, {path_, 0, 0}, folder + name,
                           companion.error);
        return std::nullopt;
      }
      return std::move(companion.bytes);
    };
    return choice;
  }

  PhotometryFile measured(std::optional<calc::PhotometricWeb> web,
                          const calc::PhotometryOptions& choice,
                          calc::Diagnostics& diagnostics) const {
    PhotometryFile file;
    file.path = path_;
    file.variant = choice.variant;
    file.emitter = choice.emitter;
    file.web = std::move(web);
    if (file.web) {
      file.facts = photometry_facts(*file.web);
      warn_of_opening(file, calc::decoded_text(content_.bytes).utf8, diagnostics);
    }
    file.diagnostics = diagnostics.all();
    return file;
  }

  const std::string& path_;
  const calc::FileReader& files_;
  calc::FileContent content_;
};

bool asks_for_a_choice(const PhotometryFile& file) {
  return std::any_of(file.diagnostics.begin(), file.diagnostics.end(), [](const auto& entry) {
    return entry.id == calc::DiagnosticId::photometry_choice_needed;
  });
}

bool is_listed(const std::vector<PhotometryFile>& list, const calc::PhotometryOptions& choice) {
  return std::any_of(list.begin(), list.end(), [&](const PhotometryFile& file) {
    return file.variant == choice.variant && file.emitter == choice.emitter;
  });
}

}  // namespace

PhotometryFile read_photometry_file(const std::string& path, const calc::FileReader& files,
                                    calc::PhotometryOptions choice) {
  return LightReader(path, files).one(choice);
}

std::vector<PhotometryFile> read_photometry_lights(const std::string& path,
                                                   const calc::FileReader& files,
                                                   const calc::PhotometryOptions& choice) {
  const LightReader reader(path, files);
  std::vector<PhotometryFile> list = reader.together(choice);
  if (!asks_for_a_choice(list.front())) return list;
  std::vector<calc::PhotometryOptions> choices = reader.choices();
  std::erase_if(choices, [&](const calc::PhotometryOptions& each) {
    const std::string id = each.emitter.substr(0, each.emitter.rfind('#'));
    return (!choice.variant.empty() && each.variant != choice.variant) ||
           (!choice.emitter.empty() && id != choice.emitter);
  });
  if (choices.empty()) return list;
  list.clear();
  // Those of a variant that go together first: they say all that they say alone, and their places.
  std::stable_sort(choices.begin(), choices.end(), [](const auto& a, const auto& b) {
    return a.variant == b.variant && a.emitter == calc::kAllEmitters &&
           b.emitter != calc::kAllEmitters;
  });
  for (const calc::PhotometryOptions& each : choices) {
    if (is_listed(list, each)) continue;
    const bool is_several = each.emitter == calc::kAllEmitters;
    std::vector<PhotometryFile> found =
        is_several ? reader.together(each) : std::vector{reader.one(each)};
    // Alternatives of one emitter need to be named.
    if (is_several && asks_for_a_choice(found.front())) continue;
    for (PhotometryFile& file : found) list.push_back(std::move(file));
  }
  return list;
}

LateralAngles lateral_angles(const calc::PhotometricWeb& web) {
  const std::vector<double>& c = web.c_rad();
  const auto degrees = [](double rad) {
    return std::round(calc::degrees_from_radians(rad) * 1.0e9) / 1.0e9;
  };
  LateralAngles angles{0.0, 0.0, degrees(web.gamma_rad().front()) - 90.0,
                       degrees(web.gamma_rad().back()) - 90.0};
  const auto is_dark = [&](std::size_t plane) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) {
      if (web.table_cd(plane, g) > 0.0) return false;
    }
    return true;
  };
  for (std::size_t p = 0; p + 1 < c.size(); ++p) {
    // The reader ends a table in the light by a dark plane right behind its last one.
    constexpr double kEdge_rad = 1.0e-6;
    const bool is_edge =
        is_dark(p) && ((p > 0 && c[p] - c[p - 1] < kEdge_rad) || c[p + 1] - c[p] < kEdge_rad);
    if (is_edge) continue;
    const double v = degrees(c[p] > calc::kPi ? c[p] - 2.0 * calc::kPi : c[p]);
    angles.v_first_deg = std::min(angles.v_first_deg, v);
    angles.v_last_deg = std::max(angles.v_last_deg, v);
  }
  return angles;
}

LongerSide longer_side(const calc::LuminousOpening& opening) {
  const double c0 = opening.along_c0_m;
  const double c90 = opening.along_c90_m;
  if (c0 > 0.0 && c0 >= kLongAspect * c90) return LongerSide::c0_c180;
  if (c90 > 0.0 && c90 >= kLongAspect * c0) return LongerSide::c90_c270;
  return LongerSide::none;
}

const char* longer_side_name(LongerSide side) {
  switch (side) {
    case LongerSide::c0_c180:
      return "C0-C180";
    case LongerSide::c90_c270:
      return "C90-C270";
    case LongerSide::none:
      break;
  }
  return "none";
}

const char* opening_shape_name(calc::OpeningShape shape) {
  switch (shape) {
    case calc::OpeningShape::rectangle:
      return "rectangle";
    case calc::OpeningShape::disk:
      return "disk";
    case calc::OpeningShape::box:
      return "box";
    case calc::OpeningShape::cylinder:
      return "cylinder";
    case calc::OpeningShape::cylinder_c0:
      return "cylinder along C0";
    case calc::OpeningShape::cylinder_c90:
      return "cylinder along C90";
    case calc::OpeningShape::ellipsoid:
      return "ellipsoid";
    case calc::OpeningShape::point:
      break;
  }
  return "point";
}

const char* symmetry_name(calc::PlaneSymmetry symmetry) {
  switch (symmetry) {
    case calc::PlaneSymmetry::axial:
      return "axial";
    case calc::PlaneSymmetry::c0_c180:
      return "C0-C180";
    case calc::PlaneSymmetry::c90_c270:
      return "C90-C270";
    case calc::PlaneSymmetry::quadrant:
      return "quadrant";
    case calc::PlaneSymmetry::none:
      break;
  }
  return "none";
}

const char* opening_relation_name(calc::OpeningRelation relation) {
  switch (relation) {
    case calc::OpeningRelation::agree:
      return "agree";
    case calc::OpeningRelation::exchanged:
      return "exchanged";
    case calc::OpeningRelation::indifferent:
      return "indifferent";
    case calc::OpeningRelation::differ:
      return "differ";
    case calc::OpeningRelation::not_stated:
      break;
  }
  return "not-stated";
}

}  // namespace cli
