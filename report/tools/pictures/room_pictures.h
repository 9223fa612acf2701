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

// Whether a run makes pictures: there is a file to put them into.
bool wants_pictures(const OutputOptions& options);

struct PictureSettings {
  bool has_files = false;  // of --images: pictures with their legend, and EXR
  std::uint64_t seed = 1;
  int jobs = 0;
  check::PictureDevice::Request device;
  report::ColourMap map = report::ColourMap::cividis;
  report::Texts texts;  // of files
};

// Of all rooms of these projects that are drawn.
calc::DrawingWork picture_work(const std::vector<check::ProjectPlan>& projects);

// Draws rooms one after the other. The device is opened for the first; a room without pictures says
// why (RoomPictures::problem), and is a room like any other otherwise. Where a GPU that was chosen
// by cost fails, that room and those that follow are drawn by software.
class PictureMaker {
 public:
  // go_on: false stops the light on surfaces.
  PictureMaker(PictureSettings settings, std::function<bool()> go_on);

  void add_pictures(const std::string& project_path, const calc::Space& space,
                    const calc::PreparedScene& scene, report::SpacePart& part);

 private:
  // picture: of luminances, without lift.
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

// Of such a picture of a room whose surfaces nobody has counted.
calc::DrawingWork view_work();
// A room with its light vertices as dots over grey surfaces, their area in proportion to their flux
// and their colour from dark (little) to bright. Throws calc::BackendFailure.
report::Raster draw_vertices(gpu::DeviceThread& device, const calc::Tracer& tracer,
                             std::span<const calc::LightVertex> vertices, bool opens_room);

// Of an escape route, at the heights of its line: stairs rise. origin_m: of the local coordinates.
std::vector<glm::dvec3> route_outline_m(const calc::RouteGrid& route, const glm::dvec3& origin_m);

// Whether pictures look into it: rooms, but not the open space.
bool opens(const calc::Space& space);

}  // namespace cli
