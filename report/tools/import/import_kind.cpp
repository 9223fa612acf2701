#include "report/tools/import/import_kind.h"

#include "calc/base/encoding.h"
#include "calc/base/file_kind.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"

#include <fmt/format.h>

#include <optional>

namespace cli {
namespace {

using calc::FileUse;

constexpr std::string_view kReads = "import reads DXF and IFC";
constexpr std::size_t kHeadBytes = 4096;

bool begins_like_step(std::string_view bytes) { return bytes.starts_with("ISO-10303"); }

bool is_named_drawing(const std::string& path) {
  const calc::FileKind* kind = calc::kind_by_name(path);
  return kind != nullptr && kind->use == FileUse::drawing;
}

}  // namespace

bool is_read_as_ifc(std::string_view bytes) {
  return begins_like_step(bytes) || bytes.starts_with("PK") || calc::looks_like_xml(bytes);
}

std::string import_kind_problem(std::string_view bytes, const std::string& path) {
  // A long header may hide the schema of a model from those who look at the beginning.
  if (begins_like_step(bytes) && is_named_drawing(path)) return "";
  const std::string name = calc::printable_path(path);
  if (bytes.empty()) return fmt::format("cannot import '{}': it is empty; {}", name, kReads);
  if (const auto other = calc::other_kind(bytes, path, FileUse::drawing, false)) {
    return fmt::format("cannot import '{}': {}; {}{}", name, other->words, kReads, other->advice);
  }
  if (calc::kind_by_content(bytes) != nullptr || !calc::looks_like_xml(bytes)) return "";
  const std::string element = calc::first_element_name(calc::start_of_text(bytes, kHeadBytes));
  return fmt::format("cannot import '{}': it is an XML file of <{}>; {}", name,
                     calc::printable(element), kReads);
}

std::string unread_drawing(std::string_view bytes, const std::string& path,
                           const std::string& problem) {
  if (calc::kind_by_content(bytes) != nullptr) return problem;
  return fmt::format("cannot import '{}': it is neither DXF nor IFC ({})",
                     calc::printable_path(path), problem);
}

}  // namespace cli
