#pragma once
// What belongs to a whole project or to the run: luminaires, messages, the calculation itself,
// where it all came from.

#include "report/document.h"

#include <cstddef>
#include <string>

namespace report {

// index: of the project, from 0; for anchors.
std::string html_messages(const ProjectPart& project);
std::string html_luminaires(const ProjectPart& project, std::size_t index);
std::string html_calculation(const Provenance& provenance, const ProjectPart& project,
                             std::size_t index);
std::string html_inputs(const ProjectPart& project);
std::string html_provenance(const Document& document);

}  // namespace report
