#pragma once
// The options of `luxgate export`.

#include "report/shell/command/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

inline constexpr const char *kRadiance = "radiance", *kGltf = "gltf", *kIfc = "ifc";

struct ExportOptions {
  std::string target;                   // "radiance", "gltf" or "ifc"
  std::string project;                  // of ifc: the model
  std::string output;                   // a folder; of ifc: the new model
  std::string results;                  // of ifc: a result file
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
