#include "report/text/folded_warnings.h"

#include "report/text/plain_text.h"

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <string_view>

namespace report {
namespace {

bool may_be_folded(const ProjectPart& project, const calc::Diagnostic& diagnostic) {
  return is_warning(diagnostic) && !is_strict_warning(project, diagnostic);
}

std::string line_of(calc::Diagnostic first, std::size_t count, int columns) {
  constexpr std::size_t kShortPath = 24;  // columns
  first.message = fmt::format("{} times, first: {}", count, first.message);
  const std::string line = calc::format_diagnostic(first);
  const auto width = static_cast<std::size_t>(columns);
  if (columns <= 0 || display_width(line) <= width) return line;
  first.where.file = shorten_start(first.where.file, kShortPath);
  return shorten_end(calc::format_diagnostic(first), width);
}

}  // namespace

std::vector<std::string> folded_warnings(const ProjectPart& project, int columns) {
  std::map<calc::DiagnosticId, std::size_t> count;
  std::size_t warnings = 0;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    if (!may_be_folded(project, diagnostic)) continue;
    ++count[diagnostic.id];
    ++warnings;
  }
  std::vector<std::string> lines;
  std::map<calc::DiagnosticId, bool> is_told;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    const std::size_t times = may_be_folded(project, diagnostic) ? count[diagnostic.id] : 1;
    if (times > 1 && is_told[diagnostic.id]) continue;
    is_told[diagnostic.id] = true;
    lines.push_back(times > 1 ? line_of(diagnostic, times, columns)
                              : calc::format_diagnostic(diagnostic));
  }
  if (lines.size() < project.diagnostics.size()) {
    lines.push_back(fmt::format("luxgate: {} warnings of {} kinds; --notes shows each of them",
                                warnings, count.size()));
  }
  return lines;
}

}  // namespace report
