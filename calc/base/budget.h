#pragma once
// Limits on what one project may take of the machine that reads it. The caller of a run sets them;
// no file can raise them. What exceeds a limit is refused before it is made, with an error of the
// project: none of it is judged, and other projects go on.

#include "calc/base/diagnostics.h"
#include "calc/base/names.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace calc {

enum class BudgetOf {
  objects,    // bodies and luminaires
  triangles,  // of all bodies
  points,     // of all planes, as their grids have them
  memory,     // bytes, as estimated from all of these
  output,     // bytes of one written file
};
inline constexpr std::size_t kBudgets = 5;

struct Budget {
  std::array<double, kBudgets> most{2.5e5, 1.0e7, 1.0e7, 8.0 * (1 << 30), 4.0 * (1 << 30)};

  double operator[](BudgetOf of) const { return most[static_cast<std::size_t>(of)]; }
  double& operator[](BudgetOf of) { return most[static_cast<std::size_t>(of)]; }
};

// Returns the amount as text: "10000000", for bytes "8 GiB".
std::string budget_text(BudgetOf of, double amount);

// Reports the error that the project, or the thing `what` names, has or would take this amount.
void report_beyond(Diagnostics& diagnostics, const SourceLocation& where, std::string_view what,
                   BudgetOf of, double amount, const Budget& budget);

template <>
struct EnumNames<BudgetOf> {
  static constexpr EnumName<BudgetOf> list[] = {{BudgetOf::objects, "objects"},
                                                {BudgetOf::triangles, "triangles"},
                                                {BudgetOf::points, "points"},
                                                {BudgetOf::memory, "memory"},
                                                {BudgetOf::output, "output"}};
};

}  // namespace calc
