#pragma once
// The contents of a report, without a format. Renderers read nothing else, so that every format
// reports the same.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/photometry/web.h"
#include "calc/scene/about_project.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/installed_price.h"
#include "calc/scene/lighting_energy.h"
#include "calc/scene/maintenance_plan.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "report/document/level_advice.h"
#include "report/document/revision.h"
#include "report/document/road_part.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/goal.h"
#include "rules/verdict/coverage.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/outcome.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace report {

// Seconds by phase; formats have them only if timing was requested, because they change from run to
// run.
struct PhaseTimes {
  double load_s = 0, prepare_s = 0, direct_s = 0, pool_s = 0, maps_s = 0, connect_s = 0, near_s = 0,
         judge_s = 0;
  double total_s = 0;
};

// The machines on which the same command with the same files gives the same bits again: any x86-64
// processor; those with the same graphics device and driver; none, because time cut it short.
enum class SameBits { any_processor, same_device, nowhere };

struct Provenance {
  std::string program_version;  // "0.1.0"
  std::string command_line;     // copyable: "luxgate check office.xml --seed 1"
  std::string timestamp;        // "" unless asked for (--timestamp or SOURCE_DATE_EPOCH)
  std::string judged_on;        // day by which waivers lasted; "" = no waiver, nothing stated
  std::uint64_t seed = 0;
  double confidence = 0.95;  // over all sampling rounds of a plane
  rules::Goal goal = rules::Goal::verdict;
  double tolerance = 0.02;      // relative half-width aimed at where nothing is decided
  std::uint64_t max_paths = 0;  // per plane and replicate
  int replicates = 0;
  std::string backend;      // "cpu"; see report/check/backend.h
  int numbers_version = 0;  // calc::kNumbersVersion of the program that calculated
  SameBits same_bits = SameBits::any_processor;
  bool is_redacted = false;  // see redact()
  // The owner's policy of the check: its name and the hash of its file; "" = none.
  std::string policy = {}, policy_sha256 = {};
  // Options that selected a part of the projects' requirements: "--plane 'desk-*'"; "" =
  // everything.
  std::string selection = {};
  // Options of the method that differ from the defaults: "--method instant-radiosity --clamp 10".
  std::string method = {};
};

// Returns the flux to report: as the photometry file states it, if the flux from its intensities,
// which is calculated with, agrees to one percent. stated_lm: 0 = not stated.
inline double told_flux_lm(double calculated_lm, double stated_lm) {
  constexpr double kSame = 0.01;
  const double apart_lm =
      stated_lm > calculated_lm ? stated_lm - calculated_lm : calculated_lm - stated_lm;
  return stated_lm > 0.0 && apart_lm <= kSame * stated_lm ? stated_lm : calculated_lm;
}

struct LuminaireRow {
  std::string type_id, photometry_file, name, format;
  // In the photometry file's own words; "" = not stated.
  std::string maker = {}, article_number = {}, lamp = {}, colour_temperature = {},
              colour_rendering = {};
  // Article of the project's lamp package, which is then ordered; "" = none.
  std::string package = {};
  int count = 0;
  double flux_lm = 0;  // one luminaire, after any override
  double power_w = 0;  // 0 = not stated
  // As in the photometry file, without the project's overrides: 0 = not stated, not known.
  double file_flux_lm = 0, file_power_w = 0;
  double stated_flux_lm = 0;  // in words of the file, see told_flux_lm(); 0 = not stated
  double max_intensity_cd = 0;
  double maintenance_factor = 1;
  calc::MaintenanceFactor maintenance;
  // Material of the housing that shades: "" = none, light passes through the luminaire. Depth 0:
  // its face.
  std::string housing_material = {};
  double housing_depth_m = 0;
  std::string sha256;  // of the photometry file
  // Intensities in C0-C180 and C90-C270, every kPolarStep_deg of gamma from -180 (C180, C270) to
  // 180; empty: not known.
  std::vector<double> c0_cd = {}, c90_cd = {};

  // Return the reported flux of one luminaire and of its file.
  double told_lm() const {
    const bool is_of_file = package.empty() && flux_lm == file_flux_lm;
    return is_of_file ? told_file_lm() : flux_lm;
  }
  double told_file_lm() const { return told_flux_lm(file_flux_lm, stated_flux_lm); }
  // Returns whether lamp or flux differ from the photometry file's: its colour data are then of
  // another light.
  bool is_of_other_light() const {
    return !package.empty() || (file_flux_lm > 0.0 && calc::is_other_flux(flux_lm, file_flux_lm));
  }
  // Returns the article to order: the package, or the article of the photometry file. "" = not
  // stated.
  const std::string& article() const { return package.empty() ? article_number : package; }
};
inline constexpr double kPolarStep_deg = 2.5;
inline constexpr int kPolarHalfSteps = 72;

