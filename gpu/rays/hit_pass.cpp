#include "gpu/rays/hit_pass.h"

#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/gather/tile_words.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/lamp_tables.h"

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
  kSizes = 4,
  kEnds = 4,
  kCounts = 5,
  kTiles = 5,
  kLeft = 5,
  kPortionsToAdd = 5,
  kLeftCount = 6,
  kList = 7,
  kChains = 7,
  kWeights = 8,
  kCumulated,
  kLinks = kCumulated,
  kSpacings,
  kChoice,
  kLights,
  kPlaces,
  kReceivers,
  kChannelWeights = kReceivers,
  kPortions = kReceivers,
  kNear = kReceivers,
  kAnswers = kReceivers
};

constexpr const char* kDoing = "finding light at hits of short rays";
constexpr std::size_t kMostGroups = 65535;  // in one direction, on any device
// Of a piece: doubles. The cut of a field has 128 nodes, or as many as there are channels.
constexpr std::size_t kMostWeights = HitLimits{}.hits * 128;
// Each stage of a later step is one dispatch: a piece has no more hits than so many dispatches of
// its slowest stage.
constexpr std::size_t kMostDispatches = 4;
// llvmpipe leaves all loops of an invocation after 65535 turns together: of a point that may have
// more hits with their portions.
constexpr std::size_t kMostHitsInSoftware = 65535 / (1 + kMostPortions) / 2;
// No sum of a place's weights: hit_far.glsl takes it for "not done".
constexpr std::uint32_t kNoSpacing = 0xbfbf'bfbf;
const DispatchSize kHitsPerDispatch{std::size_t{1} << 8, std::size_t{1} << 20,
                                    std::size_t{1} << 14};
constexpr std::size_t kPlaceBytes = 64, kReceiverBytes = sizeof(DrawReceiver);
constexpr std::size_t kLightBytes = sizeof(calc::HitLight), kWordBytes = sizeof(std::uint32_t);
constexpr std::size_t kSizeBytes = 3 * kWordBytes;     // of a dispatch
constexpr std::size_t kPortionBytes = 3 * kWordBytes;  // channel, light
// Of hits that are left so many come back with their number, the others behind them.
constexpr std::size_t kHitsPerExpected = 8;

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

// As shaders/hits/hit_direct.glsl reads it. Never empty: a shader must have something to bind.
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
      sizes_shader_("sizes of later steps", hit_shader(HitStage::sizes), programs),
      near_shader_("bounds of near light vertices", hit_shader(HitStage::near), programs),
      ends_shader_("ends of chains", hit_shader(HitStage::ends), programs),
      sums_shader_("sums of short rays", hit_shader(HitStage::sums), programs),
      bounds_("bounds at hits", hit_shader(HitStage::bounds), programs),
      later_bounds_("bounds at later hits", hit_shader(HitStage::later_bounds), programs),
      direct_("direct light at hits", hit_shader(HitStage::direct), programs),
      further_("further short rays", hit_shader(HitStage::further), programs),
      far_("light from afar at hits", hit_shader(HitStage::far), programs),
      weigh_("weigh", draw_shader(DrawStage::weigh, {.has_planar = true}), programs),
      tables_("luminaires", BufferUse::fixed),
      choice_("choice of luminaires", BufferUse::fixed),
      firsts_("beginnings of hits"),
      lights_("light at hits of short rays", BufferUse::by_device),
      links_("links of chains", BufferUse::by_device),
      chains_("chains that go on", BufferUse::by_device),
      sizes_("sizes of later steps", BufferUse::by_device),
      near_("near light vertices", BufferUse::by_device),
      ends_("ends of chains", BufferUse::by_device),
      portions_("light of chains by channels", BufferUse::by_device),
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
  buffers.hits = 0;
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
  buffers.list.assign(hits * 2 * sizeof(std::uint32_t), kNotDone);
  buffers.list.bind(kList);
  over_blocks(device, list_shader_, rays, job, buffers);
  return hits;
}

