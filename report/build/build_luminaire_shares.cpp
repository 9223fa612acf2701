#include "report/build/build_luminaire_shares.h"

#include "calc/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

namespace report {
namespace {

// One replicate's light of some luminaires, maintained.
struct Light {
  double average_lx = 0.0, direct_lx = 0.0, minimum_lx = 0.0, minimum_direct_lx = 0.0;
};

class FieldReader {
 public:
  FieldReader(const calc::PlaneField& field, std::size_t points, std::size_t minimum_point,
              double level)
      : field_(field), points_(points), minimum_point_(minimum_point), level_(level) {}

  // A field that was not sampled has replicates all the same, and all of them say one thing.
  std::size_t replicates() const { return field_.is_exact() ? 1 : field_.replicates; }

  Light light(std::size_t channel, std::size_t replicate) const {
    Light light;
    const std::vector<double>& weight = field_.point_weight;
    const double weights = weight.empty() ? static_cast<double>(points_)
                                          : std::accumulate(weight.begin(), weight.end(), 0.0);
    for (std::size_t i = 0; i < points_; ++i) {
      const auto [all_lx, direct_lx] = at_point(channel, replicate, i);
      const double counts = weight.empty() ? 1.0 : weight[i];
      light.average_lx += counts * all_lx / weights;
      light.direct_lx += counts * direct_lx / weights;
      if (i != minimum_point_) continue;
      light.minimum_lx = all_lx;
      light.minimum_direct_lx = direct_lx;
    }
    return light;
  }

  // Of one luminaire, or of several together: [replicate].
  void estimate(const std::vector<Light>& light, LuminaireShare& share) const {
    std::vector<double> average_lx, minimum_lx;
    for (const Light& one : light) {
      average_lx.push_back(one.average_lx);
      minimum_lx.push_back(one.minimum_lx);
      share.direct_lx += one.direct_lx / static_cast<double>(light.size());
      share.minimum_direct_lx += one.minimum_direct_lx / static_cast<double>(light.size());
    }
    share.average_lx = settled(calc::t_interval(average_lx, level_));
    share.minimum_lx = settled(calc::t_interval(minimum_lx, level_));
  }

 private:
  struct Parts {
    double all_lx, direct_lx;
  };

  // The mean over the receivers that the point's value is the mean of: of four planes these follow
  // the cylinder's.
  Parts at_point(std::size_t channel, std::size_t replicate, std::size_t point) const {
    const std::size_t kinds = field_.points / points_;
    const std::size_t first = kinds > 1 ? 1 : 0;
    Parts sum{0.0, 0.0};
    for (std::size_t kind = first; kind < kinds; ++kind) {
      const std::size_t receiver = kind * points_ + point;
      const double direct_lx = field_.direct_exact_at(channel, receiver) +
                               field_.direct_sampled_at(replicate, channel, receiver);
      sum.direct_lx += direct_lx;
      sum.all_lx += direct_lx + field_.indirect_at(replicate, channel, receiver);
    }
    const double scale =
        field_.channels[channel].maintenance_factor / static_cast<double>(kinds - first);
    return {scale * sum.all_lx, scale * sum.direct_lx};
  }

  const calc::PlaneField& field_;
  std::size_t points_, minimum_point_;
  double level_;
};

std::vector<Light> light_of(const FieldReader& reader, std::span<const std::size_t> channels) {
  std::vector<Light> light(reader.replicates());
  for (const std::size_t channel : channels) {
    for (std::size_t r = 0; r < light.size(); ++r) {
      const Light one = reader.light(channel, r);
      light[r].average_lx += one.average_lx;
      light[r].direct_lx += one.direct_lx;
      light[r].minimum_lx += one.minimum_lx;
      light[r].minimum_direct_lx += one.minimum_direct_lx;
    }
  }
  return light;
}

std::size_t darkest_point(const std::vector<PointRow>& points) {
  const auto darkest = std::min_element(points.begin(), points.end(), [](const auto& a, auto& b) {
    return a.measured.value < b.measured.value;
  });
  return static_cast<std::size_t>(darkest - points.begin());
}

}  // namespace

LuminaireShares build_luminaire_shares(const calc::PlaneField& field,
                                       const std::vector<calc::Luminaire>& luminaires,
                                       const std::vector<calc::LuminaireType>& types,
                                       const PlanePart& plane, double level) {
  LuminaireShares shares;
  if (plane.points.empty() || calc::is_plain_number(plane.derived)) return shares;
  const std::size_t minimum_point = darkest_point(plane.points);
  shares.minimum_at_m = plane.points[minimum_point].position_m;
  const FieldReader reader(field, plane.points.size(), minimum_point, level);

  std::vector<LuminaireShare> all(luminaires.size());
  for (std::size_t l = 0; l < all.size(); ++l) {
    const calc::Luminaire& luminaire = luminaires[l];
    all[l].id = luminaire.id;
    all[l].type_id = types[luminaire.type].id;
    all[l].group = luminaire.group;
    all[l].position_m = luminaire.position_m;
    reader.estimate(light_of(reader, std::span(&l, 1)), all[l]);
  }
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&all](std::size_t a, std::size_t b) {
    return all[a].average_lx.value > all[b].average_lx.value;
  });
  // One luminaire is not worth a line of "others".
  const std::size_t kept =
      order.size() <= kMostLuminaireShares + 1 ? order.size() : kMostLuminaireShares;
  for (std::size_t k = 0; k < kept; ++k) shares.largest.push_back(all[order[k]]);
  shares.others = order.size() - kept;
  if (shares.others > 0)
    reader.estimate(light_of(reader, std::span(order).subspan(kept)), shares.rest);
  return shares;
}

}  // namespace report
