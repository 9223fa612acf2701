#pragma once
// Validation cases that lie beside the program as tables: cases.csv, points.csv, scalars.csv,
// surfaces.csv, luminaires.csv and LM-63 files in a folder of their own.

#include "calc/base/file_reader.h"
#include "report/tools/selftest/judge.h"

#include <functional>
#include <string>
#include <vector>

namespace validation {

struct OpenCase {
  cli::selftest::JudgedCase judged;
  std::vector<std::string> printed;   // what the literature prints, of each number; "" = nothing
  std::string not_covered;            // why it was not calculated; "" = it was
  std::vector<std::string> left_out;  // numbers of it that were not, and why
};

struct OpenCases {
  std::vector<OpenCase> cases;
  std::string problem;  // "" = the tables could be read
};

// announce: told every case before it is calculated.
OpenCases run_open_cases(const std::string& folder, const calc::FileReader& files,
                         const cli::selftest::Effort& effort,
                         const std::function<void(const std::string&)>& announce);

// The same text for the same cases: no times. The HTML has every number.
std::string render_open_markdown(const OpenCases& open);
std::string render_open_html(const OpenCases& open);

}  // namespace validation
