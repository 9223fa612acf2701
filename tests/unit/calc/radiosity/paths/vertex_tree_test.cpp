#include "calc/radiosity/paths/vertex_tree.h"

#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/draws.h"
#include "calc/radiosity/sampling/radix_sort.h"
#include "calc/radiosity/sampling/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace vertex_tree_test {
namespace {

using calc::LightVertices;
using calc::RandomKey;

// Vertices on the floor, ceiling and one wall of a 4 x 4 x 3 m room, of two channels.
LightVertices some_vertices(std::size_t count) {
  LightVertices vertices;
  for (std::size_t j = 0; j < count; ++j) {
    const RandomKey key = RandomKey(7).with(j);
    const auto u = [&](std::uint64_t k) { return static_cast<float>(key.with(k).uniform()); };
    const float flux = 0.2f + u(2);
    const std::uint32_t channel = j % 5 == 0 ? 1 : 0;
    if (j % 3 == 0) vertices.push_back({{4 * u(0), 4 * u(1), 0}, flux, {0, 0, 1}, channel});
    if (j % 3 == 1) vertices.push_back({{4 * u(0), 4 * u(1), 3}, flux, {0, 0, -1}, channel});
    if (j % 3 == 2) vertices.push_back({{0, 4 * u(0), 3 * u(1)}, flux, {1, 0, 0}, channel});
  }
  return vertices;
}

TEST(RadixSort, OrdersLongKeysAndKeepsEqualOnes) {
  std::vector<calc::KeyedIndex> items;
  for (std::uint32_t i = 0; i < 5000; ++i) {
    items.push_back({RandomKey(i % 1700).bits() >> 3, i});
  }
  std::vector<calc::KeyedIndex> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& a, const auto& b) { return a.key < b.key; });
  calc::radix_sort(items, 61);
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(items[i].key, expected[i].key);
    EXPECT_EQ(items[i].index, expected[i].index);
  }
}

TEST(VertexTree, NodesHoldTheirVertices) {
  const calc::VertexTree tree(some_vertices(3000), 2);
  ASSERT_EQ(tree.vertices().size(), 3000u);
  ASSERT_EQ(tree.roots().size(), 2u);
  std::size_t leaves = 0;
  for (const calc::VertexNode& node : tree.nodes()) {
    double flux = 0.0;
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      const calc::LightVertex& v = tree.vertices()[i];
      flux += static_cast<double>(v.flux_lm);
      EXPECT_EQ(v.channel, node.channel);
      EXPECT_LE(glm::length(v.position_m - node.centre_m), node.radius_m * 1.00001f + 1e-5f);
      if (node.cos_spread > -1.0f) {
        EXPECT_GE(glm::dot(v.normal, node.axis), node.cos_spread - 1e-4f);
      }
    }
    EXPECT_NEAR(static_cast<double>(node.flux_lm) / flux, 1.0, 1e-4);
    if (node.child == 0) {
      ++leaves;
      continue;
    }
    EXPECT_EQ(tree.nodes()[node.child].first, node.first);
    EXPECT_EQ(tree.nodes()[node.child].last, tree.nodes()[node.child + 1].first);
    EXPECT_EQ(tree.nodes()[node.child + 1].last, node.last);
  }
  EXPECT_GT(leaves, 700u);
}

// A number beyond unsigned int would be undefined: the sanitizers of tests/sanitize tell.
TEST(VertexTree, TakesVerticesAtOnePlace) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{5}}) {
    const calc::LightVertex one{{1, 2, 3}, 0.5f, {0, 0, 1}, 0};
    const calc::VertexTree tree(LightVertices(count, one), 1);
    ASSERT_EQ(tree.roots().size(), 1u);
    EXPECT_EQ(tree.vertices().size(), count);
    EXPECT_EQ(tree.nodes()[tree.roots()[0]].last, count);
  }
}

TEST(VertexTree, FindsTheVertexOfAShareOfFlux) {
  const calc::VertexTree tree(some_vertices(100), 2);
  for (std::uint32_t first : {0u, 13u}) {
    for (const std::uint32_t last : {14u, 47u, 80u}) {
      for (std::uint32_t j = first; j < last; ++j) {
        const double begin = tree.flux_before_lm(first);
        const double whole = tree.flux_before_lm(last) - begin;
        const double middle = 0.5 * (tree.flux_before_lm(j) + tree.flux_before_lm(j + 1));
        EXPECT_EQ(tree.vertex_at(first, last, (middle - begin) / whole), j);
      }
    }
  }
}

