#include "calc/radiosity/direct/direct.h"

#include "calc/photometry/web_sketch.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/shadow_batch.h"
#include "calc/radiosity/terms/opening_constants.h"
#include "calc/scene/opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace calc {
namespace {

bool is_point(const PlacedLuminaire& luminaire) {
  return luminaire.opening.shape == OpeningShape::point;
}

void add_source(ShadowBatch& batch, const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                const Receiver& receiver, const glm::vec3& from_m, double weight, double offset_m,
                double* sums, std::size_t stride, float* largest = nullptr) {
  const double lx = point_illuminance_lx(luminaire, source_m, receiver);
  if (lx <= 0.0) return;
  batch.add(from_m, glm::vec3(lifted_source_m(luminaire, source_m, receiver.position_m, offset_m)),
            weight * lx, &sums[luminaire.channel * stride], largest);
}

// A point of a luminaire's opening, as seen from the receiver, with all of its light for `weight`.
void add_opening_point(ShadowBatch& batch, const PlacedLuminaire& luminaire,
                       const OpeningView& view, double s, double t, const Receiver& receiver,
                       const glm::vec3& from_m, double weight, double offset_m, double* sums,
                       std::size_t stride, float* largest = nullptr) {
  const OpeningView::Point source = view.point(s, t);
  if (!luminaire.opening.is_body()) {
    return add_source(batch, luminaire, source.position_m, receiver, from_m, weight, offset_m, sums,
                      stride, largest);
  }
  const glm::dvec3 out = glm::normalize(receiver.position_m - source.position_m);
  const double lx =
      view.weight(source, out) * point_illuminance_lx(luminaire, source.position_m, receiver);
  if (!(lx > 0.0)) return;
  batch.add(from_m, glm::vec3(source.position_m + offset_m * source.normal), weight * lx,
            &sums[luminaire.channel * stride], largest);
}

OpeningView view_from(const PlacedLuminaire& luminaire, const glm::dvec3& position_m) {
  const glm::dvec3 to_point = position_m - luminaire.position_m;
  const double distance_m = glm::length(to_point);
  // At the centre of a flat opening any direction will do.
  return {luminaire, distance_m > 0.0 ? to_point / distance_m : -luminaire.world_from_luminaire[2]};
}

struct CellExtent {
  glm::dvec3 centre_m;
  double diameter_m;
  double length_s_m, length_t_m;  // of its longest line along s and along t
};

CellExtent cell_extent(const OpeningView& view, const OpeningCell& cell) {
  // Just inside, where two faces meet.
  constexpr std::array<double, 3> kPlaces{1.0e-9, 0.5, 1.0 - 1.0e-9};
  std::array<std::array<glm::dvec3, 3>, 3> at;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      at[i][k] = view.point(cell.s + kPlaces[i] * cell.size_s, cell.t + kPlaces[k] * cell.size_t)
                     .position_m;
    }
  }
  CellExtent extent{at[1][1], 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      extent.diameter_m =
          std::max(extent.diameter_m, 2.0 * glm::length(at[i][k] - extent.centre_m));
    }
    extent.length_s_m = std::max(
        extent.length_s_m, glm::length(at[1][i] - at[0][i]) + glm::length(at[2][i] - at[1][i]));
    extent.length_t_m = std::max(
        extent.length_t_m, glm::length(at[i][1] - at[i][0]) + glm::length(at[i][2] - at[i][1]));
  }
  return extent;
}

std::uint32_t cell_samples(double diameter_m, double distance_m, double error_factor) {
  const double ratio = std::min(1.0, diameter_m / distance_m);
  const double wanted = kCellError * ratio / (kCellWantedError * error_factor);  // n^1.5
  double n = 1.0;
  while (n * n * n < wanted * wanted) n *= 2.0;
  return static_cast<std::uint32_t>(n);
}

// A receiver in touch with the opening would split for ever. 2^-32 of its sides is below the
// distance that any receiver keeps, see ray_offset_m().
constexpr int kDeepestSplit = 64;
// A part reaches no farther from its middle than half its diameter, but for bent ones.
constexpr double kJustOutside = 1.5;

// What parts are made of, and for which point.
struct SplitOpening {
  const PlacedLuminaire& luminaire;
  const OpeningView view;
  const glm::dvec3& position_m;
  double error_factor;
  bool is_narrow;        // its beams
  double largest_ratio;  // of a part's diameter to its distance, where it is not lit as a whole
};

