#include "report/tools/check/store_words.h"

#include "report/shell/print.h"

namespace cli {

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

}  // namespace cli
