#include "calc/radiosity/looks/vertex_cache.h"

#include "calc/radiosity/looks/scene_fingerprint.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

namespace vertex_cache_test {
namespace {

using namespace test_support;
using testing::HasSubstr;

// Two luminaires of two groups in a box far from where the project has its origin.
class VertexCacheFile : public testing::Test {
 protected:
  VertexCacheFile() {
    add_box(scene, {-2, -1.5, 0}, {4, 3, 2.5}, 0.6);
    add_luminaire(scene, web, {-1, 0, 2});
    add_luminaire(scene, weak, {1, 0.5, 1.5});
    scene.luminaires[1].channel = 1;
    scene.channels.push_back({"spots", 0.7});
    scene.origin_m = {512345.678, -4000000.123, 77.1};
    set_extent(scene);
    settings.replicates = 4;
    settings.first_paths = 64;
    settings.max_paths = 256;
    settings.seed = 9;
  }

  calc::VertexCache traced() {
    calc::TracedCache result = calc::trace_vertex_cache(scene, settings);
    EXPECT_EQ(result.problem, "");
    result.cache->made_by = "test 1 (rays 2)";
    result.cache->space_id = "a room";
    return std::move(*result.cache);
  }

  // Why the file is refused after an edit; "" = it is not.
  std::string problem_after(const std::function<void(std::string&)>& edit) {
    std::string bytes = calc::render_vertex_ply(traced());
    edit(bytes);
    const calc::TracedCache parsed = calc::parse_vertex_ply(bytes);
    EXPECT_EQ(parsed.cache.has_value(), parsed.problem.empty());
    return parsed.problem;
  }

  static void replace(std::string& bytes, const std::string& from, const std::string& to) {
    const std::size_t at = bytes.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    bytes.replace(at, from.size(), to);
  }

