#include "calc/base/budget.h"

#include "calc/base/diagnostic_ids.h"

#include <fmt/format.h>

namespace calc {
namespace {

bool is_of_bytes(BudgetOf of) { return of == BudgetOf::memory || of == BudgetOf::output; }

std::string_view words_of(BudgetOf of) {
  switch (of) {
    case BudgetOf::objects:
      return "objects and luminaires";
    case BudgetOf::triangles:
      return "triangles";
    case BudgetOf::points:
      return "calculation points";
    case BudgetOf::memory:
      return "of memory";
    case BudgetOf::output:
      break;
  }
  return "in a file";
}

}  // namespace

std::string budget_text(BudgetOf of, double amount) {
  if (!is_of_bytes(of)) return fmt::format("{:.0f}", amount);
  constexpr double kKiB = 1 << 10, kMiB = 1 << 20, kGiB = 1 << 30;
  if (amount < kKiB) return fmt::format("{:.0f} byte{}", amount, amount == 1.0 ? "" : "s");
  if (amount < kMiB) return fmt::format("{:.4g} KiB", amount / kKiB);
  return amount < kGiB ? fmt::format("{:.4g} MiB", amount / kMiB)
                       : fmt::format("{:.4g} GiB", amount / kGiB);
}

void report_beyond(Diagnostics& diagnostics, const SourceLocation& where, std::string_view what,
                   BudgetOf of, double amount, const Budget& budget) {
  diagnostics.report(DiagnosticId::beyond_limit, where, what, budget_text(of, amount), words_of(of),
                     budget_text(of, budget[of]), name_of(of));
}

}  // namespace calc
