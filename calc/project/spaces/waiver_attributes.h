#pragma once
// Reads the attributes of a waiver (calc/scene/waiver.h): reason, person and last day.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/waiver.h"

#include <string_view>

namespace calc {

struct WaiverNames {
  std::string_view because = "because", by = "by", until = "until";
};

// Requires all three; reports a missing attribute or an invalid day, and `until` is "" then.
Waiver read_waiver(ElementReader& reader, const WaiverNames& names = {});

}  // namespace calc
