#pragma once
// Adds to pictures of a room what they show besides light: edges, luminaires, calculation planes,
// light vertices.

#include "calc/radiosity/looks/cutaway.h"
#include "calc/radiosity/paths/light_vertex.h"
#include "calc/scene/prepared_scene.h"
#include "gpu/raster/camera.h"
#include "gpu/raster/picture.h"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

namespace gpu {

// Returns the box of surfaces and luminaires, with some size in every direction.
RoomBox box_of(const calc::PreparedScene& scene);

// Adds edges where surfaces end or fold by more than 20 degrees; those of removed ones are faint.
// scale: pixels of the drawing per pixel of the picture as displayed.
void add_edges(PictureScene& picture, const calc::PreparedScene& scene,
               const calc::Cutaway& cutaway, double scale);

// Returns the rim of a flat opening, or of a body's outline from below; a single place for a point.
std::vector<glm::dvec3> opening_rim_m(const calc::PlacedLuminaire& luminaire);

// Adds the openings of luminaires, or dots where they have no size. glow: the colour of each,
// without a rim; empty: white glass with a dark rim.
using LuminaireGlow = std::function<glm::vec4(const calc::PlacedLuminaire&)>;
void add_luminaires(PictureScene& picture, const calc::PreparedScene& scene, double scale,
                    const LuminaireGlow& glow = {});

// Adds a closed line, faint behind surfaces: the outline of a calculation plane. is_faint: all of
// it, for planes seen from behind.
void add_outline(PictureScene& picture, std::span<const glm::dvec3> corner_m, double scale,
                 bool is_faint);

// A dot for each vertex, its area in proportion to its flux; the largest is most_px across, none is
// below least_px. colour: of its share in the largest flux, in [0, 1].
struct VertexStyle {
  double least_px = 1.5, most_px = 14.0;
  std::function<glm::vec4(double share)> colour;
};
void add_vertices(PictureScene& picture, std::span<const calc::LightVertex> vertices,
                  const VertexStyle& style, double scale);

// Draws a room with its light vertices as dots over grey surfaces, shaded in [0, 1] by their
// direction. Local coordinates; a device's failure throws calc::BackendFailure.
Picture render_vertices(DeviceThread& thread, const calc::Tracer& tracer,
                        std::span<const calc::LightVertex> vertices, const VertexStyle& style,
                        bool opens_room, int width, double scale);

}  // namespace gpu
