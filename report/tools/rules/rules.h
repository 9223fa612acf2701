#pragma once
// `luxgate rules` and `luxgate explain`.

#include "calc/base/file_reader.h"
#include "report/cli/options.h"

#include <string>

namespace cli {

struct RulesRun {
  std::string out, err;
  int exit_code = 0;
};

RulesRun run_rules(const Options& options, const calc::FileReader& files);
RulesRun run_explain(const Options& options, const calc::FileReader& files);

}  // namespace cli
