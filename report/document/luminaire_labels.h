#pragma once
// The mark by which all plans, schedules and tables name a luminaire.

#include "report/document/document.h"

namespace report {

// Sets LuminaireMark::label of all luminaires of the project: "A1", "A2", "B1". The letter is that
// of the type in the schedule, see position_letter(). The number counts the luminaires of the type
// over the whole project: by spaces_in_order(), and in a space in the order of the project.
// Luminaires whose type the project does not have, as a result file may say, have a number alone.
//
// Results do not hold marks: they follow from the rest, so that a check and what is read from its
// result have the same ones. Of a part of a project the spaces that are left count.
void label_luminaires(ProjectPart& project);

}  // namespace report
