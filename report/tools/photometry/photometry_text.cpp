#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/photometry/photometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

constexpr double kNearSymmetry = 0.01;  // of the maximum: worth a word

std::string degrees(double rad, int decimals = 1) {
  std::string text = report::format_fixed(calc::degrees_from_radians(rad), decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

std::string number(double value, int digits = 5) {
  const int before = value > 0.0 ? static_cast<int>(std::floor(calc::log10(value))) + 1 : 1;
  return report::format_fixed(value, std::max(0, digits - std::max(before, 1)));
}

std::string percent(double share, int decimals = 1) {
  return report::format_fixed(100.0 * share, decimals) + " %";
}

std::string light_rows(const calc::PhotometricWeb& web, const PhotometryFacts& facts) {
  const calc::PhotometrySource& source = web.source();
  const double flux = web.flux_lm();
  std::string text = named_row(
      "flux", fmt::format("{} lm from the intensities; {} down, {} up", number(flux, 6),
                          percent(facts.downward_share), percent(1.0 - facts.downward_share)));
  if (source.stated_flux_lm > 0.0) {
    text += named_row("", fmt::format("{} lm stated for the luminaire, {} of that",
                                      number(source.stated_flux_lm, 6),
                                      percent(source.stated_flux_lm / flux, 2)));
  }
  const double rated = source.rated_lamp_flux_lm;
  text += named_row("lamps", rated > 0.0 ? fmt::format("{} lm stated; the luminaire gives {} of it",
                                                       number(rated, 6), percent(flux / rated, 2))
                                         : std::string("no flux stated (absolute photometry)"));
  const double power = source.input_power_w;
  const std::string whose = source.power_rule.empty() ? "" : ": " + source.power_rule;
  text +=
      named_row("efficacy", power > 0.0 ? fmt::format("{} lm/W at {} W{}", number(flux / power, 4),
                                                      report::format_shortest(power), whose)
                                        : std::string("no power stated"));
  return text;
}

std::string peak_row(const PhotometryFacts& facts) {
  const double gamma = facts.peak.gamma_rad;
  std::string where =
      fmt::format("C {}, gamma {}", degrees(facts.peak.c_rad, 3), degrees(gamma, 3));
  if (gamma <= 0.0) where = "nadir (gamma 0)";
  if (gamma >= calc::kPi) where = "zenith (gamma 180)";
  return named_row("maximum", fmt::format("{} cd at {}", number(facts.peak.intensity_cd), where));
}

std::string width_words(const calc::BeamWidth& width) {
  if (width.lobes == 0) return "no light";
  if (width.lobes == 1) return degrees(width.lobe_rad) + "°";
  return fmt::format("{}° over {} lobes, {}° the highest", degrees(width.span_rad), width.lobes,
                     degrees(width.lobe_rad));
}

std::string width_row(const char* name, const std::array<calc::BeamWidth, kPlanePairs>& widths) {
  return named_row(name, fmt::format("C0-C180 {}; C90-C270 {}", width_words(widths[kC0C180]),
                                     width_words(widths[kC90C270])));
}

std::string symmetry_words(calc::PlaneSymmetry symmetry) {
  switch (symmetry) {
    case calc::PlaneSymmetry::axial:
      return "axial";
    case calc::PlaneSymmetry::quadrant:
      return "about C0-C180 and C90-C270";
    case calc::PlaneSymmetry::c0_c180:
      return "about C0-C180";
    case calc::PlaneSymmetry::c90_c270:
      return "about C90-C270";
    case calc::PlaneSymmetry::none:
      break;
  }
  return "none";
}

double difference_of(const calc::SymmetryFit& fit, calc::PlaneSymmetry symmetry) {
  if (symmetry == calc::PlaneSymmetry::axial) return fit.axial;
  if (symmetry == calc::PlaneSymmetry::c0_c180) return fit.c0_c180;
  if (symmetry == calc::PlaneSymmetry::c90_c270) return fit.c90_c270;
  return std::max(fit.c0_c180, fit.c90_c270);
}

std::string symmetry_row(const calc::SymmetryFit& fit) {
  const calc::PlaneSymmetry exact = calc::symmetry_within(fit, calc::kExactSymmetry);
  const calc::PlaneSymmetry near = calc::symmetry_within(fit, kNearSymmetry);
  std::string words = symmetry_words(exact);
  if (near != exact) {
    words += fmt::format("; {} within {} of the maximum", symmetry_words(near),
                         percent(difference_of(fit, near), 2));
  }
  return named_row("symmetry", words);
}

std::string steps_words(const std::vector<double>& angles_rad) {
  const double step = angles_rad[1] - angles_rad[0];
  for (std::size_t i = 1; i < angles_rad.size(); ++i) {
    if (std::abs(angles_rad[i] - angles_rad[i - 1] - step) > 1.0e-8) return "uneven steps";
  }
  return fmt::format("step {}", degrees(step, 3));
}

std::string table_row(const calc::PhotometricWeb& web) {
  const std::vector<double>& gamma = web.gamma_rad();
  if (web.axis() == calc::TableAxis::lateral) {
    const LateralAngles angles = lateral_angles(web);
    return named_row("table",
                     fmt::format("LM-63 type B, planes about the line C90-C270: V {:g} to {:g}, "
                                 "H {:g} to {:g} ({})",
                                 angles.v_first_deg, angles.v_last_deg, angles.h_first_deg,
                                 angles.h_last_deg, steps_words(gamma)));
  }
  const std::string planes = web.is_axial()
                                 ? "1 C-plane for all"
                                 : fmt::format("{} C-planes around the circle, {}",
                                               web.c_rad().size() - 1, steps_words(web.c_rad()));
  return named_row("table", fmt::format("{}; {} gamma angles {} to {}, {}", planes, gamma.size(),
                                        degrees(gamma.front(), 3), degrees(gamma.back(), 3),
                                        steps_words(gamma)));
}

std::string cubic_row(const PhotometryFacts& facts) {
  if (!facts.interpolation) return named_row("cubic", "not compared: the table is very large");
  const double flux = 100.0 * facts.interpolation->flux_share;
  return named_row("cubic",
                   fmt::format("interpolation would change the light by up to {} of the maximum "
                               "and the flux by {:+.2f} %",
                               percent(facts.interpolation->largest_share, 2), flux));
}

std::string lamp_tilt_rows(const calc::PhotometrySource& source) {
  if (!source.lamp_tilt) return "";
  const calc::LampTilt& tilt = *source.lamp_tilt;
  const char* const kLamps[] = {"vertical in a luminaire that points down",
                                "horizontal along C0-C180",
                                "horizontal, tilting with the luminaire"};
  std::string text =
      named_row("lamp tilt", fmt::format("the lamp is {}; where it is tilted the light is "
                                         "multiplied by",
                                         kLamps[tilt.geometry - 1]));
  constexpr std::size_t kMostShown = 12;
  std::string pairs;
  for (std::size_t i = 0; i < tilt.factor.size() && i < kMostShown; ++i) {
    pairs += fmt::format("{}{:g} at {}°", i == 0 ? "" : ", ", tilt.factor[i],
                         degrees(tilt.angle_rad[i], 3));
  }
  if (tilt.factor.size() > kMostShown) {
    pairs += fmt::format(", ... ({} angles up to {}°)", tilt.factor.size(),
                         degrees(tilt.angle_rad.back(), 3));
  }
  return text + named_row("", pairs);
}

// How the plane of the maximum lies to the longer side.
std::string peak_to_side(const calc::Peak& peak, LongerSide side) {
  if (peak.gamma_rad <= 0.0 || peak.gamma_rad >= calc::kPi) return "";
  const double axis_rad = side == LongerSide::c0_c180 ? 0.0 : 0.5 * calc::kPi;
  const double along = std::abs(calc::cos(peak.c_rad - axis_rad));
  if (along > calc::cos(calc::kPi / 8.0)) return ", the maximum lies along it";
  if (along < calc::sin(calc::kPi / 8.0)) return ", the maximum lies across it";
  return ", the maximum lies at an angle to it";
}

std::string opening_row(const calc::LuminousOpening& opening, const calc::Peak& peak) {
  std::string words = opening_shape_name(opening.shape);
  if (opening.shape != calc::OpeningShape::point) {
    words +=
        fmt::format(" {} m along C0, {} m along C90", report::format_metres(opening.along_c0_m),
                    report::format_metres(opening.along_c90_m));
  }
  if (opening.height_m > 0.0) {
    const double longer_m = std::max(opening.along_c0_m, opening.along_c90_m);
    const bool is_unusually_high = opening.height_m > 0.1 * longer_m;
    words += fmt::format(", {} m high{}", report::format_metres(opening.height_m),
                         !opening.is_body() && is_unusually_high ? " (used as flat)" : "");
  }
  const LongerSide side = longer_side(opening);
  if (side != LongerSide::none) {
    words +=
        fmt::format("; longer side along {}{}", longer_side_name(side), peak_to_side(peak, side));
  }
  return named_row("opening", words);
}

std::string vector_words(const glm::dvec3& vector) {
  // No minus before a zero that rounding made.
  const auto coordinate = [](double value) {
    return report::format_shortest(std::round(value * 1.0e4) / 1.0e4 + 0.0);
  };
  return fmt::format("{} {} {}", coordinate(vector.x), coordinate(vector.y), coordinate(vector.z));
}

std::string together_rows(const PhotometryFile& file) {
  if (!file.together) return "";
  const TogetherFacts& all = *file.together;
  std::string text = named_row(
      "together",
      fmt::format("emitter 'all': {} emitters, {} lm, {}", all.emitters, number(all.flux_lm, 6),
                  all.power_w > 0.0 ? report::format_shortest(all.power_w) + " W"
                                    : std::string("power not known")));
  if (file.place) {
    text +=
        named_row("place", fmt::format("{} m from the middle of them, light along {}, C 0 along {}",
                                       vector_words(file.place->position_m),
                                       vector_words(-file.place->turn[2]),
                                       vector_words(file.place->turn[0])));
  }
  return text;
}

std::string choice_words(const PhotometryFile& file) {
  if (file.variant.empty() && file.emitter.empty()) return "";
  std::string words;
  if (!file.variant.empty()) words = "variant " + report::printable(file.variant);
  if (!file.emitter.empty()) {
    words += (words.empty() ? "" : ", ") + ("emitter " + report::printable(file.emitter));
  }
  return " [" + words + "]";
}

std::string warning_rows(const PhotometryFile& file, bool colour) {
  if (file.diagnostics.empty()) return named_row("warnings", "none");
  std::string text = named_row("warnings", fmt::format("{}", file.diagnostics.size()));
  for (const calc::Diagnostic& entry : file.diagnostics) {
    const std::string line = report::printable(calc::format_diagnostic(entry));
    text += colour ? fmt::format("    \033[33m{}\033[0m\n", line) : fmt::format("    {}\n", line);
  }
  return text;
}

std::string heading(const std::string& text, bool colour) {
  return colour ? "\033[1m" + text + "\033[0m" : text;
}

}  // namespace

std::string named_row(const char* name, const std::string& value) {
  return fmt::format("  {:<11} {}\n", name, value);
}

std::string render_photometry_text(const PhotometryFile& file, bool colour) {
  std::string text = heading(report::printable(file.path) + choice_words(file), colour);
  if (!file.web) return text + "\n  not readable: see the errors\n";
  const calc::PhotometricWeb& web = *file.web;
  const calc::PhotometrySource& source = web.source();
  const std::string name = report::printable(source.luminaire_name);
  const std::string maker = report::printable(source.manufacturer);
  if (!name.empty()) text += ": " + name;
  if (!maker.empty()) text += " (" + maker + ")";
  text += "\n" + named_row("format", report::printable(source.format));
  text += light_rows(web, file.facts);
  text += together_rows(file);
  text += peak_row(file.facts);
  text += width_row("beam 50 %", file.facts.beam);
  text += width_row("field 10 %", file.facts.field);
  text += symmetry_row(file.facts.symmetry);
  text += table_row(web);
  text += cubic_row(file.facts);
  if (!source.axis_rule.empty()) text += named_row("axes", report::printable(source.axis_rule));
  text += opening_row(web.opening(), file.facts.peak);
  text += named_row("factors", source.applied_factors.empty()
                                   ? "none"
                                   : report::printable(source.applied_factors));
  text += lamp_tilt_rows(source);
  return text + warning_rows(file, colour);
}

}  // namespace cli
