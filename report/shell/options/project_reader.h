#pragma once
// Reads what projects are made of, as the command line has it: also from standard input, and, if
// asked, says what is read.

#include "calc/base/file_reader.h"
#include "report/shell/options/project_options.h"

#include <mutex>
#include <set>
#include <string>

namespace cli {

class ProjectReader : public calc::FileReader {
 public:
  // With --verbose tells to standard error which luxgate.toml holds, and of each file once that it
  // is read. The options must live as long.
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
