#include "report/formats/xlsx_workbook.h"

#include "report/text/number_format.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace report {
namespace {

constexpr std::string_view kXmlHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
constexpr std::string_view kMainSpace = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
constexpr std::string_view kOfficeSpace =
    "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
constexpr std::string_view kPackageSpace =
    "http://schemas.openxmlformats.org/package/2006/relationships";

// --- styles: numbers of rows of cellXfs
// -----------------------------------------------------------

constexpr int kMostShownDecimals = 9;
enum XlsxStyle : int {
  kPlainStyle,
  kWrappedStyle,
  kHeadStyle,
  kLabelStyle,
  kTitleStyle,
  kQuotedStyle,  // editing the cell does not turn the text into a formula either
  kQuotedWrappedStyle,
  kNameStyle,  // heads of columns for programs
  kFirstFixedStyle,
  kFirstPercentStyle = kFirstFixedStyle + kMostShownDecimals + 1,
};
constexpr int kFirstNumberFormat = 164;  // those below are the program's own

int style_of(TextLook look, bool is_quoted) {
  switch (look) {
    case TextLook::head:
      return kHeadStyle;
    case TextLook::label:
      return kLabelStyle;
    case TextLook::title:
      return kTitleStyle;
    case TextLook::wrapped:
      return is_quoted ? kQuotedWrappedStyle : kWrappedStyle;
    case TextLook::plain:
      break;
  }
  return is_quoted ? kQuotedStyle : kPlainStyle;
}

struct VerdictColour {
  std::string_view text, fill;  // colours: RRGGBB
};
// In the order of CellColour; the last one is of what does not count.
constexpr std::array kColours{VerdictColour{"006100", "C6EFCE"}, VerdictColour{"9C0006", "FFC7CE"},
                              VerdictColour{"7F6000", "FFEB9C"}, VerdictColour{"5B2C83", "E4D7F1"},
                              VerdictColour{"7F7F7F", "FFFFFF"}};

std::string styles_xml() {
  std::string formats, fixed, percent, colours;
  const auto style = [](int format) {
    return fmt::format(
        "<xf numFmtId=\"{}\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" "
        "applyNumberFormat=\"1\" applyAlignment=\"1\"><alignment vertical=\"top\"/></xf>",
        format);
  };
  for (int d = 0; d <= kMostShownDecimals; ++d) {
    const std::string digits = d == 0 ? "0" : "0." + std::string(static_cast<std::size_t>(d), '0');
    const int number = kFirstNumberFormat + d, share = number + kMostShownDecimals + 1;
    formats += fmt::format("<numFmt numFmtId=\"{}\" formatCode=\"{}\"/>", number, digits);
    formats += fmt::format("<numFmt numFmtId=\"{}\" formatCode=\"+{}%;-{}%;{}%\"/>", share, digits,
                           digits, digits);
    fixed += style(number);
    percent += style(share);
  }
  for (const VerdictColour& colour : kColours) {
    colours += fmt::format(
        "<dxf><font><color rgb=\"FF{}\"/></font><fill><patternFill><bgColor "
        "rgb=\"FF{}\"/></patternFill></fill></dxf>",
        colour.text, colour.fill);
  }
  const auto text_style = [](int font, int fill, bool wraps, bool is_quoted) {
    return fmt::format(
        "<xf numFmtId=\"0\" fontId=\"{}\" fillId=\"{}\" borderId=\"0\" xfId=\"0\"{} "
        "applyFont=\"1\" applyFill=\"1\" applyAlignment=\"1\"><alignment "
        "vertical=\"top\"{}/></xf>",
        font, fill, is_quoted ? " quotePrefix=\"1\"" : "",
        wraps ? " horizontal=\"left\" wrapText=\"1\"" : "");
  };
  // In the order of XlsxStyle.
  const std::string styles = text_style(0, 0, false, false) + text_style(0, 0, true, false) +
                             text_style(1, 2, true, false) + text_style(1, 0, true, false) +
                             text_style(2, 0, false, false) + text_style(0, 0, false, true) +
                             text_style(0, 0, true, true) + text_style(3, 2, true, false) + fixed +
                             percent;
  const auto font = [](int size, bool is_bold, std::string_view colour = "") {
    return fmt::format(
        "<font>{}<sz val=\"{}\"/>{}<name val=\"Calibri\"/><family val=\"2\"/></font>",
        is_bold ? "<b/>" : "", size, colour);
  };
  const int numbers = 2 * (kMostShownDecimals + 1);
  return fmt::format(
      "{}<styleSheet xmlns=\"{}\"><numFmts count=\"{}\">{}</numFmts>"
      "<fonts count=\"4\">{}{}{}{}</fonts>"
      "<fills count=\"3\"><fill><patternFill patternType=\"none\"/></fill>"
      "<fill><patternFill patternType=\"gray125\"/></fill>"
      "<fill><patternFill patternType=\"solid\"><fgColor rgb=\"FFE7E6E6\"/><bgColor "
      "indexed=\"64\"/></patternFill></fill></fills>"
      "<borders count=\"1\"><border><left/><right/><top/><bottom/><diagonal/></border></borders>"
      "<cellStyleXfs count=\"1\"><xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" "
      "borderId=\"0\"/></cellStyleXfs>"
      "<cellXfs count=\"{}\">{}</cellXfs>"
      "<cellStyles count=\"1\"><cellStyle name=\"Normal\" xfId=\"0\" "
      "builtinId=\"0\"/></cellStyles>"
      "<dxfs count=\"{}\">{}</dxfs></styleSheet>\n",
      kXmlHead, kMainSpace, numbers, formats, font(11, false), font(11, true), font(14, true),
      font(11, false, "<color rgb=\"FF7F7F7F\"/>"), static_cast<int>(kFirstFixedStyle) + numbers,
      styles, kColours.size(), colours);
}

// --- texts ---------------------------------------------------------------------------------------

// "A", "B", ..., "AA"
std::string column_letters(std::size_t column) {
  std::string letters;
  for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
  return letters;
}

// A spreadsheet counts in units of UTF-16.
std::size_t utf16_units(std::string_view character) { return character.size() == 4 ? 2 : 1; }

// At most so many as a cell may have, and then with the mark at its end.
std::string cut_to_cell(std::string text, std::string_view mark, bool& is_cut) {
  is_cut = false;
  if (text.size() <= kMostCellCharacters) return text;  // bytes are never fewer
  std::size_t units = 0, end_of_short = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    const std::size_t length = std::max<std::size_t>(calc::first_character(rest).length, 1);
    units += utf16_units(rest.substr(0, length));
    at += length;
    if (units <= kMostCellCharacters - mark.size()) end_of_short = at;
  }
  if (units <= kMostCellCharacters) return text;
  is_cut = true;
  text.resize(end_of_short);
  return text.append(mark);
}

