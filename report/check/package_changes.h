#pragma once
// A project's text with other lamp packages. All else stays as it stands in the file.

#include "calc/base/diagnostics.h"

#include <map>
#include <optional>
#include <string>

namespace check {

// article_of_type: for the id of a <luminaire-type> the article of one of its packages, which takes
// the place of its flux and power. The text is in UTF-8. Empty after an error: what parse_xml()
// refuses.
std::optional<std::string> with_packages(const std::string& bytes, const std::string& file,
                                         const std::map<std::string, std::string>& article_of_type,
                                         calc::Diagnostics& diagnostics);

}  // namespace check
