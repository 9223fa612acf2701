#pragma once
// Pairs values of B with points of A.

#include "report/tools/compare/comparison.h"
#include "report/tools/compare/value_table.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace cli {

class PointPairs {
 public:
  // quantity: of A's planes, by their ids. distance_m: points within this distance are the same.
  // All must outlive it.
  PointPairs(std::vector<report::ComparedPlane>& planes,
             const std::map<std::string, std::string>& quantity, double distance_m);

  // Gives the row's value to A's point there, the nearest of a single plane. Returns "", or why it
  // cannot; a row without a point is counted.
  std::string place(const TableRow& row);

  // Keeps only points with a value of B, and planes with such points. Returns a sentence for each
  // thing that either side lacks. rows: number of placed rows.
  std::vector<std::string> drop_unpaired(std::size_t rows);

 private:
  bool is_there(const TableRow& row, const report::ComparedPoint& point) const;

  std::vector<report::ComparedPlane>& planes_;
  const std::map<std::string, std::string>& quantity_;
  double distance_m_;
  std::vector<std::vector<bool>> has_b_;  // [plane][point]
  std::size_t strangers_ = 0;
  std::string first_stranger_;
};

}  // namespace cli