void split_cell(const SplitOpening& split, const OpeningCell& cell, int depth,
                std::vector<OpeningCell>& cells) {
  const CellExtent extent = cell_extent(split.view, cell);
  const double distance = glm::length(extent.centre_m - split.position_m);
  double largest_ratio = 1.0;
  if (split.is_narrow) {
    const double radius_m = kJustOutside * 0.5 * extent.diameter_m;
    const WebSketch::Band band =
        intensities_towards(split.luminaire, extent.centre_m, radius_m, split.position_m);
    if (band.most_cd == 0.0) return;
    if (band.is_partly_dark) largest_ratio = split.largest_ratio;
  }
  if (extent.diameter_m <= largest_ratio * distance || depth == kDeepestSplit) {
    cells.push_back(cell);
    cells.back().samples = cell_samples(extent.diameter_m, distance, split.error_factor);
    return;
  }
  // The longer side is halved, so that parts stay about as long as wide.
  OpeningCell first = cell;
  const bool is_along_s = extent.length_s_m >= kAlikeSides * extent.length_t_m;
  (is_along_s ? first.size_s : first.size_t) *= 0.5;
  OpeningCell second = first;
  (is_along_s ? second.s : second.t) += is_along_s ? first.size_s : first.size_t;
  split_cell(split, first, depth + 1, cells);
  split_cell(split, second, depth + 1, cells);
}

// Parts as small as narrow beams want them, if is_fine; else as small as they are far.
std::vector<OpeningCell> cells_of(const PlacedLuminaire& luminaire, const glm::dvec3& position_m,
                                  double error_factor, bool is_fine) {
  const double finest_rad =
      is_fine ? luminaire.web->sketch().finest_rad() : std::numeric_limits<double>::infinity();
  const bool is_narrow = std::isfinite(finest_rad);
  const double largest_ratio = is_narrow ? std::min(1.0, kPartOfBeam * finest_rad) : 1.0;
  const SplitOpening split{luminaire,  view_from(luminaire, position_m),
                           position_m, error_factor,
                           is_narrow,  largest_ratio};
  const double size_m = glm::length(luminaire.opening.size_m());
  const double distance_m = glm::length(luminaire.position_m - position_m);
  std::vector<OpeningCell> cells;
  if (size_m <= largest_ratio * distance_m) {
    cells.push_back({});
    cells.back().samples = cell_samples(size_m, distance_m, error_factor);
    return cells;
  }
  const std::span<const double> ends = split.view.piece_ends();  // the faces of a body
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    split_cell(split, {ends[i], 0.0, ends[i + 1] - ends[i], 1.0, 1}, 0, cells);
  }
  return cells;
}

struct DrawnCell {
  OpeningCell cell;
  double probability = 0.0;  // 0: all parts are behind the receiver
};

// A part of an opening, near ones more often: in proportion to area, cosine and 1 / distance^2.
// Parts are no larger than their distance, so that none that the receiver sees is left out, and
// that no sample is much larger than the whole.
template <class Uniform>
DrawnCell draw_cell(const OpeningView& view, const std::vector<OpeningCell>& cells,
                    const Receiver& receiver, double least_m, const Uniform& uniform) {
  if (cells.size() == 1) return {cells.front(), 1.0};
  std::vector<double> up_to;  // sums of weights
  double sum = 0.0;
  for (const OpeningCell& cell : cells) {
    const glm::dvec3 way =
        view.point(cell.s + 0.5 * cell.size_s, cell.t + 0.5 * cell.size_t).position_m -
        receiver.position_m;
    const double distance = std::max(glm::length(way), least_m);
    const double cosine = glm::dot(way, receiver.axis) / distance;
    sum += cell.size_s * cell.size_t * std::max(0.0, cosine + 0.5) / (distance * distance);
    up_to.push_back(sum);
  }
  if (!(sum > 0.0)) return {};
  const auto found = std::upper_bound(up_to.begin(), up_to.end() - 1, uniform() * sum);
  const auto k = static_cast<std::size_t>(found - up_to.begin());
  return {cells[k], (up_to[k] - (k > 0 ? up_to[k - 1] : 0.0)) / sum};
}

}  // namespace

bool has_extended_luminaires(const PreparedScene& scene) {
  return !std::all_of(scene.luminaires.begin(), scene.luminaires.end(), is_point);
}

DirectRays add_point_sources(const Tracer& tracer, const Receiver& receiver,
                             const DirectProofs& proofs, double* sums, std::size_t stride) {
  ShadowBatch batch(tracer, proofs.has_shadows, kReceiverToSource);
  const glm::vec3 from(tracer.lift(receiver));
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = luminaires[l];
    if (!is_point(luminaire) || proofs.leaves_out(l)) continue;
    if (luminaire.reach && !luminaire.reach->holds(luminaire.position_m, receiver.position_m)) {
      continue;
    }
    add_source(batch, luminaire, luminaire.position_m, receiver, from, 1.0, tracer.offset_m(), sums,
               stride);
  }
  batch.flush();
  return {batch.rays(), batch.has_contributions(), batch.has_hidden(), batch.has_seen()};
}

