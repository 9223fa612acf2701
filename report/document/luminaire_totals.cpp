#include "report/document/luminaire_totals.h"

namespace report {

LuminaireTotals totals_of(const std::vector<LuminaireRow>& luminaires) {
  LuminaireTotals totals;
  for (const LuminaireRow& row : luminaires) {
    totals.count += row.count;
    totals.flux_lm += row.count * row.flux_lm;
    totals.power_w += row.count * row.power_w;
    if (row.count > 0 && !(row.power_w > 0.0)) totals.is_power_known = false;
  }
  return totals;
}

std::string position_letter(std::size_t row) {
  constexpr std::size_t kLetters = 26;
  std::string name;
  for (++row; row > 0; row = (row - 1) / kLetters)
    name.insert(name.begin(), static_cast<char>('A' + (row - 1) % kLetters));
  return name;
}

}  // namespace report
