#pragma once
// Reports for publication: machine-specific details and traces of the user are removed, facts about
// the design and the calculation stay.

#include "report/document/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Redacts the whole document:
// - files are named relative to the folder of their project, those outside it by their last name
//   alone; projects whose files have one name get "project<k>/" before it, k from 1;
// - the command line has the same names;
// - other paths in messages, absolute or with leading "..", become their last name;
// - so does the baseline; a git revision and its commits stay;
// - graphics devices lose their name, the backend "gpu (NAME): ..." becomes "gpu: ...".
// Names from the project itself (rooms, planes, luminaires, persons who waived) are part of the
// design and stay, as do versions, seeds and hashes. A second call changes nothing.
void redact(Document& document);

// Redacts projects that come one by one.
class Redaction {
 public:
  // paths: unchanged paths of all projects.
  explicit Redaction(std::vector<std::string> paths);

  void redact(DocumentFrame& frame) const;
  void redact(ProjectPart& project, std::size_t index) const;

  // Returns the prefix of file names: "" or "project2/".
  const std::string& prefix(std::size_t index) const { return prefixes_[index]; }

 private:
  std::vector<std::string> paths_, prefixes_;
};

}  // namespace report
