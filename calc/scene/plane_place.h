#pragma once
// Where a plane is, and which luminaires are in front of it.

#include "calc/photometry/web.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// The corners of an area or of the line of a route, or the points of a list; world coordinates,
// metres.
std::vector<glm::dvec3> places_of(const CalcPlane& plane);
// One for each place; of an area all are alike. Unit.
std::vector<glm::dvec3> normals_of(const CalcPlane& plane);

// How far the luminous opening reaches from its centre towards a unit direction of the world, in
// metres; 0 of a point.
double opening_reach_m(const LuminousOpening& opening, const Luminaire& luminaire,
                       const glm::dvec3& direction);

// Whether no luminaire of the space has a part of its luminous opening in front of any place of the
// plane (within a micrometre): only reflected light reaches it. Of those that are on in the scene
// (null: all of them), and have at least a thousandth of the flux of the strongest: what is weaker
// is no reason to face it. False without such luminaires.
bool faces_away(const Project& project, const Space& space, const CalcPlane& plane,
                const LightScene* scene = nullptr);

// Of the rooms, which throw no shadow in the open space, one that stands between a lit luminaire of
// it and one of the points, where that luminaire would give more than a hundredth of what all of
// them do by intensity and distance. Asked of at most some hundred points, spread over all. Null:
// none does.
const Space* room_between(const Project& project, const Space& open_space,
                          const std::vector<glm::dvec3>& points_m, const LightScene* scene);

}  // namespace calc
