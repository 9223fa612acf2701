#include "report/result_file/json.h"

#include "report/result_file/json_writer.h"
#include "report/text/json_layout.h"

namespace report {

std::string render_json(const Document& document) { return json_layout(json_of(document)); }

}  // namespace report
