#include "calc/project/spaces/waiver_attributes.h"

#include "calc/base/day.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <string>

namespace calc {
namespace {

std::string read_last_day(ElementReader& reader, std::string_view name) {
  std::string day(trim(reader.text(name)));
  if (day.empty() || is_day(day)) return day;
  reader.report(DiagnosticId::waiver_incomplete, reader.where(name), name, reader.element().name,
                fmt::format("'{}' is not a date; expected YYYY-MM-DD", day));
  return {};
}

}  // namespace

Waiver read_waiver(ElementReader& reader, const WaiverNames& names) {
  return {reader.text(names.because), reader.text(names.by), read_last_day(reader, names.until),
          reader.where()};
}

}  // namespace calc
