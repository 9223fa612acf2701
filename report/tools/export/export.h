#pragma once
// `luxgate export`: a project as a scene for another program.

#include "calc/base/file_reader.h"
#include "report/shell/command/command.h"
#include "report/shell/process/print.h"
#include "report/tools/export/export_options.h"

namespace cli {

CommandOutcome run_export(const ExportOptions& options, const calc::FileReader& disk);

Command export_command();

}  // namespace cli
