#pragma once
// The schema of project files. It is here, since part of their grammar is about rules.

#include <string>

namespace rules {

// calc/project/luxgate-project-1.xsd, which 'luxgate schema' writes.
std::string project_schema();

}  // namespace rules
