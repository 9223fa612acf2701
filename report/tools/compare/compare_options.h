#pragma once
// The options of `luxgate compare`.

#include "report/shell/command/command.h"
#include "report/shell/output/data_output.h"
#include "report/shell/output/page_options.h"

#include <string>
#include <vector>

namespace cli {

struct CompareOptions {
  std::string a, b;
  std::vector<std::string> planes;  // "A" or "A=B"; empty = all
  double tolerance = 0.0;           // share of B, besides the intervals
  double distance_m = 0.01;         // within which points are the same
  int worst = 5;
  bool is_partial = false;  // what only one side has is a note, not an error
  std::vector<DataOutput> outputs;
  PageChoice page;  // of html
  bool quiet = false;
};

Command compare_syntax(CompareOptions& options);

}  // namespace cli
