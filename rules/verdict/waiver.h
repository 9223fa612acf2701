#pragma once
// A requirement that somebody has decided to live without, for a time.

#include "calc/base/xml_reader.h"
#include "rules/catalogue/requirement.h"
#include "rules/verdict/judge.h"

#include <optional>
#include <string_view>

namespace rules {

// The attributes waived-because, waived-by and waived-until (YYYY-MM-DD): all of them or none.
// Empty if there is none, and after an error.
std::optional<Waiver> read_waiver(calc::ElementReader& reader);

// The day of an attribute that must be there, YYYY-MM-DD; "" after an error.
std::string read_day(calc::ElementReader& reader, std::string_view name);

// A verdict that somebody may live without.
constexpr bool can_be_waived(Verdict verdict) {
  return verdict == Verdict::fail || verdict == Verdict::undecided;
}

// A finding that fails or is undecided is waived up to the last day, and then does not count; its
// verdict stays. The reason says so, or that the waiver has ended. today: YYYY-MM-DD.
void apply_waiver(Finding& finding, std::string_view today);

}  // namespace rules
