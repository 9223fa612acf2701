// Weights of groups from the device, bit by bit: a float that differs in its last place would move
// a draw to another vertex, too rarely for a test of sums to see.
#include "calc/radiosity/sampling/random.h"
#include "gpu/gather/draw_piece.h"
#include "gpu/gather/shader_text.h"
#include "gpu/gather/tile_words.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/scene/device_points.h"
#include "gpu/scene/device_pool.h"
#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace gpu_weights_test {
namespace {

using namespace test_support;

enum class Normals { any, of_a_box, nearly_alike };

// crowding: above 1 most lie near one corner, where parts are denser than the whole.
calc::LightVertices some_vertices(std::size_t count = 20'000, Normals normals = Normals::any,
                                  std::uint32_t channels = 1, double crowding = 1.0) {
  calc::LightVertices vertices;
  const calc::RandomKey key(8);
  for (std::uint64_t j = 0; j < count; ++j) {
    const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform(); };
    glm::dvec3 normal(u(0) - 0.5, u(1) - 0.5, u(2) - 0.5);
    glm::dvec3 at(9 * std::pow(u(3), crowding), 7 * std::pow(u(4), crowding),
                  3 * std::pow(u(5), crowding));
    if (normals == Normals::of_a_box) {
      const auto axis = static_cast<glm::length_t>(3 * u(0));
      normal = glm::dvec3(0.0);
      normal[axis] = u(1) < 0.5 ? 1.0 : -1.0;
      at[axis] = u(1) < 0.5 ? 0.0 : glm::dvec3(9, 7, 3)[axis];
    }
    if (normals == Normals::nearly_alike) normal = 0.3 * normal + glm::dvec3(0, 0.2, 1);
    vertices.push_back({glm::vec3(at), static_cast<float>(0.01 + u(6)),
                        glm::vec3(glm::normalize(normal)),
                        static_cast<std::uint32_t>(j % channels)});
  }
  return vertices;
}

// What the device makes of a piece's tiles: gpu/shaders/gather/tile_words.glsl.
std::vector<std::uint32_t> tiles_by_device(const gpu::DrawPiece& piece,
                                           const gpu::DevicePool& pool) {
  std::vector<std::uint32_t> words(piece.tile_count * piece.words_per_tile());
  const gpu::GlProgram program("choose", gpu::choose_shader());
  gpu::GlBuffer views("views"), tiles("tiles");
  views.assign(gpu::DrawPoints::pack(piece.batch->tracer, piece.batch->tiles, piece.block).views);
  tiles.assign(words.size() * sizeof(std::uint32_t), gpu::kNotDone);
  pool.bind_nodes();
  views.bind(4);
  tiles.bind(5);
  program.use();
  const calc::CutRequest& cut = piece.batch->cut;
  program.set("most_nodes", piece.most_nodes);
  program.set("most_ranges", piece.most_ranges);
  program.set("first_tile", static_cast<std::uint32_t>(piece.first_tile));
  program.set("smallest_bound_per_m2", cut.smallest_bound_per_m2);
  program.set("wanted_nodes", static_cast<std::uint32_t>(cut.nodes));
  program.set("leave_out_hidden", cut.leave_out_hidden ? 1u : 0u);
  program.set("two", 2u);
  glDispatchCompute(static_cast<unsigned>(piece.tile_count), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  tiles.read(0, std::as_writable_bytes(std::span(words)));
  return words;
}

std::vector<float> weights_by_device(const gpu::DrawPiece& piece, const calc::VertexTree& tree) {
  std::vector<float> weights(piece.weights());
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::GlProgram program("weigh", gpu::draw_shader(gpu::DrawStage::weigh, piece.shape));
    gpu::DevicePools pools;
    const gpu::DevicePool& pool = pools.send(tree.identity(), gpu::pack_pool(tree));
    gpu::GlBuffer receivers("points"), tiles("tiles"), result("weights");
    tiles.assign(tiles_by_device(piece, pool));
    receivers.assign(
        gpu::DrawPoints::pack(piece.batch->tracer, piece.batch->tiles, piece.block).receivers);
    result.reserve(weights.size() * sizeof(float));
    pool.bind_vertices();
    pool.bind_tree();
    receivers.bind(4);
    tiles.bind(5);
    result.bind(8);
    program.use();
    program.set("most_nodes", piece.most_nodes);
    program.set("most_ranges", piece.most_ranges);
    program.set("first_receiver", static_cast<std::uint32_t>(piece.first_receiver));
    program.set("first_tile", static_cast<std::uint32_t>(piece.first_tile));
    program.set("smallest_bound_per_m2", piece.batch->cut.smallest_bound_per_m2);
    glDispatchCompute(piece.most_nodes / 64 + 1, static_cast<unsigned>(piece.receivers), 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    result.read(0, std::as_writable_bytes(std::span(weights)));
  });
  return weights;
}