std::size_t HitPass::most_hits(const DeviceState& device, const calc::NearField& field,
                               const ShortRayJob& job) const {
  const std::size_t row = std::max<std::size_t>({1, field.cut.size(), field.channels});
  std::size_t most = std::min({limits_.hits, kMostGroups, kMostWeights / row});
  for (const Stage* stage : {&bounds_, &direct_, &further_}) {
    most = std::min(most, kMostDispatches * stage->pacer.items());
  }
  most = std::min(most, kMostDispatches * far_.pacer.items() / kPlacesPerHit);
  const bool is_software = device.context.device().is_software;
  if (is_software && job.part.most_rays() > kMostHitsInSoftware) {
    most = std::min(most, kMostHitsInSoftware);
  }
  return std::max<std::size_t>(1, most);
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
  program.set("has_far_light", field.cut.size() > 0 ? 1u : 0u);
  program.set("depth", piece.depth);
  program.set("last_depth", kChainSteps - 1);
  program.set("first_light", word(piece.depth * piece.count));
  program.set("next_light", word((piece.depth + 1) * piece.count));
  program.set("first_hit", word(piece.first));
  program.set("hit_count", word(piece.count));
  program.set("most_places", word(piece.count));
  program.set("items_per_place", kPlacesPerHit);
  program.set("request_count", word(piece.job.part.points()));
  program.set("is_first_piece", piece.first == 0 ? 1u : 0u);
  program.set("leaves_all", limits_.leaves_all ? 1u : 0u);
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

// Of a later step the device knows alone how many there are: it takes the size that it wrote.
// False: the deadline passed.
bool HitPass::run_stage(Stage& stage, const Piece& piece, std::size_t items, std::uint32_t size) {
  start(stage.program, piece);
  if (piece.depth > 0) {
    if (calc::is_past(piece.field.deadline_s)) return false;
    stage.program.set("first_item", 0u);
    stage.program.set("item_count", word(items));
    glDispatchComputeIndirect(static_cast<GLintptr>(size * kSizeBytes));
    wait_for_writes();
    return true;
  }
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

// Of what draws share: `groups` for each place, or as many as the device wrote.
void HitPass::run_rows(const GlProgram& program, const Piece& piece, std::size_t groups,
                       std::uint32_t size) const {
  start(program, piece);
  if (piece.depth > 0) {
    glDispatchComputeIndirect(static_cast<GLintptr>(size * kSizeBytes));
  } else if (size == kDispatchNodes) {
    glDispatchCompute(word(groups), word(piece.count), 1);
  } else {
    glDispatchCompute(word(piece.count), 1, 1);
  }
  wait_for_writes();
}

// The places' light from afar. False: the deadline passed.
bool HitPass::draw(DeviceState& device, const Piece& piece) {
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
  const DevicePool& pool = device.pools.find_or_send(piece.field.tree, piece.packed);
  pool.bind_vertices();
  pool.bind_tree();
  weights_.reserve(piece.count * cut.size() * sizeof(float));
  cumulated_.reserve(piece.count * cut.size() * sizeof(double));
  spacings_.assign(piece.count * sizeof(glm::dvec2), kNoSpacing);
  receivers_.bind(kReceiversToDraw);
  piece.buffers.tiles.bind(kTiles);
  weights_.bind(kWeights);
  cumulated_.bind(kCumulated);
  spacings_.bind(kSpacings);
  start_near(piece);
  run_rows(weigh_, piece, (cut.size() + kGroupSize - 1) / kGroupSize, kDispatchNodes);
  run_rows(*share, piece, 1, kDispatchRows);
  near_.bind(kNear);
  return run_stage(far_, piece, piece.count * kPlacesPerHit, kDispatchDraws) &&
         bound_near(device, piece);
}

// An empty list of draws whose vertex is near, as large as it can get; one group is always there.
void HitPass::start_near(const Piece& piece) {
  near_.reserve((kNearHead + piece.count * kPlacesPerHit * kNearSize) * kWordBytes);
  near_.fill(kNearHead * kWordBytes, 0);
  near_.fill(kSizeBytes, 1);
}

// False: the deadline passed.
bool HitPass::bound_near(DeviceState& device, const Piece& piece) const {
  if (calc::is_past(piece.field.deadline_s)) return false;
  bind(device, piece);
  start(near_shader_, piece);
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, near_.name());
  glDispatchComputeIndirect(0);
  wait_for_writes();
  return true;
}

// Rows of all steps, each "not done".
void HitPass::prepare(const Piece& piece, HitBuffers::Piece& found) {
  constexpr std::uint32_t kHitNotDone = calc::HitLight::kNotDone;
  const std::size_t rows = kChainSteps * piece.count;
  lights_.assign(rows * kLightBytes, kHitNotDone);
  links_.assign(rows * kWordBytes, kHitNotDone);
  chains_.reserve((kChainHead + piece.count * kChainSize) * kWordBytes);
  chains_.fill(kChainHead * kWordBytes, 0);
  sizes_.assign(kDispatches * kSizeBytes, 0);
  ends_.assign(piece.count * kEndSize * kWordBytes, kHitNotDone);
  portions_.reserve(piece.count * kMostPortions * kPortionBytes);
  places_.reserve(piece.count * kPlaceBytes);
  receivers_.reserve(piece.count * kReceiverBytes);
  channel_weights_.reserve(piece.count * std::max<std::size_t>(1, piece.field.channels) *
                           sizeof(double));
  found.hits = piece.count;
  found.expected = std::max<std::size_t>(1, piece.count / kHitsPerExpected);
  found.left.assign(piece.count * kLightBytes, kHitNotDone);
  found.left_count.assign(kWordBytes, 0);
}

// All but what draws need: that lies in the way of some of it.
void HitPass::bind(DeviceState& device, const Piece& piece) const {
  const DeviceScene& scene = device.scenes.of(piece.field.tracer);
  scene.bind();
  scene.bind_surfaces();
  piece.rays.bind(device, piece.job, piece.buffers.rays);
  tables_.bind(kTables);
  piece.buffers.field.bind(ShortRayPass::kField);
  lights_.bind(kLights);
  places_.bind(kPlaces);
}

// Of a later step's dispatches.
void HitPass::write_sizes(const Piece& piece) const {
  chains_.bind(kChains);
  sizes_.bind(kSizes);
  start(sizes_shader_, piece);
  glDispatchCompute(1, 1, 1);
  wait_for_writes();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, sizes_.name());
}

