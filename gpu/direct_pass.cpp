#include "gpu/direct_pass.h"

#include "calc/radiosity/low_discrepancy.h"
#include "gpu/gl_error.h"
#include "gpu/lamp_tables.h"
#include "gpu/path_shader_text.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
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

constexpr std::uint32_t kFilledNumber = 0xffff'ffff;  // twice: a double that is no number

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
  std::vector<std::uint32_t> words;
  for (int dimension = 0; dimension < 2; ++dimension) {
    for (int bit = 0; bit < 32; ++bit) {
      words.push_back(calc::ScrambledSobol::direction_number(dimension, bit));
    }
  }
  words.insert(words.end(), piece.is_asked.begin(), piece.is_asked.end());
  return words;
}

std::uint32_t count(std::size_t n) { return static_cast<std::uint32_t>(n); }

void dispatch(std::size_t invocations) {
  glDispatchCompute(count((invocations + kGroupSize - 1) / kGroupSize), 1, 1);
}

std::size_t channels_of(const DirectPiece& piece) { return piece.tracer->scene().channels.size(); }

[[noreturn]] void throw_not_done() {
  throw calc::BackendFailure("the device did not finish its work");
}

bool is_done(double value) { return std::bit_cast<std::uint64_t>(value) != ~std::uint64_t{0}; }

// Samples of pairs of which nothing is proved, in chunks, point by point.
struct Chunks {
  std::vector<std::uint32_t> first;                 // [point], and one more
  std::vector<std::array<std::uint32_t, 4>> chunk;  // as shaders/direct_chunks.glsl has them
};

Chunks chunks_of(const DirectPiece& piece, std::uint32_t most_samples) {
  Chunks result{{0}, {}};
  const std::size_t points = piece.points.size(), luminaires = piece.is_asked.size();
  const std::uint32_t rounds = piece.rounds.last - piece.rounds.first;
  for (std::size_t p = 0; p < points; ++p) {
    for (std::size_t l = 0; l < luminaires && piece.is_left[p] == 0; ++l) {
      const std::uint32_t pair = piece.pairs[l * points + p];
      if (pair % kPairStep != kPairSampled) continue;
      const std::uint32_t samples = pair / kPairStep * rounds;
      for (std::uint32_t at = 0; at < samples; at += most_samples) {
        result.chunk.push_back({count(p), count(l), at, std::min(most_samples, samples - at)});
      }
    }
    result.first.push_back(count(result.chunk.size()));
  }
  return result;
}

}  // namespace

DirectPass::DirectPass(const ProgramCache& programs)
    : classify_("what points see of luminaires", direct_shader(DirectStage::classify), programs),
      seen_("light of openings that are seen", direct_shader(DirectStage::seen), programs),
      sums_("sums of direct light", direct_shader(DirectStage::sums), programs),
      samples_("samples of openings", direct_shader(DirectStage::samples), programs),
      totals_program_("sums of samples of openings", direct_shader(DirectStage::totals), programs),
      points_("calculation points"),
      tables_("luminaires"),
      words_("random numbers"),
      sketches_("photometry"),
      pairs_("points and luminaires"),
      light_("direct light"),
      list_("samples of openings"),
      chunk_sums_("sums of samples"),
      known_("sums of direct light"),
      totals_("direct light of replicates") {}

void DirectPass::run(DeviceState& device, const DirectLimits& limits, DirectPiece& piece) {
  send(device, piece);
  find_pairs(device, piece);
  sum_seen(device, piece);
  if (!piece.keys.empty()) sample(device, limits, piece);
  device.check("direct light");
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
  scene.bind();
  scene.order.bind(kList);
  points_.bind(kPoints);
  tables_.bind(kTables);
  words_.bind(kWords);
  sketches_.bind(kSketches);
}

void DirectPass::start(const GlProgram& program, const DirectPiece& piece) const {
  program.use();
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
  program.set("first_pair", 0u);
  program.set("last_pair", count(piece.points.size() * piece.is_asked.size()));
}

