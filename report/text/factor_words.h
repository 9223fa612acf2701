#pragma once
// A maintenance factor in words of its own.

#include "report/text/text_numbers.h"

#include <string>

namespace report {

// "0.8" as "0.80", "0.857": a product of four factors has more digits than anybody states.
inline std::string factor_words(const Texts& t, double factor) {
  const std::string text = format_fixed(factor, 3);
  return t.number(text.ends_with('0') ? text.substr(0, text.size() - 1) : text);
}

}  // namespace report