bool is_hex(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

// "_x000D_" would be read as a line end.
bool looks_like_escape(std::string_view text) {
  return text.size() >= 7 && text.starts_with("_x") && text[6] == '_' &&
         std::all_of(text.begin() + 2, text.begin() + 6, is_hex);
}

// text: printable.
std::string xlsx_text(std::string_view text) {
  std::string xml;
  xml.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (looks_like_escape(text.substr(i))) xml += "_x005F";
    switch (text[i]) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += text[i];
    }
  }
  return xml;
}

bool begins_like_a_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
}

// Words break earlier than at the last character of a line.
std::size_t estimated_lines(std::string_view text, int width) {
  const auto in_line = static_cast<std::size_t>(std::max(width * 9 / 10, 1));
  return 1 + text.size() / in_line;
}

// Of the head and foot of a page, where "&" begins a command.
std::string page_words(std::string_view text) {
  constexpr std::size_t kMost = 90;  // both together have room for 255
  std::string words;
  std::size_t count = 0;
  for (std::string_view left = text; !left.empty() && count < kMost; ++count) {
    const std::size_t length = std::max<std::size_t>(calc::first_character(left).length, 1);
    words += left.front() == '&' ? std::string_view("&&") : left.substr(0, length);
    left.remove_prefix(length);
  }
  return words;
}

