#include "calc/photometry/web_compare.h"

#include "calc/base/units.h"
#include "calc/photometry/web_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace calc {
namespace {

constexpr double kDarkShare = 0.01;
constexpr double kSameSize_m = 0.005, kSameSizeShare = 0.03;

// One angle in the frames of both webs.
struct PlanePair {
  double c_a_rad, c_b_rad;
};

std::vector<PlanePair> plane_pairs(const MeasureAngles& a, const MeasureAngles& b, WebTurn turn) {
  const double shift = 0.5 * kPi * turn.quarters;
  // A single plane says nothing about C.
  const bool from_a =
      b.c_rad.size() == 1 || (a.c_rad.size() > 1 && a.c_rad.size() < b.c_rad.size());
  std::vector<PlanePair> pairs;
  for (const double c : from_a ? a.c_rad : b.c_rad) {
    const double image =
        from_a ? (turn.mirrored ? shift - c : c + shift) : (turn.mirrored ? shift - c : c - shift);
    pairs.push_back(from_a ? PlanePair{c, image} : PlanePair{image, c});
  }
  return pairs;
}

std::vector<double> gamma_angles(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double>& coarse = b.size() < a.size() ? b : a;
  const std::vector<double>& fine = b.size() < a.size() ? a : b;
  std::vector<double> angles = coarse;
  for (const double gamma : fine) {
    if (gamma < coarse.front() || gamma > coarse.back()) angles.push_back(gamma);
  }
  return angles;
}

bool same_size(double a_m, double b_m) {
  return std::abs(a_m - b_m) <= std::max(kSameSize_m, kSameSizeShare * std::max(a_m, b_m));
}

TurnFit fit_turn(const PhotometricWeb& a, const PhotometricWeb& b, const MeasureAngles& angles_a,
                 const MeasureAngles& angles_b, WebTurn turn) {
  const double highest =
      std::max(a.max_intensity_cd() / a.flux_lm(), b.max_intensity_cd() / b.flux_lm());
  double sum = 0.0;
  double largest = 0.0;
  std::size_t count = 0;
  const std::vector<double> gammas = gamma_angles(angles_a.gamma_rad, angles_b.gamma_rad);
  for (const PlanePair& pair : plane_pairs(angles_a, angles_b, turn)) {
    for (const double gamma : gammas) {
      const double in_a = a.intensity_cd(pair.c_a_rad, gamma) / a.flux_lm();
      const double in_b = b.intensity_cd(pair.c_b_rad, gamma) / b.flux_lm();
      if (std::max(in_a, in_b) < kDarkShare * highest) continue;
      const double difference = std::abs(in_b - in_a) / highest;
      sum += difference * difference;
      largest = std::max(largest, difference);
      ++count;
    }
  }
  return {turn, count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)), largest};
}

}  // namespace

OpeningRelation relate_openings(const LuminousOpening& a, const LuminousOpening& b, WebTurn turn) {
  if (a.shape == OpeningShape::point || b.shape == OpeningShape::point) {
    return OpeningRelation::not_stated;
  }
  const bool heights_agree = !a.is_body() || !b.is_body() || same_size(a.height_m, b.height_m);
  const auto equal = [&](bool exchange) {
    return heights_agree && same_size(exchange ? a.along_c90_m : a.along_c0_m, b.along_c0_m) &&
           same_size(exchange ? a.along_c0_m : a.along_c90_m, b.along_c90_m);
  };
  const bool exchange = turn.quarters % 2 == 1;  // mirror images of odd turns exchange them, too
  const bool with = equal(exchange);
  const bool without = equal(!exchange);
  if (with && without) return OpeningRelation::indifferent;
  if (with) return OpeningRelation::agree;
  return without ? OpeningRelation::exchanged : OpeningRelation::differ;
}

WebComparison compare_webs(const PhotometricWeb& a, const PhotometricWeb& b) {
  const MeasureAngles angles_a = measure_angles(a);
  const MeasureAngles angles_b = measure_angles(b);
  WebComparison comparison;
  comparison.flux_ratio = b.flux_lm() / a.flux_lm();
  for (const bool mirrored : {false, true}) {
    for (int quarters = 0; quarters < 4; ++quarters) {
      comparison.fits.push_back(fit_turn(a, b, angles_a, angles_b, {quarters, mirrored}));
    }
  }
  std::vector<TurnFit>& fits = comparison.fits;
  std::stable_sort(fits.begin(), fits.end(),
                   [](const TurnFit& x, const TurnFit& y) { return x.rms < y.rms; });
  const double limit = fits.front().rms + kIndistinguishable;
  const auto others =
      std::find_if(fits.begin(), fits.end(), [&](const TurnFit& fit) { return fit.rms > limit; });
  comparison.alike = static_cast<std::size_t>(others - fits.begin());
  const auto rank = [&](const TurnFit& fit) {
    const bool is_against =
        relate_openings(a.opening(), b.opening(), fit.turn) == OpeningRelation::exchanged;
    return std::tuple(is_against, fit.turn.mirrored, fit.turn.quarters);
  };
  std::sort(fits.begin(), others,
            [&](const TurnFit& x, const TurnFit& y) { return rank(x) < rank(y); });
  comparison.openings = relate_openings(a.opening(), b.opening(), fits.front().turn);
  return comparison;
}

std::string turn_words(WebTurn turn) {
  if (!turn.mirrored) {
    if (turn.quarters == 0) return "not turned";
    return fmt::format("turned by {0} degrees about the vertical axis (C = C + {0})",
                       90 * turn.quarters);
  }
  // C -> q - C leaves C = q / 2 where it is.
  const int plane = 45 * turn.quarters;
  const std::string image =
      turn.quarters == 0 ? "C = -C" : fmt::format("C = {} - C", 90 * turn.quarters);
  return fmt::format("mirrored at the plane C {}-C {} ({})", plane, plane + 180, image);
}

}  // namespace calc
