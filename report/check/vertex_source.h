#pragma once
// Light vertices from a file instead of tracing them: `luxgate check --vpl`.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/radiosity/looks/vertex_cache.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>

namespace check {

// Of one space, with the settings of use_settings_of().
struct VertexSource {
  std::string file;
  calc::VertexCache cache;
};

// As in VertexCache::made_by: the program and the version of its numbers.
std::string vertex_maker();

// Empty after an error: unreadable, changed, of another version, or too few replicates to judge by.
std::optional<VertexSource> read_vertex_source(const std::string& file,
                                               const calc::FileReader& files,
                                               calc::Diagnostics& diagnostics);

// Seed, replicates and paths.
void use_settings_of(const calc::VertexCache& cache, calc::RadiositySettings& settings);

// False after an error.
bool has_space_of(const VertexSource& source, const calc::Project& project,
                  calc::Diagnostics& diagnostics);
// skips: of the run that wants to use them.
bool fits(const VertexSource& source, const calc::PreparedScene& scene, const calc::SkipSet& skips,
          calc::Diagnostics& diagnostics);

}  // namespace check
