#pragma once
// Folders where projects are asked for: `luxgate check designs/`.

#include <string>
#include <string_view>
#include <vector>

namespace cli {

// As a project: that which standard input has, also where a folder has this name.
inline constexpr const char* kStandardInput = "-";

bool is_folder(const std::string& project);

// The name of the first element of an XML file's text; "" if that cannot be told: no XML, another
// encoding than UTF-8, or too long a way to it.
std::string_view root_element(std::string_view text);

// In place of each folder all projects in it and below, in the order of their paths: files "*.xml"
// but those whose root is certainly another element (rule packs, policies, gbXML). Files and
// folders whose names begin with a point are left alone, as are links to folders. "", or what is
// wrong: a folder that cannot be read, or has no project, or a link to a file outside of it.
std::string expand_folders(std::vector<std::string>& projects);

}  // namespace cli
