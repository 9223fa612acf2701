#pragma once
// Reads the files of projects for a command line: also from standard input, and, if requested,
// reporting each file.

#include "calc/base/file_reader.h"
#include "report/shell/options/project_options.h"

#include <mutex>
#include <set>
#include <string>

namespace cli {

class ProjectReader : public calc::FileReader {
 public:
  // With --verbose reports on standard error which luxgate.toml applies, and each file once when it
  // is read. The options must outlive this.
  explicit ProjectReader(const ProjectOptions& options);

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;

 private:
  void tell_once(const std::string& path, const calc::FileContent& content) const;

  const ProjectOptions& options_;
  const calc::DiskFileReader disk_;
  mutable std::mutex mutex_;  // several projects are read at the same time
  mutable std::set<std::string> told_;
};

}  // namespace cli
