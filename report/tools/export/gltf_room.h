#pragma once
// A room as a model for common viewers, with the illuminance on its surfaces as colours.

#include "calc/radiosity/looks/surface_light.h"
#include "calc/scene/prepared_scene.h"
#include "report/images/heatmap.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace cli::gltf {

struct Outline {
  std::string id;
  std::vector<glm::dvec3> corner_m;  // closed; local, as in PreparedScene
};

struct Room {
  std::string id, name;
  const calc::PreparedScene* scene = nullptr;
  calc::LitSurfaces light;
  std::vector<Outline> planes;
};

// Returns a scale from 0 to the value that only the brightest hundredth of the rooms' surfaces
// exceeds.
report::ColourScale common_scale(const std::vector<Room>& rooms);

// Returns a binary glTF 2.0 file: metres, y up, north of plans (+y) away from the viewer; surfaces
// with their colours and their lux (the attribute _ILLUMINANCE_LX), both at their corners, openings
// of luminaires, outlines of planes, and the scale's legend before the room. The room's place in
// the project is in the scene's extras. Materials are unlit (KHR_materials_unlit).
std::string write_glb(const Room& room, const report::ColourScale& scale);

}  // namespace cli::gltf