  calc::PhotometricWeb web = isotropic_web(100.0), weak = isotropic_web(15.0);
  calc::PreparedScene scene;
  calc::RadiositySettings settings;
};

TEST_F(VertexCacheFile, GivesBackEveryBit) {
  const calc::VertexCache cache = traced();
  const calc::TracedCache parsed = calc::parse_vertex_ply(calc::render_vertex_ply(cache));
  ASSERT_EQ(parsed.problem, "");
  EXPECT_EQ(parsed.cache->made_by, "test 1 (rays 2)");
  EXPECT_EQ(parsed.cache->space_id, "a room");
  EXPECT_EQ(parsed.cache->scene, cache.scene);
  EXPECT_EQ(parsed.cache->seed, 9u);
  EXPECT_EQ(parsed.cache->replicates, 4);
  EXPECT_EQ(parsed.cache->paths, 256u);
  EXPECT_EQ(parsed.cache->first_paths, 64u);
  EXPECT_EQ(parsed.cache->channels, 2u);
  EXPECT_EQ(parsed.cache->origin_m, scene.origin_m);
  ASSERT_EQ(parsed.cache->batches.size(), 12u);  // looks of 64, 64 and 128 paths
  for (std::size_t b = 0; b < 12; ++b) {
    const calc::VertexCacheBatch& in = cache.batches[b];
    const calc::VertexCacheBatch& out = parsed.cache->batches[b];
    EXPECT_EQ(out.absorbed_lm, in.absorbed_lm);
    EXPECT_EQ(out.escaped_lm, in.escaped_lm);
    EXPECT_EQ(out.luminaire, in.luminaire);
    ASSERT_EQ(out.vertices.size(), in.vertices.size());
    ASSERT_GT(in.vertices.size(), 64u);
    EXPECT_EQ(std::memcmp(out.vertices.data(), in.vertices.data(),
                          in.vertices.size() * sizeof(calc::LightVertex)),
              0);
    EXPECT_EQ(std::memcmp(out.origins.data(), in.origins.data(),
                          in.origins.size() * sizeof(calc::VertexOrigin)),
              0);
  }
}

TEST_F(VertexCacheFile, IsWhatPlyViewersRead) {
  const calc::VertexCache cache = traced();
  const std::string bytes = calc::render_vertex_ply(cache);
  EXPECT_EQ(bytes.find("ply\nformat binary_little_endian 1.0\ncomment "), 0u);
  const std::size_t end = bytes.find("end_header\n") + 11;
  EXPECT_EQ(bytes.size() - end, cache.vertices() * 58);
  EXPECT_THAT(bytes.substr(0, end),
              HasSubstr("element vertex " + std::to_string(cache.vertices()) +
                        "\nproperty float x\nproperty float y\nproperty float z\n"));
  float x = 0.0f, y = 0.0f, z = 0.0f;
  std::memcpy(&x, &bytes[end], 4);
  std::memcpy(&y, &bytes[end + 4], 4);
  std::memcpy(&z, &bytes[end + 8], 4);
  EXPECT_NEAR(x, 512345.678, 2.1);  // scene coordinates
  EXPECT_NEAR(y, -4000000.123, 2.1);
  EXPECT_NEAR(z, 77.1 + 1.25, 1.3);
}

TEST_F(VertexCacheFile, FluxColumnAddsUpToTheReflectedFlux) {
  const calc::VertexCache cache = traced();
  const std::string bytes = calc::render_vertex_ply(cache);
  const std::size_t begin = bytes.find("end_header\n") + 11;
  double file_lm = 0.0, vertices_lm = 0.0;
  for (std::size_t at = begin; at < bytes.size(); at += 58) {
    float flux = 0.0f;
    std::memcpy(&flux, &bytes[at + 24], 4);
    file_lm += static_cast<double>(flux);
  }
  for (const calc::VertexCacheBatch& batch : cache.batches) {
    for (const calc::LightVertex& v : batch.vertices) {
      vertices_lm += static_cast<double>(v.flux_lm) * (batch.last - batch.first) / 256.0;
    }
  }
  EXPECT_NEAR(file_lm / vertices_lm, 1.0, 1e-12);
  // Closed box: reflected = Phi rho / (1 - rho), four replicates.
  const double phi = web.flux_lm() + weak.flux_lm();
  EXPECT_NEAR(file_lm / (4.0 * phi * 0.6 / 0.4), 1.0, 0.03);
}

TEST_F(VertexCacheFile, KnowsBounceAndLuminaire) {
  for (const calc::VertexCacheBatch& batch : traced().batches) {
    std::size_t first_reflections = 0;
    for (std::size_t k = 0; k < batch.vertices.size(); ++k) {
      ASSERT_LT(batch.luminaire[k], 2u);
      EXPECT_EQ(batch.vertices[k].channel, scene.luminaires[batch.luminaire[k]].channel);
      EXPECT_GE(batch.origins[k].path, batch.first);
      EXPECT_LT(batch.origins[k].path, batch.last);
      if (batch.origins[k].reflection == 0) ++first_reflections;
    }
    EXPECT_EQ(first_reflections, batch.last - batch.first);  // no path leaves a closed box
  }
}

TEST_F(VertexCacheFile, ResultsAreTheSameToTheBit) {
  calc::SensorGrid grid;
  for (const double x : {-1.5, 0.0, 1.9}) {
    grid.position_m.push_back(scene.origin_m + glm::dvec3(x, 0.3, 0.7));
    grid.normal.emplace_back(0, 0, 1);
  }
  const calc::TracedCache parsed = calc::parse_vertex_ply(calc::render_vertex_ply(traced()));
  ASSERT_EQ(parsed.problem, "");
  const auto solve = [&](const calc::VertexCache* cache) {
    const auto gatherer = calc::make_cpu_gatherer();
    return calc::solve_illuminance(
        scene, {{"plane", &grid}}, settings, 0.95, *gatherer,
        [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {},
        cache);
  };
  const calc::SpaceSolution without = solve(nullptr), with = solve(&*parsed.cache);
  EXPECT_EQ(with.fields[0].indirect_lx, without.fields[0].indirect_lx);
  EXPECT_EQ(with.fields[0].direct_exact_lx, without.fields[0].direct_exact_lx);
  EXPECT_EQ(with.fields[0].largest_share, without.fields[0].largest_share);
  EXPECT_EQ(with.balance.absorbed_lm.value, without.balance.absorbed_lm.value);
  EXPECT_EQ(with.fields[0].stop, without.fields[0].stop);
  EXPECT_GT(without.fields[0].indirect_lx[0], 0.0);
  EXPECT_GT(without.pool_rays, 0u);
  EXPECT_EQ(with.pool_rays, 0u);  // nothing was traced
  // It is the cache that answers: other vertices, other light.
  calc::VertexCache brighter = *parsed.cache;
  for (auto& batch : brighter.batches) {
    for (auto& vertex : batch.vertices) vertex.flux_lm *= 2.0f;
  }
  EXPECT_GT(solve(&brighter).fields[0].indirect_lx[0], 1.5 * without.fields[0].indirect_lx[0]);
  settings.max_paths = 512;
  EXPECT_THROW(solve(&*parsed.cache), std::logic_error);
}

TEST_F(VertexCacheFile, RefusesWhatIsNotOne) {
  EXPECT_EQ(problem_after([](std::string&) {}), "");
  EXPECT_THAT(problem_after([](std::string& b) { b = ""; }), HasSubstr("not a PLY file"));
  EXPECT_THAT(problem_after([](std::string& b) { b = "solid x"; }), HasSubstr("not a PLY file"));
  EXPECT_THAT(problem_after([](std::string& b) {
                b = "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n";
              }),
              HasSubstr("does not hold light vertices of this version"));
  EXPECT_THAT(
      problem_after([](std::string& b) { replace(b, "light vertices 1", "light vertices 2"); }),
      HasSubstr("does not hold light vertices of this version"));
}

TEST_F(VertexCacheFile, RefusesAnotherLength) {
  EXPECT_THAT(problem_after([](std::string& b) { b.pop_back(); }), HasSubstr("cut off or changed"));
  EXPECT_THAT(problem_after([](std::string& b) { b += 'x'; }), HasSubstr("cut off or changed"));
  EXPECT_THAT(problem_after([](std::string& b) { b.resize(b.find("end_header")); }),
              HasSubstr("must continue with 'end_header'"));
  EXPECT_THAT(problem_after([](std::string& b) { b.resize(200); }),
              HasSubstr("must continue with"));
  EXPECT_THAT(problem_after([](std::string& b) {
                const std::size_t at = b.find("element vertex ") + 15;
                b.replace(at, b.find('\n', at) - at, "18446744073709551615");
              }),
              HasSubstr("cut off or changed"));
}

TEST_F(VertexCacheFile, RefusesEveryEdit) {
  EXPECT_THAT(problem_after([](std::string& b) { b.back() = static_cast<char>(b.back() ^ 1); }),
              HasSubstr("checksum"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "seed 9", "seed 8"); }),
              HasSubstr("checksum"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "space a room", "space b room"); }),
              HasSubstr("checksum"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "groups 2", "groups 1"); }),
              HasSubstr("checksum"));
  // One content, one file: also of the checksum itself.
  EXPECT_THAT(problem_after([](std::string& b) {
                const std::size_t at = b.find("checksum ") + 9;
                const std::size_t letter = b.find_first_of("abcdef", at);
                ASSERT_LT(letter, at + 16);
                b[letter] = static_cast<char>(b[letter] - 'a' + 'A');
              }),
              HasSubstr("must continue with"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "replicates 4", "replicates 3"); }),
              HasSubstr("must continue with"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "replicates 4", "replicates 0"); }),
              HasSubstr("not allowed"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "replicate 256", "replicate 257"); }),
              HasSubstr("not allowed"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "batch 0 0 64", "batch 0 0 65"); }),
              HasSubstr("not the expected one"));
  EXPECT_THAT(problem_after([](std::string& b) { replace(b, "seed 9", "seed nine"); }),
              HasSubstr("'comment seed '"));
  EXPECT_THAT(
      problem_after([](std::string& b) { replace(b, "property float nx", "property int nx"); }),
      HasSubstr("'property float nx'"));
}

