// Files of light vertices, as `luxgate vpl` writes them.
#include "calc/radiosity/vertex_cache.h"

#include "tests/fuzz/target.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::as_text(data, size);
  const calc::TracedCache parsed = calc::parse_vertex_ply(bytes);
  if (parsed.cache.has_value() != parsed.problem.empty()) std::abort();
  if (parsed.cache && calc::render_vertex_ply(*parsed.cache) != bytes) std::abort();
  return 0;
}
