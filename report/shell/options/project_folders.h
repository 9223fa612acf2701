#pragma once
// Folders in place of projects: `luxgate check designs/`.

#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Names standard input as a project, even if a folder has this name.
inline constexpr const char* kStandardInput = "-";

bool is_folder(const std::string& project);

// Returns whether files of this name in a folder count as projects: "*.xml", in upper or lower
// case.
bool has_project_name(std::string_view name);

// Returns whether the text may begin a project: its root is <luxgate>, in upper or lower case, or
// cannot be told, as in another encoding or behind very long comments. Rule packs, policies and
// gbXML are excluded.
bool may_be_project(std::string_view text);

// Replaces each folder by all possible projects in it and below, in the order of their paths. Files
// and folders with a leading dot are skipped. Unreadable entries stay in the list so that they are
// reported: links to nothing, links to files outside, and links to folders outside that contain
// projects. Returns "", or what is wrong: a folder that cannot be read, or has no project.
std::string expand_folders(std::vector<std::string>& projects);

}  // namespace cli
