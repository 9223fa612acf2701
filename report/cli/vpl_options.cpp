#include "report/cli/vpl_options.h"

#include "report/cli/option_values.h"

namespace cli {

std::vector<ValueOption> vpl_value_options(VplOptions& options) {
  calc::RadiositySettings& settings = options.radiosity;
  return {{"-o,--output", "FILE.ply", "Where to; needed, never over an input",
           some_text(options.output)},
          {"--paths", "N", "Light paths of each replicate, a power of two; default 4096",
           power_of_two(settings.max_paths, 16, std::uint64_t{1} << 30)},
          {"--replicates", "N",
           "Independent repetitions, 1 to 64; 'check --vpl' needs 4 for its intervals; default 16",
           whole_number(settings.replicates, 1, 64)},
          {"--seed", "N", "Seed of the random numbers; default 1",
           whole_number(settings.seed, 0, UINT64_MAX)},
          {"--space", "ID", "Which space; needed if there are several", some_text(options.space)},
          {"--jobs", "N", "Threads; default one per core. Never changes the file",
           whole_number(settings.jobs, 1, 1024)}};
}

std::string vpl_contradiction(const VplOptions& options) {
  return options.output.empty() ? "-o FILE.ply is needed" : "";
}

}  // namespace cli