struct MaterialRow {
  std::string id;
  double reflectance = 0;  // diffuse, [0, 1]
};

struct PointRow {
  glm::dvec3 position_m, normal;  // normal: axis of the plane's kernel
  int column = 0, row = 0;
  // In the plane's unit, with every luminaire at full output, times maintenance factors; glare
  // ratings are of the new installation.
  calc::Estimate measured;
  double direct_lx = 0;  // maintained, mean over replicates
  double indirect_lx = 0;
};

// The light of one dimming group on a plane, alone and at full output, reflections included.
struct GroupShare {
  std::string group;          // "" = luminaires without a group
  calc::Estimate average_lx;  // maintained
  double direct_lx = 0;       // of it, on average over the points
  // [point] as PlanePart::points, maintained, to kShareDigits digits, for calculating the light at
  // other levels. Empty: this group is the only one, or kMostShareValues are not enough.
  std::vector<double> point_lx = {};
};
inline constexpr int kShareDigits = 6;
inline constexpr std::size_t kMostShareValues = 20'000;  // of all groups of a plane

// The light of one luminaire on a plane, alone and at full output, reflections included;
// maintained.
struct LuminaireShare {
  std::string id;              // "" = the project gives none
  std::string type_id, group;  // group "" = none
  glm::dvec3 position_m{0.0};
  calc::Estimate average_lx;
  double direct_lx = 0;          // of it, on average over the points
  calc::Estimate minimum_lx;     // at LuminaireShares::minimum_at_m
  double minimum_direct_lx = 0;  // of it
};
inline constexpr std::size_t kMostLuminaireShares = 10;
struct LuminaireShares {
  std::vector<LuminaireShare> largest;  // by average; empty: not asked for
  std::size_t others = 0;               // 0: there are no more; never 1
  LuminaireShare rest;                  // all others together: light only
  glm::dvec3 minimum_at_m{0.0};         // the point with the least light of all luminaires
};

// The light for which all requirements of a plane ask, if it is not all luminaires at full output
// with reflected light, maintained: drawings of emergency lighting show it.
struct AskedPoint {
  calc::Estimate measured;
  double direct_lx = 0, indirect_lx = 0;
};
struct AskedLight {
  std::string scene;  // "" = full output
  rules::LightState state = rules::LightState::maintained;
  bool direct_only = false;
  std::vector<AskedPoint> points;  // as PlanePart::points
  calc::Estimate average, minimum, maximum, uniformity_min_avg, uniformity_min_max;
  // The values above and those of the plane are exchanged, see ShownPlane.
  bool is_shown = false;

  bool is_asked_by(const rules::Requirement& requirement) const {
    return requirement.scene == scene && requirement.state == state &&
           requirement.direct_only == direct_only;
  }
};

// A finding of a plane after one sampling round of its growing results.
struct LookFinding {
  rules::Verdict verdict = rules::Verdict::not_judged;
  calc::Estimate measured;  // meaningless when not judged
};
struct PlaneLook {
  std::uint64_t paths = 0;  // so far, all replicates
  std::uint64_t rays = 0;   // so far, towards luminaires, light vertices and near surfaces
  std::size_t points = 0;   // that took part
  calc::Estimate average;   // as PlanePart::average
  std::vector<LookFinding> findings;  // as PlanePart::findings
};

struct PlanePart {
  std::string id, was, name, space_id;  // was: as of a room
  calc::SourceLocation where;
  // The quantity of all values below that do not name a unit; calc::unit_of(derived) is their unit.
  calc::ReceiverKernel kernel = calc::ReceiverKernel::planar;
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;
  std::vector<calc::Message> remarks;  // how the quantity was come by, where that is to be told
  bool is_computed = false;            // false: `reason` says why; the rest is then empty
  calc::Message reason;
  calc::Message made_by, changed;  // see calc::CalcPlane
  calc::SensorGrid grid;           // rule, counts, spacing, margin, dropped points
  std::vector<PointRow> points;
  // Maintained; ratings and ratios have only minimum and maximum.
  calc::Estimate average, minimum, maximum, uniformity_min_avg, uniformity_min_max;
  std::vector<rules::Finding> findings;
  std::optional<AskedLight> asked_light;  // of illuminances; with points and statistics alone
  std::vector<GroupShare> groups;         // of illuminances: their averages add up to `average`
  LuminaireShares by_luminaire;           // likewise
  std::vector<PlaneLook> looks;           // empty: nothing was sampled, or not known
  calc::StopReason stop = calc::StopReason::exact;
  int looks_planned = 1;                 // intervals hold over that many rounds together
  std::size_t unseen_points = 0;         // sampled light may reach them, but no sample has
  std::size_t single_sample_points = 0;  // a single sample is too large a share of the value
  calc::SolveCounters counters;
  std::vector<glm::dvec2>
      outline_m;  // of the plane, in its (u, v) from grid.origin_m; empty for point lists
  std::vector<std::vector<glm::dvec2>> holes_m;
};

