#include "calc/radiosity/direct.h"

#include "calc/radiosity/low_discrepancy.h"
#include "calc/radiosity/shadow_batch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace calc {
namespace {

bool is_point(const PlacedLuminaire& luminaire) {
  return luminaire.opening.shape == OpeningShape::point;
}

void add_source(ShadowBatch& batch, const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                const Receiver& receiver, const glm::vec3& from_m, double weight, double offset_m,
                double* sums, std::size_t stride) {
  const double lx = point_illuminance_lx(luminaire, source_m, receiver);
  if (lx <= 0.0) return;
  batch.add(from_m, glm::vec3(lifted_source_m(luminaire, source_m, receiver.position_m, offset_m)),
            weight * lx, &sums[luminaire.channel * stride]);
}

struct CellExtent {
  glm::dvec3 centre_m;
  double diameter_m;
};

CellExtent cell_extent(const PlacedLuminaire& luminaire, const OpeningCell& cell) {
  const auto at = [&](double s, double t) {
    return opening_point_m(luminaire, cell.s + s * cell.size, cell.t + t * cell.size);
  };
  if (cell.size == 1.0) {  // the whole opening
    const LuminousOpening& opening = luminaire.opening;
    return {luminaire.position_m, std::hypot(opening.along_c0_m, opening.along_c90_m)};
  }
  const glm::dvec3 centre = at(0.5, 0.5);
  double radius = 0.0;
  for (const double s : {0.0, 0.5, 1.0}) {
    for (const double t : {0.0, 0.5, 1.0})
      radius = std::max(radius, glm::length(at(s, t) - centre));
  }
  return {centre, 2.0 * radius};
}

std::uint32_t cell_samples(double diameter_m, double distance_m) {
  // n points of a scrambled net on a part are off by 0.8 diameter / distance * n^-1.5.  [measured
  // for a Lambertian panel at 45 degrees: within 35 % of that for 1 to 64 points and 1 to 8
  // diameters]
  constexpr double kOneSampleError = 0.8;
  constexpr double kWantedError = 0.005;
  const double ratio = std::min(1.0, diameter_m / distance_m);
  return std::bit_ceil(static_cast<std::uint32_t>(
      std::ceil(std::pow(kOneSampleError * ratio / kWantedError, 2.0 / 3.0))));
}

// A receiver in touch with the opening would split for ever; 2^-12 of an opening is a fraction of a
// millimetre.
constexpr int kDeepestSplit = 12;

void split_cell(const PlacedLuminaire& luminaire, const glm::dvec3& position_m,
                const OpeningCell& cell, int depth, std::vector<OpeningCell>& cells) {
  const CellExtent extent = cell_extent(luminaire, cell);
  const double distance = glm::length(extent.centre_m - position_m);
  if (extent.diameter_m <= distance || depth == kDeepestSplit) {
    cells.push_back({cell.s, cell.t, cell.size, cell_samples(extent.diameter_m, distance)});
    return;
  }
  const double half = 0.5 * cell.size;
  for (const double ds : {0.0, half}) {
    for (const double dt : {0.0, half}) {
      split_cell(luminaire, position_m, {cell.s + ds, cell.t + dt, half, 1}, depth + 1, cells);
    }
  }
}

}  // namespace

bool has_extended_luminaires(const PreparedScene& scene) {
  return !std::all_of(scene.luminaires.begin(), scene.luminaires.end(), is_point);
}

DirectRays add_point_sources(const Tracer& tracer, const Receiver& receiver,
                             const DirectProofs& proofs, double* sums, std::size_t stride) {
  ShadowBatch batch(tracer, proofs.has_shadows);
  const glm::vec3 from(tracer.lift(receiver));
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = luminaires[l];
    if (!is_point(luminaire) || proofs.leaves_out(l)) continue;
    add_source(batch, luminaire, luminaire.position_m, receiver, from, 1.0, tracer.offset_m(), sums,
               stride);
  }
  batch.flush();
  return {batch.rays(), batch.has_contributions()};
}

DirectRays add_extended_sources(const Tracer& tracer, const Receiver& receiver,
                                const DirectProofs& proofs, RandomKey key,
                                std::uint32_t first_round, std::uint32_t last_round, double* sums,
                                std::size_t stride) {
  ShadowBatch batch(tracer, proofs.has_shadows);
  const glm::vec3 from(tracer.lift(receiver));
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    if (is_point(luminaires[l]) || proofs.leaves_out(l)) continue;
    const std::vector<OpeningCell> cells = opening_cells(luminaires[l], receiver.position_m);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const OpeningCell& cell = cells[c];
      const double weight =
          cell.size * cell.size / cell.samples;  // the sample square is area-preserving
      const ScrambledSobol sobol(key.with(l).with(c));
      for (std::uint32_t i = first_round * cell.samples; i < last_round * cell.samples; ++i) {
        const auto u = sobol.sample_pair(i, 0);
        const glm::dvec3 source =
            opening_point_m(luminaires[l], cell.s + cell.size * u[0], cell.t + cell.size * u[1]);
        add_source(batch, luminaires[l], source, receiver, from, weight, tracer.offset_m(), sums,
                   stride);
      }
    }
  }
  batch.flush();
  return {batch.rays(), batch.has_contributions()};
}

std::uint64_t add_direct_sample(const Tracer& tracer, const Receiver& receiver, RandomKey key,
                                double weight, double* sums, std::size_t stride) {
  ShadowBatch batch(tracer, tracer.has_shadows());
  const glm::vec3 from(tracer.lift(receiver));
  const auto& luminaires = tracer.scene().luminaires;
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    const RandomKey opening_key = key.with(l);
    const glm::dvec3 source = opening_point_m(luminaires[l], opening_key.with(0).uniform(),
                                              opening_key.with(1).uniform());
    add_source(batch, luminaires[l], source, receiver, from, weight, tracer.offset_m(), sums,
               stride);
  }
  batch.flush();
  return batch.rays();
}

std::vector<OpeningCell> opening_cells(const PlacedLuminaire& luminaire,
                                       const glm::dvec3& position_m) {
  std::vector<OpeningCell> cells;
  split_cell(luminaire, position_m, {}, 0, cells);
  return cells;
}

}  // namespace calc
