#include "gpu/rays/gl_path_tracer.h"

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/rays/path_pass.h"
#include "gpu/rays/path_rounds.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// Paths of one pass: a large device runs 270,000 threads, and 64 MiB of vertices hold a round (of
// which three may be read at once).
constexpr std::uint32_t kPathsPerPass = std::uint32_t{1} << 18;
constexpr std::uint32_t kPathsPerSoftwarePass = std::uint32_t{1} << 13;

std::uint32_t whole_chunks(std::uint32_t paths) {
  return (paths + calc::kPathsPerChunk - 1) / calc::kPathsPerChunk * calc::kPathsPerChunk;
}

// Jobs of many threads, replicates of one look, go to the device in bundles.
class PathQueue {
 public:
  explicit PathQueue(std::shared_ptr<DeviceThread> thread)
      : thread_(std::move(thread)),
        most_paths_(thread_->device().is_software ? kPathsPerSoftwarePass : kPathsPerPass) {}
  ~PathQueue() {
    thread_->clean_up([this](DeviceState&) { pass_.reset(); });
  }
  PathQueue(const PathQueue&) = delete;
  PathQueue& operator=(const PathQueue&) = delete;

  std::uint32_t most_paths() const { return most_paths_; }

  // Waits for the results. Throws calc::BackendFailure.
  void run(PathJob& job, RoundCollector& rounds) {
    PathInbox inbox;
    job.take = [&](PathRound round) { inbox.put(std::move(round)); };
    hand_in({&job, &inbox});
    std::exception_ptr failure;
    while (const std::optional<PathRound> round = inbox.next()) {
      if (failure) continue;  // the device waits for the rest, too
      try {
        rounds.add(*round);
      } catch (...) {
        failure = std::current_exception();
      }
    }
    if (!inbox.problem().empty()) throw calc::BackendFailure(inbox.problem());
    if (failure) std::rethrow_exception(failure);
  }

 private:
  struct Entry {
    PathJob* job;
    PathInbox* inbox;
  };

  // There are never fewer pieces of work on their way to the device than jobs that wait, and each
  // takes one at least.
  void hand_in(const Entry& entry) {
    {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(entry);
    }
    try {
      thread_->start([this](DeviceState& device) { run_bundle(device); },
                     [this](const std::string& problem) { end_bundle(problem); });
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      // Another's piece may have taken it already.
      const auto is_this = [&](const Entry& other) { return other.inbox == entry.inbox; };
      if (std::erase_if(waiting_, is_this) > 0) throw;
    }
  }

  // The first that waits, and those of the same emitter that wait directly behind it and fit.
  void take_bundle() {
    const std::scoped_lock lock(mutex_);
    std::uint32_t paths = 0;
    while (!waiting_.empty() && under_way_.size() < PathPass::kMostJobs) {
      const PathJob& job = *waiting_.front().job;
      paths += whole_chunks(job.last - job.first);
      if (paths > most_paths_) break;
      if (!under_way_.empty() && !is_same_source(job, *under_way_.front().job)) break;
      under_way_.push_back(waiting_.front());
      waiting_.pop_front();
    }
  }

  static bool is_same_source(const PathJob& a, const PathJob& b) {
    return a.tracer.identity() == b.tracer.identity() &&
           a.emitter.identity() == b.emitter.identity();
  }

  void run_bundle(DeviceState& device) {
    take_bundle();
    if (under_way_.empty()) return;  // another's piece had it
    std::vector<PathJob*> jobs;
    for (const Entry& entry : under_way_) jobs.push_back(entry.job);
    if (!pass_) pass_ = std::make_unique<PathPass>(most_paths_, device.programs);
    pass_->run(device, jobs);
  }

  // Whoever waits may be gone as soon as it is told. What waits for another bundle may yet do
  // better, unless the device had been lost before and nothing was run.
  void end_bundle(const std::string& problem) {
    if (!problem.empty()) {
      pass_.reset();  // what it kept may be what left no room
      const std::scoped_lock lock(mutex_);
      if (under_way_.empty()) under_way_.swap(waiting_);
    }
    for (const Entry& entry : under_way_) entry.inbox->end(problem);
    under_way_.clear();
  }

  const std::shared_ptr<DeviceThread> thread_;
  const std::uint32_t most_paths_;
  std::mutex mutex_;
  std::deque<Entry> waiting_;
  // Of the device's thread alone.
  std::deque<Entry> under_way_;
  std::unique_ptr<PathPass> pass_;
};

class GlPathTracer : public calc::PathTracer {
 public:
  explicit GlPathTracer(std::shared_ptr<DeviceThread> thread) : queue_(std::move(thread)) {}

  calc::TracedPaths trace(const calc::Tracer& tracer, const calc::Emitter& emitter,
                          const calc::PathBatch& batch) override {
    calc::TracedPaths traced;
    std::uint64_t vertices = 0;
    for (std::uint32_t first = batch.first; first < batch.last;) {
      const std::uint32_t last = first + std::min(queue_.most_paths(), batch.last - first);
      PathJob job{tracer, emitter, batch, first, last, batch.most_vertices - vertices};
      RoundCollector rounds(traced.vertices,
                            static_cast<double>(last - batch.first) / (batch.last - batch.first));
      queue_.run(job, rounds);
      vertices += job.vertices;
      traced.rays += job.rays;
      traced.absorbed_lm += job.absorbed_lm;
      traced.escaped_lm += job.escaped_lm;
      traced.has_endless_path = job.has_endless_path;
      traced.has_too_many_vertices = job.has_too_many_vertices;
      if (job.is_useless()) {
        traced.vertices.clear();
        break;
      }
      rounds.finish();
      first = last;
    }
    return traced;
  }

 private:
  PathQueue queue_;
};

}  // namespace

std::unique_ptr<calc::PathTracer> make_gl_path_tracer(std::shared_ptr<DeviceThread> thread) {
  return std::make_unique<GlPathTracer>(std::move(thread));
}

}  // namespace gpu
