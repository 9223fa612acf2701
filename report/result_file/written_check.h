#pragma once
// Checks the derived keys of a result file: counts, whether a row is met, units. They must follow
// from the rest.

#include "report/document/document.h"
#include "report/result_file/json_cursor.h"

namespace report {

// Checks the keys. at: the file that the document was read from. Throws BadJson. Words are skipped,
// because earlier versions may have worded them differently, as are missing keys.
void check_written(const JsonCursor& at, const Document& document);

}  // namespace report
