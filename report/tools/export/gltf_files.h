#pragma once
// `luxgate export gltf`: rooms to files.

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

// Names of files by the ids of spaces. On some systems names that differ in case alone are one.
std::map<std::string, std::string> gltf_names(const std::vector<const calc::Space*>& spaces);

// A model of each space that has light to show; notes: the others, what a model leaves out, and the
// sampling error of its light. Empty after an error.
std::vector<ExportedFile> gltf_files(const GltfSettings& wanted, const calc::Project& project,
                                     const std::vector<const calc::Space*>& spaces,
                                     std::vector<std::string>& notes,
                                     calc::Diagnostics& diagnostics);

}  // namespace cli
