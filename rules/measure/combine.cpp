#include "calc/scene/scene_level.h"
#include "rules/measure/metrics.h"

#include <algorithm>
#include <span>
#include <utility>

namespace rules {
namespace {

double weight_of(const calc::LightChannel& channel, LightState state,
                 const std::vector<std::pair<std::string, double>>& level_of_group) {
  const double level = calc::level_of(level_of_group, channel.group);
  return state == LightState::initial ? level : level * channel.maintenance_factor;
}

// Adds to[i] += weight * from[i]; a part that was not computed is empty and adds nothing.
void add_weighted(const std::vector<double>& from_lx, std::size_t row, double weight,
                  std::span<double> to_lx) {
  if (from_lx.empty()) return;
  const double* values = from_lx.data() + row * to_lx.size();
  for (std::size_t i = 0; i < to_lx.size(); ++i) to_lx[i] += weight * values[i];
}

// Sums for each point over all rows of some parts of a field, row by row as in memory.
struct PointSums {
  explicit PointSums(std::size_t points) : all_lx(points, 0.0), scene_lx(points, 0.0) {}

  // Adds a part. share: weight of its values, 1 / replicates. A factor is used because dividing
  // each value takes half the time of all judging.
  void add(const std::vector<double>& part, const std::vector<double>& weights, double share) {
    const std::size_t points = all_lx.size();
    for (std::size_t row = 0; row * points < part.size(); ++row) {
      const double weight = weights[row % weights.size()];
      const double* values = part.data() + row * points;
      for (std::size_t i = 0; i < points; ++i) {
        const double value = values[i] * share;
        all_lx[i] += value;
        scene_lx[i] += weight * value;
      }
    }
  }

  std::vector<double> all_lx, scene_lx;  // [point]: all channels at full output, weighted
};

// Returns [point]: 1 if sampled light of these channels may reach the point, but no sample did. The
// field's own marks are for all channels together; a scene with fewer channels may miss more
// points.
std::vector<std::uint8_t> find_unseen(const calc::PlaneField& field,
                                      const std::vector<double>& weights) {
  std::vector<std::uint8_t> unseen(field.points, 0);
  if (field.unseen.empty()) return unseen;
  PointSums sums(field.points);
  sums.add(field.direct_sampled_lx, weights, 1.0);
  sums.add(field.indirect_lx, weights, 1.0);
  for (std::size_t i = 0; i < field.points; ++i) {
    const bool may_be_lit = field.unseen[i] != 0 || sums.all_lx[i] > 0.0;
    unseen[i] = sums.scene_lx[i] == 0.0 && may_be_lit ? 1 : 0;
  }
  return unseen;
}

// Returns [point]: shares for the scene. The field's shares are for all channels at full output; in
// a scene with less light a sample may be a larger share. An upper bound: the sample may belong to
// any channel.
std::vector<float> scale_shares(const calc::PlaneField& field, const std::vector<double>& weights) {
  std::vector<float> shares = field.largest_share;
  if (shares.empty()) return shares;
  const double largest_weight = *std::max_element(weights.begin(), weights.end());
  PointSums sums(field.points);
  sums.add(field.direct_exact_lx, weights, 1.0);
  const double share = 1.0 / static_cast<double>(field.replicates);
  sums.add(field.direct_sampled_lx, weights, share);
  sums.add(field.indirect_lx, weights, share);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    // A dark point is unseen or exactly dark; neither is a matter of shares.
    if (!(sums.scene_lx[i] > 0.0)) continue;
    shares[i] *= static_cast<float>(largest_weight * sums.all_lx[i] / sums.scene_lx[i]);
  }
  return shares;
}

// Returns the mean over the replicates of all channels' light at one point, at full output.
double mean_lx(const std::vector<double>& part, std::size_t point, std::size_t points,
               std::size_t replicates) {
  double sum_lx = 0.0;
  for (std::size_t k = point; k < part.size(); k += points) sum_lx += part[k];
  return sum_lx / static_cast<double>(replicates);
}

bool may_sample(const std::vector<calc::LightChannel>& channels,
                const std::vector<double>& weights) {
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (weights[c] > 0.0 && channels[c].may_sample_direct) return true;
  }
  return false;
}

