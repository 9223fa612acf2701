#include "gpu/gl_gatherer.h"

#include "gpu/gather_pass.h"
#include "gpu/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <deque>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// Of one dispatch: short enough for the watchdogs of desktop drivers.
constexpr std::size_t kMostPerJob = std::size_t{1} << 18;
static_assert(kMostPerJob <= GatherPass::kMostConnections);

GpuReceiver gpu_receiver(const calc::Tracer& tracer, const calc::Receiver& receiver) {
  return {glm::vec4(glm::vec3(receiver.position_m), 0.0f),
          glm::vec4(glm::vec3(receiver.axis), static_cast<float>(receiver.kernel)),
          glm::vec4(glm::vec3(tracer.lift(receiver)), 0.0f)};
}

// Jobs of many threads go to the device in bundles.
class JobQueue {
 public:
  explicit JobQueue(std::shared_ptr<DeviceThread> thread) : thread_(std::move(thread)) {}
  ~JobQueue() {
    thread_->clean_up([this](DeviceState&) { pass_.reset(); });
  }
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  const Device& device() const { return thread_->device(); }

  // Waits for the results. Throws calc::BackendFailure.
  void run(GatherJob& job) {
    Entry entry{&job, false, ""};
    {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(&entry);
    }
    try {
      thread_->run([&](DeviceState& device) {
        while (!entry.is_done) run_bundle(device);  // nothing to do if another's bundle had it
      });
    } catch (const calc::BackendFailure&) {
      const std::scoped_lock lock(mutex_);
      std::erase(waiting_, &entry);
      throw;
    }
    if (!entry.problem.empty()) throw calc::BackendFailure(entry.problem);
  }

 private:
  struct Entry {
    GatherJob* job;
    bool is_done;
    std::string problem;
  };

  // As many jobs as wait and fit into one pass.
  std::vector<Entry*> next_bundle() {
    std::vector<Entry*> bundle;
    const std::scoped_lock lock(mutex_);
    std::size_t connections = 0;
    while (!waiting_.empty()) {
      connections += waiting_.front()->job->connections.size();
      if (connections > GatherPass::kMostConnections) break;
      bundle.push_back(waiting_.front());
      waiting_.pop_front();
    }
    return bundle;
  }

  void run_bundle(DeviceState& device) {
    const std::vector<Entry*> bundle = next_bundle();
    std::vector<GatherJob*> jobs;
    for (Entry* entry : bundle) {
      jobs.push_back(entry->job);
      entry->is_done = true;
    }
    try {
      if (!pass_) pass_ = std::make_unique<GatherPass>();
      pass_->run(device, jobs);
    } catch (const std::exception& error) {
      for (Entry* entry : bundle) entry->problem = error.what();
      throw;
    }
  }

  const std::shared_ptr<DeviceThread> thread_;
  std::mutex mutex_;
  std::deque<Entry*> waiting_;
  std::unique_ptr<GatherPass> pass_;  // of the device's thread alone
};

// Adds the results of some connections in their order; returns the rays.
std::uint64_t add_results(const calc::GatherBatch& batch,
                          std::span<const calc::Connection> connections,
                          std::span<const std::uint32_t> results, const calc::GatherSums& sums) {
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < connections.size(); ++i) {
    if (results[i] == kNoRay) continue;
    if (results[i] == kNotDone) throw calc::BackendFailure("the device did not finish its work");
    ++rays;
    if (results[i] == kAddsNothing) continue;
    const calc::Connection& connection = connections[i];
    const calc::LightVertex& v = batch.vertices[connection.vertex];
    auto lx = std::bit_cast<float>(results[i]);
    if (lx < 0.0f) {
      lx = calc::connection_lx(connection.weight, v.flux_lm,
                               batch.bounds.limited(connection.vertex, -lx));
    }
    sums.lx[v.channel * sums.stride + connection.receiver] += static_cast<double>(lx);
    float& largest = sums.largest_lx[connection.receiver];
    largest = std::max(largest, lx);
  }
  return batch.has_shadows ? rays : 0;
}

class GlGatherer : public calc::Gatherer {
 public:
  explicit GlGatherer(std::shared_ptr<DeviceThread> thread) : queue_(std::move(thread)) {}

  std::uint64_t gather(const calc::GatherBatch& batch, const calc::GatherSums& sums) override {
    std::vector<GpuReceiver> receivers;
    receivers.reserve(batch.receivers.size());
    for (const calc::Receiver& receiver : batch.receivers) {
      receivers.push_back(gpu_receiver(batch.tracer, receiver));
    }
    std::vector<std::uint32_t> results;
    std::uint64_t rays = 0;
    for (std::size_t first = 0; first < batch.connections.size(); first += kMostPerJob) {
      const std::size_t count = std::min(kMostPerJob, batch.connections.size() - first);
      const auto connections = batch.connections.subspan(first, count);
      results.resize(count);
      GatherJob job{&batch.tracer,     batch.vertices, batch.vertices_identity,
                    receivers,         connections,    batch.bounds.lowest_per_m2(),
                    batch.has_shadows, results};
      queue_.run(job);
      rays += add_results(batch, connections, results, sums);
    }
    return rays;
  }

  std::string description() const override {
    const Device& device = queue_.device();
    return fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  }

 private:
  JobQueue queue_;
};

}  // namespace

std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread) {
  return std::make_unique<GlGatherer>(std::move(thread));
}

}  // namespace gpu
