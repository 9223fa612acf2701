#include "report/stream/sink.h"

#include "calc/base/budget.h"

#include <fmt/format.h>

namespace report {

void fail_beyond(double bytes, double most_bytes) {
  if (!(bytes > most_bytes)) return;
  constexpr calc::BudgetOf kOutput = calc::BudgetOf::output;
  throw WriteFailure(fmt::format("it would have more than {}, see --limit {}",
                                 calc::budget_text(kOutput, most_bytes), calc::name_of(kOutput)));
}

}  // namespace report
