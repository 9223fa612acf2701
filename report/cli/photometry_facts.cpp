#include "calc/photometry/ies_header.h"
#include "calc/photometry/photometry_file.h"
#include "calc/units.h"
#include "report/cli/photometry.h"

#include <algorithm>

namespace cli {
namespace {

constexpr double kLongAspect = 1.5;
constexpr double kBeamShare = 0.5, kFieldShare = 0.1;

void warn_of_opening(const PhotometryFile& file, const std::string& bytes,
                     calc::Diagnostics& diagnostics) {
  const calc::LuminousOpening& opening = file.web->opening();
  const std::optional<calc::Lm63Header> header = calc::read_lm63_header(bytes);
  if (!header || longer_side(opening) != LongerSide::c90_c270) return;
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
  return facts;
}

std::size_t PhotometryFile::count(calc::Severity severity) const {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.begin(), diagnostics.end(),
                    [&](const calc::Diagnostic& entry) { return entry.severity() == severity; }));
}

PhotometryFile read_photometry_file(const std::string& path, const calc::FileReader& files) {
  PhotometryFile file;
  file.path = path;
  calc::Diagnostics diagnostics;
  const calc::FileContent content = files.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
  } else {
    file.web = calc::parse_photometry(content.bytes, path, diagnostics);
    if (file.web) {
      file.facts = photometry_facts(*file.web);
      warn_of_opening(file, content.bytes, diagnostics);
    }
  }
  file.diagnostics = diagnostics.all();
  return file;
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
