#pragma once
// Words of a schedule of luminaires, the same in every format.

#include "report/document/luminaire_schedule.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// Returns "4000", or the file's own words; "" = nothing readable as a colour. For a type with
// another flux or lamp package than the file's it says that this is the file's value.
std::string colour_temperature_words(const Texts& t, const LuminaireRow& type);
// Returns "80", "80–89", "≥ 80", or the file's own words; "" as above.
std::string colour_rendering_words(const Texts& t, const LuminaireRow& type);
// Returns "2.80 m, 3.20 m", for many heights "2.60 m to 3.20 m"; "" = none.
std::string mounting_words(const Texts& t, const ScheduleRow& row);
// Returns "1.01 Open office, 1.02 Office and 3 more"; not escaped.
std::string rooms_words(const Texts& t, const ScheduleRow& row);
// Returns "luminous opening 1.20 m × 0.30 m"; "" = not known.
std::string opening_words(const Texts& t, const ScheduleRow& row);
// Returns remarks to be read with the counts: unused types, the meaning of a road's luminaires. Not
// escaped.
std::vector<std::string> schedule_remarks(const Texts& t, const LuminaireSchedule& schedule);

}  // namespace report
