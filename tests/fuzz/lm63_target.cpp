// LM-63; the second file, if there is one, is what TILT=<file> names.
#include "calc/photometry/read/ies_lm63.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::TwoFiles files = fuzz::split_files(fuzz::as_text(data, size));
  calc::Diagnostics diagnostics;
  const calc::CompanionReader read_companion = [&](const std::string&) {
    return std::optional(files.second);
  };
  const auto web = calc::parse_lm63(files.first, "a.ies", diagnostics, read_companion);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (web) fuzz::check_web(*web);
  return 0;
}
