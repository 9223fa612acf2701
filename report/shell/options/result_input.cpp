#include "report/shell/options/result_input.h"

#include "calc/base/diagnostic_ids.h"
#include "report/result_file/read_json.h"
#include "report/shell/process/print.h"

namespace cli {

std::optional<report::Document> read_result_or_print(const std::string& path,
                                                     const calc::FileReader& files) {
  const calc::FileContent content = files.read(path);
  if (!content.ok()) {
    print_error(calc::DiagnosticId::file_not_readable, path, content.error);
    return std::nullopt;
  }
  std::string problem;
  std::optional<report::Document> document = report::read_json(content.bytes, problem, path);
  if (!document) print_error(calc::DiagnosticId::result_not_readable, path, problem);
  return document;
}

std::optional<report::Document> read_whole_result_or_print(const std::string& path,
                                                           const calc::FileReader& files) {
  std::optional<report::Document> document = read_result_or_print(path, files);
  if (!document || document->provenance.selection.empty()) return document;
  print_error(calc::DiagnosticId::result_not_readable, path,
              "for a comparison: only a part of what is required was judged, by " +
                  document->provenance.selection);
  return std::nullopt;
}

}  // namespace cli
