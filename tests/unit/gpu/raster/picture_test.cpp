#include "gpu/raster/picture.h"

#include "calc/radiosity/looks/surface_light.h"
#include "gpu/raster/room_drawing.h"
#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace picture_test {
namespace {

using namespace test_support;

struct Pixel {
  float value;
  std::array<int, 4> cover;
};

Pixel pixel_at(const gpu::Picture& picture, const gpu::Camera& camera, const glm::dvec3& p_m) {
  const glm::dvec3 place = camera.project(p_m);
  const auto x = static_cast<std::size_t>(0.5 * (place.x + 1.0) * picture.width);
  const auto y = static_cast<std::size_t>(0.5 * (1.0 - place.y) * picture.height);
  const std::size_t i = y * static_cast<std::size_t>(picture.width) + x;
  const auto part = [&](std::size_t k) { return static_cast<int>(picture.cover[4 * i + k]); };
  return {picture.value[i], {part(0), part(1), part(2), part(3)}};
}

void add_quad(gpu::PictureScene& scene, const glm::vec3& origin, const glm::vec3& u,
              const glm::vec3& v, float value) {
  const auto first = static_cast<std::uint32_t>(scene.position_m.size());
  for (const glm::vec3& p : {origin, origin + u, origin + u + v, origin + v}) {
    scene.position_m.push_back(p);
    scene.value.push_back(value);
  }
  scene.triangle.emplace_back(first, first + 1, first + 2);
  scene.triangle.emplace_back(first, first + 2, first + 3);
}

// The letter L seen from above: its foot runs to +x, its stem to +y; and a post of value 3.
gpu::PictureScene letter() {
  gpu::PictureScene scene;
  add_quad(scene, {0, 0, 0}, {3, 0, 0}, {0, 0.5f, 0}, 1.0f);
  add_quad(scene, {0, 0.5f, 0}, {0.5f, 0, 0}, {0, 1.5f, 0}, 2.0f);
  add_quad(scene, {0.1f, 0.1f, 0.4f}, {0.3f, 0, 0}, {0, 0.3f, 0}, 3.0f);
  return scene;
}
const gpu::RoomBox kLetterBox{{0, 0, 0}, {3, 2, 0.4}};

TEST(Picture, IsNotMirrored) {
  LUXGATE_NEEDS_OPENGL();
  const auto device = gl_device();
  const gpu::Camera plan = gpu::plan_camera(kLetterBox);
  const gpu::Picture picture = gpu::draw_picture(*device, letter(), plan, 300);
  const auto at = [&](double x_share, double y_share) {  // from the left and from the top
    const auto x = static_cast<std::size_t>(x_share * picture.width);
    const auto y = static_cast<std::size_t>(y_share * picture.height);
    return picture.value[y * static_cast<std::size_t>(picture.width) + x];
  };
  EXPECT_NEAR(static_cast<double>(picture.width) / picture.height, 3.18 / 2.18, 0.02);
  EXPECT_EQ(at(0.9, 0.9), 1.0f);                    // the foot, at the lower right
  EXPECT_EQ(at(0.1, 0.1), 2.0f);                    // the stem, at the upper left
  EXPECT_EQ(at(0.9, 0.1), gpu::Picture::kNothing);  // nothing at the upper right
  EXPECT_EQ(at(0.10, 0.86), 3.0f);                  // what is higher hides what is lower
}

TEST(Picture, CornerViewHasXToTheRightAndZUp) {
  LUXGATE_NEEDS_OPENGL();
  const auto device = gl_device();
  const gpu::Camera camera = gpu::corner_camera(kLetterBox);
  const gpu::Picture picture = gpu::draw_picture(*device, letter(), camera, 400);
  EXPECT_GT(camera.project({3, 0, 0}).x, camera.project({0, 0, 0}).x);
  EXPECT_GT(camera.project({0, 2, 0}).y, camera.project({0, 0, 0}).y);
  EXPECT_GT(camera.project({1, 1, 0.4}).y, camera.project({1, 1, 0}).y);
  EXPECT_EQ(pixel_at(picture, camera, {2.5, 0.25, 0}).value, 1.0f);
  EXPECT_EQ(pixel_at(picture, camera, {0.25, 1.7, 0}).value, 2.0f);
  EXPECT_EQ(pixel_at(picture, camera, {0.25, 0.25, 0.4}).value, 3.0f);
  EXPECT_EQ(pixel_at(picture, camera, {2.5, 1.5, 0}).value, gpu::Picture::kNothing);
}

TEST(Picture, FitsAndDrawsNothingOutside) {
  LUXGATE_NEEDS_OPENGL();
  const auto device = gl_device();
  for (const gpu::RoomBox& box :
       {gpu::RoomBox{{-3, 5, 1}, {17, 7, 4}}, gpu::RoomBox{{0, 0, 0}, {1, 6, 2}}}) {
    for (const gpu::Camera& camera : {gpu::corner_camera(box), gpu::plan_camera(box)}) {
      gpu::PictureScene scene;
      const glm::vec3 low(box.low_m), size(box.high_m - box.low_m);
      add_quad(scene, low, {size.x, 0, 0}, {0, size.y, 0}, 1.0f);
      scene.lines.push_back({box.low_m, box.high_m, glm::vec4(1.0f), 3.0});
      const gpu::Picture picture = gpu::draw_picture(*device, scene, camera, 200);
      glm::dvec3 reach(0.0);
      for (std::size_t k = 0; k < 8; ++k) {
        const glm::dvec3 corner((k & 1u) != 0 ? box.high_m.x : box.low_m.x,
                                (k & 2u) != 0 ? box.high_m.y : box.low_m.y,
                                (k & 4u) != 0 ? box.high_m.z : box.low_m.z);
        reach = glm::max(reach, glm::abs(camera.project(corner)));
      }
      const double longer_px = std::max(picture.width, picture.height);
      const double margin_x_px = 0.5 * (1.0 - reach.x) * picture.width;
      EXPECT_NEAR(margin_x_px, 0.028 * longer_px, 0.002 * longer_px);
      EXPECT_NEAR(0.5 * (1.0 - reach.y) * picture.height, margin_x_px, 0.6);
      EXPECT_LT(reach.z, 1.0);
      std::size_t seen = 0;
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          const auto i = static_cast<std::size_t>(y * picture.width + x);
          const bool is_there = picture.value[i] >= 0.0f || picture.cover[4 * i + 3] > 0;
          if (is_there) ++seen;
          const double margin_px = margin_x_px - 3.0;  // half the line's width, and its end
          const bool is_margin = x < margin_px || x >= picture.width - margin_px || y < margin_px ||
                                 y >= picture.height - margin_px;
          EXPECT_FALSE(is_margin && is_there) << x << " " << y;
        }
      }
      EXPECT_GT(seen, 100u);
    }
  }
}

