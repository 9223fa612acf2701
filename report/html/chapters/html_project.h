#pragma once
// Parts about a whole project or the run: luminaires, messages, the calculation, its sources.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the messages. index: of the project, from 0; for anchors. with_places: with the files and
// lines of the messages.
std::string html_messages(const Texts& t, const ProjectPart& project, bool with_places = true);
std::string html_luminaires(const Texts& t, const ProjectPart& project, std::size_t index);
std::string html_calculation(const Texts& t, const Provenance& provenance,
                             const ProjectPart& project, std::size_t index);
std::string html_inputs(const Texts& t, const ProjectPart& project);
std::string html_provenance(const Texts& t, const Provenance& provenance);

}  // namespace report