// Returns the field without reflections. A point that no sample of direct light reached is unseen,
// whatever reflected light did; but if nothing lit in the scene is sampled (emergency luminaires
// that are points, beside panels that are off) everything is exact. Shares grow as their light
// decreases.
calc::PlaneField direct_part(calc::PlaneField field, const std::vector<double>& weights) {
  const std::vector<double> indirect_lx = std::move(field.indirect_lx);
  field.indirect_lx.clear();
  field.even_indirect_lx.clear();
  field.largest_sample_lx.clear();
  if (field.direct_sampled_lx.empty() || !may_sample(field.channels, weights)) {
    field.direct_sampled_lx.clear();  // of channels that are out
    field.even_direct_sampled_lx.clear();
    field.replicates = 1;
    field.unseen.clear();
    field.largest_share.clear();
    return field;
  }
  field.unseen.assign(field.points, 1);
  for (std::size_t i = 0; i < field.largest_share.size(); ++i) {
    const double direct_lx = mean_lx(field.direct_exact_lx, i, field.points, 1) +
                             mean_lx(field.direct_sampled_lx, i, field.points, field.replicates);
    const double reflected_lx = mean_lx(indirect_lx, i, field.points, field.replicates);
    if (direct_lx > 0.0) {
      field.largest_share[i] *= static_cast<float>((direct_lx + reflected_lx) / direct_lx);
    }
  }
  return field;
}

}  // namespace

std::vector<double> channel_weights(
    const calc::PlaneField& field, LightState state,
    const std::vector<std::pair<std::string, double>>& level_of_group) {
  std::vector<double> weights;
  for (const calc::LightChannel& channel : field.channels) {
    weights.push_back(weight_of(channel, state, level_of_group));
  }
  return weights;
}

PointValues combine_channels(const calc::PlaneField& field, LightState state,
                             const std::vector<std::pair<std::string, double>>& level_of_group,
                             LightParts parts) {
  const std::vector<double> weights = channel_weights(field, state, level_of_group);
  const bool has_reflection = !field.indirect_lx.empty();
  const bool has_vain_samples =
      !has_reflection && !field.direct_sampled_lx.empty() && !may_sample(field.channels, weights);
  if (has_vain_samples || (parts == LightParts::direct && has_reflection)) {
    return combine_channels(direct_part(field, weights), state, level_of_group);
  }
  PointValues values;
  values.points = field.points;
  values.weight = field.point_weight;
  // A scene that dims everything to 0 is exactly dark, whatever was sampled.
  const bool has_light =
      std::any_of(weights.begin(), weights.end(), [](double weight) { return weight > 0.0; });
  values.replicates = field.is_exact() || !has_light ? 1 : field.replicates;
  if (has_light) {
    values.unseen = find_unseen(field, weights);
    values.largest_share = scale_shares(field, weights);
    // It may be of any channel.
    const double largest_weight = *std::max_element(weights.begin(), weights.end());
    values.largest_sample_lx = field.largest_sample_lx;
    for (double& sample : values.largest_sample_lx) sample *= largest_weight;
  }
  const auto sum_of = [&](const std::vector<double>& sampled_lx,
                          const std::vector<double>& indirect_lx) {
    std::vector<double> value_lx(values.replicates * values.points, 0.0);
    for (std::size_t r = 0; r < values.replicates; ++r) {
      const std::span<double> row(value_lx.data() + r * values.points, values.points);
      for (std::size_t c = 0; c < weights.size(); ++c) {
        add_weighted(field.direct_exact_lx, c, weights[c], row);
        add_weighted(sampled_lx, r * weights.size() + c, weights[c], row);
        add_weighted(indirect_lx, r * weights.size() + c, weights[c], row);
      }
    }
    return value_lx;
  };
  values.value_lx = sum_of(field.direct_sampled_lx, field.indirect_lx);
  if (!field.even_direct_sampled_lx.empty() || !field.even_indirect_lx.empty()) {
    values.even_lx = sum_of(field.even_direct_sampled_lx, field.even_indirect_lx);
  }
  return values;
}

PointValues select_points(const PointValues& values, const std::vector<std::size_t>& points) {
  if (points.size() == values.points) return values;
  PointValues selected;
  selected.points = points.size();
  selected.replicates = values.replicates;
  for (std::size_t r = 0; r < values.replicates; ++r) {
    for (const std::size_t point : points) selected.value_lx.push_back(values.at(r, point));
  }
  for (std::size_t r = 0; !values.even_lx.empty() && r < values.replicates; ++r) {
    for (const std::size_t point : points) selected.even_lx.push_back(values.even_at(r, point));
  }
  for (const std::size_t point : points) {
    if (!values.unseen.empty()) selected.unseen.push_back(values.unseen[point]);
    if (!values.largest_share.empty()) {
      selected.largest_share.push_back(values.largest_share[point]);
    }
    if (!values.largest_sample_lx.empty()) {
      selected.largest_sample_lx.push_back(values.largest_sample_lx[point]);
    }
    if (!values.weight.empty()) selected.weight.push_back(values.weight[point]);
  }
  return selected;
}

}  // namespace rules
