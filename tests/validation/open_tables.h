#pragma once
// The tables of the open validation cases, as they are read.

#include "calc/base/file_reader.h"

#include <glm/glm.hpp>

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace validation {

using Row = std::map<std::string, std::string>;

// A table that cannot be read ends the list: nothing is guessed.
struct BadTable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What the program has no word for.
struct NotCovered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Tables {
  std::vector<Row> cases, points, scalars, surfaces, luminaires;
  std::string folder;
  const calc::FileReader& files;
};
// BadTable if one cannot be read.
Tables read_tables(const std::string& folder, const calc::FileReader& files);

std::vector<Row> rows_of(const std::vector<Row>& rows, const std::string& id);

// BadTable if it is none.
double number(const Row& row, const std::string& name);
glm::dvec3 vector(std::string_view text);                          // three numbers
std::vector<std::string> split(const std::string& text, char at);  // parts, trimmed
// Of the words after `name` in "name words; name words".
std::string part_named(const std::string& text, const std::string& name);

}  // namespace validation
