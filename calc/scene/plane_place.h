#pragma once
// The place of a plane, and the luminaires in front of it.

#include "calc/photometry/web.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// Returns the corners of an area or of a route's line, or the points of a list; world coordinates,
// metres.
std::vector<glm::dvec3> places_of(const CalcPlane& plane);
// Returns a unit normal for each place; those of an area are all alike.
std::vector<glm::dvec3> normals_of(const CalcPlane& plane);

// Returns how far the luminous opening reaches from its centre towards a unit direction of the
// world, in metres; 0 for a point.
double opening_reach_m(const LuminousOpening& opening, const Luminaire& luminaire,
                       const glm::dvec3& direction);

// Returns whether no luminaire of the space has a part of its luminous opening in front of any
// place of the plane (within a micrometre), so that only reflected light reaches it. Only
// luminaires count that are on in the scene (null: all) and have at least a thousandth of the
// strongest flux, because a weaker one is no reason to face it. False without such luminaires.
bool faces_away(const Project& project, const Space& space, const CalcPlane& plane,
                const LightScene* scene = nullptr);

// Returns a room between a lit luminaire of the open space and one of the points, where that
// luminaire would give more than a hundredth of the light of all of them by intensity and distance.
// Rooms cast no shadow in the open space. At most some hundred points, spread over all, are tested.
// Null: there is none.
const Space* room_between(const Project& project, const Space& open_space,
                          const std::vector<glm::dvec3>& points_m, const LightScene* scene);

}  // namespace calc
