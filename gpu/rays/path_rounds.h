#pragma once
// Passes light vertices from the device's thread to the requesting thread, which reads them alone,
// so that other threads do not wait for that.

#include "calc/radiosity/paths/light_vertex.h"
#include "gpu/opengl/borrowed_bytes.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace gpu {

// The vertices that the reflections of one round left, for one job.
struct PathRound {
  std::vector<std::uint32_t> chunk_vertices;  // [chunk of the job]
  BorrowedBytes vertices;  // in order of chunks, then of reflections, then of paths
  double share_alive;      // of the job's paths, which go on
};

// A queue from the device's thread to the waiting one.
class PathInbox {
 public:
  void put(PathRound round);
  // Ends the queue: why there is no more, "" if nothing is missing. The inbox may be gone then.
  void end(const std::string& problem);
  // Waits for the next round; empty: the end. The caller has to take all, because the device waits
  // for the parts it lent.
  std::optional<PathRound> next();
  // Returns the problem, after the end.
  const std::string& problem() const { return problem_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<PathRound> rounds_;
  bool has_ended_ = false;
  std::string problem_;
};

// Appends a job's rounds to the existing vertices.
class RoundCollector {
 public:
  // share: this job's share of the final `vertices`, to reserve room.
  RoundCollector(calc::LightVertices& vertices, double share)
      : vertices_(vertices), begin_(vertices.size()), share_(share) {}

  // Adds a round; throws calc::BackendFailure if the device did not finish its work.
  void add(const PathRound& round);
  // Orders the vertices chunk by chunk, as the CPU does.
  void finish();

 private:
  struct LaterRound {
    calc::LightVertices vertices{};
    std::vector<std::uint32_t> chunk_vertices{};
  };

  void make_room(std::size_t count, double share_alive);

  calc::LightVertices& vertices_;  // of the first round, until the end
  std::size_t begin_;
  double share_;
  std::vector<std::uint32_t> chunk_vertices_;
  std::vector<LaterRound> later_;
};

}  // namespace gpu
