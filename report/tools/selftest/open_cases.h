#pragma once
// Validation cases that lie beside the program as tables: cases.csv, points.csv, scalars.csv,
// surfaces.csv, luminaires.csv and LM-63 files in a folder of their own. Not part of the selftest's
// verdict.

#include "calc/base/file_reader.h"
#include "report/tools/selftest/judge.h"

#include <functional>
#include <string>
#include <vector>

namespace cli::selftest {

struct OpenCase {
  JudgedCase judged;
  std::vector<std::string> printed;   // what the literature prints, of each number; "" = nothing
  std::string not_covered;            // why it was not calculated; "" = it was
  std::vector<std::string> left_out;  // numbers of it that were not, and why
};

struct OpenCases {
  std::vector<OpenCase> cases;
  std::string problem;  // "" = the tables could be read
};

// go_on: asked before every case; false ends the list there.
OpenCases run_open_cases(const std::string& folder, const calc::FileReader& files,
                         const Effort& effort,
                         const std::function<bool(const std::string&)>& go_on);

}  // namespace cli::selftest