// False: the deadline passed.
bool HitPass::do_step(DeviceState& device, const Piece& piece) {
  const bool is_first = piece.depth == 0;
  if (!is_first) write_sizes(piece);
  bind(device, piece);
  if (is_first) {
    piece.buffers.list.bind(kList);
  } else {
    chains_.bind(kChains);
  }
  receivers_.bind(kReceivers);
  if (!run_stage(is_first ? bounds_ : later_bounds_, piece, piece.count, kDispatchPlaces)) {
    return false;
  }
  choice_.bind(kChoice);
  channel_weights_.bind(kChannelWeights);
  if (!run_stage(direct_, piece, piece.count, kDispatchPlaces)) return false;
  chains_.bind(kChains);
  links_.bind(kLinks);
  if (!run_stage(further_, piece, piece.count, kDispatchPlaces)) return false;
  return piece.field.cut.size() == 0 || draw(device, piece);
}

// What each chain brought, to its request.
void HitPass::add_up(const Piece& piece, const HitBuffers::Piece& found) const {
  lights_.bind(kLights);
  links_.bind(kLinks);
  ends_.bind(kEnds);
  portions_.bind(kPortions);
  choice_.bind(kChoice);
  found.left.bind(kLeft);
  found.left_count.bind(kLeftCount);
  start(ends_shader_, piece);
  dispatch(piece.count);
  wait_for_writes();
  piece.buffers.list.bind(kList);
  portions_.bind(kPortionsToAdd);
  piece.buffers.answers.bind(kAnswers);
  start(sums_shader_, piece);
  glDispatchCompute(word((piece.job.part.points() + kGroupSize - 1) / kGroupSize),
                    word(piece.field.channels), 1);
  wait_for_writes();
}