calc::Cut cut_for(const calc::VertexTree& tree, const std::vector<calc::Receiver>& tile,
                  bool leave_out_hidden) {
  calc::Cut cut;
  cut.build(tree, calc::tile_of(tile, 7.0), {64, 1.0f, leave_out_hidden});
  return cut;
}

TEST(Cut, HoldsEveryVertexThatCanLightTheTile) {
  const calc::VertexTree tree(some_vertices(3000), 2);
  const std::vector<calc::Receiver> tile{{{1.0, 2.0, 0.8}, {0, 0, 1}},
                                         {{1.4, 2.2, 0.8}, {0, 0, 1}}};
  for (const bool leave_out : {true, false}) {
    const calc::Cut cut = cut_for(tree, tile, leave_out);
    std::vector<int> held(tree.vertices().size(), 0);
    for (std::size_t c = 0; c < cut.size(); ++c) {
      for (std::uint32_t k = 0; k < cut.count(c); ++k) ++held[cut.first(c) + k];
    }
    std::size_t left_out = 0;
    for (std::size_t j = 0; j < held.size(); ++j) {
      EXPECT_LE(held[j], 1);
      const bool is_floor = tree.vertices()[j].position_m.z < 0.8f;
      if (!is_floor) {
        EXPECT_EQ(held[j], 1) << j;
      }
      if (held[j] == 0) ++left_out;
    }
    EXPECT_EQ(left_out > 900, leave_out);  // the floor, a third
    EXPECT_LE(cut.size(), 70u);
    EXPECT_GE(cut.size(), 60u);
  }
}

// Vertices of curved things, whose nodes hold normals of many directions; receivers that look
// everywhere, and planes.
TEST(Cut, LeavesOutNothingThatLightsTheTile) {
  LightVertices vertices;
  for (std::uint64_t j = 0; j < 4000; ++j) {
    const RandomKey key = RandomKey(11).with(j);
    const auto u = [&](std::uint64_t k) { return key.with(k).uniform(); };
    // Parts of three spheres, seen from outside and inside.
    const glm::dvec3 direction =
        glm::normalize(glm::dvec3(u(0) - 0.5, u(1) - 0.5, 0.2 + static_cast<double>(j % 3) * u(2)));
    const glm::dvec3 centre(static_cast<double>(j % 3), 1.0, 0.5);
    const double side = j % 5 == 0 ? -1.0 : 1.0;
    vertices.push_back({glm::vec3(centre + 0.4 * direction), static_cast<float>(0.1 + u(3)),
                        glm::vec3(side * direction), 0});
  }
  const calc::VertexTree tree(std::move(vertices), 1);
  std::size_t left_out = 0;
  for (std::uint64_t t = 0; t < 300; ++t) {
    const RandomKey key = RandomKey(12).with(t);
    const auto u = [&](std::uint64_t k) { return key.with(k).uniform(); };
    std::vector<calc::Receiver> tile;
    for (std::uint64_t i = 0; i < 4; ++i) {
      tile.push_back({{4 * u(0) - 1 + 0.2 * u(10 + i), 3 * u(1) + 0.2 * u(20 + i), 3 * u(2) - 1},
                      {0, 0, 1},
                      t % 2 == 0 ? calc::ReceiverKernel::scalar : calc::ReceiverKernel::planar});
    }
    calc::Cut cut;
    cut.build(tree, calc::tile_of(tile, 5.0), {300, 1.0f, true});
    std::vector<std::uint8_t> is_held(tree.vertices().size(), 0);
    for (std::size_t c = 0; c < cut.size(); ++c) {
      for (std::uint32_t k = 0; k < cut.count(c); ++k) is_held[cut.first(c) + k] = 1;
    }
    for (std::size_t j = 0; j < is_held.size(); ++j) {
      if (is_held[j] != 0) continue;
      ++left_out;
      const calc::LightVertex& v = tree.vertices()[j];
      for (const calc::Receiver& receiver : tile) {
        const glm::dvec3 way = glm::dvec3(v.position_m) - receiver.position_m;
        const bool is_behind =
            receiver.kernel == calc::ReceiverKernel::planar && glm::dot(way, receiver.axis) <= 0.0;
        EXPECT_TRUE(is_behind || glm::dot(glm::dvec3(v.normal), way) >= 0.0) << t << " " << j;
      }
    }
  }
  EXPECT_GT(left_out, 300u * 400u);
}