// A luminaire in plans and tables.
struct LuminaireMark {
  glm::dvec3 position_m;
  std::string type_id;
  std::string id = {};                     // "" = the project gives none
  std::string group = {};                  // dimming group; "" = none
  std::vector<glm::dvec2> outline_m = {};  // of the opening from above, world; empty: a point
  // World directions of C0 and of gamma = 0, unit; 0: not known.
  glm::dvec3 c0{0.0}, axis{0.0};
  std::string label = {};  // "A1": follows from the rest of the project, see label_luminaires()
};

struct BodyMark {  // furniture, for plans
  std::string id;
  double low_z_m = 0, high_z_m = 0;
  std::vector<std::array<glm::dvec2, 2>> lines_m;  // from above, world
  std::string materials = {};                      // ids, in the order of their first triangles
};

// The finish of a room's shell: floor, ceiling and walls.
struct SurfaceFinish {
  std::string surface;    // "floor", "wall1"
  std::string materials;  // ids, as of a body
};

// The colours for low and for high values.
enum class ColourMap {
  cividis,       // dark blue to yellow: for all common forms of colour vision, and for grey print
  false_colour,  // blue, cyan, green, yellow, red, magenta, as lighting programs have it
};

// A picture of a room, as files.
struct RoomPicture {
  std::string name;   // "corner", "plan", "rendered": for file names
  std::string title;  // "seen from above a corner"
  int width = 0, height = 0;
  std::string png;           // without legend, transparent around the room
  std::string labelled_png;  // with legend; "" = not asked for
  std::string exr;           // in lx; "" = not asked for, or a rendered view
  bool is_rendered = false;  // tone-mapped luminance; false: illuminance in false colours
};

struct RoomPictures {
  std::vector<RoomPicture> list;   // empty: not asked for, or there is a problem
  std::string problem;             // why there are none; "" = no problem
  double low_lx = 0, step_lx = 1;  // a ColourScale
  int bands = 1;
  ColourMap map = ColourMap::cividis;
  double highest_lx = 0;   // seen; above the scale it is painted as the last band
  double error_share = 0;  // relative standard error of sampling on surfaces, root mean square
  std::string device;      // that drew them
};

struct SpacePart {
  std::string id, was, name;  // was: its id in earlier revisions; "" = the same
  calc::InstalledPower power;
  std::optional<calc::LightingEnergy> energy;  // of a year, where the project states its use
  calc::InstalledPrice price;           // for sweeps: nothing is judged by it, and no result has it
  std::vector<glm::dvec2> footprint_m;  // empty for the open space
  double floor_z_m = 0, height_m = 0;
  std::size_t triangles = 0;
  std::size_t degenerate_triangles = 0;  // left out
  std::vector<LuminaireMark> luminaires;
  std::vector<SurfaceFinish> finishes;
  std::vector<BodyMark> bodies;
  std::size_t bodies_left_out = 0;  // too many to draw
  // Edges and bends of surfaces of a room from a file, two ends each; only the longest, if too
  // many.
  std::vector<glm::dvec3> surface_lines_m;
  std::size_t surface_lines_left_out = 0;
  calc::FluxBalance balance;
  // Hash of everything here that light depends on except maintenance and dimming, see
  // scene_digest(); "" in results of earlier versions. Equal hashes: the same light.
  std::string scene_sha256;
  std::vector<PlanePart> planes;
  std::vector<calc::Message> notes;          // zones of workplaces that were not made, and why
  std::vector<rules::RowCoverage> coverage;  // what is asked of which rows
  std::optional<RoadPart> road;              // of a street, else nothing
  RoomPictures pictures;
};

struct SceneRow {  // luminaires that are dimmed
  std::string id;
  std::vector<std::pair<std::string, double>> level_of_group;  // [0, 1]; others are at 1
};

// Returns the level of luminaires of that group, "" = of no group.
double level_of(const SceneRow& scene, const std::string& group);

struct ProjectPart {
  std::string path, name;
  calc::AboutProject about;
  std::optional<double> north_deg;  // as of calc::Project
  calc::MaintenancePlan maintenance_plan;
  bool is_judged = false;  // false: it could not be read or calculated; see diagnostics
  std::vector<calc::Diagnostic> diagnostics;  // warnings and errors, in order
  // Ids of those warnings that count like errors, as --strict requires.
  std::vector<calc::DiagnosticId> strict_warnings;
  std::vector<LuminaireRow> luminaires;
  std::vector<MaterialRow> materials;
  std::vector<SceneRow> scenes;
  std::vector<SpacePart> spaces;
  std::vector<rules::AggregateFinding> aggregates;  // and classes, of rule packs
  // Advice for scenes with unmet requirements, see check --advice; empty: not requested.
  std::optional<std::vector<LevelAdvice>> advice;
  std::vector<calc::InputFile> inputs;
  PhaseTimes times;
};

