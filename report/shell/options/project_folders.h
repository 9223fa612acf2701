#pragma once
// Folders where projects are asked for: `luxgate check designs/`.

#include <string>
#include <string_view>
#include <vector>

namespace cli {

// As a project: that which standard input has, also where a folder has this name.
inline constexpr const char* kStandardInput = "-";

bool is_folder(const std::string& project);

// Whether files of this name are taken for projects in a folder: "*.xml", large letters or small.
bool has_project_name(std::string_view name);

// Whether that may be one by what it begins with: its root is <luxgate>, in whatever letters, or
// cannot be told, as of another encoding or behind very long comments. What is a rule pack, a
// policy or gbXML is none.
bool may_be_project(std::string_view text);

// In place of each folder all that may be a project in it and below, in the order of their paths.
// Files and folders whose names begin with a point are left alone. What cannot be read stands among
// them, so that it is told of and nothing is left out in silence: links to nothing, links to files
// outside, and links to folders outside in which there are projects. "", or what is wrong: a folder
// that cannot be read, or has no project.
std::string expand_folders(std::vector<std::string>& projects);

}  // namespace cli
