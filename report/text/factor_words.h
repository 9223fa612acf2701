#pragma once
// Words for a maintenance factor.

#include "report/text/text_numbers.h"

#include <string>

namespace report {

// Returns "0.80" for "0.8", and "0.857": a product of four factors has more digits than are ever
// stated.
inline std::string factor_words(const Texts& t, double factor) {
  const std::string text = format_fixed(factor, 3);
  return t.number(text.ends_with('0') ? text.substr(0, text.size() - 1) : text);
}

}  // namespace report
