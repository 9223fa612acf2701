#pragma once
// What a result file says beside the keys that are read: counts, whether a row is met, units. It
// must be what follows from the rest.

#include "report/document/document.h"
#include "report/result_file/json_cursor.h"

namespace report {

// at: the file that the document was read from. Throws BadJson. Words are passed over: earlier
// versions may have put them otherwise; and so are keys that the file lacks.
void check_written(const JsonCursor& at, const Document& document);

}  // namespace report
