#pragma once
// Aligned plain text.

#include <string>
#include <vector>

namespace bench {

// Prints a heading line, then rows with columns as wide as their widest cell, right-aligned but the
// first.
class Table {
 public:
  Table(std::string title, std::vector<std::string> heads);
  void add(std::vector<std::string> cells);
  void print() const;  // to stdout

 private:
  std::string title_;
  std::vector<std::vector<std::string>> rows_;
};

std::string percent(double share);  // 0.0123 -> "1.23"
std::string number(double value);   // 4 significant digits
std::string count(double value);    // no decimals

}  // namespace bench
