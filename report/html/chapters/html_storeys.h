#pragma once
// Floor plans of a project's storeys, and site plans of roads and outdoor areas.

#include "report/document/document.h"
#include "report/document/storeys.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns headings (h3) and figures to scale: for each storey its installation and its results; for
// each outdoor space a plan with both. "" if no storey has two rooms and no outdoor space needs
// more than its own plan. index: of the project.
std::string html_storeys(const Texts& t, const ProjectPart& project, std::size_t index,
                         Paper paper);

// Returns the title of the section: "Floor plans", or "Site plan: School" without storeys; escaped.
std::string storeys_title(const Texts& t, const ProjectPart& project);

}  // namespace report
