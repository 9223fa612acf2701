// glTF, JSON and GLB; the second file, if there is one, stands beside it under every name.
#include "calc/meshes/mesh_gltf.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::TwoFiles files = fuzz::split_files(fuzz::as_text(data, size));
  calc::Diagnostics diagnostics;
  const calc::SideFiles side_files = [&](const std::string&) {
    return std::optional(files.second);
  };
  const auto mesh = calc::parse_gltf(files.first, "a.gltf", side_files, diagnostics);
  fuzz::check_messages(mesh.has_value(), diagnostics);
  if (mesh) fuzz::check_mesh(*mesh);
  return 0;
}
