#pragma once
// Traces light paths on the device: uploads, some reflections of all paths per dispatch until none
// lives, vertices back. For the thread that owns the context.

#include "calc/radiosity/paths/light_paths.h"
#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/opengl/gl_read_back.h"
#include "gpu/rays/path_rounds.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <span>
#include <vector>

namespace gpu {

// Some paths of one batch; jobs of one emitter share a pass.
struct PathJob {
  const calc::Tracer& tracer;
  const calc::Emitter& emitter;
  const calc::PathBatch& batch;
  std::uint32_t first = 0, last = 0;  // of the batch's paths, by whole chunks
  std::uint64_t most_vertices = 0;    // for this job
  // Receives the vertices, round after round, those of rounds before it was found useless too.
  // Called on the device's thread, which waits in the end until they are back: pass them on.
  std::function<void(PathRound)> take{};

  // After run():
  double absorbed_lm = 0.0, escaped_lm = 0.0;
  std::uint64_t vertices = 0, rays = 0;
  bool has_endless_path = false, has_too_many_vertices = false, is_late = false;

  bool is_useless() const { return has_endless_path || has_too_many_vertices || is_late; }
};

// Buffers of a pass. A path's place in them is its slot; the slots of a chunk (kPathsPerChunk paths
// of one job) are consecutive. Where paths have ended, the others move up between rounds.
//   words     direction numbers, then kJobSize per job
//   states    4 uvec4 per slot: origin, index; direction, channel and job; flux and survival;
//             absorbed and escaped so far (double)
//   vertices  [reflection of the round][slot], 2 uvec4, as calc::LightVertex
//   counts    per slot: vertices of this round, and how the path ended (kPathEndings)
//   balances  per path of a chunk, once it has ended: absorbed and escaped
class PathPass {
 public:
  // most_paths: of one run(), a multiple of kPathsPerChunk. Never changes a result.
  PathPass(std::uint32_t most_paths, const ProgramCache& programs);

  // Runs all jobs at once: at most kMostJobs of one tracer and emitter, of at most most_paths()
  // with chunks counted as full. Throws GlError; is then of no more use.
  void run(DeviceState& device, std::span<PathJob* const> jobs);

  std::uint32_t most_paths() const { return most_paths_; }
  static constexpr std::size_t kMostJobs = 64;

 private:
  struct Chunk {
    std::size_t job;
    std::uint32_t first_path, paths;
  };
  struct Tables {
    std::uint64_t emitter;
    GlBuffer value;
  };
  struct ChunkSum {
    std::uint32_t vertices, alive, rays, is_done;
  };
  // Vertices of one round on their way. While they are read, the next round uses another.
  struct Delivery {
    GlReadBack back{"packed light vertices"};
    std::vector<std::vector<std::uint32_t>> chunk_vertices{};  // [job]
    std::vector<double> share_alive{};                         // [job]
  };

  std::uint32_t reflections_left(const PathJob& job) const;
  // Returns the reflections of the next round.
  std::uint32_t reflections_for(DeviceState& device, std::span<PathJob* const> jobs) const;
  void start(std::span<PathJob* const> jobs);
  void emit(std::span<PathJob* const> jobs);
  // Traces the next reflections of all living paths.
  void trace(DeviceState& device, const PathJob& job, std::uint32_t reflections);
  std::vector<ChunkSum> sum_up();
  void pack(std::span<PathJob* const> jobs, const std::vector<ChunkSum>& sums);
  Delivery& free_delivery();
  // Delivers what pack() started last, unless already done.
  void deliver(std::span<PathJob* const> jobs);
  void start_balance();
  void finish_balance(std::span<PathJob* const> jobs);
  const GlBuffer& tables_of(const PathJob& job);

  const std::uint32_t most_paths_;
  GlProgram starts_program_, paths_program_, sums_program_, places_program_, balance_program_;
  GlBuffer words_, vertices_, packed_, counts_, chunks_, sums_, places_, balances_;
  std::array<GlBuffer, 2> states_;
  GlReadBack sums_back_;
  std::list<Delivery> deliveries_{3};  // longest unused first
  const std::vector<std::uint32_t> direction_numbers_;
  DispatchPacer pacer_;       // items: reflections of all paths
  std::list<Tables> tables_;  // latest use first
  // Of this run:
  std::vector<Chunk> chunk_;
  std::vector<std::uint32_t> slot_;   // first of each chunk; chunks + 1 entries
  std::vector<std::uint64_t> alive_;  // paths of each job; at least 1 before the first reflection
  std::uint32_t reflection_ = 0;      // done
  Delivery* on_its_way_ = nullptr;
  std::size_t now_ = 0;  // which of states_ holds this round's, not the next one's
};

}  // namespace gpu
