#pragma once
// A project whose text is another one than its file's.

#include "calc/base/file_reader.h"

#include <string>

namespace cli {

// Every other file is as it is.
class ChangedProject : public calc::FileReader {
 public:
  // files: they outlive this.
  ChangedProject(const calc::FileReader& files, std::string project, std::string text);

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;

 private:
  const calc::FileReader& files_;
  const std::string project_, text_;
};

}  // namespace cli
