#pragma once
// Numbers of convergence documents as words, shared by their formats for people.

#include "report/converge_document.h"

#include <optional>
#include <string>

namespace report {

std::string error_words(double share);                 // two significant digits: "12 %", "0.034 %"
std::string error_words(const ConvergeError& e);       // "< 0.12 %" below the reference's error
std::string time_words(double seconds);                // "4.2 ms", "0.31 s", "12 s"
std::string time_words(const ConvergeTarget& target);  // "~12 s" extrapolated, "–" not known
std::string slope_words(const std::optional<double>& slope);   // "-0.62"
std::string coverage_words(const ConvergeCoverage& coverage);  // "94.8 %", "–" if nothing varied
std::string count_words(double count);                         // "12 400"

}  // namespace report
