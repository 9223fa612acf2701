// EULUMDAT, with the lamp set that the length of the input asks for.
#include "calc/photometry/read/eulumdat.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  calc::PhotometryOptions options;
  options.lamp_set = static_cast<int>(size % 3);
  const auto web = calc::parse_eulumdat(fuzz::as_text(data, size), "a.ldt", options, diagnostics);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (web) fuzz::check_web(*web);
  return 0;
}
