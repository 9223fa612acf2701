#pragma once
// Checks one project from file to document part: loading, binding requirements, and grids, scene,
// illuminance and verdicts of each space. Run calls it.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "report/check/observer.h"
#include "report/check/run.h"
#include "report/check/units.h"
#include "report/document/document.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <string_view>
#include <vector>

namespace check {

// Does the work of Run::check() and Run::light(), but throws calc::BackendFailure and
// std::bad_alloc if the machine fails.
report::ProjectPart check_project(const std::string& path, const Run& run, Observer& observer);
calc::Diagnostics light_units(const std::string& path, const std::vector<Unit>& units,
                              const Run& run, Observer& observer);

// Everything that check_project() reads and checks, without calculation; what will not be judged,
// whatever the light, is a warning, and so are numbers of one public source where that is asked
// for. day: YYYY-MM-DD, see day_of().
report::ProjectPart validate_project(const std::string& path, const calc::FileReader& files,
                                     const std::vector<rules::RulePack>& packs,
                                     std::string_view day, const calc::Budget& budget = {},
                                     bool warns_of_one_source = false);

}  // namespace check
