// GLDF from the inside: the input is product.xml of an intact archive, whose checksums mutations of
// an archive never get right. The second file, if there is one, is the choice of an emitter.
#include "calc/photometry/read/gldf.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/zip_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string kLdt = test_support::ldt_text({});
  static const std::string kIes = test_support::ies_text({});
  const fuzz::TwoFiles files = fuzz::split_files(fuzz::as_text(data, size));
  const std::string bytes = test_support::zip_bytes(
      {{"product.xml", std::string(files.first)}, {"ldc/a.ldt", kLdt}, {"ldc/b.ies", kIes}}, false);
  calc::Diagnostics diagnostics;
  calc::PhotometryOptions options;
  options.emitter = files.second;
  const auto web = calc::parse_gldf(bytes, "a.gldf", options, diagnostics);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (web) fuzz::check_web(*web);
  return 0;
}
