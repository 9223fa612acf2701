#pragma once
// Traces paths from points to find what luminaires contribute to them: one pool of surface points
// serves every luminaire and every possible place of one, without a run for each.
//
//   E(x) = E_dir(x) + mean over paths of sum_k rho_1 ... rho_k E_dir(y_k),
//
// y_k: the hits of a path from x with density cos / pi. The weight of a surface point does not
// depend on luminaires [reciprocity; the adjoint of light paths]. The influence of a reflectance
// follows from the same paths: how often its surface is in the product.

#include "calc/base/message.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace calc {

// A mean of points, or a single point. Planar receivers only.
struct ImportanceTarget {
  std::vector<Receiver> receiver;  // local coordinates, at least one
  std::vector<double> weight;      // as many, > 0, their sum is any; empty: all count alike
};

// Surfaces that change their reflectance together.
struct SurfaceClasses {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_triangle;  // [triangle]; kNoClass: stays as it is
  double step = 0.1;                       // by which reflectances grow, for Change::step_lx
};
inline constexpr std::uint32_t kNoClass = 0xffffffffu;

struct ImportanceSettings {
  std::uint64_t seed = 1;
  std::size_t batches = 16;       // independent, >= 2: they give the intervals
  std::uint32_t paths = 256;      // of each target and batch, >= 1; best a power of two
  std::size_t most_points = 64;   // of a target with more points each batch draws as many, >= 1
  int jobs = 0;                   // threads; 0 = one per core. Never changes a result
  std::function<bool()> goes_on;  // asked now and then, on any thread; may be empty
};

struct ImportanceVertex {
  glm::dvec3 position_m, normal;  // local; unit, on the side that the path came from
  double weight;                  // what direct light of 1 lx here adds to the target, lx
};

struct ImportancePool {
  std::size_t targets = 0, classes = 0, batches = 0;
  std::vector<ImportanceVertex> vertices;  // those of a batch and target stand together
  std::vector<std::size_t> first;          // [batch * targets + target], and the end
  // [vertex * classes + class]: growth of its weight per unit of reflectance, and by the step.
  std::vector<double> slope, step;
  std::uint64_t rays = 0;
  Message problem;  // why there is none; "" = there is
};

// Returns the pool. After the first reflection paths continue with the reflectance as probability,
// but at least a quarter, so that dark surfaces that might be lighter are sampled as well.
// Unbiased. Parallel inside; the same bits for any number of threads.
ImportancePool trace_importance(const Tracer& tracer, std::span<const ImportanceTarget> targets,
                                const SurfaceClasses& classes, const ImportanceSettings& settings);

// Light of each luminaire on its own, new and at full output. Batches are independent, each an
// unbiased estimate, but exact parts are the same in all of them.
struct LightByLuminaire {
  std::size_t batches = 0, targets = 0, luminaires = 0, classes = 0;
  std::vector<double> direct_lx, reflected_lx;  // [(batch * targets + target) * luminaires + l]
  // Light that surfaces of a class would add: per unit of reflectance, and by the step.
  // [((batch * targets + target) * classes + class) * luminaires + l]
  std::vector<double> slope_lx, step_lx;
  std::uint64_t rays = 0;
  Message problem;  // why there is none; "" = there is

  double total_lx(std::size_t batch, std::size_t target, std::size_t luminaire) const {
    const std::size_t i = (batch * targets + target) * luminaires + luminaire;
    return direct_lx[i] + reflected_lx[i];
  }
  std::size_t class_index(std::size_t batch, std::size_t target, std::size_t surface_class,
                          std::size_t luminaire) const {
    return ((batch * targets + target) * classes + surface_class) * luminaires + luminaire;
  }
};

// Returns the light of each luminaire. tracer: of the same surfaces, in the same local coordinates,
// as the pool's; each luminaire has its own channel, see separate_luminaires(). One place of each
// opening is drawn for each surface point, near parts more often beside an opening; direct light at
// the targets is as for planes. The same bits for any number of threads.
LightByLuminaire light_of_luminaires(const Tracer& tracer,
                                     std::span<const ImportanceTarget> targets,
                                     const ImportancePool& pool,
                                     const ImportanceSettings& settings);

}  // namespace calc
