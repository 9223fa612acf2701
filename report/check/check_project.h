#pragma once
// One project from file to document part: load, bind requirements, and per space grids, scene,
// illuminance, verdicts.

#include "calc/base/file_reader.h"
#include "calc/radiosity/solve.h"
#include "calc/radiosity/stages.h"
#include "report/check/backend.h"
#include "report/check/observer.h"
#include "report/check/settings.h"
#include "report/check/units.h"
#include "report/check/vertex_source.h"
#include "report/document/document.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace check {

// What a whole batch shares.
struct Context {
  const Settings& settings;
  const calc::FileReader& files;
  const std::vector<rules::RulePack>& packs;
  const calc::Stages& stages;
  Observer& observer;
  const VertexSource* vertices = nullptr;  // settings are its own; or null
  const calc::LookStore* store = nullptr;  // of looks, to be used again; never changes a result
  // Spaces of a project that are calculated at the same time, see most_at_once(); changes no
  // result.
  std::size_t spaces_at_once = 1;
};

// How many projects, and spaces of each, are best calculated at the same time: one where a device
// or a time limit is shared among them, else some for each thread.
std::size_t most_at_once(const Settings& settings, Backend backend);

// Calculates and judges. Input errors end up in the part's diagnostics and leave it not judged; a
// plane without points is not judged, the others are. A check that its observer stops has judged
// nothing. Throws calc::BackendFailure, and
// std::invalid_argument for settings that problem_with() refuses.
report::ProjectPart check_project(const std::string& path, const Context& context);

// The same on the processor, with nobody watching; files of the disk, delivered rule packs only.
report::ProjectPart check_project(const std::string& path, const Settings& settings = {});

// Calculates the light of these units of one project, so that the context's store has every look
// that check_project() will ask for; nothing is judged for a report. Errors: what cannot be read,
// and units whose light a store cannot keep or whose spaces or planes there are not.
calc::Diagnostics light_units(const std::string& path, const std::vector<Unit>& units,
                              const Context& context);

// Everything that check_project() reads and checks, without calculation; what will not be judged,
// whatever the light, is a warning. day: YYYY-MM-DD, see day_of().
report::ProjectPart validate_project(const std::string& path, const calc::FileReader& files,
                                     const std::vector<rules::RulePack>& packs,
                                     std::string_view day, const calc::Budget& budget = {});

}  // namespace check
