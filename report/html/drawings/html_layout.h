#pragma once
// A room as fitters need it: plan and elevation to a scale of drawings, with dimensions, north,
// luminaires with their marks, furniture and calculation planes.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A figure for paper, where its scale holds: views of at most 150 mm by 140 mm together, or 122 mm
// by 78 mm in projects with many rooms or planes. "" where there is nothing to draw.
std::string html_layout(const Texts& t, const ProjectPart& project, const SpacePart& space);

}  // namespace report
