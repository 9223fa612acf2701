#include "gpu/gl_gatherer.h"

#include "gpu/gather_pass.h"
#include "gpu/gl_error.h"
#include "gpu/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
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

// Runs jobs of many threads, one bundle after the other, on the thread that owns the context.
class GatherThread {
 public:
  explicit GatherThread(const GathererRequest& request)
      : request_(request), thread_([this] { work(); }) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return is_open_ || !problem_.empty(); });
  }

  ~GatherThread() {
    {
      const std::scoped_lock lock(mutex_);
      is_ending_ = true;
    }
    wanted_.notify_one();
    thread_.join();
  }

  GatherThread(const GatherThread&) = delete;
  GatherThread& operator=(const GatherThread&) = delete;

  // Why there is no context, "" if there is one. Does not change after construction.
  const std::string& problem() const { return problem_; }
  const Device& device() const { return device_; }

  // Waits for the results. Throws calc::BackendFailure.
  void run(GatherJob& job) {
    Entry entry{&job, false, ""};
    std::unique_lock lock(mutex_);
    queue_.push_back(&entry);
    wanted_.notify_one();
    changed_.wait(lock, [&] { return entry.is_done; });
    if (!entry.problem.empty()) throw calc::BackendFailure(entry.problem);
  }

 private:
  struct Entry {
    GatherJob* job;
    bool is_done;
    std::string problem;
  };

  void work() {
    std::string problem;
    const std::unique_ptr<EglContext> context =
        EglContext::open(request_.device, request_.fault, problem);
    {
      const std::scoped_lock lock(mutex_);
      problem_ = problem;
      if (context) device_ = context->device();
      is_open_ = context != nullptr;
    }
    changed_.notify_all();
    if (!context) return;
    GatherPass pass(*context, request_.fault);
    std::string loss;  // once lost, a context stays lost
    for (std::vector<Entry*> bundle = next_bundle(); !bundle.empty(); bundle = next_bundle()) {
      finish(bundle, loss.empty() ? run(pass, bundle, loss) : loss);
    }
  }

  // As many jobs as wait and fit into one pass; none: the end.
  std::vector<Entry*> next_bundle() {
    std::vector<Entry*> bundle;
    std::unique_lock lock(mutex_);
    wanted_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
    std::size_t connections = 0;
    while (!queue_.empty()) {
      connections += queue_.front()->job->connections.size();
      if (connections > GatherPass::kMostConnections) break;
      bundle.push_back(queue_.front());
      queue_.pop_front();
    }
    return bundle;
  }

  // "" or what went wrong; `loss` is set if nothing can be done after it.
  static std::string run(GatherPass& pass, const std::vector<Entry*>& bundle, std::string& loss) {
    std::vector<GatherJob*> jobs;
    for (const Entry* entry : bundle) jobs.push_back(entry->job);
    try {
      pass.run(jobs);
      return "";
    } catch (const OutOfMemory& error) {
      return error.what();
    } catch (const std::bad_alloc&) {
      return "the program is out of memory";
    } catch (const std::exception& error) {
      return loss = error.what();
    }
  }

  void finish(const std::vector<Entry*>& bundle, const std::string& problem) {
    {
      const std::scoped_lock lock(mutex_);
      for (Entry* entry : bundle) {
        entry->problem = problem;
        entry->is_done = true;
      }
    }
    changed_.notify_all();
  }

  const GathererRequest request_;
  std::mutex mutex_;
  std::condition_variable wanted_, changed_;
  std::deque<Entry*> queue_;
  bool is_open_ = false, is_ending_ = false;
  std::string problem_;
  Device device_;
  std::thread thread_;  // last: it uses all the others
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
  explicit GlGatherer(const GathererRequest& request) : thread_(request) {}

  const GatherThread& thread() const { return thread_; }

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
      thread_.run(job);
      rays += add_results(batch, connections, results, sums);
    }
    return rays;
  }

  std::string description() const override {
    const Device& device = thread_.device();
    return fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  }

 private:
  GatherThread thread_;
};

}  // namespace

std::unique_ptr<calc::Gatherer> make_gl_gatherer(const GathererRequest& request, Device& device,
                                                 std::string& problem) {
  auto gatherer = std::make_unique<GlGatherer>(request);
  problem = gatherer->thread().problem();
  if (!problem.empty()) return nullptr;
  device = gatherer->thread().device();
  return gatherer;
}

}  // namespace gpu
