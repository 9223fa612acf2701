#include "report/cli/version.h"

#include "calc/radiosity/rays.h"

#include <fmt/format.h>

namespace cli {

// LUXGATE_VERSION, LUXGATE_COMPILER and LUXGATE_BUILD_TYPE come from CMake.
std::string program_version() { return LUXGATE_VERSION; }

std::string version_text(bool as_json) {
  const std::string tracer = calc::tracer_version();
  if (as_json) {
    return fmt::format(
        "{{\"luxgate\": \"{}\", \"compiler\": \"{}\", \"build_type\": \"{}\", \"rays\": \"{}\"}}\n",
        LUXGATE_VERSION, LUXGATE_COMPILER, LUXGATE_BUILD_TYPE, tracer);
  }
  return fmt::format("luxgate {}\ncompiler   {}\nbuild type {}\nrays       {}\n", LUXGATE_VERSION,
                     LUXGATE_COMPILER, LUXGATE_BUILD_TYPE, tracer);
}

}  // namespace cli
