// TM-33; the second file, if there is one, is the choice of an emitter.
#include "calc/photometry/read/tm33_xml.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::TwoFiles files = fuzz::split_files(fuzz::as_text(data, size));
  calc::Diagnostics diagnostics;
  calc::PhotometryOptions options;
  options.emitter = files.second;
  const auto web = calc::parse_tm33(files.first, "a.xml", options, diagnostics);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (web) fuzz::check_web(*web);
  return 0;
}
