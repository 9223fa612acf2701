#pragma once
// `luxgate import`: makes a project from a plan.

#include "report/shell/command/command.h"

#include <string>

namespace cli {

struct ImportOptions {
  std::string file, map, unit, folder;
  bool suggests_map = false, as_json = false;
};

Command import_command();

}  // namespace cli
