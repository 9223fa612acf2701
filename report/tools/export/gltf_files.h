#pragma once
// `luxgate export gltf`: writes rooms to files.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "report/tools/export/exported_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cli {

struct GltfSettings {
  std::uint64_t seed = 1;
  int jobs = 0;  // never changes a model
};

// Returns names of files by the ids of spaces. Names never differ only in case, because some
// systems treat these as one.
std::map<std::string, std::string> gltf_names(const std::vector<const calc::Space*>& spaces);

// Returns a model of each space that has light to show. notes: the other spaces, omitted parts of a
// model, and the sampling error of its light. Empty after an error.
std::vector<ExportedFile> gltf_files(const GltfSettings& wanted, const calc::Project& project,
                                     const std::vector<const calc::Space*>& spaces,
                                     std::vector<std::string>& notes,
                                     calc::Diagnostics& diagnostics);

}  // namespace cli
