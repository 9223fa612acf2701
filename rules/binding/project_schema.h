#pragma once
// The schema of project files. It is here, since part of their grammar is about rules.

#include "calc/base/element_table.h"

#include <string>
#include <vector>

namespace rules {

// calc/project/luxgate-project-1.xsd, which 'luxgate schema' writes.
std::string project_schema();

// The reference for people, in Markdown: calc/project/project-format.md, which 'luxgate schema
// --markdown' writes.
std::string project_reference();

// Rows with what is about rules, in place of those of the same type in project_elements.h.
const std::vector<calc::ElementRow>& rows_about_rules();

}  // namespace rules