// Tiles, and room for their sums.
struct Wanted {
  calc::ReceiverTiles tiles;
  std::vector<double> lx;
  std::vector<float> largest_lx;
  std::vector<calc::GatherSums> sums;

  explicit Wanted(const std::vector<std::vector<calc::Receiver>>& receivers,
                  std::size_t channels = 1) {
    std::vector<calc::ReceiverGroup> groups;
    std::uint32_t point = 0;
    for (const auto& tile : receivers) {
      auto& group = groups.emplace_back();
      group.receiver = tile;
      for (std::size_t k = 0; k < tile.size(); ++k) group.point.push_back(point++);
    }
    lx.resize(point * channels);
    largest_lx.resize(point);
    tiles = calc::ReceiverTiles(std::move(groups));
    for (std::size_t t = 0; t < receivers.size(); ++t) {
      const std::size_t before = tiles.receivers_before(t);
      sums.push_back({&lx[before * channels], receivers[t].size(), &largest_lx[before]});
    }
  }
  Wanted(const Wanted&) = delete;
  Wanted& operator=(const Wanted&) = delete;
};

TEST(GlWeights, AreTheCpusInBits) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {9, 7, 3}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const calc::VertexTree tree(some_vertices(), 1);
  const calc::VertexBounds bounds(0.3);
  const calc::RandomKey key(9);
  std::vector<calc::Receiver> receivers;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const auto u = [&](std::uint64_t k) { return key.with(i).with(k).uniform(); };
    receivers.push_back({{9 * u(0), 7 * u(1), 3 * u(2)},
                         glm::normalize(glm::dvec3(u(3) - 0.5, u(4) - 0.5, u(5))),
                         static_cast<calc::ReceiverKernel>(i % 5)});
  }
  const Wanted wanted({receivers});
  const calc::CutRequest request{1024, 0.4f, true};
  const calc::DrawBatch batch{tracer, tree, bounds,       request, 64,         true,
                              0.0,    key,  wanted.tiles, 0,       wanted.sums};
  gpu::DrawPacker packer(batch, {});
  gpu::DrawPiece piece;
  ASSERT_TRUE(packer.next(piece));
  ASSERT_EQ(piece.receivers, receivers.size());
  const std::vector<float> device = weights_by_device(piece, tree);

  calc::Cut cut;
  cut.build(tree, calc::tile_of(receivers, scene.extent_m), request);
  ASSERT_EQ(cut.size(), piece.most_nodes);
  std::vector<float> weights;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    cut.weigh(receivers[i], weights);
    for (std::size_t c = 0; c < weights.size(); ++c) {
      if (weights[c] != device[i * piece.most_nodes + c]) ++differing;
    }
  }
  EXPECT_EQ(differing, 0u) << "of " << device.size();
}

// The nodes of a tile as the CPU chooses them, in the same words.
std::vector<std::uint32_t> tile_by_cpu(const gpu::DrawPiece& piece, std::size_t tile) {
  const calc::VertexTree& tree = piece.batch->tree;
  calc::Cut cut;
  std::vector<std::uint32_t> nodes;
  std::vector<calc::Cut::ChannelRange> ranges;
  cut.select(tree,
             calc::tile_of(piece.batch->group(tile).receiver, piece.batch->tracer.scene().extent_m),
             piece.batch->cut, nodes, ranges);
  std::vector<std::uint32_t> words{static_cast<std::uint32_t>(nodes.size()),
                                   static_cast<std::uint32_t>(ranges.size()), 0u, gpu::kTileChosen};
  std::size_t k = 0;
  for (std::uint32_t root = 0; root < tree.roots().size(); ++root) {
    const bool is_lit = k < ranges.size() && tree.nodes()[nodes[ranges[k].begin]].channel ==
                                                 tree.nodes()[tree.roots()[root]].channel;
    // An empty range lies where its nodes would.
    const std::uint32_t end = k > 0 ? ranges[k - 1].end : 0u;
    words.insert(words.end(), {is_lit ? ranges[k].begin : end, is_lit ? ranges[k].end : end});
    if (!is_lit) continue;
    words[2] = root;
    ++k;
  }
  words.insert(words.end(), nodes.begin(), nodes.end());
  return words;
}

