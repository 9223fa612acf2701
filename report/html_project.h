#pragma once
// What belongs to a whole project or to the run: luminaires, messages, the calculation itself,
// where it all came from.

#include "report/document.h"

#include <string>

namespace report {

std::string html_messages(const ProjectPart& project);
std::string html_luminaires(const ProjectPart& project);
std::string html_calculation(const Provenance& provenance, const ProjectPart& project);
std::string html_inputs(const ProjectPart& project);
std::string html_provenance(const Document& document);

}  // namespace report
