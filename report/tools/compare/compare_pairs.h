#pragma once
// Which value of B belongs to which point of A.

#include "report/tools/compare/comparison.h"
#include "report/tools/compare/value_table.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace cli {

class PointPairs {
 public:
  // quantity: of A's planes, by their ids. distance_m: points as near as this are the same. All
  // must outlive it.
  PointPairs(std::vector<report::ComparedPlane>& planes,
             const std::map<std::string, std::string>& quantity, double distance_m);

  // Gives the row's value to A's point there, the nearest of one plane. "", or why it cannot; a row
  // without any point counts as a stranger.
  std::string place(const TableRow& row);

  // Leaves only points that have a value of B, and planes with such points. Gives what either side
  // lacks, a sentence each. rows: how many were placed.
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