// False: the deadline passed.
bool HitPass::find(DeviceState& device, Piece piece, HitBuffers::Piece& found) {
  nodes_ = device.scenes.of(piece.field.tracer).nodes;
  prepare(piece, found);
  for (piece.depth = 0; piece.depth < kChainSteps; ++piece.depth) {
    if (!do_step(device, piece)) return false;
  }
  add_up(piece, found);
  found.back.start(
      {{found.left_count, 0, kWordBytes}, {found.left, 0, found.expected * kLightBytes}},
      calc::HitLight::kNotDone);
  check_gl(kDoing);
  return true;
}

bool HitPass::find(DeviceState& device, const ShortRayPass& rays, const calc::NearField& field,
                   const PackedPool* packed, const ShortRayJob& job, HitBuffers& buffers) {
  buffers.hits = list_hits(device, rays, job, buffers);
  if (buffers.hits == 0) return true;
  send_luminaires(field);
  buffers.tiles.assign(tiles_of(field));
  const std::size_t bytes = job.part.points() * hit_answer_bytes(field.channels);
  buffers.answers.assign(bytes, kNotDone);
  for (std::size_t first = 0, count = 0; first < buffers.hits; first += count) {
    count = std::min(most_hits(device, field, job), buffers.hits - first);
    if (buffers.used == buffers.pieces.size()) buffers.pieces.emplace_back();
    HitBuffers::Piece& found = buffers.pieces[buffers.used++];
    if (!find(device, {field, packed, job, rays, buffers, first, count}, found)) return false;
  }
  buffers.answers_back.start({{buffers.answers, 0, bytes}}, kNotDone);
  check_gl(kDoing);
  return true;
}

HitAnswers HitPass::take(DeviceState& device, const calc::NearField& field, const ShortRayJob& job,
                         HitBuffers& buffers) {
  HitAnswers answers;
  answers.hits = buffers.hits;
  if (buffers.hits == 0) return answers;
  std::vector<std::size_t> left(buffers.used);
  for (std::size_t k = 0; k < buffers.used; ++k) {
    HitBuffers::Piece& piece = buffers.pieces[k];
    piece.back.wait(kDoing);
    std::uint32_t count = 0;
    piece.back.copy(0, std::as_writable_bytes(std::span(&count, 1)));
    if (count > piece.hits) throw_not_done();
    left[k] = count;
    if (count <= piece.expected) continue;
    piece.rest.start(
        {{piece.left, piece.expected * kLightBytes, (count - piece.expected) * kLightBytes}},
        calc::HitLight::kNotDone);
    piece.rest.wait(kDoing);
  }
  buffers.answers_back.wait(kDoing);
  device.check(kDoing);
  // From here on nothing fails: what is lent comes back only if its reader has it.
  answers.left.reserve(2 * buffers.used);
  for (std::size_t k = 0; k < buffers.used; ++k) {
    HitBuffers::Piece& piece = buffers.pieces[k];
    const std::size_t together = std::min(left[k], piece.expected), more = left[k] - together;
    answers.left.push_back(
        {piece.back.lend(0, kWordBytes + piece.expected * kLightBytes), kWordBytes, together});
    if (more > 0) answers.left.push_back({piece.rest.lend(0, more * kLightBytes), 0, more});
  }
  answers.requests =
      buffers.answers_back.lend(0, job.part.points() * hit_answer_bytes(field.channels));
  return answers;
}

}  // namespace gpu
