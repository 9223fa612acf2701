#pragma once
// Changes the lamp packages in a project's text. Everything else stays unchanged.

#include "calc/base/diagnostics.h"

#include <map>
#include <optional>
#include <string>

namespace check {

// Returns the changed text in UTF-8. article_of_type: for the id of a <luminaire-type> the article
// of one of its packages, which replaces its flux and power. Empty after an error: parse_xml()
// refuses the text.
std::optional<std::string> with_packages(const std::string& bytes, const std::string& file,
                                         const std::map<std::string, std::string>& article_of_type,
                                         calc::Diagnostics& diagnostics);

}  // namespace check
