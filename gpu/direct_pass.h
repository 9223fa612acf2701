#pragma once
// Direct light of some points on the device, stage after stage.

#include "calc/radiosity/direct_tracer.h"
#include "gpu/device_thread.h"
#include "gpu/dispatch_pacer.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_direct_tracer.h"
#include "gpu/gl_program.h"
#include "gpu/gl_read_back.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gpu {

// A piece of work, as it goes to the device and comes back.
struct DirectPiece {
  const calc::Tracer* tracer = nullptr;
  std::span<const calc::Receiver> points{};
  std::span<const calc::RandomKey> keys{};   // [point]; empty: of point openings, without samples
  std::span<const std::uint8_t> is_asked{};  // [luminaire]
  bool has_shadows = true;
  calc::OpeningRounds rounds{};
  double deadline_s = 0.0;  // see calc::is_past()

  // The deadline passed: nothing below is whole.
  bool is_cut_short = false;
  // Pairs that are not kPairNothing: of point openings, that is the shadow rays.
  std::uint64_t asked_pairs = 0;
  // Pairs of which nothing is proved, luminaire by luminaire.
  struct Sampled {
    std::uint32_t point, luminaire, samples;  // samples of one round
  };
  std::vector<Sampled> sampled{};
  // [point]: 1 = so near to an opening that this falls into more parts than a shader visits; all of
  // the point is left to the CPU, so that its light is that of the CPU.
  std::vector<std::uint8_t> is_left{};
  // [channel * points + point]
  std::vector<double> known_lx{};
  // [replicate][channel][point] and then [replicate][point], see shaders/direct_totals.glsl
  std::vector<double> totals{};
};

// All calls need the context current, the destructor too. They throw GlError and
// calc::BackendFailure.
class DirectPass {
 public:
  explicit DirectPass(const ProgramCache& programs);  // must outlive it

  void run(DeviceState& device, const DirectLimits& limits, DirectPiece& piece);

 private:
  void send(DeviceState& device, const DirectPiece& piece);
  void send_tables(const calc::Tracer& tracer);
  void find_pairs(DirectPiece& piece);
  void sum_seen(DirectPiece& piece);
  void take_pairs(DirectPiece& piece);
  void take_known(DirectPiece& piece);
  void sample(const DirectLimits& limits, DirectPiece& piece);
  void sample_points(DirectPiece& piece, std::size_t first, std::size_t last,
                     std::span<const std::uint32_t> list, std::size_t chunks);
  void start(const GlProgram& program, const DirectPiece& piece) const;
  void run_in_parts(DirectPiece& piece, const GlProgram& program, DispatchPacer& pacer,
                    std::size_t items, const char* first, const char* last);

  const ProgramCache& programs_;
  GlProgram classify_, seen_, sums_;
  std::unique_ptr<GlProgram> samples_, add_up_;  // once openings of some size are asked for
  GlBuffer points_, tables_, words_, sketches_, pairs_, light_, list_, chunk_sums_, known_, totals_;
  GlReadBack pairs_back_, known_back_, totals_back_;
  DispatchPacer classify_pacer_, seen_pacer_, samples_pacer_;
  std::vector<std::uint32_t> words_of_pairs_;  // as they came back
  std::uint32_t nodes_ = 0;                    // of the scene at hand
  std::uint64_t tables_of_ = 0;                // identity of a tracer; 0 = none
};

}  // namespace gpu
