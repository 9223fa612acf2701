#include "report/tools/pictures/room_pictures.h"

#include "calc/base/elementary.h"
#include "calc/radiosity/looks/surface_light.h"
#include "report/images/exr.h"
#include "report/images/png.h"
#include "report/text/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

namespace cli {
namespace {

constexpr int kCornerWidth = 1000, kPlanWidth = 640, kMostHeight = 720, kVertexWidth = 1400;
constexpr std::size_t kMostTriangles = 60'000;
constexpr double kMeshTriangles = 5500.0;  // of a lit mesh, in most rooms  [counted]
constexpr double kLift = 2e-3;             // of the room's diagonal
constexpr double kDotRadius_px = 2.6, kFewestDotPixels = 0.9;
constexpr double kScale = report::kOversampling;

glm::vec4 gl_colour(report::Rgb colour) {
  return {static_cast<float>(colour.r) / 255.0f, static_cast<float>(colour.g) / 255.0f,
          static_cast<float>(colour.b) / 255.0f, 1.0f};
}

struct View {
  const char* name;
  const char* title;
  gpu::Camera camera;
  int width = 1;  // of the finished picture
  calc::Cutaway cutaway;
};

int fitting_width(const gpu::Camera& camera, int wanted) {
  return std::clamp(static_cast<int>(kMostHeight * camera.aspect), 64, wanted);
}

std::vector<View> make_views(const calc::Tracer& tracer, bool opens_room) {
  const gpu::RoomBox box = gpu::box_of(tracer.scene());
  std::vector<View> views{{"corner", "seen from above a corner", gpu::corner_camera(box), 1, {}},
                          {"plan", "seen from above", gpu::plan_camera(box), 1, {}}};
  views[0].width = fitting_width(views[0].camera, kCornerWidth);
  views[1].width = fitting_width(views[1].camera, kPlanWidth);
  for (View& view : views) {
    view.cutaway = calc::cut_away(tracer, view.camera.eye_m, opens_room);
  }
  return views;
}

// The sides that some view shows, each once, and for every view which of them.
struct SharedSides {
  std::vector<calc::SurfaceSide> side;
  std::vector<std::vector<std::uint8_t>> is_shown;  // [view][side]
};

SharedSides share_sides(const std::vector<View>& views, std::size_t triangles) {
  SharedSides shared;
  std::vector<std::array<int, 2>> index(triangles, {-1, -1});
  for (const View& view : views) {
    for (const calc::SurfaceSide& side : view.cutaway.shown) {
      int& known = index[side.triangle][side.is_flipped ? 1 : 0];
      if (known >= 0) continue;
      known = static_cast<int>(shared.side.size());
      shared.side.push_back(side);
    }
  }
  for (const View& view : views) {
    std::vector<std::uint8_t>& shown = shared.is_shown.emplace_back(shared.side.size(), 0);
    for (const calc::SurfaceSide& side : view.cutaway.shown) {
      shown[static_cast<std::size_t>(index[side.triangle][side.is_flipped ? 1 : 0])] = 1;
    }
  }
  return shared;
}

std::vector<double> point_values(const report::SpacePart& part) {
  std::vector<double> values;
  for (const report::PlanePart& plane : part.planes) {
    if (!report::is_plain_illuminance(plane)) continue;
    for (const report::PointRow& point : plane.points) values.push_back(point.measured.value);
  }
  return values;
}

// Pixels of the drawing between a plane's first two points.
double spacing_px(const report::PlanePart& plane, const glm::dvec3& origin_m,
                  const gpu::Camera& camera, int width_px) {
  if (plane.points.size() < 2) return 1e9;
  const glm::dvec3 a = camera.project(plane.points[0].position_m - origin_m);
  const glm::dvec3 b = camera.project(plane.points[1].position_m - origin_m);
  return 0.5 * width_px * calc::hypot(b.x - a.x, (b.y - a.y) / camera.aspect);
}

void add_planes(gpu::PictureScene& picture, const report::SpacePart& part,
                const glm::dvec3& origin_m, const View& view, const report::ColourScale& scale) {
  for (const report::PlanePart& plane : part.planes) {
    if (!plane.is_computed) continue;
    const calc::SensorGrid& grid = plane.grid;
    const bool is_planar = report::is_plain_illuminance(plane);
    // What it measures is on the side that the eye does not see.
    const bool is_turned =
        is_planar && grid.columns > 0 &&
        glm::dot(glm::cross(grid.u, grid.v), view.camera.eye_m + origin_m - grid.origin_m) < 0.0;
    const auto outline = [&](const std::vector<glm::dvec2>& corners) {
      std::vector<glm::dvec3> corner_m;
      for (const glm::dvec2& uv : corners) {
        corner_m.push_back(grid.origin_m + uv.x * grid.u + uv.y * grid.v - origin_m);
      }
      gpu::add_outline(picture, corner_m, kScale, is_turned);
    };
    if (grid.route) {
      gpu::add_outline(picture, route_outline_m(*grid.route, origin_m), kScale, is_turned);
    } else if (!plane.outline_m.empty()) {
      outline(plane.outline_m);
    }
    for (const auto& hole : plane.holes_m) outline(hole);
    if (!is_planar || is_turned) continue;
    const double radius_px = std::min(
        kDotRadius_px * kScale,
        0.3 * spacing_px(plane, origin_m, view.camera, static_cast<int>(kScale) * view.width));
    if (radius_px < kFewestDotPixels * kScale) continue;
    for (const report::PointRow& point : plane.points) {
      const int band = report::band_of(scale, point.measured.value);
      picture.dots.push_back({point.position_m - origin_m, radius_px,
                              gl_colour(report::band_colour(scale, band)),
                              glm::vec4(0.05f, 0.06f, 0.09f, 1.0f)});
    }
  }
}

gpu::PictureScene surfaces_of(const calc::LitSurfaces& lit,
                              const std::vector<std::uint8_t>& shown) {
  gpu::PictureScene picture;
  picture.position_m = lit.position_m;
  picture.value = lit.lx;
  for (std::size_t k = 0; k < lit.triangle.size(); ++k) {
    if (shown[lit.side[k]] != 0) picture.triangle.push_back(lit.triangle[k]);
  }
  return picture;
}

report::DrawnRoom drawn_room(gpu::Picture picture) {
  return {picture.width, picture.height, std::move(picture.value), std::move(picture.cover)};
}

// Even in both directions, so that it halves.
int drawn_width(int width) { return report::kOversampling * width; }

report::DrawnRoom cropped(report::DrawnRoom drawn) {
  const int height = drawn.height - drawn.height % report::kOversampling;
  const auto pixels = static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(height);
  drawn.lx.resize(pixels);
  drawn.cover.resize(4 * pixels);
  drawn.height = height;
  return drawn;
}

gpu::Picture memory_of(report::DrawnRoom drawn) {
  gpu::Picture picture;
  picture.value = std::move(drawn.lx);
  picture.cover = std::move(drawn.cover);
  return picture;
}

}  // namespace

// The right side of the line comes first, the left one comes back.
std::vector<glm::dvec3> route_outline_m(const calc::RouteGrid& route, const glm::dvec3& origin_m) {
  const std::vector<glm::dvec2> outline_m = calc::route_outline_m(route.line);
  const std::size_t corners = route.line.corner_m.size();
  std::vector<glm::dvec3> corner_m;
  for (std::size_t k = 0; k < outline_m.size(); ++k) {
    const std::size_t at = k < corners ? k : 2 * corners - 1 - k;
    const double z_m = route.line.corner_m[at].z + route.height_m;
    corner_m.push_back(glm::dvec3(outline_m[k], z_m) - origin_m);
  }
  return corner_m;
}

bool opens(const calc::Space& space) { return space.shell || !space.surfaces_file.empty(); }

bool wants_pictures(const OutputOptions& options) {
  const std::vector<OutputFormat> files = planned_files(options);
  const auto is_html = [](const OutputFormat& item) {
    return item.format->is_html || item.format->is_printed;
  };
  return options.images || std::any_of(files.begin(), files.end(), is_html) ||
         std::any_of(options.formats.begin(), options.formats.end(), is_html);
}

calc::DrawingWork picture_work(const std::vector<check::ProjectPlan>& projects) {
  calc::DrawingWork work;
  for (const check::ProjectPlan& project : projects) {
    for (const check::SpacePlan& space : project.spaces) {
      if (space.triangles == 0 || space.triangles > kMostTriangles) continue;
      work.rooms += 1.0;
      for (const int width : {kCornerWidth, kPlanWidth}) {
        work.pixels += kScale * kScale * width * kMostHeight;  // at most
        work.triangles += kMeshTriangles + static_cast<double>(space.triangles);
      }
    }
  }
  return work;
}

PictureMaker::PictureMaker(PictureSettings settings, std::function<bool()> go_on)
    : settings_(std::move(settings)), go_on_(std::move(go_on)), device_(settings_.device) {}

void PictureMaker::add_pictures(const std::string& project_path, const calc::Space& space,
                                const calc::PreparedScene& scene, report::SpacePart& part) {
  std::string problem;
  for (bool again = true; again;) {
    again = false;
    try {
      problem = draw(project_path, space, scene, part);
    } catch (const calc::BackendFailure& failure) {
      problem = failure.what();
      again = device_.falls_back(problem);
    } catch (const std::exception& error) {
      problem = error.what();
    }
  }
  if (problem.empty()) return;
  part.pictures = {};
  part.pictures.problem = problem;
}

std::string PictureMaker::draw(const std::string& project_path, const calc::Space& space,
                               const calc::PreparedScene& scene, report::SpacePart& part) {
  if (scene.triangle.empty()) return "it has no surfaces";
  if (scene.triangle.size() > kMostTriangles) return "it has too many surfaces for a picture";
  std::string problem;
  gpu::DeviceThread* const device = device_.get(problem);
  if (device == nullptr) return problem;
  if (device->device().is_software && ++rooms_ > calc::kMostRoomsOnSoftware) {
    return "without a GPU only the first " + std::to_string(calc::kMostRoomsOnSoftware) +
           " rooms are drawn";
  }
  const calc::Tracer tracer(scene);
  const std::vector<View> views = make_views(tracer, opens(space));
  const SharedSides sides = share_sides(views, scene.triangle.size());
  calc::SurfaceLightSettings settings;
  settings.seed = settings_.seed;
  settings.jobs = settings_.jobs;
  settings.go_on = go_on_;
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::LitSurfaces lit = calc::light_surfaces(scene, sides.side, settings, *gatherer);
  if (!lit.problem.empty()) return lit.problem.english();

  // The scale is known once the surfaces are seen; points are painted with it.
  std::vector<report::DrawnRoom> bare;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const gpu::PictureScene picture = surfaces_of(lit, sides.is_shown[v]);
    bare.push_back(
        drawn_room(gpu::draw_picture(*device, picture, views[v].camera, views[v].width / 4)));
  }
  const report::ColourScale scale = report::room_scale(bare, point_values(part));
  report::RoomPictures pictures;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const View& view = views[v];
    gpu::PictureScene picture = surfaces_of(lit, sides.is_shown[v]);
    picture.lift_m = kLift * scene.extent_m;
    gpu::add_edges(picture, scene, view.cutaway, kScale);
    add_planes(picture, part, scene.origin_m, view, scale);
    gpu::add_luminaires(picture, scene, kScale);
    report::DrawnRoom drawn = cropped(drawn_room(gpu::draw_picture(
        *device, picture, view.camera, drawn_width(view.width), std::move(recycled_))));
    const report::Raster raster = report::paint_room(drawn, report::band_palette(scale));
    report::RoomPicture& made = pictures.list.emplace_back();
    made.name = view.name;
    made.title = view.title;
    made.width = raster.width;
    made.height = raster.height;
    made.png = report::encode_png(raster);
    if (settings_.has_files) {
      made.labelled_png = report::encode_png(report::with_legend(raster, scale));
      made.exr = report::render_room_exr(project_path, space.id, view.title, raster.width,
                                         raster.height, report::mean_values(drawn));
    }
    pictures.highest_lx =
        std::max(pictures.highest_lx,
                 static_cast<double>(*std::max_element(drawn.lx.begin(), drawn.lx.end())));
    recycled_ = memory_of(std::move(drawn));
  }
  pictures.low_lx = scale.low;
  pictures.step_lx = scale.step;
  pictures.bands = scale.bands;
  pictures.error_share = lit.error_share;
  pictures.device = device->device().name();
  part.pictures = std::move(pictures);
  return "";
}

calc::DrawingWork view_work() {
  calc::DrawingWork work;
  work.rooms = 1.0;
  work.pixels = kScale * kScale * kVertexWidth * kVertexWidth;
  work.triangles = kMeshTriangles;
  return work;
}

report::Raster draw_vertices(gpu::DeviceThread& device, const calc::Tracer& tracer,
                             std::span<const calc::LightVertex> vertices, bool opens_room) {
  gpu::VertexStyle style;
  style.colour = [](double share) { return gl_colour(report::cividis(std::sqrt(share))); };
  const report::DrawnRoom drawn = cropped(drawn_room(gpu::render_vertices(
      device, tracer, vertices, style, opens_room, drawn_width(kVertexWidth), kScale)));
  report::Palette greys{{}, 1.0f / 256.0f};
  for (int shade = 0; shade < 256; ++shade) {
    const auto grey = static_cast<std::uint8_t>(shade);
    greys.colour.push_back({grey, grey, grey});
  }
  return report::paint_room(drawn, greys);
}

}  // namespace cli
