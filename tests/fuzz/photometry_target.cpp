// Any photometry file: the archive of GLDF byte by byte, how a format is told by its content, and
// what becomes of the light when it is written as another file.
#include "calc/photometry/read/photometry_file.h"

#include "calc/photometry/write/write_eulumdat.h"
#include "calc/photometry/write/write_lm63.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>

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
  fuzz::require_no_error(diagnostics, "a written file can be read");
  fuzz::check_web(*again);
  // Tables about another axis are resampled, and a warning states what that changes.
  if (web.axis() != calc::TableAxis::vertical) return;
  fuzz::require(std::abs(again->flux_lm() - web.flux_lm()) <= 1e-4 * web.flux_lm(),
                "a written file has the same flux");
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
