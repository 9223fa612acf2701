#pragma once
// Light vertices on their way from the device's thread to the one that asked for them, which alone
// reads them: what a path costs it, all others would wait for.

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

// What the reflections of one round left, of one job.
struct PathRound {
  std::vector<std::uint32_t> chunk_vertices;  // [chunk of the job]
  BorrowedBytes vertices;  // in order of chunks, then of reflections, then of paths
  double share_alive;      // of the job's paths, which go on
};

// From the device's thread to the one that waits.
class PathInbox {
 public:
  void put(PathRound round);
  // After the last: why there is no more, "" if nothing is missing. The inbox may be gone then.
  void end(const std::string& problem);
  // Waits for the next; nothing: the end. Whoever asked has to take all: the device waits for what
  // it lent.
  std::optional<PathRound> next();
  // After the end.
  const std::string& problem() const { return problem_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<PathRound> rounds_;
  bool has_ended_ = false;
  std::string problem_;
};

// Puts a job's rounds behind the vertices that are there.
class RoundCollector {
 public:
  // share: of all that `vertices` will have in the end, when this job is done; for room.
  RoundCollector(calc::LightVertices& vertices, double share)
      : vertices_(vertices), begin_(vertices.size()), share_(share) {}

  // Throws calc::BackendFailure if the device did not finish its work.
  void add(const PathRound& round);
  // Chunk by chunk, as the CPU orders them.
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
