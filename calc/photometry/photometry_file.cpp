#include "calc/photometry/photometry_file.h"

#include "calc/photometry/eulumdat.h"
#include "calc/photometry/ies_header.h"
#include "calc/photometry/ies_lm63.h"
#include "calc/photometry/line_cursor.h"
#include "calc/photometry/number_stream.h"
#include "calc/photometry/text_encoding.h"
#include "calc/text.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr char kDosEndOfFile = '\x1A';

// Type, symmetry and number of planes: three lines of one whole number each, at lines 2 to 4.
bool looks_like_eulumdat(std::string_view text) {
  LineCursor lines(text);
  lines.next();
  for (int i = 0; i < 3; ++i) {
    const std::optional<std::string_view> line = lines.next();
    if (!line) return false;
    const std::optional<double> value = parse_photometry_number(trim(*line));
    if (!value || *value != std::floor(*value)) return false;
  }
  return true;
}

std::string what_it_is(std::string_view text) {
  const std::string_view start = trim(text.substr(0, 200));
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return "the file is empty";
  if (start.starts_with("PK")) return "it is a ZIP archive (GLDF?)";
  if (start.starts_with('<')) return "it is XML (TM-33?)";
  return "no TILT= line, and lines 2 to 4 are not the three counts of EULUMDAT";
}

}  // namespace

std::optional<PhotometricWeb> parse_photometry(std::string_view bytes, const std::string& name,
                                               Diagnostics& diagnostics) {
  const SourceLocation file{name, 0, 0};
  if (looks_like_utf16(bytes)) {
    diagnostics.report(DiagnosticId::photometry_encoding, file);
    return std::nullopt;
  }
  std::string_view text = bytes;
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  if (const std::size_t end = text.find(kDosEndOfFile); end != std::string_view::npos) {
    diagnostics.report(DiagnosticId::photometry_end_mark, file, text.size() - end - 1);
    text = text.substr(0, end);
  }
  if (read_lm63_header(text)) return parse_lm63(text, name, diagnostics);
  if (trim(text.substr(0, 200)).starts_with("IES")) return parse_lm63(text, name, diagnostics);
  if (looks_like_eulumdat(text)) return parse_eulumdat(text, name, diagnostics);
  diagnostics.report(DiagnosticId::photometry_format, file, what_it_is(text));
  return std::nullopt;
}

}  // namespace calc
