#include "tests/validation/open_tables.h"

#include "calc/base/csv.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace validation {

namespace {

std::vector<Row> read_table(const std::string& path, const calc::FileReader& files) {
  const calc::FileContent content = files.read(path);
  if (!content.ok()) throw BadTable(fmt::format("cannot read '{}': {}", path, content.error));
  calc::CsvReader table(content.bytes);
  const std::optional<calc::CsvRecord> header = table.next();
  std::vector<Row> rows;
  while (const std::optional<calc::CsvRecord> record = table.next()) {
    if (record->is_blank()) continue;
    if (record->cells.size() != header->cells.size()) {
      throw BadTable(fmt::format("'{}': line {} has {} values for {} names", path, record->line,
                                 record->cells.size(), header->cells.size()));
    }
    Row& row = rows.emplace_back();
    for (std::size_t c = 0; c < record->cells.size(); ++c) {
      row[header->cells[c].text] = record->cells[c].text;
    }
  }
  if (table.problem()) throw BadTable(fmt::format("'{}': {}", path, table.problem()->what));
  return rows;
}

}  // namespace

Tables read_tables(const std::string& folder, const calc::FileReader& files) {
  return {read_table(folder + "/cases.csv", files),
          read_table(folder + "/points.csv", files),
          read_table(folder + "/scalars.csv", files),
          read_table(folder + "/surfaces.csv", files),
          read_table(folder + "/luminaires.csv", files),
          folder,
          files};
}

std::vector<Row> rows_of(const std::vector<Row>& rows, const std::string& id) {
  std::vector<Row> chosen;
  for (const Row& row : rows) {
    if (row.at("case_id") == id) chosen.push_back(row);
  }
  return chosen;
}

double number(const Row& row, const std::string& name) {
  const auto found = row.find(name);
  const std::optional<double> value =
      found == row.end() ? std::nullopt : calc::parse_number(found->second);
  if (!value) throw BadTable(fmt::format("column '{}' of a table has no number", name));
  return *value;
}

glm::dvec3 vector(std::string_view text) {
  const std::vector<std::string_view> words = calc::split_words(text);
  if (words.size() != 3) throw BadTable("three numbers are needed: " + std::string(text));
  glm::dvec3 v;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> value = calc::parse_number(words[static_cast<std::size_t>(k)]);
    if (!value) throw BadTable("no number: " + std::string(text));
    v[k] = *value;
  }
  return v;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = std::string(calc::trim(part));
  return parts;
}

std::string part_named(const std::string& text, const std::string& name) {
  for (const std::string& part : split(text, ';')) {
    if (part.substr(0, part.find(' ')) == name) return part.substr(part.find(' ') + 1);
  }
  throw BadTable("no '" + name + "' in: " + text);
}

}  // namespace validation
