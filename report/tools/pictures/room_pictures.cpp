#include "report/tools/pictures/room_pictures.h"

#include "calc/base/units.h"
#include "calc/radiosity/looks/surface_light.h"
#include "calc/scene/opening.h"
#include "report/html/room/html_room.h"
#include "report/images/exr.h"
#include "report/images/png.h"
#include "report/images/tone_map.h"
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
constexpr std::size_t kRenderedView = 0;  // of make_views(): the corner
constexpr double kRenderedShare = 0.6;    // of the width of the same view in false colours
constexpr std::size_t kMostTriangles = 60'000;
constexpr double kMeshTriangles = 5500.0;  // of a lit mesh, in most rooms  [counted]
constexpr double kLift = 2e-3;             // of the room's diagonal
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

void add_planes(gpu::PictureScene& picture, const report::SpacePart& part,
                const glm::dvec3& origin_m, const View& view) {
  for (const report::PlanePart& plane : part.planes) {
    if (!plane.is_computed) continue;
    const calc::SensorGrid& grid = plane.grid;
    // What it measures is on the side that the eye does not see.
    const bool is_turned =
        report::is_plain_illuminance(plane) && grid.columns > 0 &&
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

// The same light as luminance in cd/m2 of surfaces that are matt. A corner where surfaces of
// several reflectances meet has a value for each.
gpu::PictureScene luminance_of(const calc::LitSurfaces& lit, const SharedSides& sides,
                               std::size_t view, const calc::PreparedScene& scene) {
  gpu::PictureScene picture;
  for (std::size_t k = 0; k < lit.triangle.size(); ++k) {
    if (sides.is_shown[view][lit.side[k]] == 0) continue;
    const auto cd_m2_by_lx =
        static_cast<float>(scene.reflectance[sides.side[lit.side[k]].triangle] / calc::kPi);
    const auto first = static_cast<std::uint32_t>(picture.position_m.size());
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t at = lit.triangle[k][corner];
      picture.position_m.push_back(lit.position_m[at]);
      picture.value.push_back(lit.lx[at] * cd_m2_by_lx);
    }
    picture.triangle.emplace_back(first, first + 1, first + 2);
  }
  return picture;
}

// All of its light spread evenly over the opening, as a matt surface sends it; of a point, which
// has no area, what is white.
double glow_cd_m2(const calc::PreparedScene& scene, const calc::PlacedLuminaire& luminaire) {
  constexpr double kWhite_cd_m2 = 1e9;
  const double area_m2 =
      calc::seen_opening_m2(luminaire, luminaire.world_from_luminaire * glm::dvec3(0.0, 0.0, -1.0));
  if (!(area_m2 > 0.0)) return kWhite_cd_m2;
  return luminaire.web->flux_lm() * luminaire.flux_scale *
         scene.channels[luminaire.channel].maintenance_factor / (calc::kPi * area_m2);
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

report::RoomPicture as_picture(const report::Raster& raster, const char* name) {
  report::RoomPicture picture;
  picture.name = name;
  picture.width = raster.width;
  picture.height = raster.height;
  picture.png = report::encode_png(raster);
  return picture;
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
      for (const double share_width :
           {1.0 * kCornerWidth, 1.0 * kPlanWidth, kRenderedShare * kRenderedShare * kCornerWidth}) {
        work.pixels += kScale * kScale * share_width * kMostHeight;  // at most
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

report::Raster PictureMaker::render(gpu::DeviceThread& device, gpu::PictureScene picture,
                                    const calc::PreparedScene& scene, const gpu::Camera& camera,
                                    int width) {
  // Its brightness is known once it is seen.
  const gpu::Picture bare = gpu::draw_picture(device, picture, camera, width / 4);
  const double average = report::log_average(bare.value);
  picture.lift_m = kLift * scene.extent_m;
  gpu::add_luminaires(picture, scene, kScale, [&](const calc::PlacedLuminaire& luminaire) {
    return gl_colour(report::toned(glow_cd_m2(scene, luminaire), average));
  });
  report::DrawnRoom drawn = cropped(drawn_room(
      gpu::draw_picture(device, picture, camera, drawn_width(width), std::move(recycled_))));
  report::Raster raster = report::paint_room(drawn, report::tone_palette(average));
  recycled_ = memory_of(std::move(drawn));
  return raster;
}

std::string PictureMaker::draw(const std::string& project_path, const calc::Space& space,
                               const calc::PreparedScene& scene, report::SpacePart& part) {
  if (scene.triangle.empty()) return "the room has no surfaces";
  if (scene.triangle.size() > kMostTriangles) return "the room has too many surfaces for a picture";
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

  // The scale is known once the surfaces are seen.
  std::vector<report::DrawnRoom> bare;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const gpu::PictureScene picture = surfaces_of(lit, sides.is_shown[v]);
    bare.push_back(
        drawn_room(gpu::draw_picture(*device, picture, views[v].camera, views[v].width / 4)));
  }
  report::ColourScale scale = report::room_scale(bare);
  scale.map = settings_.map;
  report::RoomPictures pictures;
  const auto add = [&](report::RoomPicture picture, const View& view, const auto& with_words) {
    picture.title = view.title;
    if (settings_.has_files) {
      picture.labelled_png = report::encode_png(
          with_words(report::PictureFrame{report::picture_words(settings_.texts, part, picture)}));
    }
    pictures.list.push_back(std::move(picture));
  };
  for (std::size_t v = 0; v < views.size(); ++v) {
    const View& view = views[v];
    gpu::PictureScene picture = surfaces_of(lit, sides.is_shown[v]);
    picture.lift_m = kLift * scene.extent_m;
    gpu::add_edges(picture, scene, view.cutaway, kScale);
    add_planes(picture, part, scene.origin_m, view);
    gpu::add_luminaires(picture, scene, kScale);
    report::DrawnRoom drawn = cropped(drawn_room(gpu::draw_picture(
        *device, picture, view.camera, drawn_width(view.width), std::move(recycled_))));
    const report::Raster raster = report::paint_room(drawn, report::band_palette(scale));
    report::RoomPicture made = as_picture(raster, view.name);
    if (settings_.has_files) {
      made.exr = report::render_room_exr(project_path, space.id, view.title, raster.width,
                                         raster.height, report::mean_values(drawn));
    }
    pictures.highest_lx =
        std::max(pictures.highest_lx,
                 static_cast<double>(*std::max_element(drawn.lx.begin(), drawn.lx.end())));
    recycled_ = memory_of(std::move(drawn));
    add(std::move(made), view, [&](const report::PictureFrame& frame) {
      return report::with_legend(raster, scale, frame);
    });
    if (v != kRenderedView) continue;
    const report::Raster rendered =
        render(*device, luminance_of(lit, sides, v, scene), scene, view.camera,
               static_cast<int>(kRenderedShare * view.width));
    made = as_picture(rendered, "rendered");
    made.is_rendered = true;
    add(std::move(made), view,
        [&](const report::PictureFrame& frame) { return report::with_frame(rendered, frame); });
  }
  pictures.low_lx = scale.low;
  pictures.step_lx = scale.step;
  pictures.bands = scale.bands;
  pictures.map = scale.map;
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
