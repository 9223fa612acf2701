#include "report/cli/version.h"

#include "calc/radiosity/rays.h"
#include "gpu/egl_context.h"
#include "report/cli/devices.h"
#include "report/json_layout.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cli {

// LUXGATE_VERSION, LUXGATE_COMPILER and LUXGATE_BUILD_TYPE come from CMake.
std::string program_version() { return LUXGATE_VERSION; }

std::string version_text(bool as_json) {
  const std::string tracer = calc::tracer_version();
  if (as_json) {
    return report::json_layout(
        nlohmann::ordered_json{{"luxgate", LUXGATE_VERSION},
                               {"compiler", LUXGATE_COMPILER},
                               {"build_type", LUXGATE_BUILD_TYPE},
                               {"rays", tracer},
                               {"opengl_devices", devices_json(gpu::list_devices())}});
  }
  return fmt::format("luxgate {}\ncompiler   {}\nbuild type {}\nrays       {}\n", LUXGATE_VERSION,
                     LUXGATE_COMPILER, LUXGATE_BUILD_TYPE, tracer);
}

}  // namespace cli