struct Pool {
  std::size_t vertices;
  Normals normals;
  std::uint32_t channels;
  double crowding = 1.0;

  // Names of tests are made of it.
  friend void PrintTo(const Pool& pool, std::ostream* to) {
    *to << pool.vertices << " vertices of kind " << static_cast<int>(pool.normals) << ", "
        << pool.channels << " channels, crowding " << pool.crowding;
  }
};

class GlCuts : public ::testing::TestWithParam<Pool> {};

// Node by node, for tiles that are near and far, flat and not, above and under what lights them.
TEST_P(GlCuts, AreTheCpusInBits) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {9, 7, 3}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const auto [count, normals, channels, crowding] = GetParam();
  const calc::VertexTree tree(some_vertices(count, normals, channels, crowding), channels);
  const calc::VertexBounds bounds(0.3);
  const calc::RandomKey key(19);
  std::vector<std::vector<calc::Receiver>> receivers;
  for (std::uint64_t t = 0; t < 60; ++t) {
    const auto u = [&](std::uint64_t k) { return key.with(t).with(k).uniform(); };
    auto& tile = receivers.emplace_back();
    // Every third looks away from all that lights it, from outside.
    const glm::dvec3 at(9 * std::pow(u(0), crowding), 7 * std::pow(u(1), crowding),
                        t % 3 == 0 ? 3.5 : 3 * std::pow(u(2), crowding));
    for (std::uint64_t i = 0; i < 1 + t % 9; ++i) {
      const double apart = t % 2 == 0 ? 0.1 : 1.5;
      tile.push_back({at + glm::dvec3(apart * u(10 + 2 * i), apart * u(11 + 2 * i), 0.0),
                      {0, 0, 1},
                      t % 5 == 1 ? calc::ReceiverKernel::scalar : calc::ReceiverKernel::planar});
      if (t % 3 == 1) tile.back().axis = glm::normalize(glm::dvec3(u(4) - 0.5, u(5) - 0.5, 0.3));
    }
  }
  const Wanted wanted(receivers, channels);
  std::size_t hidden_tiles = 0, left_out = 0;
  for (const calc::CutRequest request : {calc::CutRequest{1, 0.4f, true},
                                         {128, 0.4f, true},
                                         {333, 0.001f, true},
                                         {1024, 2.0f, true},
                                         {1024, 0.4f, false}}) {
    const calc::DrawBatch batch{tracer, tree, bounds,       request, 64,         true,
                                0.0,    key,  wanted.tiles, 0,       wanted.sums};
    gpu::DrawPacker packer(batch, {});
    gpu::DrawPiece piece;
    ASSERT_TRUE(packer.next(piece));
    ASSERT_EQ(piece.tile_count, receivers.size());
    ASSERT_TRUE(piece.chooses_nodes());
    std::vector<std::uint32_t> device;
    gl_device()->run([&](gpu::DeviceState&) {
      gpu::DevicePools pools;
      device = tiles_by_device(piece, pools.send(tree.identity(), gpu::pack_pool(tree)));
    });
    for (std::size_t t = 0; t < receivers.size(); ++t) {
      const std::vector<std::uint32_t> cpu = tile_by_cpu(piece, t);
      const auto begin = device.begin() + static_cast<std::ptrdiff_t>(t * piece.words_per_tile());
      const std::vector<std::uint32_t> own(begin, begin + static_cast<std::ptrdiff_t>(cpu.size()));
      EXPECT_EQ(own, cpu) << "tile " << t << " of " << request.nodes;
      hidden_tiles += cpu[0] == 0 ? 1u : 0u;
      left_out += request.nodes == 1024 && cpu[0] < piece.most_nodes ? 1u : 0u;
    }
  }
  // Where there is something to leave out, it was left out.
  if (normals == Normals::of_a_box) {
    EXPECT_GT(hidden_tiles + left_out, 0u);
  }
}

