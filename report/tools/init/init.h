#pragma once
// A first project to start from.

#include "report/shell/command/command.h"

#include <string>

namespace cli {

// The result: written files, or an error in words (then nothing was written).
struct InitResult {
  std::string project_file;
  std::string error;
};

// Writes project.xml and photometry/panel.ies into `folder` (made if needed). Existing files are an
// error and stay as they are. The project runs and passes (tested).
InitResult write_starter_project(const std::string& folder);

Command init_command();

}  // namespace cli
