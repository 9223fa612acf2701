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
#include <utility>
#include <vector>

namespace report {

inline constexpr std::size_t kMostSheetRows =
    1'048'576;  // of every spreadsheet, the head with them
inline constexpr std::size_t kMostCellCharacters = 32'767;  // UTF-16 units

// Cells of `verdict` get a colour by their word, but where the row's cell of `counts` has a word
// that says that it does not count.
enum class ColumnRole { other, verdict, counts };

struct SheetColumn {
  std::string heading;
  int width = 10;            // characters
  int decimals = kOfColumn;  // of numbers that do not say it
  bool is_wrapped = false;   // long texts: in several lines
  ColumnRole role = ColumnRole::other;
  bool is_printed = true;  // false: for programs. Such columns come last, and are not on paper
};

// The first row: it stays in sight, and filters the others.
enum class SheetHead { with, without };

enum class TextLook { plain, wrapped, head, label, title };

enum class CellColour { good, bad, unsure, unjudged };

// What all sheets of a workbook have in common.
struct WorkbookLook {
  bool is_letter = false;                                 // paper; else A4
  std::vector<std::pair<std::string, CellColour>> words;  // of verdicts, in the reader's language;
                                                          // one without a colour is never good
  std::vector<std::string> uncounted;                     // words of `counts`
  std::string cut_mark;  // at the end of a text that is longer than a cell may be; short
};

// How a sheet is printed: all columns that are printed on one page width, whatever that takes.
struct SheetPage {
  bool is_portrait = false;
  int frozen_columns = 0;  // that stay in sight, as the head does
};

// Rows of one kind; beyond `most_rows` they go on in a sheet "NAME 2", which has the same head.
class SheetSeries {
 public:
  // name: up to 25 letters. most_rows: of one sheet, >= 2. look: outlives it.
  SheetSeries(std::string name, std::vector<SheetColumn> columns, const WorkbookLook& look,
              const SpillPlace& place, std::size_t most_rows = kMostSheetRows,
              SheetHead head = SheetHead::with, const SheetPage& page = {});

  // As many cells as columns. Texts are made safe, and never taken for a formula. Throws
  // WriteFailure.
  void add(std::span<const TableCell> row);
  void add(std::span<const TableCell> row, TextLook look);  // of all its texts
  // The same of a sheet without a head: a label in the first column (two, where there are more than
  // two), and its value in all others that are printed.
  void add_pair(std::string_view label, const TableCell& value, TextLook look = TextLook::wrapped);
  // The head of a table in a sheet without a head: on every page from here on.
  void add_head();
  // At the top of its pages; before the first row. "" = nothing.
  void set_title(std::string title) { title_ = std::move(title); }

  std::size_t rows() const { return rows_; }  // all sheets together, without heads
  std::size_t sheets() const { return parts_.size(); }
  std::size_t cut_texts() const { return cut_texts_; }  // that were longer than a cell may be
  const std::string& name() const { return name_; }

 private:
  friend class Workbook;
  struct Part {
    std::string name;
    std::unique_ptr<PackedFile> file;
    std::size_t rows = 0;                  // with the head
    std::size_t head_row = 0;              // from 1; 0: none
    std::vector<std::string> merged = {};  // ranges
  };

  void begin_part();
  void end_part();
  template <class LookOf>
  void add_row(std::span<const TableCell> row, LookOf look_of);
  void begin_row();
  void end_row();
  // width: of the cell, characters.
  void add_cell(std::size_t column, const TableCell& cell, TextLook look, int width);
  std::size_t printed_columns() const;
  std::string colours(std::size_t column, std::size_t first, std::size_t last,
                      std::string_view counts) const;
  std::string page_xml() const;

  std::string name_, title_;
  std::vector<SheetColumn> columns_;
  const WorkbookLook& look_;
  SpillPlace place_;
  std::size_t most_rows_;
  bool has_head_;
  SheetPage page_;
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
