#include "tests/bench/photometry.h"

#include "calc/base/units.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace bench {
namespace {

// The table's numbers times what gives it the flux.
WebTable scaled_to(WebTable table, double flux_lm) {
  const double factor = flux_lm / make_web(table).flux_lm();
  for (double& cd : table.cd) cd *= factor;
  return table;
}

double wide(double gamma_deg) {
  const double cosine = std::cos(calc::radians_from_degrees(gamma_deg));
  return gamma_deg >= 90.0 ? 0.0 : std::pow(cosine, 1.3);
}

void append_wrapped(std::string& text, const std::vector<double>& values, std::size_t begin,
                    std::size_t end) {
  constexpr std::size_t kPerLine = 10;
  for (std::size_t i = begin; i < end; ++i) {
    const bool is_last = i + 1 == end || (i + 1 - begin) % kPerLine == 0;
    text += fmt::format("{:.9g}{}", values[i], is_last ? "\n" : " ");
  }
}

}  // namespace

WebTable wide_web(double flux_lm) {
  WebTable table{"wide", {0.0}, {}, {}};
  for (int k = 0; k <= 36; ++k) {
    table.gamma_deg.push_back(2.5 * k);
    table.cd.push_back(wide(2.5 * k));
  }
  return scaled_to(std::move(table), flux_lm);
}

WebTable asymmetric_web(double flux_lm) {
  WebTable table{"asymmetric", {}, {}, {}};
  for (int k = 0; k <= 36; ++k) table.gamma_deg.push_back(2.5 * k);
  for (int c = 0; c <= 24; ++c) {
    table.c_deg.push_back(15.0 * c);
    const double angle = calc::radians_from_degrees(c == 24 ? 0.0 : 15.0 * c);
    const double lean = 0.5 * std::cos(angle) + 0.3 * std::sin(angle);
    for (const double gamma_deg : table.gamma_deg) {
      const double sine = std::sin(calc::radians_from_degrees(gamma_deg));
      table.cd.push_back(wide(gamma_deg) * (1.0 + lean * sine));
    }
  }
  return scaled_to(std::move(table), flux_lm);
}

WebTable spot_web(double flux_lm, double beam_deg) {
  WebTable table{"spot", {0.0}, {}, {}};
  const double half_rad = calc::radians_from_degrees(0.5 * beam_deg);
  const double exponent = std::log(0.5) / std::log(std::cos(half_rad));
  constexpr int kSteps = 80;
  for (int k = 0; k <= kSteps; ++k) {
    const double gamma_deg = 2.5 * beam_deg * k / kSteps;
    table.gamma_deg.push_back(gamma_deg);
    const double cosine = std::cos(calc::radians_from_degrees(gamma_deg));
    table.cd.push_back(k == kSteps ? 0.0 : std::pow(cosine, exponent));
  }
  table.gamma_deg.push_back(90.0);
  table.cd.push_back(0.0);
  return scaled_to(std::move(table), flux_lm);
}

calc::PhotometricWeb make_web(const WebTable& table) {
  std::vector<double> c_rad, gamma_rad;
  for (const double deg : table.c_deg) {
    c_rad.push_back(deg == 360.0 ? 2.0 * calc::kPi : calc::radians_from_degrees(deg));
  }
  for (const double deg : table.gamma_deg) gamma_rad.push_back(calc::radians_from_degrees(deg));
  return calc::PhotometricWeb::make(c_rad, gamma_rad, table.cd, {}, {});
}

std::string ies_text(const WebTable& table) {
  const std::size_t gammas = table.gamma_deg.size(), planes = table.c_deg.size();
  std::string text = fmt::format(
      "IESNA:LM-63-2002\n[TEST] made by formula, not measured\n[TESTLAB] none\n"
      "[ISSUEDATE] 01-JAN-2026\n[MANUFAC] luxgate benchmarks\n[LUMCAT] {}\n"
      "TILT=NONE\n1 -1 1 {} {} 1 2 0 0 0\n1 1 30\n",
      table.name, gammas, planes);
  append_wrapped(text, table.gamma_deg, 0, gammas);
  append_wrapped(text, table.c_deg, 0, planes);
  for (std::size_t c = 0; c < planes; ++c) {
    append_wrapped(text, table.cd, c * gammas, (c + 1) * gammas);
  }
  return text;
}

}  // namespace bench
