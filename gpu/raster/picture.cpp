#include "gpu/raster/picture.h"

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/raster/gl_render_program.h"
#include "gpu/raster/gl_target.h"

#include <epoxy/gl.h>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpu {
namespace {

// In the picture's coordinates, as the shader reads it.
struct CoverVertex {
  glm::vec3 place;
  glm::vec4 colour, rim;
  glm::vec3 disc;
};
static_assert(sizeof(CoverVertex) == 14 * sizeof(float));

// Triangles of one kind, those that shine through surfaces first.
struct Cover {
  std::vector<CoverVertex> hidden, shown;
};

class CoverBuilder {
 public:
  CoverBuilder(const PictureScene& scene, const Camera& camera, int width, int height)
      : scene_(scene), camera_(camera), half_px_(0.5 * width, 0.5 * height) {}

  Cover build() {
    for (const PictureFace& face : scene_.faces) {
      for (const glm::dvec3& corner : face.corner_m) {
        cover_.shown.push_back({glm::vec3(place(corner)), face.colour, {}, {}});
      }
    }
    for (const PictureLine& line : scene_.lines) add(line);
    for (const PictureDot& dot : scene_.dots) add(dot);
    return std::move(cover_);
  }

 private:
  glm::dvec3 place(const glm::dvec3& p_m) const {
    return camera_.project(camera_.nearer(p_m, scene_.lift_m));
  }
  glm::dvec3 shifted(const glm::dvec3& place, const glm::dvec2& px) const {
    return {glm::dvec2(place) + px / half_px_, place.z};
  }

  // Along the axis that is seen longest.
  double px_per_metre(const glm::dvec3& p_m) const {
    const glm::dvec2 at(camera_.project(p_m));
    double most = 1e-9;
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep_m = 1e-3;
      glm::dvec3 beside_m = p_m;
      beside_m[k] += kStep_m;
      const glm::dvec2 moved = (glm::dvec2(camera_.project(beside_m)) - at) * half_px_;
      most = std::max(most, glm::length(moved) / kStep_m);
    }
    return most;
  }

  void add(const PictureLine& line) {
    const glm::dvec3 a = place(line.from_m), b = place(line.to_m);
    glm::dvec2 along = glm::dvec2(b - a) * half_px_;
    const double length_px = glm::length(along);
    along = length_px > 1e-6 ? along / length_px : glm::dvec2(1, 0);
    const glm::dvec2 across = 0.5 * line.width_px * glm::dvec2(-along.y, along.x);
    const glm::dvec2 end = 0.5 * line.width_px * along;  // square ends close corners
    const std::array<glm::dvec3, 4> q{shifted(a, across - end), shifted(a, -across - end),
                                      shifted(b, -across + end), shifted(b, across + end)};
    for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u}) {
      CoverVertex v{glm::vec3(q[k]), line.colour, {}, {}};
      cover_.shown.push_back(v);
      if (line.hidden_share <= 0.0) continue;
      v.colour.a *= static_cast<float>(line.hidden_share);
      cover_.hidden.push_back(v);
    }
  }

  void add(const PictureDot& dot) {
    // Twice its radius nearer, so that the surface that it lies on does not cut it in half.
    const double lift_m = std::max(scene_.lift_m, 2.0 * dot.radius_px / px_per_metre(dot.centre_m));
    const glm::dvec3 centre = camera_.project(camera_.nearer(dot.centre_m, lift_m));
    constexpr std::array<glm::dvec2, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u}) {
      const glm::dvec2 corner = kCorners[k];
      cover_.shown.push_back({glm::vec3(shifted(centre, corner * dot.radius_px)), dot.colour,
                              dot.rim, glm::vec3(glm::dvec3(corner, dot.radius_px))});
    }
  }

  const PictureScene& scene_;
  const Camera& camera_;
  glm::dvec2 half_px_;
  Cover cover_;
};

// An array for drawing, with the inputs of a vertex shader described for it.
class VertexArray {
 public:
  VertexArray() { glGenVertexArrays(1, &name_); }
  ~VertexArray() { glDeleteVertexArrays(1, &name_); }
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;
  void bind() const { glBindVertexArray(name_); }

  static void input(unsigned location, int components, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
  }

 private:
  unsigned name_ = 0;
};

