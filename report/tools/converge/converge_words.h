#pragma once
// Words for numbers of convergence documents, shared by their formats for people.

#include "report/tools/converge/converge_document.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Phases in the order of their columns.
struct ConvergePhase {
  std::string_view key, title;
  double ConvergePhases::*seconds;
  int colour;  // class "p<colour>" in HTML
};
const std::vector<ConvergePhase>& all_phases();
// Returns the phases, without shadow maps if no method drew any.
std::vector<ConvergePhase> shown_phases(const ConvergeDocument& document);
// Returns the OpenGL device and its effect on times, for people; "" = none was used.
std::string opengl_words(const Texts& t, const ConvergeDocument& document);

// Returns the title on the page.
const char* phase_title(const Texts& t, const ConvergePhase& phase);
const char* metric_title(const Texts& t, ConvergeMetric metric);
// Returns the title of a method; unknown methods keep their own title.
std::string method_title(const Texts& t, const ConvergeMethod& method);

// Numbers have decimal points here; pages turn them by Texts::number().
std::string error_words(double share);            // two significant digits: "12 %", "0.034 %"
std::string error_words(const ConvergeError& e);  // "< 0.12 %" below the reference's error
std::string time_words(double seconds);           // "4.2 ms", "0.31 s", "12 s"
std::string phase_words(double seconds);          // "–" for a phase that a method does not have
std::string time_words(const ConvergeTarget& target);  // "~12 s" extrapolated, "–" not known
std::string slope_words(const std::optional<double>& slope);   // "-0.62"
std::string coverage_words(const ConvergeCoverage& coverage);  // "94.8 %", "–" if nothing varied
std::string count_words(double count);                         // "12 400"

}  // namespace report
