#include "gpu/gl_path_tracer.h"

#include "calc/radiosity/gatherer.h"
#include "gpu/gl_error.h"
#include "gpu/path_pass.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// Paths of one pass: a large device runs 270,000 threads, and 64 MiB of vertices hold a round.
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
  void run(PathJob& job) {
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
    PathJob* job;
    bool is_done;
    std::string problem;
  };

  // The first that waits, and those of the same emitter that wait directly behind it and fit.
  std::vector<Entry*> next_bundle() {
    std::vector<Entry*> bundle;
    const std::scoped_lock lock(mutex_);
    std::uint32_t paths = 0;
    while (!waiting_.empty() && bundle.size() < PathPass::kMostJobs) {
      const PathJob& job = *waiting_.front()->job;
      paths += whole_chunks(job.last - job.first);
      if (paths > most_paths_) break;
      if (!bundle.empty() && !is_same_source(job, *bundle.front()->job)) break;
      bundle.push_back(waiting_.front());
      waiting_.pop_front();
    }
    return bundle;
  }

  static bool is_same_source(const PathJob& a, const PathJob& b) {
    return a.tracer.identity() == b.tracer.identity() &&
           a.emitter.identity() == b.emitter.identity();
  }

  void run_bundle(DeviceState& device) {
    const std::vector<Entry*> bundle = next_bundle();
    std::vector<PathJob*> jobs;
    for (Entry* entry : bundle) {
      jobs.push_back(entry->job);
      entry->is_done = true;
    }
    try {
      if (!pass_) pass_ = std::make_unique<PathPass>(most_paths_, device.programs);
      pass_->run(device, jobs);
    } catch (const std::exception& error) {
      pass_.reset();  // what it kept may be what left no room
      for (Entry* entry : bundle) entry->problem = error.what();
      throw;
    }
  }

  const std::shared_ptr<DeviceThread> thread_;
  const std::uint32_t most_paths_;
  std::mutex mutex_;
  std::deque<Entry*> waiting_;
  std::unique_ptr<PathPass> pass_;  // of the device's thread alone
};

// Chunk by chunk, as the CPU orders them.
void append_vertices(PathJob& job, calc::LightVertices& vertices) {
  if (vertices.empty() && job.rounds.size() == 1) {
    vertices = std::move(job.rounds.front().vertices);
    return;
  }
  vertices.reserve(vertices.size() + job.vertices);
  for (std::size_t c = 0; c + 1 < job.rounds.front().chunk_first.size(); ++c) {
    for (const PathJob::Round& round : job.rounds) {
      const auto begin = round.vertices.begin();
      vertices.insert(vertices.end(), begin + static_cast<std::ptrdiff_t>(round.chunk_first[c]),
                      begin + static_cast<std::ptrdiff_t>(round.chunk_first[c + 1]));
    }
  }
}

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
      queue_.run(job);
      vertices += job.vertices;
      traced.rays += job.rays;
      traced.absorbed_lm += job.absorbed_lm;
      traced.escaped_lm += job.escaped_lm;
      traced.has_endless_path = job.has_endless_path;
      traced.has_too_many_vertices = job.has_too_many_vertices;
      if (job.is_useless()) break;
      append_vertices(job, traced.vertices);
      first = last;
    }
    if (traced.has_endless_path || traced.has_too_many_vertices) traced.vertices.clear();
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
