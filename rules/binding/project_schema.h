#pragma once
// The schema of project files. It is in rules/ because part of their grammar is about rules.

#include "calc/base/element_table.h"

#include <string>
#include <vector>

namespace rules {

// Returns the text of calc/project/luxgate-project-1.xsd, which 'luxgate schema' writes.
std::string project_schema();

// Returns the reference for people in Markdown: calc/project/project-format.md, which 'luxgate
// schema --markdown' writes.
std::string project_reference();

// Returns the rows about rules, which replace those of the same type in project_elements.h.
const std::vector<calc::ElementRow>& rows_about_rules();

}  // namespace rules
