#include "gpu/rays/path_pass.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/rays/path_tables.h"
#include "gpu/scene/number_table.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace gpu {
namespace {

enum LightPathBinding : unsigned {
  kTables = 3,  // 0 to 2 and 8 are those of DeviceScene
  kWords,
  kStates,
  kVertices,
  kCounts
};
enum PlacesBinding : unsigned { kChunks = 0, kPlaces, kPacked, kNextStates, kBalances };

// Reflections of a path in one round: room for so many of every path, for more when fewer live.
constexpr std::uint32_t kReflectionsPerRound = 8;
constexpr std::uint32_t kMostReflectionsPerRound = 64;

// Mesa's llvmpipe leaves all loops of an invocation after 65535 turns: reflections of one round
// that stay below it even if a ray visits all boxes and triangles, twice because the rays of one
// vector wait for each other. More than the 65535 of a single ray are told by the shader.
std::uint32_t reflections_of_software(std::uint32_t turns_of_ray) {
  constexpr std::uint32_t kMostTurns = 60000, kTurnsBesides = 100;
  return std::max(1u, kMostTurns / (2 * std::min(turns_of_ray, kMostTurns) + kTurnsBesides));
}

constexpr std::size_t kMostTables = 2;
constexpr std::size_t kStateBytes = 64;

// Reflections of all paths in one dispatch.
DispatchSize dispatch_size(std::uint32_t most_paths) {
  const std::size_t most = std::size_t{most_paths} * kMostReflectionsPerRound;
  return {most_paths / kReflectionsPerRound, most, std::size_t{most_paths} * kReflectionsPerRound};
}

void run_groups(std::size_t invocations) {
  glDispatchCompute(static_cast<GLuint>((invocations + kGroupSize - 1) / kGroupSize), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace

PathPass::PathPass(std::uint32_t most_paths, const ProgramCache& programs)
    : most_paths_(most_paths),
      starts_program_("starts of light paths", path_starts_shader(), programs),
      paths_program_("light paths", light_path_shader(), programs),
      sums_program_("sums of light paths", path_sums_shader(), programs),
      places_program_("places of light paths", path_places_shader(), programs),
      balance_program_("balance of light paths", path_balance_shader(), programs),
      words_("random numbers"),
      vertices_("light vertices", BufferUse::by_device),
      packed_("packed light vertices", BufferUse::by_device),
      counts_("counts of light vertices", BufferUse::by_device),
      chunks_("chunks of light paths"),
      sums_("sums of light paths", BufferUse::by_device),
      places_("places of light vertices"),
      balances_("fluxes of light paths", BufferUse::by_device),
      states_{GlBuffer("light paths", BufferUse::by_device),
              GlBuffer("light paths", BufferUse::by_device)},
      sums_back_("sums of light paths"),
      direction_numbers_(sobol_words(calc::kSobolDimensions)),
      pacer_(dispatch_size(most_paths)) {
  const std::size_t room =
      std::size_t{most_paths} * kReflectionsPerRound * sizeof(calc::LightVertex);
  vertices_.reserve(room);
  packed_.reserve(room);
  counts_.reserve(most_paths * sizeof(std::uint32_t));
  balances_.reserve(most_paths * sizeof(glm::dvec2));
  for (GlBuffer& states : states_) states.reserve(most_paths * kStateBytes);
}

void PathPass::run(DeviceState& device, std::span<PathJob* const> jobs) {
  start(jobs);
  emit(jobs);
  while (slot_.back() > 0) {
    const std::uint32_t reflections = reflections_for(device, jobs);
    for (PathJob* job : jobs) {
      if (calc::is_past(job->batch.deadline_s)) job->is_late = true;
    }
    trace(device, *jobs.front(), reflections);
    const std::vector<ChunkSum> sums = sum_up();
    deliver(jobs);  // of the round before, which has long been there
    reflection_ += reflections;
    device.check("tracing light paths");
    pack(jobs, sums);
  }
  start_balance();
  deliver(jobs);
  finish_balance(jobs);
  device.check("tracing light paths");
}

std::uint32_t PathPass::reflections_for(DeviceState& device, std::span<PathJob* const> jobs) const {
  std::uint32_t left = kMostReflectionsPerRound;
  if (device.context.device().is_software) {  // has no watchdog, and short rounds cost time
    left =
        std::min(left, reflections_of_software(device.scenes.of(jobs.front()->tracer).most_turns));
  } else {
    left = std::min(
        left, static_cast<std::uint32_t>(std::max<std::size_t>(pacer_.items() / slot_.back(), 1)));
  }
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    // A batch whose paths have all ended may have reached its last reflection.
    const bool goes_on = !jobs[j]->is_useless() && alive_[j] > 0;
    if (goes_on) left = std::min(left, reflections_left(*jobs[j]));
  }
  return std::min(left, most_paths_ * kReflectionsPerRound / slot_.back());
}

std::uint32_t PathPass::reflections_left(const PathJob& job) const {
  const auto most = static_cast<std::uint32_t>(job.batch.most_reflections);
  return most > reflection_ ? most - reflection_ : 0;
}

void PathPass::start(std::span<PathJob* const> jobs) {
  std::vector<std::uint32_t> words = direction_numbers_;
  chunk_.clear();
  slot_.assign(1, 0);
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    const PathJob& job = *jobs[j];
    const calc::ScrambledSobol sobol = calc::path_samples(job.batch);
    std::array<std::uint32_t, kJobSize> part{};
    static_assert(calc::kSobolDimensions <= kJobKey);
    for (int dimension = 0; dimension < calc::kSobolDimensions; ++dimension) {
      part[static_cast<std::size_t>(dimension)] = sobol.scramble(dimension);
    }
    part[kJobKey] = static_cast<std::uint32_t>(sobol.key().bits());
    part[kJobKey + 1] = static_cast<std::uint32_t>(sobol.key().bits() >> 32);
    part[kJobFirstPath] = job.first;
    part[kJobBatchPaths] = job.batch.last - job.batch.first;
    part[kJobFirstSlot] = slot_.back();
    words.insert(words.end(), part.begin(), part.end());
    for (std::uint32_t first = job.first; first < job.last; first += calc::kPathsPerChunk) {
      const std::uint32_t paths = std::min(calc::kPathsPerChunk, job.last - first);
      chunk_.push_back({j, first, paths});
      slot_.push_back(slot_.back() + paths);
    }
  }
  words_.assign(words);
  balances_.fill(chunk_.size() * calc::kPathsPerChunk * sizeof(glm::dvec2), ~0u);  // NaN
  alive_.assign(jobs.size(), 1);
  reflection_ = 0;
  on_its_way_ = nullptr;
}

void PathPass::emit(std::span<PathJob* const> jobs) {
  const PathJob& job = *jobs.front();
  starts_program_.use();
  tables_of(job).bind(kTables);
  words_.bind(kWords);
  states_[now_].bind(kStates);
  starts_program_.set("luminaire_count",
                      static_cast<std::uint32_t>(job.emitter.scene().luminaires.size()));
  starts_program_.set("path_count", slot_.back());
  starts_program_.set("job_count", static_cast<std::uint32_t>(jobs.size()));
  run_groups(slot_.back());
  check_gl("starting light paths");
}

void PathPass::trace(DeviceState& device, const PathJob& job, std::uint32_t reflections) {
  const std::uint32_t paths = slot_.back();
  counts_.fill(paths * sizeof(std::uint32_t), ~0u);
  const DeviceScene& scene = device.scenes.of(job.tracer);
  paths_program_.use();
  scene.bind();
  scene.bind_surfaces();
  tables_of(job).bind(kTables);
  words_.bind(kWords);
  states_[now_].bind(kStates);
  vertices_.bind(kVertices);
  counts_.bind(kCounts);
  paths_program_.set("node_count", scene.nodes);
  paths_program_.set("path_count", paths);
  paths_program_.set("first_reflection", reflection_);
  paths_program_.set("reflections", reflections);
  pacer_.run(std::size_t{paths} * reflections, "tracing light paths", [&] { run_groups(paths); });
  check_gl("tracing light paths");
}

std::vector<PathPass::ChunkSum> PathPass::sum_up() {
  chunks_.assign(slot_);
  std::vector<ChunkSum> sums(chunk_.size());
  sums_.assign(sums.size() * sizeof(ChunkSum), ~0u);
  sums_program_.use();
  sums_program_.set("chunk_count", static_cast<std::uint32_t>(chunk_.size()));
  chunks_.bind(kChunks);
  sums_.bind(kPlaces);
  counts_.bind(kCounts);
  run_groups(chunk_.size());
  const auto bytes = std::as_writable_bytes(std::span(sums));
  sums_back_.start({{sums_, 0, bytes.size()}}, ~0u);
  sums_back_.wait("adding up light paths");
  sums_back_.copy(0, bytes);
  check_gl("adding up light paths");
  for (const ChunkSum& sum : sums) {
    if (sum.is_done != 1) throw_not_done();
  }
  return sums;
}

// Decides which jobs go on, moves vertices and living paths together, fetches the former.
void PathPass::pack(std::span<PathJob* const> jobs, const std::vector<ChunkSum>& sums) {
  alive_.assign(jobs.size(), 0);
  for (std::size_t c = 0; c < chunk_.size(); ++c) {
    PathJob& job = *jobs[chunk_[c].job];
    job.vertices += sums[c].vertices;
    job.rays += sums[c].rays;
    alive_[chunk_[c].job] += sums[c].alive;
  }
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    PathJob& job = *jobs[j];
    if (job.vertices > job.most_vertices) job.has_too_many_vertices = true;
    if (reflections_left(job) == 0 && alive_[j] > 0) job.has_endless_path = true;
  }