void DirectPass::find_pairs(DeviceState& device, DirectPiece& piece) {
  piece.pairs.assign(piece.points.size() * piece.is_asked.size(), kNotDone);
  pairs_.assign(piece.pairs.size() * sizeof(std::uint32_t), kNotDone);
  start(classify_, piece);
  classify_.set("node_count", device.scenes.of(*piece.tracer).nodes);
  pairs_.bind(kPairs);
  dispatch(piece.pairs.size());
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  pairs_.read(0, std::as_writable_bytes(std::span(piece.pairs)));
  device.check("finding what points see of luminaires");
  const std::size_t points = piece.points.size();
  piece.is_left.assign(points, 0);
  for (std::size_t i = 0; i < piece.pairs.size(); ++i) {
    if (piece.pairs[i] == kNotDone) throw_not_done();
    if (piece.pairs[i] == kPairLeft) piece.is_left[i % points] = 1;
  }
}

void DirectPass::sum_seen(DeviceState& device, DirectPiece& piece) {
  const std::size_t sums = channels_of(piece) * piece.points.size();
  light_.assign(piece.pairs.size() * 2 * sizeof(double), kFilledNumber);
  known_.assign(2 * sums * sizeof(double), kFilledNumber);
  light_.bind(kLight);
  known_.bind(kKnown);
  start(seen_, piece);
  dispatch(piece.pairs.size());
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  start(sums_, piece);
  dispatch(sums);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  piece.known_lx.assign(sums, std::bit_cast<double>(~std::uint64_t{0}));
  known_.read(0, std::as_writable_bytes(std::span(piece.known_lx)));
  device.check("adding direct light");
  if (!std::all_of(piece.known_lx.begin(), piece.known_lx.end(), is_done)) throw_not_done();
}

void DirectPass::sample(DeviceState& device, const DirectLimits& limits, DirectPiece& piece) {
  const std::size_t points = piece.points.size(), replicates = piece.rounds.replicates;
  const std::size_t totals = replicates * (channels_of(piece) + 1) * points;
  totals_.assign(totals * sizeof(double), kFilledNumber);
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
    sample_points(device, limits, piece, first, last, list,
                  chunks.first[last] - chunks.first[first]);
    first = last;
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  piece.totals.assign(totals, std::bit_cast<double>(~std::uint64_t{0}));
  totals_.read(0, std::as_writable_bytes(std::span(piece.totals)));
  device.check("adding samples of openings");
  if (!std::all_of(piece.totals.begin(), piece.totals.end(), is_done)) throw_not_done();
}

void DirectPass::sample_points(DeviceState& device, const DirectLimits& limits,
                               const DirectPiece& piece, std::size_t first, std::size_t last,
                               std::span<const std::uint32_t> list, std::size_t chunks) {
  const std::size_t jobs = chunks * piece.rounds.replicates;
  list_.assign(list);
  // Never empty: a shader must have something to bind.
  chunk_sums_.assign(std::max<std::size_t>(jobs, 1) * 4 * sizeof(std::uint32_t), kNotDone);
  list_.bind(kList);
  chunk_sums_.bind(kChunkSums);
  totals_.bind(kTotals);
  if (jobs > 0) {
    start(samples_, piece);
    samples_.set("node_count", device.scenes.of(*piece.tracer).nodes);
    samples_.set("listed_points", count(last - first));
    for (std::size_t begin = 0; begin < jobs; begin += limits.chunks_per_dispatch) {
      const std::size_t end = std::min(jobs, begin + limits.chunks_per_dispatch);
      samples_.set("first_job", count(begin));
      samples_.set("last_job", count(end));
      dispatch(end - begin);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  start(totals_program_, piece);
  totals_program_.set("listed_points", count(last - first));
  totals_program_.set("first_point", count(first));
  dispatch(piece.rounds.replicates * channels_of(piece) * (last - first));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace gpu
