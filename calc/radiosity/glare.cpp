#include "calc/radiosity/glare.h"

#include "calc/radiosity/emission.h"
#include "calc/radiosity/opening.h"
#include "calc/radiosity/shadow_batch.h"
#include "calc/units.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

// Of a source as the eye sees it, by its centre; multiples of the distance along the line of sight.
struct SeenAt {
  double along_m, sideways, upwards;

  SeenAt(const glm::dvec3& to_source, const glm::dvec3& look)
      : along_m(glm::dot(to_source, look)),
        sideways(glm::length(glm::cross(look, to_source - to_source.z * kUp)) / along_m),
        upwards(to_source.z / along_m) {}

  bool is_in_field() const {
    return along_m > 0.0 && sideways <= kWidestSource + kBinaryNoise &&
           std::abs(upwards) <= kHighestSource + kBinaryNoise;
  }
  bool is_below() const { return upwards < -kBinaryNoise; }

  static constexpr double kBinaryNoise = 1.0e-9;
  static constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};
};

// Lines of sight from an eye to an opening: how many could reach it, and how many do.
struct Sight {
  double open = 0.0;
  std::size_t lines = 0;
};

Sight look_at(const Tracer& tracer, const PlacedLuminaire& luminaire, const Receiver& receiver,
              bool has_shadows, std::uint64_t& rays) {
  ShadowBatch batch(tracer, has_shadows);
  const glm::vec3 from(tracer.lift(receiver));
  const glm::dvec3 towards = glm::normalize(receiver.position_m - luminaire.position_m);
  const OpeningView view(luminaire, towards);
  const bool is_point = luminaire.opening.shape == OpeningShape::point;
  const std::size_t side = is_point ? 1 : kSightLines;
  Sight sight;
  for (std::size_t k = 0; k < side * side; ++k) {
    const OpeningView::Point at =
        view.point((static_cast<double>(k % side) + 0.5) / static_cast<double>(side),
                   (static_cast<double>(k / side) + 0.5) / static_cast<double>(side));
    glm::dvec3 to =
        lifted_source_m(luminaire, at.position_m, receiver.position_m, tracer.offset_m());
    if (luminaire.opening.is_body()) {
      // The outline is that for a far eye; a near one sees less of a body.
      if (!(glm::dot(at.normal, receiver.position_m - at.position_m) > 0.0)) continue;
      to = at.position_m + tracer.offset_m() * at.normal;
    }
    ++sight.lines;
    batch.add(from, glm::vec3(to), 1.0, &sight.open);
  }
  batch.flush();
  rays += batch.rays();
  return sight;
}

double intensity_cd(const PlacedLuminaire& luminaire, const glm::dvec3& direction) {
  const glm::dvec3 out = glm::transpose(luminaire.world_from_luminaire) * direction;
  return luminaire.web->intensity_cd({out.x, out.y, out.z}) * luminaire.flux_scale;
}

class GlareEye {
 public:
  GlareEye(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
           std::span<GlareSum> sums)
      : tracer_(tracer), receiver_(receiver), has_shadows_(has_shadows), sums_(sums) {}

  void add(const PlacedLuminaire& luminaire) {
    const glm::dvec3 to_source = luminaire.position_m - receiver_.position_m;
    const SeenAt seen(to_source, receiver_.axis);
    if (!seen.is_in_field()) return;
    const double r2 = glm::dot(to_source, to_source);
    const glm::dvec3 out = to_source / -std::sqrt(r2);
    const double cd = intensity_cd(luminaire, out);
    if (!(cd > 0.0)) return;
    const Sight sight = look_at(tracer_, luminaire, receiver_, has_shadows_, rays_);
    if (!(sight.open > 0.0)) return;
    const double area_m2 = seen_opening_m2(luminaire, out);
    const double solid_angle_sr = area_m2 / r2;
    if (!(area_m2 > 0.0)) return refuse(luminaire, GlareProblem::no_area, 0.0);
    if (seen.is_below()) return refuse(luminaire, GlareProblem::below_sight, seen.upwards);
    if (solid_angle_sr > kLargestGlareSource_sr) {
      return refuse(luminaire, GlareProblem::too_large, solid_angle_sr);
    }
    const double index = guth_index(to_source, receiver_.axis).value();
    const double whole = cd * cd / (area_m2 * r2) / (index * index);
    add(sums_[luminaire.channel], whole, sight, solid_angle_sr < kSmallestGlareSource_sr);
  }

  std::uint64_t rays() const { return rays_; }

 private:
  static void add(GlareSum& sum, double whole, const Sight& sight, bool is_too_small) {
    const double share = sight.open / static_cast<double>(sight.lines);
    const double doubt = share < 1.0 ? 1.0 / static_cast<double>(kSightLines) : 0.0;
    sum.value += whole * share;
    sum.high += whole * std::min(1.0, share + doubt);
    if (!is_too_small) sum.low += whole * std::max(0.0, share - doubt);
  }

  void refuse(const PlacedLuminaire& luminaire, GlareProblem problem, double number) {
    std::optional<GlareRefusal>& refusal = sums_[luminaire.channel].refusal;
    if (refusal) return;
    refusal = GlareRefusal{0, luminaire.channel, problem, number, {}};
    const glm::dvec3 world_m = luminaire.position_m + tracer_.scene().origin_m;
    refusal->luminaire_m = {world_m.x, world_m.y, world_m.z};
  }

  const Tracer& tracer_;
  const Receiver& receiver_;
  bool has_shadows_;
  std::span<GlareSum> sums_;
  std::uint64_t rays_ = 0;
};

}  // namespace

std::optional<double> guth_index(const glm::dvec3& to_source, const glm::dvec3& look) {
  const SeenAt seen(to_source, look);
  if (!seen.is_in_field() || seen.is_below()) return std::nullopt;
  const double upwards = std::max(0.0, seen.upwards);
  const double s = degrees_from_radians(std::atan(std::hypot(seen.sideways, upwards)));
  const double t = degrees_from_radians(std::atan2(seen.sideways, upwards));
  return std::exp((35.2 - 0.31889 * t - 1.22 * std::exp(-2.0 * t / 9.0)) * 1.0e-3 * s +
                  (21.0 + 0.26667 * t - 0.002963 * t * t) * 1.0e-5 * s * s);
}

std::uint64_t add_glare_sources(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
                                std::span<GlareSum> channel_sums) {
  GlareEye eye(tracer, receiver, has_shadows, channel_sums);
  for (const PlacedLuminaire& luminaire : tracer.scene().luminaires) eye.add(luminaire);
  return eye.rays();
}

}  // namespace calc