// In a formula, between quotes.
std::string formula_text(std::string_view text) {
  std::string quoted;
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return "\"" + quoted + "\"";
}

}  // namespace

SheetSeries::SheetSeries(std::string name, std::vector<SheetColumn> columns,
                         const WorkbookLook& look, const SpillPlace& place, std::size_t most_rows,
                         SheetHead head, const SheetPage& page)
    : name_(std::move(name)),
      columns_(std::move(columns)),
      look_(look),
      place_(place),
      most_rows_(most_rows),
      has_head_(head == SheetHead::with),
      page_(page),
      last_texts_(columns_.size()) {
  if (most_rows_ < 2 || most_rows_ > kMostSheetRows)
    throw std::logic_error("a sheet of so many rows is not possible");
  for (std::size_t i = 0; i < columns_.size(); ++i) letters_.push_back(column_letters(i));
  begin_part();
}

std::size_t SheetSeries::printed_columns() const {
  const auto first = std::find_if(columns_.begin(), columns_.end(),
                                  [](const SheetColumn& column) { return !column.is_printed; });
  return static_cast<std::size_t>(first - columns_.begin());
}

void SheetSeries::begin_part() {
  if (!parts_.empty()) end_part();
  const std::string number = parts_.empty() ? "" : fmt::format(" {}", parts_.size() + 1);
  Part& part = parts_.emplace_back();
  part.name = name_ + number;
  part.file = std::make_unique<PackedFile>(place_);
  std::string widths, frozen;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    widths += fmt::format("<col min=\"{}\" max=\"{}\" width=\"{}\" customWidth=\"1\"/>", i + 1,
                          i + 1, columns_[i].width);
  }
  if (has_head_) {
    const auto columns = static_cast<std::size_t>(page_.frozen_columns);
    const std::string_view pane = columns > 0 ? "bottomRight" : "bottomLeft";
    frozen = fmt::format(
        "<pane {}ySplit=\"1\" topLeftCell=\"{}2\" activePane=\"{}\" state=\"frozen\"/><selection "
        "pane=\"{}\"/>",
        columns > 0 ? fmt::format("xSplit=\"{}\" ", columns) : "", column_letters(columns), pane,
        pane);
  }
  part.file->write(
      fmt::format("{}<worksheet xmlns=\"{}\"><sheetPr><pageSetUpPr fitToPage=\"1\"/></sheetPr>"
                  "<sheetViews><sheetView workbookViewId=\"0\">{}</sheetView></sheetViews>"
                  "<sheetFormatPr defaultRowHeight=\"15\"/><cols>{}</cols><sheetData>",
                  kXmlHead, kMainSpace, frozen, widths));
  if (has_head_) add_head();
}

void SheetSeries::add_head() {
  parts_.back().head_row = parts_.back().rows + 1;
  begin_row();
  for (std::size_t i = 0; i < columns_.size(); ++i)
    add_cell(i, columns_[i].heading, TextLook::head, columns_[i].width);
  end_row();
}

// counts: the cell of the first row that says whether a verdict counts; "" = there is none.
std::string SheetSeries::colours(std::size_t column, std::size_t first, std::size_t last,
                                 std::string_view counts) const {
  std::string rules;
  int priority = 1;
  if (!counts.empty() && !look_.uncounted.empty()) {
    std::string any;
    for (const std::string& words : look_.uncounted)
      any += fmt::format("{}${}={}", any.empty() ? "" : ",", counts, formula_text(words));
    rules = fmt::format(
        "<cfRule type=\"expression\" dxfId=\"{}\" priority=\"{}\" "
        "stopIfTrue=\"1\"><formula>OR({})</formula></cfRule>",
        kColours.size() - 1, priority++, xlsx_text(any));
  }
  for (const auto& [word, colour] : look_.words) {
    rules += fmt::format(
        "<cfRule type=\"cellIs\" dxfId=\"{}\" priority=\"{}\" "
        "operator=\"equal\"><formula>{}</formula></cfRule>",
        static_cast<int>(colour), priority++, xlsx_text(formula_text(word)));
  }
  return fmt::format("<conditionalFormatting sqref=\"{0}{1}:{0}{2}\">{3}</conditionalFormatting>",
                     letters_[column], first, last, rules);
}

