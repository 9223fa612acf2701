#pragma once
// What a schedule of luminaires says in words, the same in every format.

#include "report/document/luminaire_schedule.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// "4000", or the file's own words; "" = nothing that anybody could read as a colour. Of a type with
// another flux, or lamp package, than the file's: that it is the file's.
std::string colour_temperature_words(const Texts& t, const LuminaireRow& type);
// "80", "80–89", "≥ 80", or the file's own words; "": likewise.
std::string colour_rendering_words(const Texts& t, const LuminaireRow& type);
// "2.80 m, 3.20 m", of many "2.60 m to 3.20 m"; "" = nowhere.
std::string mounting_words(const Texts& t, const ScheduleRow& row);
// "1.01 Open office, 1.02 Office and 3 more"; not escaped.
std::string rooms_words(const Texts& t, const ScheduleRow& row);
// "luminous opening 1.20 m × 0.30 m"; "" = not known.
std::string opening_words(const Texts& t, const ScheduleRow& row);
// What must be read with the counts: types that are not used, what a road's luminaires are. Not
// escaped.
std::vector<std::string> schedule_remarks(const Texts& t, const LuminaireSchedule& schedule);

}  // namespace report
