#pragma once
// The options of `luxgate converge`.

#include "report/shell/command/command.h"
#include "report/shell/output/data_output.h"
#include "report/shell/output/page_options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

struct ConvergeOptions {
  std::string project;
  std::string space;                    // "" = the only one
  std::vector<std::string> planes;      // ids; empty = all of the space
  std::vector<std::string> rule_files;  // packs besides those delivered, folders too
  std::vector<std::string> allowed;     // see --allow
  std::vector<std::string> methods{"core", "instant-radiosity"};
  std::string reference = "own";                   // or a CSV file
  std::uint64_t reference_paths = 0;               // of each of its 64 replicates; 0 = 2 max_paths
  bool is_indirect = false;                        // errors of the reflected part alone
  std::uint64_t min_paths = 64, max_paths = 8192;  // of one replicate, powers of two
  int replicates = 16;
  int seeds = 5;              // runs at every number of paths
  std::uint64_t seed = 1;     // the first of them
  double clamp_per_m2 = 1.0;  // of clamped-instant-radiosity
  int jobs = 0;
  int gl_device = -1;  // as of `luxgate devices`; -1 = the first that is usable
  std::vector<DataOutput> outputs;
  PageChoice page;  // of html
  bool quiet = false;
};

Command converge_syntax(ConvergeOptions& options);

}  // namespace cli
