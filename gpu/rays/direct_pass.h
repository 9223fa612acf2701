#pragma once
// Computes direct light of some points on the device, stage after stage.

#include "calc/radiosity/direct/direct_tracer.h"
#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/opengl/borrowed_bytes.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/opengl/gl_read_back.h"
#include "gpu/rays/gl_direct_tracer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gpu {

// A piece of work, on its way to the device and back.
struct DirectPiece {
  const calc::Tracer* tracer = nullptr;
  std::span<const calc::Receiver> points{};
  std::span<const calc::RandomKey> keys{};   // [point]; empty: of point openings, without samples
  std::span<const std::uint8_t> is_asked{};  // [luminaire]
  bool has_shadows = true;
  calc::OpeningRounds rounds{};
  double deadline_s = 0.0;  // see calc::is_past()

  // The deadline passed: results below are incomplete.
  bool is_cut_short = false;
  // Pairs that are not kPairNothing: for point openings the number of shadow rays.
  std::uint64_t asked_pairs = 0;
  // Pairs without a proof, luminaire by luminaire.
  struct Sampled {
    std::uint32_t point, luminaire, samples;  // samples of one round
  };
  std::vector<Sampled> sampled{};
  // [point]: 1 = so near to an opening that it has more parts than a shader visits; the CPU
  // computes the whole point, so that its light is the CPU's.
  std::vector<std::uint8_t> is_left{};
  // [channel * points + point]
  std::vector<double> known_lx{};
  // [replicate][channel][point] and then [replicate][point], see shaders/direct/direct_totals.glsl
  std::vector<double> totals{};
};

// Buffers of a piece, from its start until all of it is back.
struct DirectBuffers {
  GlBuffer points{"calculation points"};
  GlBuffer words{"random numbers"};
  GlBuffer pairs{"points and luminaires", BufferUse::by_device};
  GlBuffer light{"direct light", BufferUse::by_device};
  GlBuffer known{"sums of direct light", BufferUse::by_device};
  GlBuffer totals{"direct light of replicates", BufferUse::by_device};
  GlReadBack pairs_back{"points and luminaires"};
  GlReadBack known_back{"sums of direct light"};
  GlReadBack totals_back{"direct light of replicates"};
};

// Samples of pairs without a proof, of some points that go together.
struct DirectSamples {
  std::size_t first_point, last_point;
  std::vector<std::uint32_t> list;  // as shaders/direct/direct_chunks.glsl has it
  std::size_t chunks;
};

// What the caller does with what came back, on its own thread. They throw calc::BackendFailure if
// the device did not do its work.
void take_pairs(const BorrowedBytes& pairs, DirectPiece& piece);
std::vector<DirectSamples> samples_of(const DirectPiece& piece, const DirectLimits& limits);
// known_lx and, with keys, totals.
void take_sums(const BorrowedBytes& known, const BorrowedBytes& totals, DirectPiece& piece);

// Works in three steps, between which the device's thread does other work. All calls, also the
// destructor, need the context current. They throw GlError.
class DirectPass {
 public:
  explicit DirectPass(const ProgramCache& programs);  // must outlive it

  // Starts proofs and known light.
  void start(DeviceState& device, DirectPiece& piece, DirectBuffers& buffers);
  // Of what is proved, a word for each pair. Waits.
  BorrowedBytes pairs(DeviceState& device, const DirectPiece& piece, DirectBuffers& buffers);
  // With keys: the rest, by samples.
  void sample(DeviceState& device, DirectPiece& piece, std::span<const DirectSamples> samples,
              DirectBuffers& buffers);
  struct Sums {
    BorrowedBytes known, totals;  // totals: with keys
  };
  // Waits, and returns the sums.
  Sums sums(DeviceState& device, const DirectPiece& piece, DirectBuffers& buffers);

 private:
  void send_tables(const calc::Tracer& tracer);
  void bind(DeviceState& device, const DirectPiece& piece, const DirectBuffers& buffers);
  void find_pairs(DirectPiece& piece, DirectBuffers& buffers);
  void sum_seen(DirectPiece& piece, DirectBuffers& buffers);
  void sample_points(DirectPiece& piece, const DirectSamples& samples);
  void use(const GlProgram& program, const DirectPiece& piece) const;
  void run_in_parts(DirectPiece& piece, const GlProgram& program, DispatchPacer& pacer,
                    std::size_t items, const char* first, const char* last);

  const ProgramCache& programs_;
  GlProgram classify_, seen_, sums_;
  std::unique_ptr<GlProgram> samples_, add_up_;  // once openings of some size are asked for
  GlBuffer tables_, sketches_, list_, chunk_sums_;
  DispatchPacer classify_pacer_, seen_pacer_, samples_pacer_;
  std::uint32_t nodes_ = 0;      // of the scene at hand
  std::uint64_t tables_of_ = 0;  // identity of a tracer; 0 = none
};

}  // namespace gpu
