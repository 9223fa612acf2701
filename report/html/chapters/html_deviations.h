#pragma once
// What a reader must know before relying on "all met": waivers, deviations from the standard,
// limits that are weaker than their row, and zones that are left out of it.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// A section, which says so where there is nothing of the kind; "" where nothing is asked at all.
// index: of the project. folder: of the planes' pages, see plane_href().
std::string html_deviations(const Texts& t, const ProjectPart& project, std::size_t index,
                            const std::string& folder);

}  // namespace report
