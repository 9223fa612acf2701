// Files of light vertices, as `luxgate vpl` writes them.
#include "calc/base/diagnostic_ids.h"
#include "calc/radiosity/looks/vertex_cache.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::as_text(data, size);
  const calc::TracedCache parsed = calc::parse_vertex_ply(bytes);
  calc::Diagnostics diagnostics;
  if (!parsed.problem.empty()) {
    diagnostics.report(calc::DiagnosticId::vertex_cache_unreadable, {"a.ply", 0, 0},
                       parsed.problem);
  }
  fuzz::check_messages(parsed.cache.has_value(), diagnostics);
  if (!parsed.cache) return 0;
  fuzz::require(calc::render_vertex_ply(*parsed.cache) == bytes, "what is read is written again");
  return 0;
}
