#pragma once
// One project from file to document part.

#include "calc/file_reader.h"
#include "calc/radiosity/gatherer.h"
#include "report/cli/options.h"
#include "report/cli/progress.h"
#include "report/cli/room_pictures.h"
#include "report/document.h"
#include "rules/rule_pack.h"

#include <string>
#include <vector>

namespace cli {

// What a whole batch shares.
struct CheckContext {
  const Options& options;
  const calc::FileReader& files;
  const std::vector<rules::RulePack>& packs;
  calc::Gatherer& gatherer;
  Progress& progress;
  PictureMaker* pictures = nullptr;  // null: none are wanted
  std::string* cost_log = nullptr;   // gets what --explain-cost prints; null: not wanted
};

// Calculates and judges. Input errors end up in the part's diagnostics and leave it not judged; a
// plane without points is not judged, the others are. Stops early once interrupted(): the part must
// then not be used.
report::ProjectPart check_project(const std::string& path, const CheckContext& context);

// Everything that check_project() reads and checks, without calculation.
report::ProjectPart validate_project(const std::string& path, const calc::FileReader& files,
                                     const std::vector<rules::RulePack>& packs);

}  // namespace cli
