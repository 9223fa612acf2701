#pragma once
// Everything a report says, in no particular format. Renderers read this and nothing else, so that
// every format tells the same story.

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

// Seconds by phase; absent from formats unless timing was asked for, since they change from run to
// run.
struct PhaseTimes {
  double load_s = 0, prepare_s = 0, direct_s = 0, pool_s = 0, maps_s = 0, connect_s = 0, near_s = 0,
         judge_s = 0;
  double total_s = 0;
};

// On what machines the same command, with the same files, gives the same bits again: any x86-64
// processor; those with the same graphics device and driver; none, since time cut it short.
enum class SameBits { any_processor, same_device, nowhere };

struct Provenance {
  std::string program_version;  // "0.1.0"
  std::string command_line;     // copyable: "luxgate check office.xml --seed 1"
  std::string timestamp;        // "" unless asked for (--timestamp or SOURCE_DATE_EPOCH)
  std::string judged_on;        // day by which waivers lasted; "" = no waiver, nothing stated
  std::uint64_t seed = 0;
  double confidence = 0.95;  // over all looks of a plane
  rules::Goal goal = rules::Goal::verdict;
  double tolerance = 0.02;      // relative half-width aimed at where nothing is decided
  std::uint64_t max_paths = 0;  // per plane and replicate
  int replicates = 0;
  std::string backend;      // "cpu"; see report/check/backend.h
  int numbers_version = 0;  // calc::kNumbersVersion of the program that calculated
  SameBits same_bits = SameBits::any_processor;
  bool is_redacted = false;  // see redact()
  // The owner's policy that it was judged by: its name and the hash of its file; "" = none.
  std::string policy = {}, policy_sha256 = {};
  // Options that chose a part of what the projects require: "--plane 'desk-*'"; "" = all of it.
  std::string selection = {};
  // Options of the method that are not as by default: "--method instant-radiosity --clamp 10".
  std::string method = {};
};

// The flux that people read of a light: as its file states it where its intensities, which give the
// flux that is calculated with, agree to one percent. stated_lm: 0 = not stated.
inline double told_flux_lm(double calculated_lm, double stated_lm) {
  constexpr double kSame = 0.01;
  const double apart_lm =
      stated_lm > calculated_lm ? stated_lm - calculated_lm : calculated_lm - stated_lm;
  return stated_lm > 0.0 && apart_lm <= kSame * stated_lm ? stated_lm : calculated_lm;
}

struct LuminaireRow {
  std::string type_id, photometry_file, name, format;
  // As the photometry file has them, in its own words; "" = not stated.
  std::string maker = {}, article_number = {}, lamp = {}, colour_temperature = {},
              colour_rendering = {};
  // Article of the lamp package that the project takes, which is then the one to buy; "" = none.
  std::string package = {};
  int count = 0;
  double flux_lm = 0;  // one luminaire, after any override
  double power_w = 0;  // 0 = not stated
  // As the photometry file has them, without what the project overrides: 0 = not stated, not known.
  double file_flux_lm = 0, file_power_w = 0;
  double stated_flux_lm = 0;  // in words of the file, see told_flux_lm(); 0 = not stated
  double max_intensity_cd = 0;
  double maintenance_factor = 1;
  calc::MaintenanceFactor maintenance;
  // Of the housing that shades: "" = none, light passes through the luminaire. Depth 0: its face.
  std::string housing_material = {};
  double housing_depth_m = 0;
  std::string sha256;  // of the photometry file
  // Intensities in C0-C180 and C90-C270, every kPolarStep_deg of gamma from -180 (C180, C270) to
  // 180; empty: not known.
  std::vector<double> c0_cd = {}, c90_cd = {};

  // Of one luminaire and of its file, as people read them.
  double told_lm() const {
    const bool is_of_file = package.empty() && flux_lm == file_flux_lm;
    return is_of_file ? told_file_lm() : flux_lm;
  }
  double told_file_lm() const { return told_flux_lm(file_flux_lm, stated_flux_lm); }
  // Of another lamp or flux than the photometry file's: what that says of colour is of another
  // light.
  bool is_of_other_light() const {
    return !package.empty() || (file_flux_lm > 0.0 && calc::is_other_flux(flux_lm, file_flux_lm));
  }
  // What to order: the package, or the article that the photometry file is of. "" = not stated.
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
  // In the plane's unit: every luminaire at full output, times maintenance factors; glare ratings
  // are of the new installation.
  calc::Estimate measured;
  double direct_lx = 0;  // maintained, mean over replicates
  double indirect_lx = 0;
};

// What one dimming group gives to a plane, alone and at full output, reflections included.
struct GroupShare {
  std::string group;          // "" = luminaires without a group
  calc::Estimate average_lx;  // maintained
  double direct_lx = 0;       // of it, on average over the points
  // [point] as PlanePart::points, maintained, to kShareDigits digits: what other levels would give
  // follows from it. Empty: this group is the only one, or kMostShareValues are not enough.
  std::vector<double> point_lx = {};
};
inline constexpr int kShareDigits = 6;
inline constexpr std::size_t kMostShareValues = 20'000;  // of all groups of a plane

// What one luminaire gives to a plane, alone and at full output, reflections included; maintained.
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

// The light that all requirements of a plane ask for, where that is not all luminaires at full
// output with reflected light, maintained: what drawings of emergency lighting are to show.
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
  // The values above and those of the plane have been exchanged, see ShownPlane.
  bool is_shown = false;

  bool is_asked_by(const rules::Requirement& requirement) const {
    return requirement.scene == scene && requirement.state == state &&
           requirement.direct_only == direct_only;
  }
};