void draw_surfaces(const PictureScene& scene, const Camera& camera,
                   const GlRenderProgram& program) {
  if (scene.triangle.empty()) return;
  GlBuffer position("surfaces"), value("values of surfaces"), triangle("triangles of surfaces");
  position.assign(scene.position_m);
  value.assign(scene.value);
  triangle.assign(scene.triangle);
  const VertexArray array;
  array.bind();
  glBindBuffer(GL_ARRAY_BUFFER, position.name());
  VertexArray::input(0, 3, sizeof(glm::vec3), 0);
  glBindBuffer(GL_ARRAY_BUFFER, value.name());
  VertexArray::input(1, 1, sizeof(float), 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangle.name());
  program.use();
  program.set("clip_from_local", glm::mat4(camera.clip_from_local));
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * scene.triangle.size()), GL_UNSIGNED_INT,
                 nullptr);
  glFinish();  // before its buffers go
  check_gl("drawing surfaces");
}

void draw_cover(const std::vector<CoverVertex>& vertices, const GlRenderProgram& program) {
  if (vertices.empty()) return;
  GlBuffer buffer("lines and dots");
  buffer.assign(vertices);
  const VertexArray array;
  array.bind();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  std::size_t offset = 0;
  unsigned location = 0;
  for (const int components : {3, 4, 4, 3}) {
    VertexArray::input(location++, components, sizeof(CoverVertex), offset);
    offset += sizeof(float) * static_cast<std::size_t>(components);
  }
  program.use();
  program.set("opacity", 1.0f);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  glFinish();
  check_gl("drawing lines and dots");
}

// While it lives, nothing outside is drawn or cleared.
class Scissors {
 public:
  Scissors(int width, int height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, width, height);
  }
  ~Scissors() { glDisable(GL_SCISSOR_TEST); }
  Scissors(const Scissors&) = delete;
  Scissors& operator=(const Scissors&) = delete;
};

// The device's rows run upwards, those of a picture downwards.
Camera upside_down(Camera camera) {
  camera.clip_from_local = glm::scale(glm::dmat4(1.0), {1, -1, 1}) * camera.clip_from_local;
  return camera;
}

Picture draw(const PictureScene& scene, const Camera& camera, int width, int height,
             DeviceState& device, Picture recycled) {
  const GlTarget& target = device.pictures.target(width, height);
  target.draw_into(width, height);
  const Scissors scissors(width, height);
  const std::array<float, 4> nothing{Picture::kNothing, 0, 0, 0}, clear{0, 0, 0, 0};
  const float far = 1.0f;
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, nothing.data());
  glClearBufferfv(GL_COLOR, 1, clear.data());
  glClearBufferfv(GL_DEPTH, 0, &far);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  draw_surfaces(scene, camera, device.pictures.surfaces(device.programs));

  const Cover cover = CoverBuilder(scene, camera, width, height).build();
  const GlRenderProgram& program = device.pictures.lines_and_dots(device.programs);
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glEnablei(GL_BLEND, 1);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_GREATER);
  draw_cover(cover.hidden, program);
  glDepthFunc(GL_LEQUAL);
  draw_cover(cover.shown, program);
  glDisablei(GL_BLEND, 1);
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glBindVertexArray(0);

  Picture picture = std::move(recycled);
  picture.width = width;
  picture.height = height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.value.resize(pixels);
  picture.cover.resize(4 * pixels);
  target.read(PictureTools::kValue, width, height,
              std::as_writable_bytes(std::span(picture.value)));
  target.read(PictureTools::kCover, width, height,
              std::as_writable_bytes(std::span(picture.cover)));
  return picture;
}

}  // namespace

int height_of(const Camera& camera, int width) {
  return std::max(1, static_cast<int>(std::lround(width / camera.aspect)));
}

Picture draw_picture(DeviceThread& thread, const PictureScene& scene, const Camera& camera,
                     int width, Picture recycled) {
  Picture picture;
  std::string failure;
  thread.run([&](DeviceState& device) {
    try {
      picture = draw(scene, upside_down(camera), width, height_of(camera, width), device,
                     std::move(recycled));
      check_gl("drawing a picture");
    } catch (const GlError& error) {
      // The calculation may use this device, too: a picture must neither take it away from it, nor
      // what is kept on it.
      failure = error.what();
      device.pictures.clear();
      forget_gl_errors();
    }
    device.check("drawing a picture");
  });
  if (!failure.empty()) throw calc::BackendFailure(failure);
  return picture;
}

}  // namespace gpu
