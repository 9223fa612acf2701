#pragma once
// A workbook of Office Open XML (ISO/IEC 29500, .xlsx), sheet by sheet and row by row: nothing of
// it waits in memory. It knows nothing of light.

#include "report/formats/table.h"
#include "report/formats/xlsx_container.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace report {

inline constexpr std::size_t kMostSheetRows =
    1'048'576;  // of every spreadsheet, the head with them
inline constexpr std::size_t kMostCellCharacters = 32'767;  // UTF-16 units

// Verdicts get a colour beside their word, but where the row's cell of `counts` begins with "no".
enum class ColumnRole { other, verdict, counts };

struct SheetColumn {
  std::string heading;
  int width = 10;            // characters
  int decimals = kOfColumn;  // of numbers that do not say it
  bool is_wrapped = false;   // long texts: in several lines
  ColumnRole role = ColumnRole::other;
};

// The first row: it stays in sight, and filters the others.
enum class SheetHead { with, without };

enum class TextLook { plain, wrapped, head, label, title };

// Rows of one kind; beyond `most_rows` they go on in a sheet "NAME 2", which has the same head.
class SheetSeries {
 public:
  // name: up to 25 ASCII letters. most_rows: of one sheet, >= 2.
  SheetSeries(std::string name, std::vector<SheetColumn> columns, const SpillPlace& place,
              std::size_t most_rows = kMostSheetRows, SheetHead head = SheetHead::with);

  // As many cells as columns. Texts are made safe, and never taken for a formula. Throws
  // WriteFailure.
  void add(std::span<const TableCell> row);
  void add(std::span<const TableCell> row, TextLook look);  // of all its texts
  // The same of a sheet without a head: a label, and its value.
  void add_pair(std::string_view label, const TableCell& value, TextLook look = TextLook::wrapped);

  std::size_t rows() const { return rows_; }  // all sheets together, without heads
  std::size_t sheets() const { return parts_.size(); }
  std::size_t cut_texts() const { return cut_texts_; }  // that were longer than a cell may be
  const std::string& name() const { return name_; }

 private:
  friend class Workbook;
  struct Part {
    std::string name;
    std::unique_ptr<PackedFile> file;
    std::size_t rows = 0;  // with the head
  };

  void begin_part();
  void end_part();
  template <class LookOf>
  void add_row(std::span<const TableCell> row, LookOf look_of);
  void begin_row();
  void end_row();
  void add_cell(std::size_t column, const TableCell& cell, TextLook look);

  std::string name_;
  std::vector<SheetColumn> columns_;
  SpillPlace place_;
  std::size_t most_rows_;
  bool has_head_;
  struct LastText {
    std::string text, xml;
    bool is_quoted = false, is_cut = false;
  };
  std::vector<LastText> last_texts_;  // of each column
  std::vector<std::string> letters_;
  std::deque<Part> parts_;
  std::string row_;        // that is being written
  std::size_t lines_ = 1;  // of text in the row that is being written
  std::size_t rows_ = 0, cut_texts_ = 0;
};

struct WorkbookFacts {
  std::string title, program;  // "luxgate 0.1.0"
  std::string created;         // "2027-01-31T12:00:00Z"; "" = nothing is said
};

// Ends the sheets and writes them all, in this order. Throws WriteFailure.
class Workbook {
 public:
  void add(SheetSeries& series) { series_.push_back(&series); }
  void write(const WorkbookFacts& facts, const SpillPlace& place, Sink& sink);

 private:
  std::vector<SheetSeries*> series_;
};

}  // namespace report
