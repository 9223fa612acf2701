#pragma once
// What `advise` found: plain data.

#include "calc/base/names.h"
#include "report/tools/advise/findings.h"
#include "report/tools/advise/room_advice.h"
#include "rules/catalogue/finding.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// How many times the light of the luminaires is looked for at most.
constexpr double kMostAdvisedLight = 20.0;

enum class AdviceOutcome {
  levels,         // these levels meet everything that hangs on them
  contradiction,  // surely none up to full output do; these requirements exclude each other
  more_light,     // only with more light than the luminaires have
  too_uncertain,  // some may, but the intervals are too wide to tell
  none_found,     // the search ended, or its levels did not pass the check
};

struct AdvisedGroup {
  std::string group;  // "" = luminaires without one
  std::size_t luminaires = 0;
  double power_w = 0.0, flux_lm = 0.0;  // of all of them at full output
  double now = 1.0;                     // level in the project
  double level = 1.0;                   // advised; above 1: so many times the light
};

struct AdvisedRequirement {
  FindingPlace where;
  std::string space, plane;  // as reports title them
  rules::Finding before, after;
  // Why it is no condition on the sum of groups: it took no part in the search, and was checked
  // all the same. "" = it took part.
  std::string not_searched;
};

// What holds the least cost up.
struct AdvisedLimit {
  std::size_t requirement = 0;    // of SceneAdvice::requirements
  double cost_per_percent = 0.0;  // how much a limit would save that is looser by one percent
  // Where, and what gives the light there: the worst point, or empty, the average of the plane.
  std::optional<glm::dvec3> place_m;
  std::vector<double> lx;  // each group with its level, last the light that no level changes
};

struct SceneAdvice {
  std::string scene;  // "" = full output
  AdviceOutcome outcome = AdviceOutcome::none_found;
  std::string reason;       // of none_found, in words
  bool is_by_flux = false;  // the power of a luminaire is not known: costs are lumens
  // Watts, or lumens: with the levels now, with those advised, and what no levels undercut.
  double now = 0.0, advised = 0.0, least = 0.0;
  std::vector<AdvisedGroup> groups;
  // Groups of rooms in which nothing is asked of this scene: they stay as they are, and are in no
  // sum.
  std::vector<std::string> left_alone;
  // All that count in this scene; `after` is of the check of the changed project, of more_light
  // by the same light. Without levels `after` says nothing.
  std::vector<AdvisedRequirement> requirements;
  std::vector<std::size_t> contradicting;  // of them: without any one of these there are levels
  // Of them: what takes no part in the search and would not be met with the least power, so that
  // the levels are higher.
  std::vector<std::size_t> raised_for;
  // Of the least levels of any size, dearest first; empty where the levels are not the least ones.
  std::vector<AdvisedLimit> limits;
  // Aggregates, classes and sums of rule packs that count and do not pass in the changed project:
  // "LEED v4.1 ... (fail)".
  std::vector<std::string> aggregates_not_met;

  bool has_levels() const {
    return outcome == AdviceOutcome::levels || outcome == AdviceOutcome::more_light;
  }
  // Every requirement of the scene, and what rule packs make of all together.
  bool is_all_met() const {
    if (!aggregates_not_met.empty()) return false;
    for (const AdvisedRequirement& one : requirements) {
      if (one.after.verdict != rules::Verdict::pass) return false;
    }
    return true;
  }
};

// Light and power of one luminaire.
struct PackageLight {
  std::string article;  // "" = that of the photometry file, or the project's own numbers
  double flux_lm = 0.0, power_w = 0.0;
};

// A luminaire type that has packages and hangs in a room in which light is asked for.
struct AdvisedPackage {
  std::string type;
  std::size_t luminaires = 0;
  std::size_t where_nothing_is_asked = 0;  // of them: they change as well
  PackageLight now, advised;
};

struct PackageAdvice {
  std::string problem;      // why there is no advice; "" = there is
  bool is_by_flux = false;  // the power of one of the types is not known: costs are lumens
  std::vector<AdvisedPackage> types;
  // Of all luminaires of these types at full output, W or lm.
  double now = 0.0, advised = 0.0;
  std::size_t combinations = 0;  // of packages and what there is now
  // Of those that take less: how many are not surely too little. Their levels were not found, the
  // intervals are too wide, or the check did not pass.
  std::size_t not_excluded = 0;
  // What the combination next below lacks with the levels of now, in words; "" = there is none.
  std::string next_below;
  // Scenes whose levels change with it; the others keep those of now.
  std::vector<SceneAdvice> scenes;
  // Of all scenes and rooms: now, and in the check with other random numbers.
  std::size_t passing_now = 0, passing = 0, asked = 0;
  bool is_all_met = false;           // these, and what rule packs make of all together
  std::vector<std::string> not_met;  // with it, what counts, in words
  std::string text;                  // of the project with all of it
  bool is_as_now() const;
};

// Of --write: what went into the file, and what a check of it says with other random numbers.
struct WrittenAdvice {
  std::string file, what;  // "levels", "packages" or "places"
  std::size_t passing = 0, asked = 0;
  std::vector<std::string> not_met = {};
};

struct Advice {
  std::string project;
  std::vector<SceneAdvice> scenes;
  // What counts, does not pass and hangs on no levels, in words; asked for all scenes only.
  std::vector<std::string> not_met_besides = {};
  RoomAdvice rooms = {};                       // what was asked for of places and surfaces
  std::optional<PackageAdvice> packages = {};  // empty: nobody asked
  std::optional<WrittenAdvice> written = {};
};

std::string render_advice_text(const Advice& advice);
std::string render_package_advice_text(const PackageAdvice& advice);
// A page without a script; with maps of ceilings where places were asked for.
std::string render_advice_html(const Advice& advice);
std::string render_advice_markdown(const Advice& advice);
std::string render_advice_json(const Advice& advice);
// JSON Schema (draft 7) of render_advice_json(), made of the same keys. advice.schema.json is what
// it gives.
std::string advice_schema();

}  // namespace cli

namespace calc {

template <>
struct EnumNames<cli::AdviceOutcome> {
  static constexpr EnumName<cli::AdviceOutcome> list[] = {
      {cli::AdviceOutcome::levels, "levels"},
      {cli::AdviceOutcome::contradiction, "contradiction"},
      {cli::AdviceOutcome::more_light, "more-light"},
      {cli::AdviceOutcome::too_uncertain, "too-uncertain"},
      {cli::AdviceOutcome::none_found, "none-found"}};
};

}  // namespace calc
