// Any photometry file: the archive of GLDF byte by byte, how a format is told by its content, and
// what becomes of the light when it is written as another file.
#include "calc/photometry/photometry_file.h"

#include "calc/photometry/write_eulumdat.h"
#include "calc/photometry/write_lm63.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

namespace {

using Writer = std::optional<std::string> (*)(const calc::PhotometricWeb&, const std::string&,
                                              calc::Diagnostics&);

// What our own writers write, our readers read.
void check_written(const calc::PhotometricWeb& web, Writer write) {
  calc::Diagnostics diagnostics;
  const std::optional<std::string> text = write(web, "b", diagnostics);
  fuzz::check_messages(text.has_value(), diagnostics);
  if (!text) return;
  const auto again = calc::parse_photometry(*text, "b", diagnostics);
  fuzz::require(again.has_value(), "a written file can be read");
  fuzz::check_web(*again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto web = calc::parse_photometry(fuzz::as_text(data, size), "a", diagnostics);
  fuzz::check_messages(web.has_value(), diagnostics);
  if (!web) return 0;
  fuzz::check_web(*web);
  check_written(*web, calc::write_lm63);
  check_written(*web, calc::write_eulumdat);
  return 0;
}
