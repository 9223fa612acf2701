#pragma once
// The labels of luminaires in all plans, schedules and tables.

#include "report/document/document.h"

namespace report {

// Sets LuminaireMark::label of all luminaires of the project: "A1", "A2", "B1". The letter is that
// of the type in the schedule, see position_letter(). The number counts the luminaires of the type
// over the whole project: by spaces_in_order(), and in a space in the order of the project.
// Luminaires whose type the project lacks, as in some result files, have only a number.
//
// Results do not store labels: they follow from the rest, so a check and its result file have the
// same ones. For a part of a project only the remaining spaces count.
void label_luminaires(ProjectPart& project);

}  // namespace report
