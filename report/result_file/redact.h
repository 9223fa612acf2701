#pragma once
// Reports that can be given away: what tells of the machine and of who ran the program goes, what
// tells of the design and of the calculation stays.

#include "report/document/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// In the whole document:
// - files are named relative to the folder of their project, those outside it by their last name
//   alone; projects whose files have one name get "project<k>/" before it, k from 1;
// - the command line has the same names;
// - other paths in messages, absolute or with leading "..", become their last name;
// - so does the baseline that it is compared with; a git revision and its commits stay;
// - graphics devices lose their name, the backend "gpu (NAME): ..." becomes "gpu: ...".
// Names that the project itself gives (rooms, planes, luminaires, who waived) are the design and
// stay, as do versions, seeds and hashes. A second time changes nothing.
void redact(Document& document);

// The same for projects that come one by one.
class Redaction {
 public:
  // paths: of all projects, as they are.
  explicit Redaction(std::vector<std::string> paths);

  void redact(DocumentFrame& frame) const;
  void redact(ProjectPart& project, std::size_t index) const;

  // What goes before names of files: "" or "project2/".
  const std::string& prefix(std::size_t index) const { return prefixes_[index]; }

 private:
  std::vector<std::string> paths_, prefixes_;
};

}  // namespace report
