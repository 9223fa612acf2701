#include "calc/base/units.h"
#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/read/photometry_file.h"
#include "report/tools/photometry/photometry.h"

#include <algorithm>
#include <cmath>

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

PhotometryFile read_photometry_file(const std::string& path, const calc::FileReader& files,
                                    calc::PhotometryOptions choice) {
  PhotometryFile file;
  file.path = path;
  calc::Diagnostics diagnostics;
  const calc::FileContent content = files.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
  } else {
    choice.read_companion = [&](const std::string& name) -> std::optional<std::string> {
      const std::size_t slash = path.rfind('/');
      const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
      calc::FileContent companion = files.read(folder + name);
      if (!companion.ok()) {
        diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, folder + name,
                           companion.error);
        return std::nullopt;
      }
      return std::move(companion.bytes);
    };
    file.web = calc::parse_photometry(content.bytes, path, diagnostics, choice);
    if (file.web) {
      file.facts = photometry_facts(*file.web);
      warn_of_opening(file, content.bytes, diagnostics);
    }
  }
  file.diagnostics = diagnostics.all();
  return file;
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
