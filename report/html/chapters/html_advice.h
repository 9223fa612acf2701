#pragma once
// The chapter on dimming levels that would make a project pass.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the chapter. index: of the project. "" = not requested, or everything is met.
std::string html_advice(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
