#pragma once
// Reads light vertices from a file instead of tracing them: `luxgate check --vpl`.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/radiosity/looks/vertex_cache.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>

namespace check {

// The vertices of one space, with the settings of use_settings_of().
struct VertexSource {
  std::string file;
  calc::VertexCache cache;
};

// Returns the program and the version of its numbers, as in VertexCache::made_by.
std::string vertex_maker();

// Returns the vertices; empty after an error: the file is unreadable, changed, of another version,
// or has too few replicates to judge by.
std::optional<VertexSource> read_vertex_source(const std::string& file,
                                               const calc::FileReader& files,
                                               calc::Diagnostics& diagnostics);

// Sets seed, replicates and paths.
void use_settings_of(const calc::VertexCache& cache, calc::RadiositySettings& settings);

// Returns whether the project has the space; false after an error.
bool has_space_of(const VertexSource& source, const calc::Project& project,
                  calc::Diagnostics& diagnostics);
// Returns whether the vertices fit the scene. skips: of the run that is to use them.
bool fits(const VertexSource& source, const calc::PreparedScene& scene, const calc::SkipSet& skips,
          calc::Diagnostics& diagnostics);

}  // namespace check
