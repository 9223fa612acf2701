#pragma once
// The objects of a room, the open space or an assembly while a project is read, and how they are
// moved and repeated.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace calc {

// A rigid motion, world from local.
struct Placement {
  glm::dmat3 turn{1.0};
  glm::dvec3 shift_m{0.0};

  glm::dvec3 apply(const glm::dvec3& point) const { return turn * point + shift_m; }
};

// The upper face of a box; u and v are its full sides.
struct BoxTop {
  glm::dvec3 origin_m{0.0}, u_m{0.0}, v_m{0.0};
};

// Returns roughly the bytes that a project keeps for these objects, luminaires and triangles.
double held_bytes(double instances, double triangles);

struct ObjectSet {
  std::vector<Body> bodies;
  std::vector<Luminaire> luminaires;
  std::map<std::string, BoxTop, std::less<>> box_tops;  // by body id
  double triangles = 0;                                 // of all bodies; add_body() counts

  void add_body(Body body);
  double instances() const;
};

// A regular array: copies are at (i step.x, j step.y, k step.z), i < count[0] and so on.
struct Repeat {
  bool is_given = false;
  std::array<int, 3> count{1, 1, 1};
  glm::dvec3 step_m{0.0};

  double copies() const;
};

// Adds the moved set. Ids become name or name + "." + id (for ids that are not empty).
void append_placed(const ObjectSet& item, const Placement& placement, const std::string& name,
                   ObjectSet& into);

// Adds the moved set for all copies; if the repeat is given, "[i,j,k]" follows the name. The caller
// has checked the total size.
void append_repeated(const ObjectSet& item, const Placement& placement, const Repeat& repeat,
                     const std::string& name, ObjectSet& into);

}  // namespace calc
