#pragma once
// `luxgate photometry`: reads, checks, converts, draws and compares photometry files. photometry.md
// explains the measures and the keys of JSON and CSV.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"
#include "calc/photometry/web_compare.h"
#include "calc/photometry/web_hermite.h"
#include "calc/photometry/web_measures.h"
#include "report/formats/pdf.h"
#include "report/shell/command/command.h"
#include "report/tools/photometry/photometry_options.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// The reported plane pairs, by the C of their positive side.
enum PlanePair : std::size_t { kC0C180, kC90C270, kPlanePairs };
const char* plane_pair_name(PlanePair pair);  // "C0-C180"

// The facts shown for a web.
struct PhotometryFacts {
  calc::Peak peak;
  std::array<calc::BeamWidth, kPlanePairs> beam;   // 50 % of the highest value of the plane pair
  std::array<calc::BeamWidth, kPlanePairs> field;  // 10 %
  calc::SymmetryFit symmetry;
  double downward_share = 0.0;
  // Difference of cubic and bilinear; empty for tables of more than kMostCompared values.
  std::optional<calc::InterpolationDifference> interpolation;
};
inline constexpr std::size_t kMostCompared = 500'000;
PhotometryFacts photometry_facts(const calc::PhotometricWeb& web);

// Emitters of one luminaire that are lit together.
struct TogetherFacts {
  std::size_t emitters = 0;
  double flux_lm = 0.0, power_w = 0.0;  // of all; power 0 = not known
};

// A light of a file: the only light, or one of several.
struct PhotometryFile {
  std::string path;
  std::string variant, emitter;             // as it is chosen; "" = it need not be
  std::optional<TogetherFacts> together;    // of the emitters that it can be taken with
  std::optional<calc::EmitterPlace> place;  // among them
  std::optional<calc::PhotometricWeb> web;  // empty: not readable, `diagnostics` holds errors
  PhotometryFacts facts;                    // of the web
  std::vector<calc::Diagnostic> diagnostics;

  std::size_t count(calc::Severity severity) const;
};
// Reads a file, measures it, and warns of an LM-63 opening that lies across H 0. choice: the light
// of a file with several; its read_companion is set here: files of the same folder.
PhotometryFile read_photometry_file(const std::string& path, const calc::FileReader& files,
                                    calc::PhotometryOptions choice = {});
// Returns every light of the file that `choice` allows, with the places of emitters that can be
// combined. At least one entry; without a choice it is that of read_photometry_file().
std::vector<PhotometryFile> read_photometry_lights(const std::string& path,
                                                   const calc::FileReader& files,
                                                   const calc::PhotometryOptions& choice);

// The angles of a table about the line of C90, as LM-63 type B counts them.
struct LateralAngles {
  double v_first_deg, v_last_deg, h_first_deg, h_last_deg;
};
LateralAngles lateral_angles(const calc::PhotometricWeb& web);

// The direction of the longer side of an opening, if it is at least 1.5 times the other.
enum class LongerSide { none, c0_c180, c90_c270 };
LongerSide longer_side(const calc::LuminousOpening& opening);
const char* longer_side_name(LongerSide side);  // "none", "C0-C180", "C90-C270"
const char* opening_shape_name(calc::OpeningShape shape);
const char* symmetry_name(calc::PlaneSymmetry symmetry);
const char* opening_relation_name(calc::OpeningRelation relation);

// Returns a line of the texts below: a column with the name, then the value.
std::string named_row(const char* name, const std::string& value);
std::string render_photometry_text(const PhotometryFile& file, bool colour);
// Returns the JSON. comparison: of the first two files, or nullptr.
std::string render_photometry_json(const std::vector<PhotometryFile>& files,
                                   const calc::WebComparison* comparison);
std::string render_photometry_csv(const std::vector<PhotometryFile>& files);
// Returns the comparison; both files must be readable.
std::string render_comparison_text(const PhotometryFile& a, const PhotometryFile& b,
                                   const calc::WebComparison& comparison, bool colour);

// Lights with at most this RMS count as the same; up to the second as nearly the same.
inline constexpr double kSameLight = 0.005, kNearlySameLight = 0.03;

// A whole run: reads everything, writes the requested files, prints nothing. Exit code 2 after any
// error, 1 after warnings with --strict. printer: for a data sheet as PDF; null: a data sheet is
// then an error.
struct PhotometryRun {
  std::string out, err;
  ExitCode exit_code = kAllMet;
};
PhotometryRun run_photometry(const PhotometryOptions& options, const calc::FileReader& files,
                             bool colour, report::PagePrinter* printer = nullptr);

Command photometry_command();

}  // namespace cli
