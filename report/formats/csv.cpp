#include "report/formats/csv.h"

#include "report/formats/table.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace report {
namespace {

void add_field(const TableCell& cell, std::string& csv) {
  if (const auto* text = std::get_if<std::string>(&cell)) csv += csv_field(*text);
  if (const auto* number = std::get_if<TableNumber>(&cell)) csv += format_shortest(number->value);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) csv += fmt::format("{}", *count);
}

// One line of those columns that a CSV file has; add: appends the column of that place.
template <class Add>
void add_line(std::span<const TableColumn> columns, std::string& csv, Add add) {
  bool is_first = true;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].is_in_csv) continue;
    if (!is_first) csv += ',';
    is_first = false;
    add(i);
  }
  csv += "\r\n";
}

class TableCsvWriter : public FormatWriter {
 public:
  TableCsvWriter(const DocumentTable& table, const SpillPlace& place) : table_(table), csv_(place) {
    std::string line;
    add_line(table_.columns, line, [&](std::size_t i) { line += table_.columns[i].name; });
    csv_.write(line);
  }

  void add(const ProjectPart& project) override {
    constexpr std::size_t kTogether = std::size_t{1} << 16;
    std::string lines;
    table_.rows(project, [&](std::span<const TableCell> row) {
      add_row(row, lines);
      if (lines.size() < kTogether) return;
      csv_.write(lines);
      lines.clear();
    });
    csv_.write(lines);
  }
  void finish(const DocumentEnd& /*end*/, Sink& sink) override { csv_.copy_to(sink); }

 protected:
  void add_row(std::span<const TableCell> row, std::string& csv) const {
    add_line(table_.columns, csv, [&](std::size_t i) { add_field(row[i], csv); });
  }

 private:
  const DocumentTable& table_;
  Spill csv_;
};

class ResultsCsvWriter : public TableCsvWriter {
 public:
  ResultsCsvWriter(const DocumentFrame& frame, const SpillPlace& place)
      : TableCsvWriter(results_table(), place), frame_(frame) {}

  void finish(const DocumentEnd& end, Sink& sink) override {
    TableCsvWriter::finish(end, sink);
    std::string lines;
    const auto visit = [&](std::span<const TableCell> row) { add_row(row, lines); };
    result_of_one_source(end, visit);
    results_of_errors({}, end, visit);
    if (frame_.revised != nullptr) results_of_revision({}, *frame_.revised, visit);
    sink.write(lines);
  }

 private:
  const DocumentFrame& frame_;
};

}  // namespace

std::unique_ptr<FormatWriter> results_csv_writer(const DocumentFrame& frame,
                                                 const SpillPlace& place) {
  return std::make_unique<ResultsCsvWriter>(frame, place);
}

std::unique_ptr<FormatWriter> points_csv_writer(const DocumentFrame& /*frame*/,
                                                const SpillPlace& place) {
  return std::make_unique<TableCsvWriter>(points_table(), place);
}

std::unique_ptr<FormatWriter> luminaires_csv_writer(const DocumentFrame& /*frame*/,
                                                    const SpillPlace& place) {
  return std::make_unique<TableCsvWriter>(luminaires_table(), place);
}

}  // namespace report
