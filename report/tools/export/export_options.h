#pragma once
// The options of `luxgate export`.

#include "report/shell/command.h"

#include <string>
#include <vector>

namespace cli {

struct ExportOptions {
  std::string target;  // "radiance"
  std::string project, folder;
  std::string space;                    // "" = the only one
  std::vector<std::string> rule_files;  // packs besides those delivered, folders too
  std::vector<std::string> allowed;     // see --allow
  bool overwrites = false;
};

Command export_syntax(ExportOptions& options);

}  // namespace cli
