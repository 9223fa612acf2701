#include "report/shell/options/project_reader.h"

#include "calc/base/utf8.h"
#include "report/shell/options/project_folders.h"
#include "report/shell/process/print.h"

namespace cli {

ProjectReader::ProjectReader(const ProjectOptions& options)
    : options_(options), disk_(options.allowed) {
  if (!options.is_verbose) return;
  const std::string& settings = options.config.taken;
  tell("luxgate: settings: {}\n", settings.empty() ? "none" : calc::printable_path(settings));
}

calc::FileContent ProjectReader::read_within(const std::string& folder,
                                             const std::string& path) const {
  const bool is_standard_input = path == kStandardInput && options_.standard_input.has_value();
  calc::FileContent content = is_standard_input ? calc::FileContent{*options_.standard_input, ""}
                                                : disk_.read_within(folder, path);
  if (options_.is_verbose) tell_once(path, content);
  return content;
}

void ProjectReader::tell_once(const std::string& path, const calc::FileContent& content) const {
  const std::scoped_lock lock(mutex_);
  if (!told_.insert(path).second) return;
  if (content.ok()) {
    tell("luxgate: read {}: {} bytes\n", calc::printable_path(path), content.bytes.size());
  } else {
    tell("luxgate: cannot read {}\n", calc::printable_path(path));
  }
}

}  // namespace cli
