#pragma once
// `luxgate vpl`: light vertices into a file; and out of it for `luxgate check --vpl`.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/radiosity/vertex_cache.h"
#include "calc/scene/project.h"
#include "gpu/egl_context.h"
#include "report/cli/options.h"
#include "report/shell/command_outcome.h"
#include "report/shell/environment.h"

#include <optional>
#include <string>

namespace cli {

// gl_fault: for tests.
CommandOutcome run_vpl(const VplOptions& options, const calc::FileReader& disk,
                       const Environment& environment, gpu::Fault gl_fault);

// Empty after an error: unreadable, changed, of another version, or too few replicates to judge by.
std::optional<calc::VertexCache> read_vertex_cache(const std::string& path,
                                                   const calc::FileReader& files,
                                                   calc::Diagnostics& diagnostics);

// Seed, replicates and paths.
void use_settings_of(const calc::VertexCache& cache, calc::RadiositySettings& settings);

// False after an error.
bool has_space_of(const calc::VertexCache& cache, const calc::Project& project,
                  const Options& options, calc::Diagnostics& diagnostics);
bool fits(const calc::VertexCache& cache, const calc::PreparedScene& scene, const Options& options,
          calc::Diagnostics& diagnostics);

}  // namespace cli
