#pragma once
// The changes of a revision for CI systems, beside the findings of the result: values that became
// worse although they pass, and requirements that are weaker or different.

#include "report/document/document.h"

#include <string>
#include <vector>

namespace report {

struct CiChange {
  std::string project;  // its path; "": the whole run
  std::string rule;     // "worse", "weaker-question"
  std::string key;      // unique in the document
  calc::SourceLocation where;
  std::string message;      // printable(), English
  std::string fingerprint;  // 64 hexadecimal digits of project path and key
  bool stops = false;       // the gate; else it is told only
};

// Returns the changes in the revision's order; empty without a revision.
std::vector<CiChange> ci_changes(const Document& document);

}  // namespace report
