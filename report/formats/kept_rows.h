#pragma once
// Rows of a table that wait for the last project, as bytes: cells in memory take five times as
// much.

#include "report/formats/table.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace report {

class KeptRows {
 public:
  // All rows have the same number of cells.
  void add(std::span<const TableCell> row);
  // Returns whether some row has something in the column.
  bool is_used(std::size_t column) const { return column < is_used_.size() && is_used_[column]; }
  // Calls visit for each row, in order.
  void for_each(const std::function<void(std::vector<TableCell>)>& visit) const;

 private:
  std::string bytes_;
  std::vector<bool> is_used_;  // [column]
};

}  // namespace report