std::string SheetSeries::page_xml() const {
  constexpr int kLetter = 1, kA4 = 9;
  const std::string head = title_.empty() ? "" : "&L" + page_words(title_) + "&R&A";
  return fmt::format(
      "<pageMargins left=\"0.4\" right=\"0.4\" top=\"0.7\" bottom=\"0.6\" header=\"0.3\" "
      "footer=\"0.3\"/><pageSetup paperSize=\"{}\" orientation=\"{}\" fitToHeight=\"0\"/>"
      "<headerFooter><oddHeader>{}</oddHeader><oddFooter>&amp;Lluxgate&amp;R&amp;P / "
      "&amp;N</oddFooter></headerFooter></worksheet>\n",
      look_.is_letter ? kLetter : kA4, page_.is_portrait ? "portrait" : "landscape",
      xlsx_text(printable(head)));
}

void SheetSeries::end_part() {
  const Part& part = parts_.back();
  const std::size_t last = std::max<std::size_t>(part.rows, 1);
  std::string xml = "</sheetData>";
  if (has_head_)
    xml += fmt::format("<autoFilter ref=\"A1:{}{}\"/>", column_letters(columns_.size() - 1), last);
  if (!part.merged.empty()) {
    xml += fmt::format("<mergeCells count=\"{}\">", part.merged.size());
    for (const std::string& range : part.merged) xml += "<mergeCell ref=\"" + range + "\"/>";
    xml += "</mergeCells>";
  }
  const std::size_t first = part.head_row + 1;
  std::string counts;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].role == ColumnRole::counts)
      counts = fmt::format("{}{}", column_letters(i), first);
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].role == ColumnRole::verdict && part.rows >= first)
      xml += colours(i, first, last, counts);
  }
  part.file->write(xml + page_xml());
  part.file->finish();
}

void SheetSeries::begin_row() {
  ++parts_.back().rows;
  row_.clear();
  lines_ = 1;
}

// Programs do not agree on whether they make a row as high as its text when they open a file.
void SheetSeries::end_row() {
  constexpr std::size_t kLine_pt = 15, kMost_pt = 405;
  std::string begin = fmt::format("<row r=\"{}\"", parts_.back().rows);
  if (lines_ > 1)
    begin += fmt::format(" ht=\"{}\" customHeight=\"1\"", std::min(lines_ * kLine_pt, kMost_pt));
  parts_.back().file->write(begin + ">" + row_ + "</row>");
}

void SheetSeries::add_cell(std::size_t column, const TableCell& cell, TextLook look, int width) {
  const auto begin = [&](int style, std::string_view more) {
    fmt::format_to(std::back_inserter(row_), "<c r=\"{}{}\" s=\"{}\"{}>", letters_[column],
                   parts_.back().rows, style, more);
  };
  if (const auto* text = std::get_if<std::string>(&cell); text != nullptr && !text->empty()) {
    LastText& last = last_texts_[column];
    if (last.text != *text || last.xml.empty()) {  // a column often repeats itself
      const std::string safe = cut_to_cell(printable(*text), look_.cut_mark, last.is_cut);
      last.text = *text;
      last.is_quoted = begins_like_a_formula(safe);
      last.xml = "<is><t xml:space=\"preserve\">" + xlsx_text(safe) + "</t></is></c>";
    }
    if (last.is_cut) ++cut_texts_;
    const bool is_name = look == TextLook::head && !columns_[column].is_printed;
    begin(is_name ? static_cast<int>(kNameStyle) : style_of(look, last.is_quoted),
          " t=\"inlineStr\"");
    row_ += last.xml;
    if (look != TextLook::plain && look != TextLook::title)
      lines_ = std::max(lines_, estimated_lines(*text, width));
  } else if (const auto* number = std::get_if<TableNumber>(&cell)) {
    if (!std::isfinite(number->value)) return;
    const int decimals =
        number->decimals == kOfColumn ? columns_[column].decimals : number->decimals;
    const int shown = std::min(decimals, kMostShownDecimals);
    begin(decimals == kOfColumn
              ? static_cast<int>(kPlainStyle)
              : (number->is_percent ? kFirstPercentStyle : kFirstFixedStyle) + shown,
          "");
    row_ += "<v>" + format_shortest(number->value) + "</v></c>";
  } else if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    begin(look == TextLook::wrapped ? kWrappedStyle : kPlainStyle, "");
    row_ += fmt::format("<v>{}</v></c>", *count);
  }
}

