#pragma once
// `luxgate export`: a project as a scene for another program.

#include "calc/file_reader.h"
#include "report/cli/command_outcome.h"
#include "report/cli/export_options.h"

namespace cli {

CommandOutcome run_export(const ExportOptions& options, const calc::FileReader& disk);

}  // namespace cli
