// Project files whose attributes get other values: lines PATH=VALUE follow as a second file.
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "report/check/set_values.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"
#include "tests/support/memory_file_reader.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace {

std::vector<check::SetValue> values_in(std::string_view lines) {
  std::vector<check::SetValue> values;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    values.push_back({std::string(line.substr(0, equals)), std::string(line.substr(equals + 1))});
  }
  return values;
}

std::size_t count_elements(const calc::XmlElement& element) {
  std::size_t count = 1;
  for (const calc::XmlElement& child : element.children) count += count_elements(child);
  return count;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::TwoFiles input = fuzz::split_files(fuzz::as_text(data, size));
  const std::string project(input.first);
  const std::vector<check::SetValue> values = values_in(input.second);
  const std::vector<std::string> projects{"p.xml"};
  const calc::MemoryFileReader files({{"p.xml", project}});
  calc::Diagnostics diagnostics;
  check::check_values(projects, values, "set", files, diagnostics);
  const calc::FileContent changed = check::SetReader(files, projects, values).read("p.xml");
  fuzz::check_messages(changed.ok(), diagnostics);
  if (!changed.ok() || changed.bytes == project) return 0;
  // Elements are as many as before, on as many lines; and the values are those that were asked for.
  calc::Diagnostics of_project;
  const auto before = calc::parse_xml(project, "p.xml", of_project);
  const auto after = calc::parse_xml(changed.bytes, "p.xml", of_project);
  fuzz::require_no_error(of_project, "a changed project is well-formed");
  fuzz::require(count_elements(*before) == count_elements(*after), "no element comes or goes");
  const auto text = calc::decoded_xml(project, "p.xml", of_project);
  fuzz::require(std::count(text->begin(), text->end(), '\n') ==
                    std::count(changed.bytes.begin(), changed.bytes.end(), '\n'),
                "lines keep their numbers");
  const calc::MemoryFileReader once({{"p.xml", changed.bytes}});
  const calc::FileContent again = check::SetReader(once, projects, values).read("p.xml");
  fuzz::require(again.ok() && again.bytes == changed.bytes,
                "the same values once more change nothing");
  return 0;
}
