#include "report/tools/sweep/sweep_shards.h"

#include <algorithm>

namespace cli {
namespace {

// Of one path. More would cost more time than they save: that one of many values alone changes
// light is rare, and then only shards have some looks in common.
constexpr std::size_t kMostAsked = 8;

// How far apart two variants are that differ by one value of the path.
std::size_t stride_of(const std::vector<Vary>& vary, std::size_t path) {
  std::size_t stride = 1;
  for (std::size_t v = path + 1; v < vary.size(); ++v) stride *= vary[v].values.size();
  return stride;
}

}  // namespace

std::vector<bool> paths_of_light(
    const std::vector<Vary>& vary,
    const std::function<std::set<std::string>(std::size_t variant)>& keys_of) {
  const std::set<std::string> first = keys_of(0);
  std::vector<bool> is_of_light;
  for (std::size_t v = 0; v < vary.size(); ++v) {
    const std::size_t last = vary[v].values.size() - 1, asked = std::min(last, kMostAsked);
    bool changes = false;
    for (std::size_t i = asked; i > 0 && !changes; --i) {  // the last value differs most
      changes = keys_of(i * last / asked * stride_of(vary, v)) != first;
    }
    is_of_light.push_back(changes);
  }
  return is_of_light;
}

std::vector<std::size_t> variants_of_shard(const std::vector<Vary>& vary,
                                           const std::vector<bool>& is_of_light,
                                           const BatchShare& share) {
  std::size_t lights = 1;
  for (std::size_t v = 0; v < vary.size(); ++v)
    lights *= is_of_light[v] ? vary[v].values.size() : 1;
  std::vector<std::size_t> own;
  for (std::size_t variant = 0; variant < count_variants(vary); ++variant) {
    std::size_t light = 0;
    for (std::size_t v = 0; v < vary.size(); ++v) {
      const std::size_t values = vary[v].values.size();
      if (is_of_light[v]) light = light * values + variant / stride_of(vary, v) % values;
    }
    if (light * share.count / lights + 1 == share.number) own.push_back(variant);
  }
  return own;
}

}  // namespace cli