void add_opening_samples(ShadowBatch& batch, const Tracer& tracer, std::size_t luminaire,
                         std::span<const OpeningCell> cells, const Receiver& receiver,
                         RandomKey key, std::uint32_t first_round, std::uint32_t last_round,
                         double* sums, std::size_t stride, float* largest) {
  const PlacedLuminaire& placed = tracer.scene().luminaires[luminaire];
  const glm::vec3 from(tracer.lift(receiver));
  const OpeningView view = view_from(placed, receiver.position_m);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const OpeningCell& cell = cells[c];
    const double weight =
        cell.size_s * cell.size_t / cell.samples;  // the sample square is area-preserving
    const ScrambledSobol sobol(key.with(luminaire).with(c));
    for (std::uint32_t i = first_round * cell.samples; i < last_round * cell.samples; ++i) {
      const auto u = sobol.sample_pair(i, 0);
      add_opening_point(batch, placed, view, cell.s + cell.size_s * u[0],
                        cell.t + cell.size_t * u[1], receiver, from, weight, tracer.offset_m(),
                        sums, stride, largest);
    }
  }
}

DirectRays add_extended_sources(const Tracer& tracer, const Receiver& receiver,
                                const DirectProofs& proofs, RandomKey key,
                                std::uint32_t first_round, std::uint32_t last_round, double* sums,
                                std::size_t stride, float* largest) {
  ShadowBatch batch(tracer, proofs.has_shadows, kReceiverToSource);
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    if (is_point(luminaires[l]) || proofs.leaves_out(l)) continue;
    add_opening_samples(batch, tracer, l, opening_cells(luminaires[l], receiver.position_m),
                        receiver, key, first_round, last_round, sums, stride, largest);
  }
  batch.flush();
  return {batch.rays(), batch.has_contributions(), batch.has_hidden(), batch.has_seen()};
}

std::uint64_t add_direct_sample(const Tracer& tracer, const Receiver& receiver, RandomKey key,
                                double weight, double* sums, std::size_t stride) {
  ShadowBatch batch(tracer, tracer.has_shadows(), kHitToSource);
  const glm::vec3 from(tracer.lift(receiver));
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    const RandomKey opening_key = key.with(l);
    add_opening_point(batch, luminaires[l], view_from(luminaires[l], receiver.position_m),
                      opening_key.with(0).uniform(), opening_key.with(1).uniform(), receiver, from,
                      weight, tracer.offset_m(), sums, stride);
  }
  batch.flush();
  return batch.rays();
}

std::uint64_t add_direct_sample_of(const Tracer& tracer, std::size_t luminaire,
                                   const Receiver& receiver, RandomKey key, double weight,
                                   double* sums, std::size_t stride) {
  const PlacedLuminaire& placed = tracer.scene().luminaires[luminaire];
  const OpeningView view = view_from(placed, receiver.position_m);
  const DrawnCell drawn =
      draw_cell(view, cells_of(placed, receiver.position_m, 1.0, false), receiver,
                tracer.offset_m(), [&key] { return key.with(3).uniform(); });
  if (!(drawn.probability > 0.0)) return 0;
  ShadowBatch batch(tracer, tracer.has_shadows(), kHitToSource);
  const OpeningCell& cell = drawn.cell;
  add_opening_point(
      batch, placed, view, cell.s + cell.size_s * key.with(0).uniform(),
      cell.t + cell.size_t * key.with(1).uniform(), receiver, glm::vec3(tracer.lift(receiver)),
      weight * cell.size_s * cell.size_t / drawn.probability, tracer.offset_m(), sums, stride);
  batch.flush();
  return batch.rays();
}

std::vector<OpeningCell> opening_cells(const PlacedLuminaire& luminaire,
                                       const glm::dvec3& position_m, double error_factor) {
  return cells_of(luminaire, position_m, error_factor, true);
}

bool has_fine_beams(const PreparedScene& scene, const DirectProofs& proofs,
                    std::span<const Receiver> receivers) {
  for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = scene.luminaires[l];
    if (is_point(luminaire) || proofs.leaves_out(l)) continue;
    const double finest_rad = luminaire.web->sketch().finest_rad();
    if (!std::isfinite(finest_rad)) continue;
    const double size_m = glm::length(luminaire.opening.size_m());
    for (const Receiver& receiver : receivers) {
      const double distance_m = glm::length(luminaire.position_m - receiver.position_m);
      if (size_m > kOnePlaceOfBeam * finest_rad * distance_m) return true;
    }
  }
  return false;
}

}  // namespace calc
