#pragma once
// Facts that a reader must know before relying on "all met": waivers, deviations from the standard,
// limits weaker than their row, and omitted zones.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns a section, which says so if there is nothing of the kind; "" if nothing is required at
// all. index: of the project. folder: of the planes' pages, see plane_href().
std::string html_deviations(const Texts& t, const ProjectPart& project, std::size_t index,
                            const std::string& folder);

}  // namespace report
