#include "report/tools/converge/converge_words.h"

#include "calc/base/elementary.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace report {
namespace {

// Two significant digits, all of the whole part.
std::string two_digits(double value) {
  if (!(value > 0.0)) return "0";
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(calc::log10(value))), 0, 9);
  return format_fixed(value, decimals);
}

}  // namespace

std::string_view converge_metric_name(ConvergeMetric metric) {
  switch (metric) {
    case ConvergeMetric::rms:
      return "rms";
    case ConvergeMetric::maximum:
      return "maximum";
    case ConvergeMetric::average:
      return "average";
    case ConvergeMetric::uniformity:
      break;
  }
  return "uo";
}

const std::vector<ConvergePhase>& all_phases() {
  static const std::vector<ConvergePhase> phases{
      {"build_s", "build", &ConvergePhases::build, 0},
      {"direct_s", "direct", &ConvergePhases::direct, 1},
      {"light_paths_s", "light paths", &ConvergePhases::pool, 2},
      {"shadow_maps_s", "shadow maps", &ConvergePhases::maps, 5},
      {"connections_s", "connections", &ConvergePhases::connect, 3},
      {"near_field_s", "near field", &ConvergePhases::near, 4}};
  return phases;
}

std::vector<ConvergePhase> shown_phases(const ConvergeDocument& document) {
  std::vector<ConvergePhase> shown = all_phases();
  for (const ConvergeMethod& method : document.methods) {
    for (const ConvergeStep& step : method.steps) {
      if (step.phases.maps > 0.0) return shown;
    }
  }
  std::erase_if(shown, [](const ConvergePhase& p) { return p.seconds == &ConvergePhases::maps; });
  return shown;
}

std::string opengl_words(const Texts& t, const ConvergeDocument& document) {
  if (document.opengl.empty() || !document.is_software_opengl) return document.opengl;
  return t.say<Text::converge_software>(document.opengl);
}

const char* phase_title(const Texts& t, const ConvergePhase& phase) {
  constexpr std::pair<double ConvergePhases::*, Text> kTitles[] = {
      {&ConvergePhases::build, Text::converge_phase_build},
      {&ConvergePhases::direct, Text::converge_phase_direct},
      {&ConvergePhases::pool, Text::converge_phase_paths},
      {&ConvergePhases::maps, Text::converge_phase_maps},
      {&ConvergePhases::connect, Text::converge_phase_connect},
      {&ConvergePhases::near, Text::converge_phase_near}};
  for (const auto& [seconds, title] : kTitles) {
    if (seconds == phase.seconds) return t[title];
  }
  return "";
}

const char* metric_title(const Texts& t, ConvergeMetric metric) {
  switch (metric) {
    case ConvergeMetric::rms:
      return t[Text::converge_rms];
    case ConvergeMetric::maximum:
      return t[Text::converge_worst];
    case ConvergeMetric::average:
      return t[Text::converge_average];
    case ConvergeMetric::uniformity:
      break;
  }
  return t[Text::converge_uo];
}

std::string method_title(const Texts& t, const ConvergeMethod& method) {
  constexpr std::string_view kMaps = "shadow-map:";
  const std::string_view name = method.name;
  if (t.language() == Language::english) return method.title;
  if (name == "core") return t[Text::converge_core];
  if (name == "gpu") return t[Text::converge_gpu];
  if (name == "instant-radiosity") return t[Text::converge_instant];
  if (name == "clamped-instant-radiosity") return t[Text::converge_clamped];
  if (name == "path-tracing") return t[Text::converge_path_tracing];
  if (name.starts_with(kMaps)) return t.say<Text::converge_maps>(name.substr(kMaps.size()));
  return method.title;
}

std::string error_words(double share) {
  if (!std::isfinite(share)) return "–";
  return two_digits(100.0 * share) + " %";
}

std::string error_words(const ConvergeError& e) {
  return (e.is_below ? "< " : "") + error_words(e.value);
}

std::string time_words(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  if (seconds < 0.0995) return two_digits(1e3 * seconds) + " ms";
  return two_digits(seconds) + " s";
}

std::string phase_words(double seconds) { return seconds > 0.0 ? time_words(seconds) : "–"; }

std::string time_words(const ConvergeTarget& target) {
  if (!target.seconds) return "–";
  return (target.is_extrapolated ? "~" : "") + time_words(*target.seconds);
}

std::string slope_words(const std::optional<double>& slope) {
  return slope ? format_fixed(*slope, 2) : "–";
}

std::string coverage_words(const ConvergeCoverage& coverage) {
  return coverage.tried > 0 ? format_fixed(100.0 * coverage.share(), 1) + " %" : "–";
}

std::string count_words(double count) {
  return count >= 9.5 ? format_count(static_cast<std::uint64_t>(std::llround(count)))
                      : two_digits(count);
}

}  // namespace report
