#include "calc/photometry/read/ies_tilt.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/units.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/web_assembly.h"

#include <cstddef>
#include <utility>

namespace calc {

std::optional<LampTilt> read_tilt_data(Lm63Numbers& numbers) {
  LampTilt tilt;
  int pairs = 0;
  if (!numbers.read_whole("the lamp-to-luminaire geometry of the tilt data", 1, 3, tilt.geometry) ||
      !numbers.read_whole("the number of tilt angles", 1, 1'000'000, pairs) ||
      !numbers.check_present("the tilt data", 2 * static_cast<std::size_t>(pairs))) {
    return std::nullopt;
  }
  double previous_deg = 0.0;
  for (int i = 0; i < pairs; ++i) {
    double deg = 0.0;
    if (!numbers.read("tilt angle", deg)) return std::nullopt;
    if (!check_angle(deg, i > 0 ? &previous_deg : nullptr, -180.0, 180.0, "tilt", numbers.here(),
                     numbers.diagnostics())) {
      return std::nullopt;
    }
    tilt.angle_rad.push_back(deg * kPi / 180.0);
    previous_deg = deg;
  }
  if (tilt.angle_rad.front() > 0.0 || tilt.angle_rad.back() < 0.0) {
    numbers.refuse("the first tilt angle", tilt.angle_rad.front() * 180.0 / kPi,
                   "angles on both sides of 0, or 0");
    return std::nullopt;
  }
  for (int i = 0; i < pairs; ++i) {
    double factor = 0.0;
    if (!numbers.read("tilt factor", factor)) return std::nullopt;
    if (!(factor > 0.0)) {
      numbers.refuse("tilt factor", factor, "> 0");
      return std::nullopt;
    }
    tilt.factor.push_back(factor);
  }
  return tilt;
}

std::optional<LampTilt> read_tilt_file(const std::string& file_name, const std::string& ies_name,
                                       const SourceLocation& where,
                                       const CompanionReader& read_companion,
                                       Diagnostics& diagnostics) {
  const bool is_plain = file_name.find_first_of("/\\:") == std::string::npos &&
                        !file_name.empty() && file_name != "." && file_name != "..";
  if (!is_plain) {
    diagnostics.report(DiagnosticId::photometry_tilt_file_name, where, quotable(file_name));
    return std::nullopt;
  }
  const std::optional<std::string> bytes =
      read_companion ? read_companion(file_name) : std::nullopt;
  if (!bytes) {
    diagnostics.report(DiagnosticId::photometry_tilt_file, where, quotable(file_name));
    return std::nullopt;
  }
  const std::size_t slash = ies_name.rfind('/');
  const std::string path =
      slash == std::string::npos ? file_name : ies_name.substr(0, slash + 1) + file_name;
  Lm63Numbers numbers(*bytes, 0, path, diagnostics);
  std::optional<LampTilt> tilt = read_tilt_data(numbers);
  if (tilt && numbers.count_remaining() > 0) {
    const std::size_t left = numbers.count_remaining();
    const NumberStream::Token first = *numbers.next_token();
    diagnostics.report(DiagnosticId::photometry_trailing, numbers.at(first.line), left,
                       quotable(first.text));
  }
  return tilt;
}

}  // namespace calc
