#pragma once
// What a format says, for tests that look for words in every one of them.

#include "calc/photometry/read/zip_archive.h"
#include "report/formats/format.h"

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

// Of single points or luminaires: no verdict, and no warning.
inline bool is_table(const Format& format) {
  return format.name == "points-csv" || format.name == "luminaires-csv";
}

// Of a document, in English.
inline std::string legible(const Format& format, const Document& document) {
  const std::string bytes = format.render(document, {});
  return format.name == "xlsx" ? unpacked_sheets(bytes) : bytes;
}

}  // namespace report