struct VerdictCounts {
  int pass = 0, fail = 0, undecided = 0, not_judged = 0;
  int waived = 0;     // fail or undecided, but do not count
  int deviating = 0;  // of all these: judged with a stated deviation from the standard

  int of(rules::Verdict verdict) const;
  int all() const { return pass + fail + undecided + not_judged + waived; }
};

struct WarningCounts {
  int all = 0;
  int strict = 0;  // of them, see ProjectPart::strict_warnings
};

struct Document {
  Provenance provenance;
  std::vector<ProjectPart> projects;
  std::optional<Revision> revision;  // against a baseline, where one was given
};

// Returns the estimate of something that does not exist: NaN, which renderers show as a dash.
calc::Estimate no_estimate();
// Returns the estimate for documents: no_estimate() for a value that is not finite, except for
// is_nothing(); ends that are not finite become open ends, -infinity and +infinity, because files
// can neither hold nor explain them.
calc::Estimate settled(const calc::Estimate& estimate);
// Settles all estimates of a plane.
void settle_estimates(PlanePart& plane);

// Returns whether there is a waiver or a stated deviation, so that verdicts depend on the day.
bool hangs_on_the_day(const Document& document);

// Counts verdicts over all findings; a project that could not be judged at all counts as one
// not_judged.
VerdictCounts count_verdicts(const Document& document);
VerdictCounts count_verdicts(const ProjectPart& project);
VerdictCounts count_verdicts(const SpacePart& space);  // of its planes, without aggregates

bool is_warning(const calc::Diagnostic& diagnostic);
// Returns whether it is a warning that counts like an error.
bool is_strict_warning(const ProjectPart& project, const calc::Diagnostic& diagnostic);
WarningCounts count_warnings(const Document& document);
WarningCounts count_warnings(const ProjectPart& project);

// Returns whether options selected a part of the requirements and this project has none of it; a
// project that could not be judged may have it.
bool is_nothing_chosen(const ProjectPart& project);

// Returns the gravest outcome in it. not_judged: also for a project that could not be judged at
// all, for any plane without result, and if no project has what options selected.
rules::Outcome outcome_of(const Document& document);
rules::Outcome outcome_of(const ProjectPart& project);

// The sums over all projects of a document, added one by one: the projects themselves need not be
// kept.
struct Totals {
  int projects = 0;
  int projects_not_judged = 0;
  int projects_unchosen = 0;  // see is_nothing_chosen()
  VerdictCounts verdicts;
  WarningCounts warnings;
  int rows_in_part = 0;  // of rule packs: of which something was never asked or cannot be judged
  rules::Outcome gravest = rules::Outcome::nothing_asked;  // of the projects, each for itself
  rules::Outcome outcome = rules::Outcome::nothing_asked;  // of all together
  bool hangs_on_the_day = false;                           // see above
  bool is_cut_short = false;  // by time or an interruption, so that it hangs on the machine
  // Clauses whose numbers rest on one public source, each once: see one_source.h.
  std::vector<calc::Message> one_source_rows = {};

  void add(const ProjectPart& project);
  // Returns whether options selected nothing in any of the projects.
  bool is_selection_empty() const { return projects > 0 && projects_unchosen == projects; }
};
Totals totals_of(const Document& document);

// The frame of a document whose projects are rendered one by one and then dropped.
struct DocumentFrame {             // what is known before the first of them
  Provenance provenance;           // judged_on and same_bits come at the end
  std::vector<std::string> paths;  // of all projects, in order
  // The revision of a finding is known only when all projects are: with a baseline the whole
  // document is kept here. Null without a baseline.
  const Document* revised = nullptr;
};
struct DocumentEnd {  // what is known after the last one
  Provenance provenance;
  Totals totals;
  std::string own_revision = {};  // with which a gate of regressions compared HEAD itself; else ""
};
// Return the frame and the end of a whole document, to which the frame refers.
DocumentFrame frame_of(const Document& document);
DocumentEnd end_of(const Document& document);
// Returns errors of no single project, which every format shows beside those of projects.
std::vector<calc::Diagnostic> document_errors(const DocumentEnd& end);

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::SameBits> {
  static constexpr EnumName<report::SameBits> list[] = {
      {report::SameBits::any_processor, "any-processor"},
      {report::SameBits::same_device, "same-device"},
      {report::SameBits::nowhere, "nowhere"}};
};

}  // namespace calc