// Over many shifts every vertex that is not hidden is drawn 1 / weight times in the mean: the sum
// of weights estimates their number.
TEST(Cut, SelectsTheNodesItBuilds) {
  const calc::VertexTree tree(some_vertices(3000), 2);
  const std::vector<calc::Receiver> tile{{{0.3, 0.4, 0.8}, {0, 0, 1}},
                                         {{0.7, 0.5, 0.8}, {0, 0, 1}}};
  calc::Cut cut = cut_for(tree, tile, true);
  std::vector<std::uint32_t> nodes{12345};  // of another tile: stays
  std::vector<calc::Cut::ChannelRange> channels;
  cut.select(tree, calc::tile_of(tile, 7.0), {64, 1.0f, true}, nodes, channels);
  ASSERT_EQ(nodes.size(), cut.size() + 1);
  for (std::size_t c = 0; c < cut.size(); ++c) {
    EXPECT_EQ(tree.nodes()[nodes[c + 1]].first, cut.first(c));
    EXPECT_EQ(tree.nodes()[nodes[c + 1]].size(), cut.count(c));
  }
  ASSERT_EQ(channels.size(), cut.channels().size());
  for (std::size_t k = 0; k < channels.size(); ++k) {
    EXPECT_EQ(channels[k].begin, cut.channels()[k].begin);
    EXPECT_EQ(channels[k].end, cut.channels()[k].end);
  }
}

TEST(Draws, WeightsAreTheInverseOfTheExpectedCount) {
  const calc::VertexTree tree(some_vertices(400), 2);
  const std::vector<calc::Receiver> tile{{{1.0, 2.0, 0.8}, {0, 0, 1}}};
  const calc::Cut cut = cut_for(tree, tile, false);
  std::vector<double> drawn(400, 0.0), weight(400, 0.0);
  std::vector<float> scratch;
  constexpr int kShifts = 4096;
  for (int s = 0; s < kShifts; ++s) {
    std::vector<calc::Connection> connections;
    calc::draw_connections(tree, cut, tile[0], 0, 16, (s + 0.5) / kShifts, scratch, connections);
    EXPECT_NEAR(static_cast<double>(connections.size()), 16.0, 1.0);
    for (const calc::Connection& c : connections) {
      drawn[c.vertex] += 1.0 / kShifts;
      weight[c.vertex] = static_cast<double>(c.weight);
    }
  }
  for (std::size_t j = 0; j < 400; ++j) {
    ASSERT_GT(drawn[j], 0.0) << j;
    EXPECT_NEAR(drawn[j] * weight[j], 1.0, 0.02 + 20.0 / kShifts / drawn[j]) << j;
  }
}

// The second channel has a fifth of the flux but gets more than a fifth of the draws.
TEST(Draws, WeakChannelsGetTheirShare) {
  LightVertices vertices = some_vertices(1000);
  for (calc::LightVertex& v : vertices) v.flux_lm *= v.channel == 1 ? 0.01f : 1.0f;
  const calc::VertexTree tree(vertices, 2);
  const std::vector<calc::Receiver> tile{{{1.0, 2.0, 0.8}, {0, 0, 1}}};
  const calc::Cut cut = cut_for(tree, tile, true);
  std::vector<float> scratch;
  std::vector<calc::Connection> connections;
  calc::draw_connections(tree, cut, tile[0], 0, 1000, 0.5, scratch, connections);
  const auto weak = std::count_if(connections.begin(), connections.end(), [&](const auto& c) {
    return tree.vertices()[c.vertex].channel == 1;
  });
  EXPECT_NEAR(static_cast<double>(weak), 250.0, 10.0);  // half of the half that is shared evenly
}

}  // namespace
}  // namespace vertex_tree_test
