#include "report/tools/geometry/escape.h"

#include "calc/base/turns.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/scene/prepared_scene.h"
#include "report/tools/geometry/rimless.h"

#include <cmath>

namespace cli {
namespace {

constexpr std::uint64_t kMostPoints = 16384, kEnoughInside = 4096;
constexpr int kProbes = 32;    // rays that decide whether a point is inside; not counted again
constexpr int kFewEscape = 3;  // of them; in a corner outside a room a quarter gets out
// So many that agree from the first on decide alone. Without a rim all agree, but for rays through
// a gap that rounding leaves. With one they may differ: had only 60 % of all directions said so,
// eight would agree on the contrary in one point of 1500, and in most of those the rest, too.
constexpr int kAgreeWithoutRim = 2, kAgreeWithRim = 8;
constexpr double kNormalQuantile = 1.959963984540054;  // of 0.975

// Triangles with a corner that is not finite are left out.
calc::PreparedScene scene_of(const calc::SurfaceModel& model) {
  calc::Project project;
  project.materials.push_back({"surface", 0.0, {}});
  calc::Body body;
  body.vertex_m = model.vertex_m;
  for (const glm::uvec3& t : model.triangle) {
    const glm::dvec3 sum = model.vertex_m[t.x] + model.vertex_m[t.y] + model.vertex_m[t.z];
    if (std::isfinite(sum.x + sum.y + sum.z)) body.triangle.push_back(t);
  }
  for (glm::dvec3& v : body.vertex_m) {
    if (!std::isfinite(v.x + v.y + v.z)) v = glm::dvec3(0.0);  // of no triangle any more
  }
  body.material_of.assign(body.triangle.size(), 0);
  calc::Space space;
  space.bodies.push_back(std::move(body));
  return calc::prepare_scene(project, space);
}

class Sampler {
 public:
  Sampler(const calc::Tracer& tracer, double reach_m, bool is_sheet, bool has_rim)
      : tracer_(tracer),
        reach_m_(reach_m),
        is_sheet_(is_sheet),
        agree_(has_rim ? kAgreeWithRim : kAgreeWithoutRim) {}

  bool escapes(const glm::dvec3& from_m, calc::RandomKey key) const {
    calc::SurfaceHit hit;
    return !tracer_.closest_hit(from_m, direction(key), reach_m_, hit);
  }

  // As kProbes rays say; those that can change nothing any more are not traced.
  bool is_inside(const glm::dvec3& point_m, calc::RandomKey key) const {
    Votes votes;
    for (int probe = 0; probe < kProbes && !is_decided(votes); ++probe) {
      const int crossings = count_crossings(point_m, key.with(static_cast<std::uint64_t>(probe)));
      ++votes.rays;
      if (crossings % 2 == 1) ++votes.odd;
      if (crossings == 0) ++votes.escaped;
    }
    return says_inside(votes);
  }

 private:
  struct Votes {
    int rays = 0, odd = 0, escaped = 0;
  };

  bool says_inside(const Votes& votes) const {
    return 2 * votes.odd > votes.rays || (!is_sheet_ && votes.escaped <= kFewEscape);
  }

  bool is_decided(const Votes& votes) const {
    if (2 * votes.odd > kProbes) return true;
    const bool all_agree = votes.rays == agree_ && (votes.odd == votes.rays || votes.odd == 0);
    const bool is_even = 2 * (votes.odd + kProbes - votes.rays) <= kProbes;
    if (votes.odd > 0 && all_agree) return true;
    return (is_even || all_agree) && (is_sheet_ || votes.escaped > kFewEscape);
  }

  static glm::dvec3 direction(calc::RandomKey key) {
    const double z = 2.0 * key.with(0u).uniform() - 1.0;
    const double r = std::sqrt(1.0 - z * z);
    const calc::SineCosine turn = calc::sine_cosine_of_turns(key.with(1u).uniform());
    return {r * turn.cosine, r * turn.sine, z};
  }

  int count_crossings(glm::dvec3 from_m, calc::RandomKey key) const {
    constexpr int kMost = 1000;  // enough: each one moves the ray on
    const glm::dvec3 along = direction(key);
    calc::SurfaceHit hit;
    int count = 0;
    while (count < kMost && tracer_.closest_hit(from_m, along, reach_m_, hit)) {
      ++count;
      from_m = tracer_.lift(hit.position_m, -hit.normal);
    }
    return count;
  }

  const calc::Tracer& tracer_;
  double reach_m_;
  bool is_sheet_;
  int agree_;  // from the first probe on: enough
};

// Score interval: unlike Student's t it says something when nothing has escaped. [Wilson27]
calc::Estimate wilson_interval(std::uint64_t successes, std::uint64_t trials) {
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z2 = kNormalQuantile * kNormalQuantile;
  const double centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      kNormalQuantile * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n)) / (1.0 + z2 / n);
  // Both ends are 0 or 1 exactly where they should be, but for rounding.
  return {p, successes == 0 ? 0.0 : centre - half, successes == trials ? 1.0 : centre + half};
}

}  // namespace

Escape measure_escape(const calc::SurfaceModel& model, const calc::BoundingBox& bounds_m,
                      bool is_sheet) {
  Escape escape;
  const calc::PreparedScene scene = scene_of(model);
  const glm::dvec3 size_m = bounds_m.upper - bounds_m.lower;
  if (scene.triangle.empty() || bounds_m.is_empty() || !(size_m.x * size_m.y * size_m.z > 0.0)) {
    return escape;  // a flat sheet has no inside
  }
  const calc::FlushDenormals flush;
  const calc::Tracer tracer(scene);
  const Sampler sampler(tracer, 4.0 * scene.whole_extent_m(), is_sheet, !is_rimless(model));
  const calc::RandomKey seed = calc::RandomKey(1).with("geometry");
  std::uint64_t tried = 0, escaped = 0;
  for (; tried < kMostPoints && escape.points < kEnoughInside; ++tried) {
    const calc::RandomKey key = seed.with(tried);
    const glm::dvec3 u(key.with(0u).uniform(), key.with(1u).uniform(), key.with(2u).uniform());
    const glm::dvec3 point_m = bounds_m.lower + u * size_m - scene.origin_m;
    if (!sampler.is_inside(point_m, key.with(3u))) continue;
    ++escape.points;
    if (sampler.escapes(point_m, key.with(4u))) ++escaped;
  }
  escape.inside_share = static_cast<double>(escape.points) / static_cast<double>(tried);
  if (escape.points > 0) escape.share = wilson_interval(escaped, escape.points);
  return escape;
}

}  // namespace cli
