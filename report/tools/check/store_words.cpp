#include "report/tools/check/store_words.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/radiosity/looks/solve.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

namespace cli {

bool lacks_light(const report::PlanePart& plane) {
  return says(plane.reason, calc::Sentence::not_in_store) ||
         says(plane.reason, calc::Sentence::too_large_for_store);
}

void print_troubles(const std::string& folder, const calc::StoreTroubles& troubles) {
  calc::Diagnostics diagnostics;
  if (troubles.unusable > 0) {
    diagnostics.report(calc::DiagnosticId::store_entry_unusable, {folder, 0, 0}, troubles.unusable,
                       troubles.unusable_why);
  }
  if (!troubles.not_written.empty()) {
    diagnostics.report(calc::DiagnosticId::store_not_written, {folder, 0, 0}, troubles.not_written);
  }
  print_diagnostics(diagnostics.all(), false);
}

bool is_light_kept_or_print(const std::string& folder, const calc::StoreTroubles& troubles) {
  if (troubles.not_written.empty()) return true;
  print_error(calc::DiagnosticId::output_not_possible,
              fmt::format("light is not in the result cache '{}', because it cannot be written: {}",
                          folder, troubles.not_written));
  return false;
}

}  // namespace cli
