#pragma once
// What a report says once of numbers of standards that rest on one public source.

#include "calc/base/message.h"
#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// Returns "Numbers of 3 rows rest on one public source: EN 12464-1:2021 34.2, 36.1, 9.1. Compare
// them with your copy of the standard.", with at most kMostOneSourceRows rows; "" without rows.
// rows: as of Totals. The words are printable().
inline constexpr std::size_t kMostOneSourceRows = 12;
std::string one_source_note(const Texts& t, const std::vector<calc::Message>& rows);

// Adds the same as a warning, where there are rows: for those who want it to count and name its id
// (--strict=one-source). All others have the note alone. path: of the project.
void warn_of_one_source(const std::vector<calc::Message>& rows, const std::string& path,
                        std::vector<calc::Diagnostic>& diagnostics);
void warn_of_one_source(ProjectPart& project);

}  // namespace report
