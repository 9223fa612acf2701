#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/photometry/photometry.h"

#include <fmt/format.h>

namespace cli {
namespace {

std::string share(double value) {
  return report::format_fixed(100.0 * value, value < 0.01 ? 3 : 1) + " %";
}

std::string residual(const calc::TurnFit& fit) {
  return fmt::format("RMS {}, largest {} of the maximum", share(fit.rms), share(fit.largest));
}

std::string file_line(const char* letter, const PhotometryFile& file) {
  const std::string name = report::printable(file.web->source().luminaire_name);
  return fmt::format("{}  {}{}\n", letter, report::printable(file.path),
                     name.empty() ? "" : ": " + name);
}

std::string found_words(const calc::TurnFit& fit) {
  const bool is_plain = fit.turn == calc::WebTurn{};
  if (fit.rms <= kSameLight) {
    return is_plain ? "B is A as it is, not turned (C = C)"
                    : "B is A " + calc::turn_words(fit.turn);
  }
  if (fit.rms <= kNearlySameLight) {
    return is_plain ? "B is nearly A as it is, not turned (C = C)"
                    : "B is nearly A " + calc::turn_words(fit.turn);
  }
  return fmt::format("A and B are not the same light; the nearest is A {}",
                     calc::turn_words(fit.turn));
}

std::string size_words(const calc::LuminousOpening& opening) {
  if (opening.shape == calc::OpeningShape::point) return "a point";
  const std::string body =
      opening.is_body() ? fmt::format(", {} m high", report::format_metres(opening.height_m)) : "";
  return fmt::format("{} m along C0 and {} m along C90{}",
                     report::format_metres(opening.along_c0_m),
                     report::format_metres(opening.along_c90_m), body);
}

std::string opening_words(const PhotometryFile& a, const PhotometryFile& b,
                          calc::OpeningRelation relation) {
  const std::string sizes =
      fmt::format(" (A {}, B {})", size_words(a.web->opening()), size_words(b.web->opening()));
  switch (relation) {
    case calc::OpeningRelation::agree:
      return "they agree with that" + sizes;
    case calc::OpeningRelation::exchanged:
      return "they do NOT agree with that: length and width are exchanged" + sizes;
    case calc::OpeningRelation::indifferent:
      return "their sides are equal and say nothing about a turn" + sizes;
    case calc::OpeningRelation::differ:
      return "they have different sizes" + sizes;
    case calc::OpeningRelation::not_stated:
      break;
  }
  return "not stated in both files" + sizes;
}

}  // namespace

std::string render_comparison_text(const PhotometryFile& a, const PhotometryFile& b,
                                   const calc::WebComparison& comparison, bool colour) {
  std::string text = file_line("A", a) + file_line("B", b);
  text += named_row(
      "flux", fmt::format("A {} lm, B {} lm: B / A = {}", report::format_fixed(a.web->flux_lm(), 1),
                          report::format_fixed(b.web->flux_lm(), 1),
                          report::format_fixed(comparison.flux_ratio, 4)));
  const calc::TurnFit& best = comparison.fits.front();
  const std::string found = found_words(best);
  text += named_row("found", colour ? "\033[1m" + found + "\033[0m" : found);
  text += named_row("residual", residual(best));
  if (comparison.alike == comparison.fits.size()) {
    text +=
        named_row("or as well", "any quarter turn and mirror image: this light shows none of them");
  } else {
    for (std::size_t i = 1; i < comparison.alike; ++i) {
      const calc::TurnFit& fit = comparison.fits[i];
      text += named_row(i == 1 ? "or as well" : "",
                        fmt::format("{}: {}", calc::turn_words(fit.turn), residual(fit)));
    }
    const calc::TurnFit& next = comparison.fits[comparison.alike];
    text +=
        named_row("next best", fmt::format("{}: {}", calc::turn_words(next.turn), residual(next)));
  }
  text += named_row("openings", opening_words(a, b, comparison.openings));
  return text;
}

}  // namespace cli