  on_its_way_ = &free_delivery();
  std::vector<std::vector<std::uint32_t>>& chunk_vertices = on_its_way_->chunk_vertices;
  chunk_vertices.assign(jobs.size(), {});
  on_its_way_->share_alive.clear();
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    on_its_way_->share_alive.push_back(static_cast<double>(alive_[j]) /
                                       (jobs[j]->last - jobs[j]->first));
  }
  std::vector<glm::uvec4> places;
  std::vector<std::uint32_t> next_slot{0};
  std::uint32_t vertex = 0;
  for (std::size_t c = 0; c < chunk_.size(); ++c) {
    const std::size_t j = chunk_[c].job;
    const bool is_wanted = !jobs[j]->is_useless();
    places.emplace_back(is_wanted ? vertex : kPathDropped, next_slot.back(), chunk_[c].first_path,
                        0);
    next_slot.push_back(next_slot.back() + (is_wanted ? sums[c].alive : 0));
    if (!is_wanted) continue;
    chunk_vertices[j].push_back(sums[c].vertices);
    vertex += sums[c].vertices;
  }
  places_.assign(places);
  packed_.fill(vertex * sizeof(calc::LightVertex), ~0u);
  places_program_.use();
  places_program_.set("path_count", slot_.back());
  chunks_.bind(kChunks);
  places_.bind(kPlaces);
  packed_.bind(kPacked);
  states_[1 - now_].bind(kNextStates);
  balances_.bind(kBalances);
  states_[now_].bind(kStates);
  vertices_.bind(kVertices);
  counts_.bind(kCounts);
  run_groups(chunk_.size() * kGroupSize);  // a group for each chunk
  check_gl("packing light vertices");
  on_its_way_->back.start({{packed_, 0, vertex * sizeof(calc::LightVertex)}}, ~0u);
  now_ = 1 - now_;
  slot_ = std::move(next_slot);
}

