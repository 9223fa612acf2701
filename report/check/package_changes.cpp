#include "report/check/package_changes.h"

#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/project/reading/project_elements.h"
#include "report/check/text_change.h"

#include <utility>

namespace check {

std::optional<std::string> with_packages(const std::string& bytes, const std::string& file,
                                         const std::map<std::string, std::string>& article_of_type,
                                         calc::Diagnostics& diagnostics) {
  std::optional<std::string> text = calc::decoded_xml(bytes, file, diagnostics);
  if (!text) return std::nullopt;
  const std::optional<calc::XmlElement> root = calc::parse_xml(bytes, file, diagnostics);
  if (!root) return std::nullopt;
  TextChange change(*std::move(text));
  for (const calc::XmlElement& type : root->children) {
    const calc::XmlAttribute* id = type.find("id");
    if (type.name != "luminaire-type" || id == nullptr) continue;
    const auto package = article_of_type.find(id->value);
    if (package == article_of_type.end()) continue;
    for (const std::string_view other : calc::kReplacedByPackage) change.unset(type, other);
    change.set(type, calc::kPackageName, package->second);
  }
  return change.apply();
}

}  // namespace check
