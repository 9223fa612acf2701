#pragma once
// One project from file to document part.

#include "calc/base/file_reader.h"
#include "calc/radiosity/stages.h"
#include "calc/radiosity/vertex_cache.h"
#include "report/cli/options.h"
#include "report/document/document.h"
#include "report/shell/progress.h"
#include "report/tools/pictures/room_pictures.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace cli {

// What a whole batch shares.
struct CheckContext {
  const Options& options;
  const calc::FileReader& files;
  const std::vector<rules::RulePack>& packs;
  const calc::Stages& stages;
  Progress& progress;
  PictureMaker* pictures = nullptr;          // null: none are wanted
  std::string* cost_log = nullptr;           // gets what --explain-cost prints; null: not wanted
  const calc::VertexCache* cache = nullptr;  // of one space, with the options' settings; or null
};

// Calculates and judges. Input errors end up in the part's diagnostics and leave it not judged; a
// plane without points is not judged, the others are. Stops early once interrupted(): the part must
// then not be used.
report::ProjectPart check_project(const std::string& path, const CheckContext& context);

// Everything that check_project() reads and checks, without calculation.
report::ProjectPart validate_project(const std::string& path, const calc::FileReader& files,
                                     const std::vector<rules::RulePack>& packs);

}  // namespace cli
