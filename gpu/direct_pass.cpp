#include "gpu/direct_pass.h"

#include "calc/radiosity/phase_timer.h"
#include "gpu/gl_error.h"
#include "gpu/lamp_tables.h"
#include "gpu/number_table.h"
#include "gpu/path_shader_text.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>
#include <utility>

namespace gpu {
namespace {

enum Binding : unsigned {
  kPoints = 2,
  kTables,
  kWords,
  kSketches,
  kPairs,
  kLight,
  kList,  // before samples are taken it is the scene's, for closest hits
  kChunkSums,
  kKnown,
  kTotals
};

constexpr std::uint32_t kNoNumber = 0xffff'ffff;  // twice: a double that is none
constexpr const char* kDoing = "adding up direct light";
const DispatchSize kPairsPerDispatch{std::size_t{1} << 8, std::size_t{1} << 20,
                                     std::size_t{1} << 12};
const DispatchSize kChunksPerDispatch{std::size_t{1} << 6, std::size_t{1} << 20,
                                      std::size_t{1} << 10};

// As shaders/lamps.glsl reads it: four uvec4.
struct GpuPoint {
  glm::dvec3 position_m, axis;
  std::uint32_t kernel;
  std::array<std::uint32_t, 2> key;
  std::uint32_t unused = 0;
};
static_assert(sizeof(GpuPoint) == 64);

std::vector<GpuPoint> gpu_points(const DirectPiece& piece) {
  std::vector<GpuPoint> points;
  points.reserve(piece.points.size());
  for (std::size_t p = 0; p < piece.points.size(); ++p) {
    const calc::Receiver& receiver = piece.points[p];
    const std::uint64_t key = piece.keys.empty() ? 0 : piece.keys[p].bits();
    points.push_back({receiver.position_m,
                      receiver.axis,
                      static_cast<std::uint32_t>(receiver.kernel),
                      {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)}});
  }
  return points;
}

// Direction numbers of two dimensions, then what is asked.
std::vector<std::uint32_t> words_of(const DirectPiece& piece) {
  std::vector<std::uint32_t> words = sobol_words(2);
  words.insert(words.end(), piece.is_asked.begin(), piece.is_asked.end());
  return words;
}

std::uint32_t count(std::size_t n) { return static_cast<std::uint32_t>(n); }

void dispatch(std::size_t invocations) {
  glDispatchCompute(count((invocations + kGroupSize - 1) / kGroupSize), 1, 1);
}

std::size_t channels_of(const DirectPiece& piece) { return piece.tracer->scene().channels.size(); }

bool is_done(double value) { return std::bit_cast<std::uint64_t>(value) != ~std::uint64_t{0}; }

// Samples of pairs of which nothing is proved, in chunks, point by point.
struct Chunks {
  std::vector<std::uint32_t> first;                 // [point], and one more
  std::vector<std::array<std::uint32_t, 4>> chunk;  // as shaders/direct_chunks.glsl has them
};

Chunks chunks_of(const DirectPiece& piece, std::uint32_t most_samples) {
  const std::size_t points = piece.points.size();
  const std::uint32_t rounds = piece.rounds.last - piece.rounds.first;
  const auto chunks = [&](const DirectPiece::Sampled& pair) {
    return (pair.samples * rounds + most_samples - 1) / most_samples;
  };
  Chunks result{std::vector<std::uint32_t>(points + 1, 0), {}};
  for (const DirectPiece::Sampled& pair : piece.sampled) {
    if (piece.is_left[pair.point] == 0) result.first[pair.point + 1] += chunks(pair);
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.chunk.resize(result.first.back());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (const DirectPiece::Sampled& pair : piece.sampled) {
    if (piece.is_left[pair.point] != 0) continue;
    const std::uint32_t samples = pair.samples * rounds;
    for (std::uint32_t at = 0; at < samples; at += most_samples) {
      result.chunk[next[pair.point]++] = {pair.point, pair.luminaire, at,
                                          std::min(most_samples, samples - at)};
    }
  }
  return result;
}

}  // namespace

DirectPass::DirectPass(const ProgramCache& programs)
    : programs_(programs),
      classify_("what points see of luminaires", direct_shader(DirectStage::classify), programs),
      seen_("light of openings that are seen", direct_shader(DirectStage::seen), programs),
      sums_("sums of direct light", direct_shader(DirectStage::sums), programs),
      points_("calculation points"),
      tables_("luminaires", BufferUse::fixed),
      words_("random numbers"),
      sketches_("photometry", BufferUse::fixed),
      pairs_("points and luminaires", BufferUse::by_device),
      light_("direct light", BufferUse::by_device),
      list_("samples of openings"),
      chunk_sums_("sums of samples", BufferUse::by_device),
      known_("sums of direct light", BufferUse::by_device),
      totals_("direct light of replicates", BufferUse::by_device),
      pairs_back_("points and luminaires"),
      known_back_("sums of direct light"),
      totals_back_("direct light of replicates"),
      classify_pacer_(kPairsPerDispatch),
      seen_pacer_(kPairsPerDispatch),
      samples_pacer_(kChunksPerDispatch) {}

void DirectPass::run(DeviceState& device, const DirectLimits& limits, DirectPiece& piece) {
  send(device, piece);
  find_pairs(piece);
  if (!piece.is_cut_short) sum_seen(piece);
  if (!piece.is_cut_short) take_pairs(piece);
  if (!piece.is_cut_short && !piece.keys.empty()) sample(limits, piece);
  if (!piece.is_cut_short) take_known(piece);
  device.check(kDoing);
}

void DirectPass::send_tables(const calc::Tracer& tracer) {
  if (tables_of_ == tracer.identity()) return;
  tables_of_ = 0;  // should sending fail
  const LampTables tables = lamp_tables(tracer);
  tables_.assign(tables.entries);
  sketches_.assign(tables.sketches);
  tables_of_ = tracer.identity();
}

void DirectPass::send(DeviceState& device, const DirectPiece& piece) {
  send_tables(*piece.tracer);
  points_.assign(gpu_points(piece));
  words_.assign(words_of(piece));
  const DeviceScene& scene = device.scenes.of(*piece.tracer);
  nodes_ = scene.nodes;
  scene.bind();
  scene.order.bind(kList);
  points_.bind(kPoints);
  tables_.bind(kTables);
  words_.bind(kWords);
  sketches_.bind(kSketches);
}

void DirectPass::start(const GlProgram& program, const DirectPiece& piece) const {
  program.use();
  program.set("node_count", nodes_);
  program.set("offset_m", static_cast<float>(piece.tracer->offset_m()));
  program.set("point_count", count(piece.points.size()));
  program.set("luminaire_count", count(piece.is_asked.size()));
  program.set("channel_count", count(channels_of(piece)));
  program.set("replicate_count", count(piece.rounds.replicates));
  program.set("has_shadows", piece.has_shadows ? 1u : 0u);
  program.set("first_round", piece.rounds.first);
  program.set("last_round", piece.rounds.last);
  program.set("cell_places", 9u);
  program.set("corner_count", 4u);
  program.set("error_factor", static_cast<float>(piece.rounds.error_factor));
}

// first, last: uniforms that say which of the items a dispatch is for.
void DirectPass::run_in_parts(DirectPiece& piece, const GlProgram& program, DispatchPacer& pacer,
                              std::size_t items, const char* first, const char* last) {
  for (std::size_t begin = 0; begin < items;) {
    if (calc::is_past(piece.deadline_s)) {
      piece.is_cut_short = true;
      return;
    }
    const std::size_t end = std::min(items, begin + pacer.items());
    pacer.run(end - begin, kDoing, [&] {
      program.set(first, count(begin));
      program.set(last, count(end));
      dispatch(end - begin);
    });
    begin = end;
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void DirectPass::find_pairs(DirectPiece& piece) {
  const std::size_t pairs = piece.points.size() * piece.is_asked.size();
  const std::size_t bytes = pairs * sizeof(std::uint32_t);
  pairs_.assign(bytes, kNotDone);
  pairs_.bind(kPairs);
  start(classify_, piece);
  run_in_parts(piece, classify_, classify_pacer_, pairs, "first_pair", "last_pair");
  pairs_back_.start({{pairs_, 0, bytes}}, kNotDone);
}

void DirectPass::sum_seen(DirectPiece& piece) {
  const std::size_t pairs = piece.points.size() * piece.is_asked.size();
  const std::size_t sums = channels_of(piece) * piece.points.size();
  light_.assign(pairs * 2 * sizeof(double), kNoNumber);
  known_.assign(2 * sums * sizeof(double), kNoNumber);
  light_.bind(kLight);
  known_.bind(kKnown);
  start(seen_, piece);
  run_in_parts(piece, seen_, seen_pacer_, pairs, "first_pair", "last_pair");
  start(sums_, piece);
  dispatch(sums);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  known_back_.start({{known_, 0, sums * sizeof(double)}}, kNoNumber);
}

void DirectPass::take_pairs(DirectPiece& piece) {
  const std::size_t points = piece.points.size();
  words_of_pairs_.resize(points * piece.is_asked.size());
  pairs_back_.wait(kDoing);
  pairs_back_.copy(0, std::as_writable_bytes(std::span(words_of_pairs_)));
  piece.is_left.assign(points, 0);
  // One look at each: this is all that the CPU does for a pair that is proved.
  for (std::size_t i = 0; i < words_of_pairs_.size(); ++i) {
    const std::uint32_t word = words_of_pairs_[i];
    piece.asked_pairs += word != kPairNothing ? 1 : 0;
    static_assert(kPairNothing < kPairSampled && kPairHidden < kPairSampled &&
                  kPairSeen < kPairSampled && kPairSampled < kPairLeft);
    if (word < kPairSampled) continue;
    if (word == kNotDone) throw_not_done();
    if (word == kPairLeft) {
      piece.is_left[i % points] = 1;
    } else {
      piece.sampled.push_back({count(i % points), count(i / points), word / kPairStep});
    }
  }
}

void DirectPass::take_known(DirectPiece& piece) {
  piece.known_lx.resize(channels_of(piece) * piece.points.size());
  known_back_.wait(kDoing);
  known_back_.copy(0, std::as_writable_bytes(std::span(piece.known_lx)));
  if (!std::all_of(piece.known_lx.begin(), piece.known_lx.end(), is_done)) throw_not_done();
}

void DirectPass::sample(const DirectLimits& limits, DirectPiece& piece) {
  if (!add_up_) {
    samples_ = std::make_unique<GlProgram>("samples of openings",
                                           direct_shader(DirectStage::samples), programs_);
    add_up_ = std::make_unique<GlProgram>("sums of samples of openings",
                                          direct_shader(DirectStage::totals), programs_);
  }
  const std::size_t points = piece.points.size(), replicates = piece.rounds.replicates;
  piece.totals.resize(replicates * (channels_of(piece) + 1) * points);
  const std::size_t bytes = piece.totals.size() * sizeof(double);
  totals_.assign(bytes, kNoNumber);
  totals_.bind(kTotals);
  const Chunks chunks = chunks_of(piece, limits.chunk);
  for (std::size_t first = 0; first < points;) {
    std::size_t last = first + 1;
    const auto sums_to = [&](std::size_t p) {
      return (chunks.first[p] - chunks.first[first]) * replicates;
    };
    while (last < points && sums_to(last + 1) <= limits.chunk_sums) ++last;
    std::vector<std::uint32_t> list;
    for (std::size_t p = first; p <= last; ++p) {
      list.push_back(chunks.first[p] - chunks.first[first]);
    }
    for (std::size_t k = chunks.first[first]; k < chunks.first[last]; ++k) {
      list.insert(list.end(), chunks.chunk[k].begin(), chunks.chunk[k].end());
    }
    sample_points(piece, first, last, list, chunks.first[last] - chunks.first[first]);
    if (piece.is_cut_short) return;
    first = last;
  }
  totals_back_.start({{totals_, 0, bytes}}, kNoNumber);
  totals_back_.wait(kDoing);
  totals_back_.copy(0, std::as_writable_bytes(std::span(piece.totals)));
  if (!std::all_of(piece.totals.begin(), piece.totals.end(), is_done)) throw_not_done();
}

void DirectPass::sample_points(DirectPiece& piece, std::size_t first, std::size_t last,
                               std::span<const std::uint32_t> list, std::size_t chunks) {
  const std::size_t jobs = chunks * piece.rounds.replicates;
  list_.assign(list);
  // Never empty: a shader must have something to bind.
  chunk_sums_.assign(std::max<std::size_t>(jobs, 1) * 4 * sizeof(std::uint32_t), kNotDone);
  list_.bind(kList);
  chunk_sums_.bind(kChunkSums);
  if (jobs > 0) {
    start(*samples_, piece);
    samples_->set("listed_points", count(last - first));
    run_in_parts(piece, *samples_, samples_pacer_, jobs, "first_job", "last_job");
  }
  start(*add_up_, piece);
  add_up_->set("listed_points", count(last - first));
  add_up_->set("first_point", count(first));
  dispatch(piece.rounds.replicates * channels_of(piece) * (last - first));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace gpu
