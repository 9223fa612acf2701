#pragma once
// The changes from a baseline to a revised design: plain data. report/revision makes it.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "rules/catalogue/compare.h"
#include "rules/verdict/judge.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace report {

// The change of a requirement's result, gravest first. Worse and better are proved: beyond the
// interval of the difference.
enum class ResultChange : std::uint8_t {
  broken,       // did not fail, and fails
  new_failing,  // was not asked before, and fails
  unsure,       // was decided, and is undecided or not judged; or cannot be compared
  worse,
  gone,   // no longer asked
  fixed,  // failed, and passes
  better,
  added,  // was not asked before, and does not fail
  same
};

// The change of a requirement itself. exchanged: neither is proved to require less.
enum class QuestionChange : std::uint8_t { weaker, exchanged, stricter };

// The part of a requirement that changed.
enum class QuestionPart : std::uint8_t {
  project,  // all of it
  room,
  plane,
  requirement,
  aggregate,
  limit,
  quantity,  // what is measured, or compared how
  severity,  // whether it counts
  light,     // maintained or initial, scene, direct light only
  rule,      // row, check or level of a rule pack
  waiver,
  deviation,  // stated, of a plane from what the standard means
  policy,     // rounding, tolerance, guard
  mask,       // which points count
  area,       // of the plane: place and outline
  grid,       // its points
  margin,
  lost_points,  // left out because something is in the way
  role,         // of a row of a rule pack: no longer asked, or left out
  maintenance_factor,
  flux,   // stated by hand, of the same photometry
  power,  // likewise
  confidence,
  accuracy,  // goal, tolerance, replicates, most paths
  method,
  energy,  // hours and factors of LENI
  stated   // of a road or a field, what its values rest on
};

// A place in the design, by ids; later parts are "" if it is all of the earlier part.
struct RevisionPlace {
  std::string project;  // its path; as it was, of what is gone
  std::string space, plane;
  std::string item;            // requirement, aggregate, role, luminaire type or material
  std::string words;           // of space and plane, for people: "Office / Task area"
  calc::SourceLocation where;  // in the revision, or in the baseline of what is gone
};

struct ChangedResult {
  ResultChange change = ResultChange::same;
  RevisionPlace place;
  bool is_aggregate = false;
  std::optional<rules::Metric> metric;  // of a requirement
  std::string quantity;                 // "average, scene night": English, as all of a data format
  std::string unit;
  std::optional<rules::Verdict> verdict_before, verdict_after;  // none: it was not asked
  bool is_waived_before = false, is_waived_after = false;
  bool counts = true;  // for the exit code: not advice, nor a member of aggregates alone
  // NaN if it was not judged or not required. difference: after - before; an open interval is
  // infinite.
  calc::Estimate before, after, difference;
  // The gain for the requirement: (after - before) / |before|, negative is worse; the interval as
  // for the difference.
  calc::Estimate gain;
  // Compared replicate by replicate: the interval omits the common part of equal random numbers.
  bool is_paired = false;
  // The part of the requirement that explains a worse result that still passes: the requirement is
  // stricter than before. Maintenance factor: the loss is at most that of the lower factor over all
  // luminaires. Grid: it is finer, and nothing else in the room has changed.
  std::optional<QuestionPart> excused_by;
};

struct ChangedQuestion {
  QuestionChange change = QuestionChange::weaker;
  QuestionPart part = QuestionPart::limit;
  RevisionPlace place;
  std::string before, after;  // "" = there was none, or is none
};

// A change of the input that is no change of requirements: luminaires, photometry, materials,
// bodies.
struct ChangedInput {
  RevisionPlace place;
  std::string what;  // "luminaires", "photometry", ...
  std::string before, after;
};

// Values of a plane that differ from before, at the same points.
struct ChangedPlane {
  RevisionPlace place;
  std::vector<double> before_lx;  // [point of the plane]: maintained, as PointRow::measured
};

// Warnings of a project that are equal to earlier ones, word for word.
struct KnownWarnings {
  std::string project;                   // its path
  std::vector<std::size_t> diagnostics;  // which of its diagnostics, from 0
};