// Illuminance at a projected point is E = I h / d^3: 2 % for the mesh and the pixel.
TEST(Picture, ShowsTheIlluminanceOfAPointSource) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(200.0);
  calc::PreparedScene scene;
  test_support::add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.0);
  add_luminaire(scene, web, {0.5, 0.2, 1.5});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const gpu::Camera camera = gpu::corner_camera(gpu::box_of(scene));
  const calc::Cutaway cut = calc::cut_away(calc::Tracer(scene), camera.eye_m, false);
  const calc::LitSurfaces lit = calc::light_surfaces(scene, cut.shown, {}, *gatherer);
  gpu::PictureScene drawing;
  drawing.position_m = lit.position_m;
  drawing.value = lit.lx;
  drawing.triangle = lit.triangle;
  const gpu::Picture picture = gpu::draw_picture(*gl_device(), drawing, camera, 1200);
  for (const glm::dvec2 xy : {glm::dvec2(0.5, 0.2), {-1.5, -1.2}, {1.7, 1.1}, {-0.4, 1.8}}) {
    const double d = glm::length(glm::dvec3(xy, 0) - glm::dvec3(0.5, 0.2, 1.5));
    const double lx = 200.0 * 1.5 / (d * d * d);
    EXPECT_NEAR(static_cast<double>(pixel_at(picture, camera, {xy, 0}).value), lx, 0.02 * lx);
  }
}

TEST(Picture, GivesTheSameBitsAgain) {
  LUXGATE_NEEDS_OPENGL();
  gpu::PictureScene scene = letter();
  scene.lines.push_back({{0, 0, 0}, {3, 2, 0.1}, {0.2f, 0.4f, 0.6f, 0.5f}, 2.5, 0.5});
  scene.dots.push_back({{1, 1, 0}, 7.0, glm::vec4(1, 0, 0, 1), glm::vec4(0, 0, 0, 1)});
  const gpu::Camera camera = gpu::corner_camera(kLetterBox);
  const gpu::Picture once = gpu::draw_picture(*gl_device(), scene, camera, 301);
  const gpu::Picture again = gpu::draw_picture(*gl_device(), scene, camera, 301);
  EXPECT_EQ(once.value, again.value);
  EXPECT_EQ(once.cover, again.cover);
}

