// OBJ meshes.
#include "calc/meshes/mesh_obj.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto mesh = calc::parse_obj(fuzz::as_text(data, size), "a.obj", diagnostics);
  fuzz::check_messages(mesh.has_value(), diagnostics);
  if (mesh) fuzz::check_mesh(*mesh);
  return 0;
}