enum class GateMode : std::uint8_t { all, regression };

// The loss of a value that is allowed without being reported.
struct AllowedLoss {
  rules::Metric metric = rules::Metric::average;
  double share = 0.0;  // 0 to 1
};

struct Gate {
  GateMode mode = GateMode::all;
  double allowed_worse = 0.01;     // share; of quantities that are not in the list
  std::string weaker_accepted_by;  // the reason; "" = weaker questions are not accepted
  std::vector<AllowedLoss> allowed_worse_of = {};  // each quantity once at most
};

struct Revision {
  std::string baseline;              // the file, or the git revision as it was given
  std::vector<std::string> commits;  // of a git revision: full ids, one for each repository
  std::string baseline_version;      // of the program that made it
  Gate gate;
  std::vector<ChangedResult> results;  // without those that are the same; gravest first
  std::size_t same = 0;
  std::size_t known_failures = 0;  // that count, and failed before
  // Part of `same`: the interval of the difference includes a loss greater than allowed.
  std::size_t untold = 0;
  // HEAD is compared with itself: nothing can be worse, whatever the projects contain.
  bool is_of_itself = false;
  std::vector<ChangedQuestion> questions;
  std::vector<ChangedInput> inputs;
  std::vector<ChangedPlane> planes;
  std::vector<KnownWarnings> known_warnings;  // of projects that have some
  std::vector<calc::Message> notes;           // why something could not be compared
};

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::ResultChange> {
  static constexpr EnumName<report::ResultChange> list[] = {
      {report::ResultChange::broken, "broken"}, {report::ResultChange::new_failing, "new-failing"},
      {report::ResultChange::unsure, "unsure"}, {report::ResultChange::worse, "worse"},
      {report::ResultChange::gone, "gone"},     {report::ResultChange::fixed, "fixed"},
      {report::ResultChange::better, "better"}, {report::ResultChange::added, "new"},
      {report::ResultChange::same, "same"}};
};

template <>
struct EnumNames<report::QuestionChange> {
  static constexpr EnumName<report::QuestionChange> list[] = {
      {report::QuestionChange::weaker, "weaker"},
      {report::QuestionChange::exchanged, "exchanged"},
      {report::QuestionChange::stricter, "stricter"}};
};

template <>
struct EnumNames<report::QuestionPart> {
  static constexpr EnumName<report::QuestionPart> list[] = {
      {report::QuestionPart::project, "project"},
      {report::QuestionPart::room, "room"},
      {report::QuestionPart::plane, "plane"},
      {report::QuestionPart::requirement, "requirement"},
      {report::QuestionPart::aggregate, "aggregate"},
      {report::QuestionPart::limit, "limit"},
      {report::QuestionPart::quantity, "quantity"},
      {report::QuestionPart::severity, "severity"},
      {report::QuestionPart::light, "light"},
      {report::QuestionPart::rule, "rule"},
      {report::QuestionPart::waiver, "waiver"},
      {report::QuestionPart::deviation, "deviation"},
      {report::QuestionPart::policy, "policy"},
      {report::QuestionPart::mask, "mask"},
      {report::QuestionPart::area, "area"},
      {report::QuestionPart::grid, "grid"},
      {report::QuestionPart::margin, "margin"},
      {report::QuestionPart::lost_points, "lost-points"},
      {report::QuestionPart::role, "role"},
      {report::QuestionPart::maintenance_factor, "maintenance-factor"},
      {report::QuestionPart::flux, "flux"},
      {report::QuestionPart::power, "power"},
      {report::QuestionPart::confidence, "confidence"},
      {report::QuestionPart::accuracy, "accuracy"},
      {report::QuestionPart::method, "method"},
      {report::QuestionPart::energy, "energy"},
      {report::QuestionPart::stated, "stated"}};
};

template <>
struct EnumNames<report::GateMode> {
  static constexpr EnumName<report::GateMode> list[] = {
      {report::GateMode::all, "all"}, {report::GateMode::regression, "regression"}};
};

}  // namespace calc
