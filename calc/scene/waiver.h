#pragma once
// A decision to accept something up to a last day: an unmet requirement, a plane that deviates from
// a standard's, an omitted zone.

#include "calc/base/diagnostics.h"

#include <string>
#include <string_view>

namespace calc {

struct Waiver {
  std::string reason, owner, until;  // until: the last day, YYYY-MM-DD
  SourceLocation where = {};         // of the element that says so

  bool holds_on(std::string_view day) const { return day <= std::string_view(until); }
};

}  // namespace calc
