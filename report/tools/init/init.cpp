#include "report/tools/init/init.h"

#include "calc/base/diagnostic_ids.h"
#include "report/formats/write.h"
#include "report/shell/process/print.h"
#include "report/tools/init/starter_files.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace cli {

InitResult write_starter_project(const std::string& folder) {
  namespace fs = std::filesystem;
  struct StarterFile {
    fs::path path;
    std::string_view content;
  };
  const fs::path base = folder;
  const std::array files = {StarterFile{base / "photometry" / "panel.ies", kStarterPanel},
                            StarterFile{base / "project.xml", kStarterProject}};

  for (const StarterFile& file : files) {
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file.path, ignored))) {
      return {"", fmt::format("'{}' exists already and is kept; nothing was written",
                              file.path.string())};
    }
  }
  for (const StarterFile& file : files) {
    const std::string problem = report::write_file_atomically(file.path.string(), file.content);
    if (!problem.empty()) {
      return {"", fmt::format("cannot write '{}': {}", file.path.string(), problem)};
    }
  }
  return {files.back().path.string(), ""};
}

Command init_command() {
  const auto folder = std::make_shared<std::string>(".");
  Command command{"init", "Write a small project that runs and passes"};
  command.places = {
      {"folder", "FOLDER", "Where; made if needed. Existing files are kept", folder.get(), false}};
  command.examples = {{"luxgate init my-room", "Then: luxgate check my-room/project.xml"}};
  command.exit_codes = {{0, "written"}, {2, "an error, also that a file of that name is there"}};
  command.run = [folder](const RunContext&) {
    const InitResult result = write_starter_project(*folder);
    if (!result.error.empty()) {
      print_error(calc::DiagnosticId::output_not_possible, result.error);
      return kNotJudged;
    }
    return print_outcome({kAllMet,
                          fmt::format("Wrote {0} and its photometry. Next: luxgate check {0}\n",
                                      result.project_file),
                          {}});
  };
  return command;
}

}  // namespace cli