// One that nobody reads, the largest of them, so that no more grow than are needed at once; else
// the one that was lent first.
PathPass::Delivery& PathPass::free_delivery() {
  auto best = deliveries_.begin();
  for (auto one = deliveries_.begin(); one != deliveries_.end(); ++one) {
    if (!one->back.has_all()) continue;
    if (!best->back.has_all() || one->back.room_bytes() > best->back.room_bytes()) best = one;
  }
  deliveries_.splice(deliveries_.end(), deliveries_, best);
  return deliveries_.back();
}

void PathPass::deliver(std::span<PathJob* const> jobs) {
  if (on_its_way_ == nullptr) return;
  Delivery& delivery = *std::exchange(on_its_way_, nullptr);
  delivery.back.wait("packing light vertices");
  std::size_t first = 0;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    std::vector<std::uint32_t>& chunks = delivery.chunk_vertices[j];
    const std::size_t bytes =
        sizeof(calc::LightVertex) * std::accumulate(chunks.begin(), chunks.end(), std::size_t{0});
    if (bytes == 0) continue;
    jobs[j]->take({std::move(chunks), delivery.back.lend(first, bytes), delivery.share_alive[j]});
    first += bytes;
  }
}

void PathPass::start_balance() {
  std::vector<std::uint32_t> paths;
  for (const Chunk& chunk : chunk_) paths.push_back(chunk.paths);
  chunks_.assign(paths);
  const std::size_t bytes = chunk_.size() * sizeof(glm::dvec2);
  sums_.assign(bytes, ~0u);
  balance_program_.use();
  balance_program_.set("chunk_count", static_cast<std::uint32_t>(chunk_.size()));
  balances_.bind(0);
  chunks_.bind(1);
  sums_.bind(2);
  run_groups(chunk_.size());
  check_gl("adding up fluxes");
  sums_back_.start({{sums_, 0, bytes}}, ~0u);
}

void PathPass::finish_balance(std::span<PathJob* const> jobs) {
  sums_back_.wait("adding up fluxes");
  std::vector<glm::dvec2> sums(chunk_.size());
  sums_back_.copy(0, std::as_writable_bytes(std::span(sums)));
  for (std::size_t c = 0; c < chunk_.size(); ++c) {
    PathJob& job = *jobs[chunk_[c].job];
    if (job.is_useless()) continue;
    if (!(sums[c].x >= 0.0) || !(sums[c].y >= 0.0)) throw_not_done();
    job.absorbed_lm += sums[c].x;
    job.escaped_lm += sums[c].y;
  }
}

const GlBuffer& PathPass::tables_of(const PathJob& job) {
  const auto found = std::find_if(tables_.begin(), tables_.end(), [&](const Tables& tables) {
    return tables.emitter == job.emitter.identity();
  });
  if (found != tables_.end()) {
    tables_.splice(tables_.begin(), tables_, found);
    return tables_.front().value;
  }
  while (tables_.size() >= kMostTables) tables_.pop_back();
  Tables tables{job.emitter.identity(), GlBuffer("luminaires", BufferUse::fixed)};
  tables.value.assign(path_tables(job.emitter, job.tracer.offset_m()));
  check_gl("sending luminaires");
  tables_.push_front(std::move(tables));
  return tables_.front().value;
}

}  // namespace gpu
