#include "report/shell/csv_cells.h"

#include "calc/base/text.h"

#include <cstddef>

namespace cli {

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') {
      if (is_quoted && k + 1 < line.size() && line[k + 1] == '"') {
        cells.back() += line[++k];
      } else {
        is_quoted = !is_quoted;
      }
    } else if (line[k] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[k];
    }
  }
  for (std::string& cell : cells) cell = std::string(calc::trim(cell));
  return cells;
}

}  // namespace cli