void SheetSeries::add(std::span<const TableCell> row) {
  add_row(row, [this](std::size_t i) {
    return columns_[i].is_wrapped ? TextLook::wrapped : TextLook::plain;
  });
}

void SheetSeries::add(std::span<const TableCell> row, TextLook look) {
  add_row(row, [look](std::size_t) { return look; });
}

void SheetSeries::add_pair(std::string_view label, const TableCell& value, TextLook look) {
  const TextLook of_label = look == TextLook::title ? look : TextLook::label;
  const std::size_t printed = printed_columns(), of_value = printed > 2 ? 2 : 1;
  if (parts_.back().rows == most_rows_) begin_part();
  begin_row();
  const auto width = [&](std::size_t from, std::size_t to) {
    int characters = 0;
    for (std::size_t i = from; i < to; ++i) characters += columns_[i].width;
    return characters;
  };
  add_cell(0, std::string(label), of_label, width(0, of_value));
  add_cell(of_value, value, look, width(of_value, printed));
  const std::size_t row = parts_.back().rows;
  const auto merge = [&](std::size_t from, std::size_t to) {
    if (to - from < 2) return;
    parts_.back().merged.push_back(
        fmt::format("{}{}:{}{}", letters_[from], row, letters_[to - 1], row));
  };
  if (look == TextLook::title) {
    merge(0, printed);
  } else {
    merge(0, of_value);
    merge(of_value, printed);
  }
  end_row();
  ++rows_;
}

template <class LookOf>
void SheetSeries::add_row(std::span<const TableCell> row, LookOf look_of) {
  if (row.size() != columns_.size()) throw std::logic_error("a row has as many cells as columns");
  if (parts_.back().rows == most_rows_) begin_part();
  begin_row();
  for (std::size_t i = 0; i < row.size(); ++i) add_cell(i, row[i], look_of(i), columns_[i].width);
  end_row();
  ++rows_;
}

namespace {

std::string relation(std::size_t id, std::string_view kind, std::string_view target) {
  return fmt::format("<Relationship Id=\"rId{}\" Type=\"{}\" Target=\"{}\"/>", id, kind, target);
}
std::string relations(const std::string& list) {
  return fmt::format("{}<Relationships xmlns=\"{}\">{}</Relationships>\n", kXmlHead, kPackageSpace,
                     list);
}

std::string core_xml(const WorkbookFacts& facts) {
  std::string created;
  if (!facts.created.empty()) {
    for (const char* name : {"created", "modified"})
      created += fmt::format("<dcterms:{} xsi:type=\"dcterms:W3CDTF\">{}</dcterms:{}>", name,
                             xlsx_text(facts.created), name);
  }
  return fmt::format(
      "{}<cp:coreProperties "
      "xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/metadata/core-properties\" "
      "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:dcterms=\"http://purl.org/dc/terms/\" "
      "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"><dc:title>{}</dc:title>"
      "<dc:creator>{}</dc:creator>{}</cp:coreProperties>\n",
      kXmlHead, xlsx_text(printable(facts.title)), xlsx_text(printable(facts.program)), created);
}

}  // namespace

