// Any photometry file: the archive of GLDF byte by byte, and how a format is told by its content.
#include "calc/photometry/photometry_file.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto web = calc::parse_photometry(fuzz::as_text(data, size), "a", diagnostics);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (web) fuzz::check_web(*web);
  return 0;
}
