#pragma once
// The options of `luxgate export`.

#include "report/shell/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

inline constexpr const char *kRadiance = "radiance", *kGltf = "gltf";

struct ExportOptions {
  std::string target;  // "radiance" or "gltf"
  std::string project, folder;
  std::string space;                    // "" = the only one; for gltf all
  std::string scene;                    // of radiance: whose levels hold; "" = full output
  std::vector<std::string> rule_files;  // packs besides those delivered, folders too
  std::vector<std::string> allowed;     // see --allow
  bool overwrites = false;
  std::uint64_t seed = 1;  // of gltf
  int jobs = 0;            // of gltf, as calc::SurfaceLightSettings
};

Command export_syntax(ExportOptions& options);

}  // namespace cli
