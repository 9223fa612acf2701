#include "report/tools/init/init.h"

#include "report/shell/write.h"
#include "report/tools/init/starter_files.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
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

}  // namespace cli
