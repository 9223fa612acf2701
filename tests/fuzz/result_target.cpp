// Result files, as `luxgate report`, `compare` and --baseline read them: what is read can be
// written in every format, and as a result again.
#include "report/document/document.h"
#include "report/formats/format.h"
#include "report/result_file/read_json.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string problem;
  const auto document = report::read_json(fuzz::as_text(data, size), problem);
  fuzz::require(document.has_value() == problem.empty(), "a result, or what is wrong");
  if (!document) return 0;
  fuzz::count_result();
  const report::FormatStyle style{report::TextOptions(), report::Texts()};
  for (const report::Format& format : report::formats()) {
    const std::string text = format.render(*document, style);
    fuzz::require(!text.empty(), "a format that says something");
    if (format.name != "json") continue;
    fuzz::require(report::read_json(text, problem).has_value(), "a result that is read again");
  }
  return 0;
}
