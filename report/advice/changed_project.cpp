#include "report/advice/changed_project.h"

#include <utility>

namespace cli {

ChangedProject::ChangedProject(const calc::FileReader& files, std::string project, std::string text)
    : files_(files), project_(std::move(project)), text_(std::move(text)) {}

calc::FileContent ChangedProject::read_within(const std::string& folder,
                                              const std::string& path) const {
  if (path == project_) return {text_, ""};
  return files_.read_within(folder, path);
}

}  // namespace cli
