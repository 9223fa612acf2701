#pragma once
// The attributes of a waiver (calc/scene/waiver.h): why, who and up to which day.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/waiver.h"

#include <string_view>

namespace calc {

struct WaiverNames {
  std::string_view because = "because", by = "by", until = "until";
};

// All three must be there; what is missing or no day is reported. `until` is "" then.
Waiver read_waiver(ElementReader& reader, const WaiverNames& names = {});

}  // namespace calc
