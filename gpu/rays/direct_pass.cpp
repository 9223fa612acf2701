#include "gpu/rays/direct_pass.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/lamp_tables.h"
#include "gpu/scene/number_table.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
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

// As shaders/direct/lamps.glsl reads it: four uvec4.
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
  std::vector<std::array<std::uint32_t, 4>> chunk;  // as shaders/direct/direct_chunks.glsl has them
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

std::size_t pairs_of(const DirectPiece& piece) {
  return piece.points.size() * piece.is_asked.size();
}

std::size_t totals_of(const DirectPiece& piece) {
  return piece.keys.empty()
             ? 0
             : piece.rounds.replicates * (channels_of(piece) + 1) * piece.points.size();
}

void take_numbers(const BorrowedBytes& from, std::size_t numbers, std::vector<double>& to) {
  if (from.bytes().size() != numbers * sizeof(double)) throw_not_done();
  to.resize(numbers);
  if (numbers > 0) std::memcpy(to.data(), from.bytes().data(), from.bytes().size());
  if (!std::all_of(to.begin(), to.end(), is_done)) throw_not_done();
}

}  // namespace

void take_pairs(const BorrowedBytes& pairs, DirectPiece& piece) {
  const std::size_t points = piece.points.size();
  if (pairs.bytes().size() != pairs_of(piece) * sizeof(std::uint32_t)) throw_not_done();
  const auto* const words = reinterpret_cast<const std::uint32_t*>(pairs.bytes().data());
  piece.is_left.assign(points, 0);
  // One look at each: this is all that the CPU does for a pair that is proved.
  for (std::size_t i = 0; i < pairs_of(piece); ++i) {
    const std::uint32_t word = words[i];
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

std::vector<DirectSamples> samples_of(const DirectPiece& piece, const DirectLimits& limits) {
  const std::size_t points = piece.points.size();
  const Chunks chunks = chunks_of(piece, limits.chunk);
  std::vector<DirectSamples> samples;
  for (std::size_t first = 0; first < points;) {
    std::size_t last = first + 1;
    const auto sums_to = [&](std::size_t p) {
      return (chunks.first[p] - chunks.first[first]) * piece.rounds.replicates;
    };
    while (last < points && sums_to(last + 1) <= limits.chunk_sums) ++last;
    DirectSamples& some = samples.emplace_back();
    some.first_point = first;
    some.last_point = last;
    some.chunks = chunks.first[last] - chunks.first[first];
    for (std::size_t p = first; p <= last; ++p) {
      some.list.push_back(chunks.first[p] - chunks.first[first]);
    }
    for (std::size_t k = chunks.first[first]; k < chunks.first[last]; ++k) {
      some.list.insert(some.list.end(), chunks.chunk[k].begin(), chunks.chunk[k].end());
    }
    first = last;
  }
  return samples;
}

void take_sums(const BorrowedBytes& known, const BorrowedBytes& totals, DirectPiece& piece) {
  take_numbers(known, channels_of(piece) * piece.points.size(), piece.known_lx);
  take_numbers(totals, totals_of(piece), piece.totals);
}

DirectPass::DirectPass(const ProgramCache& programs)
    : programs_(programs),
      classify_("what points see of luminaires", direct_shader(DirectStage::classify), programs),
      seen_("light of openings that are seen", direct_shader(DirectStage::seen), programs),
      sums_("sums of direct light", direct_shader(DirectStage::sums), programs),
      tables_("luminaires", BufferUse::fixed),
      sketches_("photometry", BufferUse::fixed),
      list_("samples of openings"),
      chunk_sums_("sums of samples", BufferUse::by_device),
      classify_pacer_(kPairsPerDispatch),
      seen_pacer_(kPairsPerDispatch),
      samples_pacer_(kChunksPerDispatch) {}

void DirectPass::send_tables(const calc::Tracer& tracer) {
  if (tables_of_ == tracer.identity()) return;
  tables_of_ = 0;  // should sending fail
  const LampTables tables = lamp_tables(tracer);
  tables_.assign(tables.entries);
  sketches_.assign(tables.sketches);
  tables_of_ = tracer.identity();
}

void DirectPass::bind(DeviceState& device, const DirectPiece& piece, const DirectBuffers& buffers) {
  send_tables(*piece.tracer);
  const DeviceScene& scene = device.scenes.of(*piece.tracer);
  nodes_ = scene.nodes;
  scene.bind();
  scene.order.bind(kList);
  buffers.points.bind(kPoints);
  tables_.bind(kTables);
  buffers.words.bind(kWords);
  sketches_.bind(kSketches);
  buffers.pairs.bind(kPairs);
  buffers.light.bind(kLight);
  buffers.known.bind(kKnown);
  buffers.totals.bind(kTotals);
}

void DirectPass::start(DeviceState& device, DirectPiece& piece, DirectBuffers& buffers) {
  const std::size_t sums = channels_of(piece) * piece.points.size();
  buffers.points.assign(gpu_points(piece));
  buffers.words.assign(words_of(piece));
  buffers.pairs.assign(pairs_of(piece) * sizeof(std::uint32_t), kNotDone);
  buffers.light.assign(pairs_of(piece) * 2 * sizeof(double), kNoNumber);
  buffers.known.assign(2 * sums * sizeof(double), kNoNumber);
  bind(device, piece, buffers);
  find_pairs(piece, buffers);
  if (!piece.is_cut_short) sum_seen(piece, buffers);
  check_gl(kDoing);
}

void DirectPass::use(const GlProgram& program, const DirectPiece& piece) const {
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

void DirectPass::find_pairs(DirectPiece& piece, DirectBuffers& buffers) {
  use(classify_, piece);
  run_in_parts(piece, classify_, classify_pacer_, pairs_of(piece), "first_pair", "last_pair");
  buffers.pairs_back.start({{buffers.pairs, 0, pairs_of(piece) * sizeof(std::uint32_t)}}, kNotDone);
}

void DirectPass::sum_seen(DirectPiece& piece, DirectBuffers& buffers) {
  const std::size_t sums = channels_of(piece) * piece.points.size();
  use(seen_, piece);
  run_in_parts(piece, seen_, seen_pacer_, pairs_of(piece), "first_pair", "last_pair");
  use(sums_, piece);
  dispatch(sums);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  buffers.known_back.start({{buffers.known, 0, sums * sizeof(double)}}, kNoNumber);
}

BorrowedBytes DirectPass::pairs(DeviceState& device, const DirectPiece& piece,
                                DirectBuffers& buffers) {
  buffers.pairs_back.wait(kDoing);
  device.check(kDoing);
  return buffers.pairs_back.lend(0, pairs_of(piece) * sizeof(std::uint32_t));
}

void DirectPass::sample(DeviceState& device, DirectPiece& piece,
                        std::span<const DirectSamples> samples, DirectBuffers& buffers) {
  if (!add_up_) {
    samples_ = std::make_unique<GlProgram>("samples of openings",
                                           direct_shader(DirectStage::samples), programs_);
    add_up_ = std::make_unique<GlProgram>("sums of samples of openings",
                                          direct_shader(DirectStage::totals), programs_);
  }
  const std::size_t bytes = totals_of(piece) * sizeof(double);
  buffers.totals.assign(bytes, kNoNumber);
  bind(device, piece, buffers);
  for (const DirectSamples& some : samples) {
    sample_points(piece, some);
    if (piece.is_cut_short) return;
  }
  buffers.totals_back.start({{buffers.totals, 0, bytes}}, kNoNumber);
  check_gl(kDoing);
}

void DirectPass::sample_points(DirectPiece& piece, const DirectSamples& samples) {
  const std::size_t jobs = samples.chunks * piece.rounds.replicates;
  const std::size_t points = samples.last_point - samples.first_point;
  list_.assign(samples.list);
  // Never empty: a shader must have something to bind.
  chunk_sums_.assign(std::max<std::size_t>(jobs, 1) * 4 * sizeof(std::uint32_t), kNotDone);
  list_.bind(kList);
  chunk_sums_.bind(kChunkSums);
  if (jobs > 0) {
    use(*samples_, piece);
    samples_->set("listed_points", count(points));
    run_in_parts(piece, *samples_, samples_pacer_, jobs, "first_job", "last_job");
  }
  use(*add_up_, piece);
  add_up_->set("listed_points", count(points));
  add_up_->set("first_point", count(samples.first_point));
  dispatch(piece.rounds.replicates * channels_of(piece) * points);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

DirectPass::Sums DirectPass::sums(DeviceState& device, const DirectPiece& piece,
                                  DirectBuffers& buffers) {
  const std::size_t known = channels_of(piece) * piece.points.size() * sizeof(double);
  const std::size_t totals = totals_of(piece) * sizeof(double);
  buffers.known_back.wait(kDoing);
  if (totals > 0) buffers.totals_back.wait(kDoing);
  device.check(kDoing);
  Sums sums;
  sums.known = buffers.known_back.lend(0, known);
  if (totals > 0) sums.totals = buffers.totals_back.lend(0, totals);
  return sums;
}

}  // namespace gpu
