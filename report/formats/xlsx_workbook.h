#pragma once
// A workbook of Office Open XML (ISO/IEC 29500, .xlsx), written sheet by sheet and row by row: none
// of it is held in memory. It does not depend on light.

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

// Cells of `verdict` are coloured by their word, unless the row's cell of `counts` says that it
// does not count.
enum class ColumnRole { other, verdict, counts };

struct SheetColumn {
  std::string heading;
  int width = 10;            // characters
  int decimals = kOfColumn;  // of numbers that do not say it
  bool is_wrapped = false;   // long texts: in several lines
  ColumnRole role = ColumnRole::other;
  bool is_printed = true;  // false: for programs. Such columns come last, and are not on paper
};

// The first row, which stays visible and filters the others.
enum class SheetHead { with, without };

enum class TextLook { plain, wrapped, head, label, title };

enum class CellColour { good, bad, unsure, unjudged };

// Settings shared by all sheets of a workbook.
struct WorkbookLook {
  bool is_letter = false;                                 // paper; else A4
  std::vector<std::pair<std::string, CellColour>> words;  // of verdicts, in the reader's language;
                                                          // one without a colour is never good
  std::vector<std::string> uncounted;                     // words of `counts`
  std::string cut_mark;  // at the end of a text that is longer than a cell may be; short
};

// The print settings of a sheet: all printed columns fit on the width of one page.
struct SheetPage {
  bool is_portrait = false;
  int frozen_columns = 0;  // that stay in sight, as the head does
};

// Rows of one kind; beyond `most_rows` they continue in a sheet "NAME 2" with the same head.
class SheetSeries {
 public:
  // name: up to 25 letters. most_rows: of one sheet, >= 2. look: must outlive this.
  SheetSeries(std::string name, std::vector<SheetColumn> columns, const WorkbookLook& look,
              const SpillPlace& place, std::size_t most_rows = kMostSheetRows,
              SheetHead head = SheetHead::with, const SheetPage& page = {});

  // Adds a row with as many cells as columns. Texts are made safe, and never become a formula.
  // Throws WriteFailure.
  void add(std::span<const TableCell> row);
  void add(std::span<const TableCell> row, TextLook look);  // of all its texts
  // Adds a row to a sheet without a head: a label in the first column (two, if there are more than
  // two), and its value in all others that are printed.
  void add_pair(std::string_view label, const TableCell& value, TextLook look = TextLook::wrapped);
  // Adds the head of a table in a sheet without a head; it is on every page from here on.
  void add_head();
  // Sets the title at the top of its pages; call it before the first row. "" = none.
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
  // Adds a cell. width: of the cell, in characters.
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
