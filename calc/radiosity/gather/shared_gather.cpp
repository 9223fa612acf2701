#include "calc/radiosity/gather/shared_gather.h"

#include "calc/radiosity/sampling/phase_timer.h"

#include <cstddef>
#include <vector>

namespace calc {
namespace {

void append_receivers(const PlaneWork& plane, std::vector<Receiver>& receivers) {
  for (const ReceiverGroup& tile : plane.tiles()) {
    receivers.insert(receivers.end(), tile.receiver.begin(), tile.receiver.end());
  }
}

void gather_group(const Tracer& tracer, std::span<PlaneWork* const> planes,
                  const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times) {
  std::vector<Receiver> receivers;
  std::vector<std::size_t> first;  // of each plane
  for (const PlaneWork* plane : planes) {
    first.push_back(receivers.size());
    append_receivers(*plane, receivers);
  }
  if (receivers.empty()) return;
  std::vector<double> lx(tracer.scene().channels.size() * receivers.size(), 0.0);
  std::vector<float> largest_lx(receivers.size(), 0.0f);
  const SharedGather done = gatherer.gather_all({tracer,
                                                 batch.tree.vertices(),
                                                 batch.bounds,
                                                 receivers,
                                                 {},
                                                 planes.front()->has_shadows(),
                                                 batch.tree.identity(),
                                                 batch.deadline_s},
                                                {lx.data(), receivers.size(), largest_lx.data()});
  times.maps_s += done.maps_s;
  times.connect_s += done.gather_s;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const std::size_t last = p + 1 < planes.size() ? first[p + 1] : receivers.size();
    std::uint64_t pairs = 0;
    for (std::size_t i = first[p]; i < last; ++i) pairs += done.pairs[i];
    planes[p]->take_shared(
        batch, {lx.data() + first[p], receivers.size(), largest_lx.data() + first[p]}, pairs);
  }
}

}  // namespace

void gather_all_planes(const Tracer& tracer, std::span<PlaneWork* const> planes,
                       const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times) {
  for (const bool has_shadows : {true, false}) {
    std::vector<PlaneWork*> group;
    for (PlaneWork* plane : planes) {
      if (plane->has_shadows() == has_shadows) group.push_back(plane);
    }
    if (is_past(batch.deadline_s)) return;
    if (!group.empty()) gather_group(tracer, group, batch, gatherer, times);
  }
}

}  // namespace calc
