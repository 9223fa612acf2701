#pragma once
// The results of `advise`: plain data.

#include "report/advice/scene_advice.h"
#include "report/tools/advise/room_advice.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// Light and power of one luminaire.
struct PackageLight {
  std::string article;  // "" = that of the photometry file, or the project's own numbers
  double flux_lm = 0.0, power_w = 0.0;
};

// A luminaire type with packages that is used in a room with requirements on light.
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
  // Total of all luminaires of these types at full output, W or lm.
  double now = 0.0, advised = 0.0;
  std::size_t combinations = 0;  // of packages and what there is now
  // Combinations of lower cost that may be enough: their levels were not found, the intervals are
  // too wide, or the check did not pass.
  std::size_t not_excluded = 0;
  // What the next cheaper combination lacks at the current levels, in words; "" = there is none.
  std::string next_below;
  // Scenes whose levels change with it; the others keep the current levels.
  std::vector<SceneAdvice> scenes;
  // Counts over all scenes and rooms: now, and in the check with other random numbers.
  std::size_t passing_now = 0, passing = 0, asked = 0;
  bool is_all_met = false;           // these, and what rule packs make of all together
  std::vector<std::string> not_met;  // with it, what counts, in words
  std::string text;                  // of the project with all of it
  bool is_as_now() const;
};

// For --write: the part written to the file, and the result of its check with other random numbers.
struct WrittenAdvice {
  std::string file, what;  // "levels", "packages", "places" or "turns"
  std::size_t passing = 0, asked = 0;
  std::vector<std::string> not_met = {};
};

struct Advice {
  std::string project;
  std::vector<SceneAdvice> scenes;
  // Requirements that count, do not pass and do not depend on levels, in words; only if all scenes
  // were requested.
  std::vector<std::string> not_met_besides = {};
  RoomAdvice rooms = {};                       // what was asked for of places and surfaces
  std::optional<PackageAdvice> packages = {};  // empty: not requested
  std::optional<WrittenAdvice> written = {};
};

std::string render_advice_text(const Advice& advice);
std::string render_package_advice_text(const PackageAdvice& advice);
// Returns a page without a script, with maps of ceilings if places were requested.
std::string render_advice_html(const Advice& advice);
std::string render_advice_markdown(const Advice& advice);
std::string render_advice_json(const Advice& advice);
// Returns the JSON Schema (draft 7) of render_advice_json(), made of the same keys, as in
// advice.schema.json.
std::string advice_schema();

}  // namespace cli