// A plane as it was after one look at its growing results.
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
  // What all values below are that do not name a unit; calc::unit_of(derived) is theirs.
  calc::ReceiverKernel kernel = calc::ReceiverKernel::planar;
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;
  std::vector<calc::Message> remarks;  // how the quantity was come by, where that is to be told
  bool is_computed = false;            // false: `reason` says why; the rest is then empty
  calc::Message reason;
  calc::Message made_by, changed;  // see calc::CalcPlane
  calc::SensorGrid grid;           // rule, counts, spacing, margin, dropped points
  std::vector<PointRow> points;
  // Maintained; of ratings and ratios only minimum and maximum exist.
  calc::Estimate average, minimum, maximum, uniformity_min_avg, uniformity_min_max;
  std::vector<rules::Finding> findings;
  std::optional<AskedLight> asked_light;  // of illuminances; with points and statistics alone
  std::vector<GroupShare> groups;         // of illuminances: their averages add up to `average`
  LuminaireShares by_luminaire;           // likewise
  std::vector<PlaneLook> looks;           // empty: nothing was sampled, or not known
  calc::StopReason stop = calc::StopReason::exact;
  int looks_planned = 1;                 // intervals hold over that many looks together
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

// Of the shell of a room: floor, ceiling and walls.
struct SurfaceFinish {
  std::string surface;    // "floor", "wall1"
  std::string materials;  // ids, as of a body
};

// Which colours stand for low and for high values.
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
  // Where surfaces of a room from a file bend or end, two ends each; the longest, if too many.
  std::vector<glm::dvec3> surface_lines_m;
  std::size_t surface_lines_left_out = 0;
  calc::FluxBalance balance;
  // Of everything here that light depends on but maintenance and dimming, see scene_digest(); "" in
  // results of earlier versions. Equal ones: the same light.
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

// Of luminaires of that group, "" = of none.
double level_of(const SceneRow& scene, const std::string& group);

struct ProjectPart {
  std::string path, name;
  calc::AboutProject about;
  std::optional<double> north_deg;  // as of calc::Project
  calc::MaintenancePlan maintenance_plan;
  bool is_judged = false;  // false: it could not be read or calculated; see diagnostics
  std::vector<calc::Diagnostic> diagnostics;  // warnings and errors, in order
  // Ids of those warnings that count like errors, because somebody asked for it (--strict).
  std::vector<calc::DiagnosticId> strict_warnings;
  std::vector<LuminaireRow> luminaires;
  std::vector<MaterialRow> materials;
  std::vector<SceneRow> scenes;
  std::vector<SpacePart> spaces;
  std::vector<rules::AggregateFinding> aggregates;  // and classes, of rule packs
  // Of scenes in which something is not met, see check --advice; nothing: nobody has asked.
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

// Of what does not exist: not a number, which renderers show as a dash.
calc::Estimate no_estimate();
// As every document has them: of a value that is not finite no_estimate(), but of what
// is_nothing(), and ends that are not finite (files cannot hold them, nor tell why) as open ones,
// -infinity and +infinity.
calc::Estimate settled(const calc::Estimate& estimate);
// All of a plane's.
void settle_estimates(PlanePart& plane);

// It has a waiver or a stated deviation, so that its verdicts hang on the day.
bool hangs_on_the_day(const Document& document);

// Over all findings; a project that could not be judged at all counts as one not_judged.
VerdictCounts count_verdicts(const Document& document);
VerdictCounts count_verdicts(const ProjectPart& project);
VerdictCounts count_verdicts(const SpacePart& space);  // of its planes, without aggregates

bool is_warning(const calc::Diagnostic& diagnostic);
// It is a warning that counts like an error.
bool is_strict_warning(const ProjectPart& project, const calc::Diagnostic& diagnostic);
WarningCounts count_warnings(const Document& document);
WarningCounts count_warnings(const ProjectPart& project);

// Options chose a part of what projects require, and this one has nothing of it; what could not be
// judged may have it.
bool is_nothing_chosen(const ProjectPart& project);

// The gravest of everything in it. not_judged: also a project that could not be judged at all, and
// a plane without result, even one of which nothing is required, and projects of which none has
// what options chose.
rules::Outcome outcome_of(const Document& document);
rules::Outcome outcome_of(const ProjectPart& project);

// What a document says of all its projects together, summed up one by one: the projects themselves
// need not be kept for it.
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
  // Options chose nothing in any of the projects.
  bool is_selection_empty() const { return projects > 0 && projects_unchosen == projects; }
};
Totals totals_of(const Document& document);

// A document whose projects are rendered one by one, and forgotten.
struct DocumentFrame {             // what is known before the first of them
  Provenance provenance;           // judged_on and same_bits come at the end
  std::vector<std::string> paths;  // of all projects, in order
  // What a revision says of a finding is known only when all projects are: with a baseline the
  // whole document is kept, and stands here. Null without one.
  const Document* revised = nullptr;
};
struct DocumentEnd {  // what is known after the last one
  Provenance provenance;
  Totals totals;
  std::string own_revision = {};  // with which a gate of regressions compared HEAD itself; else ""
};
// Of one that is there as a whole, which the frame refers to.
DocumentFrame frame_of(const Document& document);
DocumentEnd end_of(const Document& document);
// Errors of no single project, which every format says beside those of projects.
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
