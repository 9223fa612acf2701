// Weights of groups from the device, bit by bit: a float that differs in its last place would move
// a draw to another vertex, too rarely for a test of sums to see.
#include "calc/radiosity/random.h"
#include "gpu/device_pool.h"
#include "gpu/draw_piece.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_program.h"
#include "gpu/shader_text.h"
#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

namespace {

using namespace test_support;

calc::LightVertices some_vertices() {
  calc::LightVertices vertices;
  const calc::RandomKey key(8);
  for (std::uint64_t j = 0; j < 20'000; ++j) {
    const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform(); };
    const glm::dvec3 normal = glm::normalize(glm::dvec3(u(0) - 0.5, u(1) - 0.5, u(2) - 0.5));
    vertices.push_back({glm::vec3(9 * u(3), 7 * u(4), 3 * u(5)), static_cast<float>(0.01 + u(6)),
                        glm::vec3(normal), 0});
  }
  return vertices;
}

std::vector<float> weights_by_device(const gpu::DrawPiece& piece, const calc::VertexTree& tree) {
  std::vector<float> weights(piece.receivers.size() * piece.most_nodes);
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::GlProgram program("weigh", gpu::draw_shader(gpu::DrawStage::weigh, piece.shape));
    gpu::DevicePools pools;
    const gpu::DevicePool& pool = pools.send(tree.identity(), gpu::pack_pool(tree));
    pool.bind_vertices();
    pool.bind_tree();
    gpu::GlBuffer receivers("points"), tiles("tiles"), result("weights");
    receivers.reserve(piece.receivers.size() * sizeof(gpu::DrawReceiver));
    receivers.write(0, std::as_bytes(std::span(piece.receivers)));
    tiles.reserve(piece.tiles.size() * sizeof(std::uint32_t));
    tiles.write(0, std::as_bytes(std::span(piece.tiles)));
    result.reserve(weights.size() * sizeof(float));
    receivers.bind(4);
    tiles.bind(5);
    result.bind(8);
    program.use();
    program.set("most_nodes", piece.most_nodes);
    program.set("smallest_bound_per_m2", piece.batch->cut.smallest_bound_per_m2);
    glDispatchCompute(piece.most_nodes / 64 + 1, static_cast<unsigned>(piece.receivers.size()), 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    result.read(0, std::as_writable_bytes(std::span(weights)));
  });
  return weights;
}

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
  const std::vector<double> shifts(receivers.size(), 0.5);
  std::vector<double> lx(receivers.size());
  std::vector<float> largest_lx(receivers.size());
  const calc::DrawTile tile{receivers, shifts, {lx.data(), lx.size(), largest_lx.data()}};
  const calc::CutRequest request{1024, 0.4f, true};
  const calc::DrawBatch batch{tracer, tree, bounds, request, 64, true, 0.0, {&tile, 1}};
  gpu::DrawPacker packer(batch, {});
  gpu::DrawPiece piece;
  ASSERT_TRUE(packer.next(piece));
  ASSERT_EQ(piece.receivers.size(), receivers.size());
  const std::vector<float> device = weights_by_device(piece, tree);

  calc::Cut cut;
  cut.build(tree, calc::tile_of(receivers, scene.extent_m), request.nodes,
            request.smallest_bound_per_m2, request.leave_out_hidden);
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

}  // namespace