void Workbook::write(const WorkbookFacts& facts, const SpillPlace& place, Sink& sink) {
  std::string types, sheets, names, links;
  std::vector<SheetSeries::Part*> parts;
  for (SheetSeries* series : series_) {
    series->end_part();
    for (SheetSeries::Part& part : series->parts_) {
      const std::size_t index = parts.size(), number = index + 1;
      parts.push_back(&part);
      types += fmt::format(
          "<Override PartName=\"/xl/worksheets/sheet{}.xml\" "
          "ContentType=\"application/"
          "vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/>",
          number);
      sheets += fmt::format("<sheet name=\"{}\" sheetId=\"{}\" r:id=\"rId{}\"/>",
                            xlsx_text(part.name), number, number);
      links += relation(number, fmt::format("{}/worksheet", kOfficeSpace),
                        fmt::format("worksheets/sheet{}.xml", number));
      const std::size_t rows = std::max<std::size_t>(part.rows, 1);
      const std::size_t printed = series->printed_columns();
      const auto add_name = [&](std::string_view name, std::string_view more, std::string range) {
        names += fmt::format(
            "<definedName name=\"_xlnm.{}\" localSheetId=\"{}\"{}>'{}'!{}</definedName>", name,
            index, more, xlsx_text(part.name), range);
      };
      if (series->has_head_) {
        add_name("_FilterDatabase", " hidden=\"1\"",
                 fmt::format("$A$1:${}${}", column_letters(series->columns_.size() - 1), rows));
      }
      if (printed < series->columns_.size()) {
        add_name("Print_Area", "", fmt::format("$A$1:${}${}", column_letters(printed - 1), rows));
      }
      if (part.head_row > 0) add_name("Print_Titles", "", fmt::format("${0}:${0}", part.head_row));
    }
  }
  links += relation(parts.size() + 1, fmt::format("{}/styles", kOfficeSpace), "styles.xml");

  ZipFile zip(sink);
  const auto add = [&](const char* name, const std::string& xml) {
    PackedFile file(place);
    file.write(xml);
    file.finish();
    zip.add(name, file);
  };
  add("[Content_Types].xml",
      fmt::format("{}<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
                  "<Default Extension=\"rels\" "
                  "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
                  "<Default Extension=\"xml\" ContentType=\"application/xml\"/>"
                  "<Override PartName=\"/xl/workbook.xml\" ContentType=\"application/"
                  "vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/>"
                  "<Override PartName=\"/xl/styles.xml\" ContentType=\"application/"
                  "vnd.openxmlformats-officedocument.spreadsheetml.styles+xml\"/>"
                  "<Override PartName=\"/docProps/core.xml\" "
                  "ContentType=\"application/vnd.openxmlformats-package.core-properties+xml\"/>{}</"
                  "Types>\n",
                  kXmlHead, types));
  add("_rels/.rels",
      relations(relation(1, fmt::format("{}/officeDocument", kOfficeSpace), "xl/workbook.xml") +
                relation(2,
                         "http://schemas.openxmlformats.org/package/2006/relationships/metadata/"
                         "core-properties",
                         "docProps/core.xml")));
  add("docProps/core.xml", core_xml(facts));
  add("xl/workbook.xml",
      fmt::format("{}<workbook xmlns=\"{}\" xmlns:r=\"{}\"><bookViews><workbookView/></bookViews>"
                  "<sheets>{}</sheets><definedNames>{}</definedNames></workbook>\n",
                  kXmlHead, kMainSpace, kOfficeSpace, sheets, names));
  add("xl/_rels/workbook.xml.rels", relations(links));
  add("xl/styles.xml", styles_xml());
  for (std::size_t i = 0; i < parts.size(); ++i)
    zip.add(fmt::format("xl/worksheets/sheet{}.xml", i + 1), *parts[i]->file);
  zip.finish();
}

}  // namespace report