// Layers are kept for the next picture, and may be larger than it.
TEST(Picture, GivesTheSameBitsAfterALargerOne) {
  LUXGATE_NEEDS_OPENGL();
  gpu::PictureScene scene = letter();
  scene.lines.push_back({{0, 0, 0}, {3, 2, 0.1}, {0.2f, 0.4f, 0.6f, 0.5f}, 2.5, 0.5});
  gpu::PictureScene full;
  add_quad(full, {-5, -5, 0.3f}, {12, 0, 0}, {0, 12, 0}, 7.0f);
  const gpu::Camera plan = gpu::plan_camera(kLetterBox), corner = gpu::corner_camera(kLetterBox);
  const gpu::Picture alone = gpu::draw_picture(*gl_device(), scene, plan, 203);
  const auto device = gl_device();
  gpu::Picture other = gpu::draw_picture(*device, full, corner, 120);
  other = gpu::draw_picture(*device, full, corner, 501, std::move(other));  // grows
  const gpu::Picture after = gpu::draw_picture(*device, scene, plan, 203, std::move(other));
  EXPECT_EQ(after.width, alone.width);
  EXPECT_EQ(after.height, alone.height);
  EXPECT_EQ(after.value, alone.value);
  EXPECT_EQ(after.cover, alone.cover);
}

TEST(Picture, DotsHaveTheirColourAndHideBehindSurfaces) {
  LUXGATE_NEEDS_OPENGL();
  gpu::PictureScene scene = letter();
  const glm::vec4 red(1, 0, 0, 1), black(0, 0, 0, 1);
  scene.dots.push_back({{2, 0.25, 0.1}, 6.0, red, black});
  scene.dots.push_back({{0.25, 0.25, 0.1}, 6.0, red, black});  // below the post
  const gpu::Camera plan = gpu::plan_camera(kLetterBox);
  const gpu::Picture picture = gpu::draw_picture(*gl_device(), scene, plan, 300);
  EXPECT_EQ(pixel_at(picture, plan, {2, 0.25, 0.1}).cover, (std::array<int, 4>{255, 0, 0, 255}));
  EXPECT_EQ(pixel_at(picture, plan, {0.25, 0.25, 0.1}).cover[3], 0);
  // The value below is still known.
  EXPECT_EQ(pixel_at(picture, plan, {2, 0.25, 0.1}).value, 1.0f);
}

TEST(Picture, EndsWithTheReasonWhenTheDeviceFails) {
  LUXGATE_NEEDS_OPENGL();
  const auto device = gl_device(gpu::Fault::context_lost);
  EXPECT_THROW(gpu::draw_picture(*device, letter(), gpu::plan_camera(kLetterBox), 100),
               calc::BackendFailure);
}

// Others use the device, too.
TEST(Picture, ThatCannotBeDrawnLeavesTheDevice) {
  LUXGATE_NEEDS_OPENGL();
  const auto device = gl_device();
  const gpu::Camera plan = gpu::plan_camera(kLetterBox);
  const gpu::Picture before = gpu::draw_picture(*device, letter(), plan, 100);
  EXPECT_THROW(gpu::draw_picture(*device, letter(), plan, 10'000'000), calc::BackendFailure);
  bool has_run = false;
  device->run([&](gpu::DeviceState& state) {
    state.check("going on");
    has_run = true;
  });
  EXPECT_TRUE(has_run);
  EXPECT_EQ(gpu::draw_picture(*device, letter(), plan, 100).value, before.value);
}

TEST(VertexView, ShowsEachVertexByItsFlux) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const std::vector<calc::LightVertex> vertices{{{1, 1, 0}, 4.0f, {0, 0, 1}, 0},
                                                {{3, 2, 0}, 1.0f, {0, 0, 1}, 0}};
  gpu::VertexStyle style;
  style.colour = [](double share) {
    return share == 1.0 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1);
  };
  const gpu::Picture picture =
      gpu::render_vertices(*gl_device(), tracer, vertices, style, true, 500, 1.0);
  const gpu::Camera camera = gpu::corner_camera(gpu::box_of(scene));
  EXPECT_EQ(pixel_at(picture, camera, {1, 1, 0}).cover, (std::array<int, 4>{255, 0, 0, 255}));
  EXPECT_EQ(pixel_at(picture, camera, {3, 2, 0}).cover, (std::array<int, 4>{0, 255, 0, 255}));
  const auto count = [&](std::size_t channel) {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < picture.cover.size(); i += 4) {
      if (picture.cover[i + channel] == 255) ++pixels;
    }
    return static_cast<double>(pixels);
  };
  EXPECT_GT(count(0), 2.0 * count(1));  // a fourth of the area, but for the rims
  const float floor = pixel_at(picture, camera, {2, 0.5, 0}).value;
  EXPECT_GT(floor, 0.8f);  // grey surfaces
  EXPECT_LE(floor, 1.0f);
}

}  // namespace
}  // namespace picture_test