TEST_F(VertexCacheFile, NamesCannotBreakTheHeader) {
  calc::VertexCache cache = traced();
  cache.space_id = "two\nlines";
  const calc::TracedCache parsed = calc::parse_vertex_ply(calc::render_vertex_ply(cache));
  ASSERT_EQ(parsed.problem, "");
  EXPECT_EQ(parsed.cache->space_id, "two lines");
}

TEST_F(VertexCacheFile, NothingReflectsNothingIsKept) {
  for (double& rho : scene.reflectance) rho = 0.0;
  const calc::TracedCache result = calc::trace_vertex_cache(scene, settings);
  EXPECT_FALSE(result.cache.has_value());
  EXPECT_THAT(result.problem, HasSubstr("no light vertices"));
}

TEST_F(VertexCacheFile, FingerprintFollowsWhatPathsDependOn) {
  const auto print = [&] { return calc::scene_fingerprint(scene, {}); };
  const std::uint64_t before = print();
  EXPECT_EQ(print(), before);
  const auto expect_other = [&](auto& value, auto other, const char* what) {
    const auto saved = value;
    value = other;
    EXPECT_NE(print(), before) << what;
    value = saved;
  };
  expect_other(scene.reflectance[3], 0.61, "reflectance");
  expect_other(scene.vertex_m[5].x, scene.vertex_m[5].x + 1e-6f, "vertex");
  expect_other(scene.luminaires[1].position_m.z, 1.5000001, "position");
  expect_other(scene.luminaires[1].flux_scale, 1.01, "flux");
  expect_other(scene.luminaires[1].world_from_luminaire[0].x, 0.99, "orientation");
  expect_other(scene.luminaires[1].channel, 0u, "light group");
  expect_other(scene.luminaires[1].opening.shape, calc::OpeningShape::disk, "opening");
  const calc::PhotometricWeb other = isotropic_web(15.1);
  expect_other(scene.luminaires[1].web, static_cast<const calc::PhotometricWeb*>(&other), "web");
  expect_other(scene.origin_m.x, 0.0, "origin");
  EXPECT_NE(calc::scene_fingerprint(scene, std::vector<std::uint8_t>{0, 1}), before);
  EXPECT_EQ(print(), before);

  // Webs of equal flux are told apart.
  const calc::PhotometricWeb twin = isotropic_web(15.0);
  add_luminaire(scene, twin, {0, 0, 2});
  add_luminaire(scene, twin, {0, 1, 2});
  const std::uint64_t with_twin = print();
  scene.luminaires.back().web = &weak;
  EXPECT_NE(print(), with_twin);
}

}  // namespace
}  // namespace vertex_cache_test
