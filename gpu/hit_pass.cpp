#include "gpu/hit_pass.h"

#include "calc/radiosity/cut.h"
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/phase_timer.h"
#include "calc/radiosity/vertex_bounds.h"
#include "calc/radiosity/vertex_tree.h"
#include "gpu/gl_error.h"
#include "gpu/lamp_tables.h"
#include "gpu/path_shader_text.h"
#include "gpu/shader_text.h"
#include "gpu/tile_words.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>

namespace gpu {
namespace {

// Others are those of DeviceScene, ShortRayPass, DevicePool and draw_arrays.glsl. Not all are used
// at the same time.
enum Binding : unsigned {
  kTables = 3,
  kReceiversToDraw = 4,
  kCounts = 5,
  kTiles = 5,
  kList = 7,
  kWeights = 8,
  kCumulated,
  kSpacings,
  kChoice,
  kLights,
  kPlaces,
  kReceivers,
  kChannelWeights = kReceivers
};

constexpr const char* kDoing = "finding light at hits of short rays";
constexpr std::size_t kMostGroups = 65535;                  // in one direction, on any device
constexpr std::size_t kMostWeights = std::size_t{1} << 22;  // of a piece: doubles
const DispatchSize kHitsPerDispatch{std::size_t{1} << 8, std::size_t{1} << 20,
                                    std::size_t{1} << 12};
constexpr std::uint32_t kPlacesPerHit = calc::kFarDraws + 1;
constexpr std::size_t kPlaceBytes = 64, kReceiverBytes = sizeof(DrawReceiver);

std::uint32_t word(std::size_t number) { return static_cast<std::uint32_t>(number); }

void dispatch(std::size_t invocations) {
  glDispatchCompute(word((invocations + kGroupSize - 1) / kGroupSize), 1, 1);
}

// For shaders and copies that read what shaders wrote.
void wait_for_writes() {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void add(std::vector<float>& table, const glm::vec3& v) {
  table.insert(table.end(), {v.x, v.y, v.z});
}

// As shaders/hit_direct.glsl reads it. Never empty: a shader must have something to bind.
std::vector<float> choice_table(const calc::LuminaireChoice& choice) {
  std::vector<float> table;
  for (const auto& source : choice.sources()) {
    for (const glm::vec3& v : {source.position_m, source.x, source.y, source.z, source.half_m}) {
      add(table, v);
    }
    table.insert(table.end(), {source.reach_m, source.scale, static_cast<float>(source.lobe),
                               static_cast<float>(source.channel)});
  }
  static_assert(kChoiceSize == 5 * 3 + 4);
  for (const auto& lobe : choice.lobes()) {
    table.push_back(lobe.largest_cd);
    table.insert(table.end(), lobe.most_cd.begin(), lobe.most_cd.end());
  }
  static_assert(kLobeSize == 1 + calc::choice_terms::kChoiceBands);
  if (table.empty()) table.push_back(0.0f);
  return table;
}

std::size_t blocks_of(const ShortRayJob& job) {
  return (job.part.rays() + kRaysPerBlock - 1) / kRaysPerBlock;
}

// The tile of all nodes and the tile of none.
std::vector<std::uint32_t> tiles_of(const calc::NearField& field) {
  const calc::Cut& cut = field.cut;
  std::vector<std::uint32_t> tiles;
  static_assert(kTileOfAll == 0 && kTileOfNothing == 1);
  append_tile(field.tree, cut.size(), cut.nodes(), cut.channels(), tiles);
  append_tile(field.tree, cut.size(), {}, {}, tiles);
  return tiles;
}

}  // namespace

HitPass::Stage::Stage(const std::string& what, const std::string& source,
                      const ProgramCache& programs)
    : program(what, source, programs), pacer(kHitsPerDispatch) {}

HitPass::HitPass(const ProgramCache& programs, const HitLimits& limits)
    : programs_(programs),
      limits_(limits),
      counts_shader_("numbers of hits", hit_shader(HitStage::counts), programs),
      list_shader_("list of hits", hit_shader(HitStage::list), programs),
      bounds_("bounds at hits", hit_shader(HitStage::bounds), programs),
      direct_("direct light at hits", hit_shader(HitStage::direct), programs),
      further_("further short rays", hit_shader(HitStage::further), programs),
      far_("light from afar at hits", hit_shader(HitStage::far), programs),
      weigh_("weigh", draw_shader(DrawStage::weigh, {.has_planar = true}), programs),
      tables_("luminaires", BufferUse::fixed),
      choice_("choice of luminaires", BufferUse::fixed),
      firsts_("beginnings of hits"),
      places_("places of hits", BufferUse::by_device),
      receivers_("hits as points", BufferUse::by_device),
      channel_weights_("weights of channels", BufferUse::by_device),
      weights_("weights of groups", BufferUse::by_device),
      cumulated_("summed weights of groups", BufferUse::by_device),
      spacings_("spacings of draws", BufferUse::by_device) {}

void HitPass::send_luminaires(const calc::NearField& field) {
  if (tables_of_ == field.tracer.identity()) return;
  tables_of_ = 0;  // should sending fail
  tables_.assign(lamp_tables(field.tracer).entries);
  choice_.assign(choice_table(field.luminaires));
  tables_of_ = field.tracer.identity();
}

// Of a block of rays each.
void HitPass::over_blocks(DeviceState& device, const GlProgram& program, const ShortRayPass& rays,
                          const ShortRayJob& job, const HitBuffers& buffers) const {
  const std::size_t blocks = blocks_of(job);
  rays.bind(device, job, buffers.rays);
  program.use();
  program.set("request_count", word(job.part.points()));
  program.set("ray_count", word(job.part.rays()));
  program.set("blocks", word(blocks));
  dispatch(blocks);
  wait_for_writes();
}

bool HitPass::start(DeviceState& device, ShortRayPass& rays, const calc::NearField& field,
                    const ShortRayJob& job, HitBuffers& buffers) {
  buffers.used = 0;
  const calc::GeometryBound::Terms terms = field.bound.terms();
  static_assert(kFieldSmallest == 0 && kFieldPerLumen == 1 && kFieldAmbient == 2 &&
                kFieldNeeded == 3 && kFieldLeast == 4);
  buffers.field.assign(std::vector<double>{terms.smallest_per_m2, terms.vertices_per_lumen,
                                           terms.ambient_per_m2, terms.needed_lx, terms.least_lx});
  buffers.field.bind(ShortRayPass::kField);
  if (!rays.trace(device, job, buffers.rays)) return false;
  wait_for_writes();
  const std::size_t bytes = blocks_of(job) * sizeof(std::uint32_t);
  buffers.counts.assign(bytes, kNotDone);
  buffers.counts.bind(kCounts);
  over_blocks(device, counts_shader_, rays, job, buffers);
  buffers.counts_back.start({{buffers.counts, 0, bytes}}, kNotDone);
  check_gl(kDoing);
  return true;
}

// Finds on the CPU where each block's hits begin, and lists them. Returns how many they are.
std::size_t HitPass::list_hits(DeviceState& device, const ShortRayPass& rays,
                               const ShortRayJob& job, HitBuffers& buffers) {
  buffers.counts_back.wait(kDoing);
  std::vector<std::uint32_t> counts(blocks_of(job), kNotDone);
  buffers.counts_back.copy(0, std::as_writable_bytes(std::span(counts)));
  std::uint32_t hits = 0;
  for (std::uint32_t& count : counts) {
    if (count == kNotDone) throw_not_done();
    const std::uint32_t first = hits;
    hits += count;
    count = first;
  }
  if (hits == 0) return 0;
  firsts_.assign(counts);
  firsts_.bind(kCounts);
  buffers.list.reserve(hits * 2 * sizeof(std::uint32_t));
  buffers.list.bind(kList);
  over_blocks(device, list_shader_, rays, job, buffers);
  return hits;
}

std::size_t HitPass::most_hits(const calc::NearField& field) const {
  const std::size_t row = std::max<std::size_t>({1, field.cut.size(), field.channels});
  return std::max<std::size_t>(1, std::min({limits_.hits, kMostGroups, kMostWeights / row}));
}

void HitPass::start(const GlProgram& program, const Piece& piece) const {
  const calc::NearField& field = piece.field;
  const auto offset_m = static_cast<float>(field.tracer.offset_m());
  program.use();
  ShortRayPass::set_keys(program, piece.job);
  program.set("node_count", nodes_);
  program.set("offset_m", offset_m);
  program.set("lift_m", offset_m);
  program.set("most_m", piece.job.most_m);
  program.set("luminaire_count", word(field.tracer.scene().luminaires.size()));
  program.set("channel_count", word(field.channels));
  program.set("has_shadows", field.tracer.has_shadows() ? 1u : 0u);
  program.set("first_hit", word(piece.first));
  program.set("row", word(piece.count));
  program.set("looks", 2u);
  program.set("cell_places", 9u);
  program.set("most_nodes", word(field.cut.size()));
  program.set("most_ranges", word(field.tree.roots().size()));
  program.set("first_receiver", 0u);
  program.set("first_tile", 0u);
  program.set("draws", calc::kFarDraws);
  program.set("two", 2u);
  program.set("smallest_bound_per_m2", static_cast<float>(field.bound.smallest()));
  program.set("bounded_from_per_m2", std::min(field.vertex_bounds.lowest_per_m2(), FLT_MAX));
}

// False: the deadline passed.
bool HitPass::run_stage(Stage& stage, const Piece& piece, std::size_t items) {
  start(stage.program, piece);
  for (std::size_t first = 0; first < items;) {
    if (calc::is_past(piece.field.deadline_s)) return false;
    const std::size_t count = std::min(stage.pacer.items(), items - first);
    stage.pacer.run(count, kDoing, [&] {
      stage.program.set("first_item", word(first));
      stage.program.set("item_count", word(count));
      dispatch(count);
    });
    first += count;
  }
  wait_for_writes();
  return true;
}

// Of the groups that the hits' light from afar is drawn from.
void HitPass::weigh(DeviceState& device, const PackedPool* packed, const Piece& piece) {
  const calc::Cut& cut = piece.field.cut;
  const bool has_many_channels = cut.channels().size() > 1;
  std::unique_ptr<GlProgram>& share = share_[has_many_channels ? 1 : 0];
  if (!share) {
    share = std::make_unique<GlProgram>(
        "share",
        draw_shader(DrawStage::share,
                    {.has_many_channels = has_many_channels, .has_given_shifts = true}),
        programs_);
  }
  const DevicePool& pool = device.pools.find_or_send(piece.field.tree, packed);
  pool.bind_vertices();
  pool.bind_tree();
  weights_.reserve(piece.count * cut.size() * sizeof(float));
  cumulated_.reserve(piece.count * cut.size() * sizeof(double));
  spacings_.reserve(piece.count * sizeof(glm::dvec2));
  receivers_.bind(kReceiversToDraw);
  piece.buffers.tiles.bind(kTiles);
  weights_.bind(kWeights);
  cumulated_.bind(kCumulated);
  spacings_.bind(kSpacings);
  start(weigh_, piece);
  glDispatchCompute(word((cut.size() + kGroupSize - 1) / kGroupSize), word(piece.count), 1);
  wait_for_writes();
  start(*share, piece);
  glDispatchCompute(word(piece.count), 1, 1);
  wait_for_writes();
}

// False: the deadline passed.
bool HitPass::find(DeviceState& device, const PackedPool* packed, const Piece& piece,
                   HitBuffers::Piece& found) {
  const calc::NearField& field = piece.field;
  const DeviceScene& scene = device.scenes.of(field.tracer);
  nodes_ = scene.nodes;
  found.hits = piece.count;
  found.lights.assign(piece.count * sizeof(calc::HitLight), calc::HitLight::kNotDone);
  places_.reserve(piece.count * kPlaceBytes);
  receivers_.reserve(piece.count * kReceiverBytes);
  channel_weights_.reserve(piece.count * std::max<std::size_t>(1, field.channels) * sizeof(double));
  const auto bind = [&] {
    scene.bind();
    scene.bind_surfaces();
    piece.rays.bind(device, piece.job, piece.buffers.rays);
    tables_.bind(kTables);
    piece.buffers.list.bind(kList);
    piece.buffers.field.bind(ShortRayPass::kField);
    found.lights.bind(kLights);
    places_.bind(kPlaces);
  };
  bind();
  receivers_.bind(kReceivers);
  if (!run_stage(bounds_, piece, piece.count)) return false;
  choice_.bind(kChoice);
  channel_weights_.bind(kChannelWeights);
  if (!run_stage(direct_, piece, piece.count)) return false;
  if (!run_stage(further_, piece, piece.count)) return false;
  if (field.cut.size() > 0) {
    weigh(device, packed, piece);
    if (!run_stage(far_, piece, piece.count * kPlacesPerHit)) return false;
  }
  found.back.start({{found.lights, 0, piece.count * sizeof(calc::HitLight)}},
                   calc::HitLight::kNotDone);
  check_gl(kDoing);
  return true;
}

bool HitPass::find(DeviceState& device, const ShortRayPass& rays, const calc::NearField& field,
                   const PackedPool* packed, const ShortRayJob& job, HitBuffers& buffers) {
  const std::size_t hits = list_hits(device, rays, job, buffers);
  if (hits == 0) return true;
  send_luminaires(field);
  buffers.tiles.assign(tiles_of(field));
  const std::size_t most = most_hits(field);
  for (std::size_t first = 0; first < hits; first += most) {
    const std::size_t count = std::min(most, hits - first);
    if (buffers.used == buffers.pieces.size()) buffers.pieces.emplace_back();
    HitBuffers::Piece& found = buffers.pieces[buffers.used++];
    if (!find(device, packed, {field, job, rays, buffers, first, count}, found)) return false;
  }
  return true;
}

std::vector<LentBytes> HitPass::take(DeviceState& device, HitBuffers& buffers) {
  for (std::size_t k = 0; k < buffers.used; ++k) buffers.pieces[k].back.wait(kDoing);
  device.check(kDoing);
  std::vector<LentBytes> lights;
  for (std::size_t k = 0; k < buffers.used; ++k) {
    HitBuffers::Piece& piece = buffers.pieces[k];
    lights.push_back(piece.back.lend(0, piece.hits * sizeof(calc::HitLight)));
  }
  return lights;
}

}  // namespace gpu
