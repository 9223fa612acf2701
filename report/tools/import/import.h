#pragma once
// A project from a plan: luxgate import.

#include "report/shell/command/command.h"

#include <string>

namespace cli {

struct ImportOptions {
  std::string file, map, unit, folder;
  bool suggests_map = false, as_json = false;
};

Command import_command();

}  // namespace cli
