#pragma once
// A room for fitters: plan and elevation at a drawing scale, with dimensions, north, luminaires
// with their marks, furniture and calculation planes.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a figure for paper, where its scale is valid: views of at most 150 mm by 140 mm together,
// or 122 mm by 78 mm in projects with many rooms or planes. "" if there is nothing to draw.
std::string html_layout(const Texts& t, const ProjectPart& project, const SpacePart& space);

}  // namespace report
