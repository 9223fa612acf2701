#pragma once
// What a format says, for tests that look for words in every one of them.

#include "calc/photometry/read/zip_archive.h"
#include "report/formats/format.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

// The text of all files of a workbook that hold cells.
inline std::string unpacked_sheets(const std::string& xlsx) {
  calc::Diagnostics diagnostics;
  auto archive = calc::ZipArchive::open(xlsx, "x.xlsx", diagnostics);
  if (!archive) return "no intact ZIP archive";
  std::string text;
  for (const std::string& name : archive->names()) {
    if (name.starts_with("xl/worksheets/")) text += archive->read(name).value_or("damaged");
  }
  return text;
}

// The words of a drawing: values of its groups 1, a blank between them, as its broken lines are
// read.
inline std::string words_of_drawing(std::string_view dxf) {
  constexpr std::string_view kEnd = "\r\n";
  std::string text;
  bool is_value = false, is_text = false;
  while (!dxf.empty()) {
    const std::size_t end = dxf.find(kEnd);
    const std::string_view line = dxf.substr(0, end);
    if (is_value && is_text) text.append(text.empty() ? "" : " ").append(line);
    if (!is_value) is_text = line == "  1";
    is_value = !is_value;
    dxf.remove_prefix(end == std::string_view::npos ? dxf.size() : end + kEnd.size());
  }
  return text;
}

// Of single points or luminaires: no verdict, and no warning.
inline bool is_table(const Format& format) {
  return format.name == "points-csv" || format.name == "luminaires-csv";
}

// Of a document, in English.
inline std::string legible(const Format& format, const Document& document) {
  const std::string bytes = format.render(document, {});
  if (format.name == "dxf") return words_of_drawing(bytes);
  return format.name == "xlsx" ? unpacked_sheets(bytes) : bytes;
}

}  // namespace report