// Pairs of vertices, one of each behind the tile, and room for one node more than there are pairs:
// each round opens one node and gains none. For so many llvmpipe has no turns of loops.
TEST(GlCutsOfManyRounds, AreTheCpusOrNone) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {9, 7, 3}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  constexpr std::size_t kPairs = 1023;
  const std::vector<calc::Receiver> tile{{{4.5, 3.5, 1.5}, {0, 0, 1}}};
  calc::LightVertices vertices;
  for (std::uint64_t j = 0; j < kPairs; ++j) {
    const calc::RandomKey key = calc::RandomKey(8).with(j);
    const glm::dvec3 at(9 * key.with(0).uniform(), 7 * key.with(1).uniform(), 1.5);
    const glm::vec3 normal(glm::normalize(tile[0].position_m - at));
    for (const double side_m : {-0.001, 0.001}) {
      vertices.push_back({glm::vec3(at + glm::dvec3(0, 0, side_m)), 1.0f, normal, 0});
    }
  }
  const calc::VertexTree tree(std::move(vertices), 1);
  const calc::VertexBounds bounds(0.3);
  const Wanted wanted({tile, tile, tile, tile});
  const std::shared_ptr<gpu::DeviceThread> thread = gl_device();
  for (const std::size_t nodes : {kPairs - 100, kPairs + 1}) {
    const calc::DrawBatch batch{tracer,       tree, bounds,     {nodes, 0.4f, true},
                                64,           true, 0.0,        calc::RandomKey(1),
                                wanted.tiles, 0,    wanted.sums};
    gpu::DrawPacker packer(batch, {});
    gpu::DrawPiece piece;
    ASSERT_TRUE(packer.next(piece));
    const std::vector<std::uint32_t> cpu = tile_by_cpu(piece, 0);
    EXPECT_EQ(cpu[0], std::min(nodes, kPairs));
    std::vector<std::uint32_t> device;
    thread->run([&](gpu::DeviceState&) {
      gpu::DevicePools pools;
      device = tiles_by_device(piece, pools.send(tree.identity(), gpu::pack_pool(tree)));
    });
    for (std::size_t t = 0; t < wanted.sums.size(); ++t) {
      const auto begin = device.begin() + static_cast<std::ptrdiff_t>(t * piece.words_per_tile());
      if (*(begin + 3) != gpu::kTileChosen) {
        EXPECT_TRUE(thread->device().is_software && nodes > kPairs) << nodes;
      } else {
        EXPECT_TRUE(std::equal(cpu.begin(), cpu.end(), begin)) << nodes;
      }
    }
  }
}

// Where the nodes of a tile were never chosen there is nothing to draw: that is not darkness.
TEST(GlCutsMissing, AreNotDarkness) {
  LUXGATE_NEEDS_OPENGL();
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::GlProgram add("add", gpu::draw_shader(gpu::DrawStage::add, {}));
    constexpr std::uint32_t kNodes = 64, kDraws = 16;
    std::array<std::uint32_t, 6> answer{};
    gpu::GlBuffer receivers("points"), tiles("tiles"), cumulated("sums"), spacings("spacings"),
        results("results"), sums("answers"), weights("weights");
    receivers.assign(std::vector<gpu::DrawReceiver>(1));
    weights.assign(kNodes * sizeof(float), 0);
    cumulated.assign(kNodes * sizeof(double), 0);
    spacings.assign(sizeof(glm::dvec2), 0);
    results.assign((kDraws + 1) * sizeof(std::uint32_t), gpu::kNoRay);
    receivers.bind(4);
    weights.bind(8);
    cumulated.bind(9);
    spacings.bind(10);
    results.bind(12);
    for (const std::uint32_t state : {gpu::kNotDone, 0u, gpu::kTileChosen}) {
      tiles.assign((gpu::kTileHead + 2 + kNodes) * sizeof(std::uint32_t), state);
      sums.assign(sizeof answer, gpu::kNotDone);
      tiles.bind(5);
      sums.bind(13);
      add.use();
      add.set("most_nodes", kNodes);
      add.set("most_ranges", 1u);
      add.set("draws", kDraws);
      glDispatchCompute(1, 1, 1);
      glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
      sums.read(0, std::as_writable_bytes(std::span(answer)));
      EXPECT_EQ(answer[0], state == gpu::kTileChosen ? 0u : gpu::kNotDone);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(
    Pools, GlCuts,
    ::testing::Values(Pool{20'000, Normals::any, 1}, Pool{20'000, Normals::of_a_box, 3},
                      Pool{5'000, Normals::nearly_alike, 2},
                      Pool{20'000, Normals::of_a_box, 2, 6.0}, Pool{20'000, Normals::any, 1, 6.0},
                      Pool{3, Normals::of_a_box, 1}, Pool{700, Normals::of_a_box, 40}));

}  // namespace
}  // namespace gpu_weights_test
