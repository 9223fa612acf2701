#pragma once
// Pictures of rooms for reports: light on their surfaces in false colours and as a rendered view,
// drawn by OpenGL.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "gpu/device/device_thread.h"
#include "gpu/raster/picture.h"
#include "gpu/raster/room_drawing.h"
#include "report/check/drawing_device.h"
#include "report/check/plan.h"
#include "report/document/document.h"
#include "report/images/room_picture.h"
#include "report/shell/output/output_options.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cli {

// Returns whether a run makes pictures: a file needs them.
bool wants_pictures(const OutputOptions& options);

struct PictureSettings {
  bool has_files = false;  // of --images: pictures with their legend, and EXR
  std::uint64_t seed = 1;
  int jobs = 0;
  check::PictureDevice::Request device;
  report::ColourMap map = report::ColourMap::cividis;
  report::Texts texts;  // of files
};

// Returns the work for all drawn rooms of these projects.
calc::DrawingWork picture_work(const std::vector<check::ProjectPlan>& projects);

// Draws rooms one after the other. The device is opened for the first; a room without pictures says
// why (RoomPictures::problem), and is otherwise like any other. If a GPU chosen by cost fails, that
// room and all later ones are drawn by software.
class PictureMaker {
 public:
  // go_on: false stops the calculation of light on surfaces.
  PictureMaker(PictureSettings settings, std::function<bool()> go_on);

  void add_pictures(const std::string& project_path, const calc::Space& space,
                    const calc::PreparedScene& scene, report::SpacePart& part);

 private:
  // Renders a view. picture: of luminances, without lift.
  report::Raster render(gpu::DeviceThread& device, gpu::PictureScene picture,
                        const calc::PreparedScene& scene, const gpu::Camera& camera, int width);
  std::string draw(const std::string& project_path, const calc::Space& space,
                   const calc::PreparedScene& scene, report::SpacePart& part);

  PictureSettings settings_;
  std::function<bool()> go_on_;
  check::PictureDevice device_;
  gpu::Picture recycled_;  // the last one's memory
  int rooms_ = 0;
};

// Returns the work of such a picture for a room with an unknown number of surfaces.
calc::DrawingWork view_work();
// Draws a room with its light vertices as dots over grey surfaces: their area is proportional to
// their flux, their colour goes from dark (little) to bright. Throws calc::BackendFailure.
report::Raster draw_vertices(gpu::DeviceThread& device, const calc::Tracer& tracer,
                             std::span<const calc::LightVertex> vertices, bool opens_room);

// Returns the outline of an escape route, at the heights of its line: stairs rise. origin_m: of the
// local coordinates.
std::vector<glm::dvec3> route_outline_m(const calc::RouteGrid& route, const glm::dvec3& origin_m);

// Returns whether pictures look into it: rooms do, the open space does not.
bool opens(const calc::Space& space);

}  // namespace cli
