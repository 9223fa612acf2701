#include "calc/project/reading/object_set.h"

#include <fmt/format.h>

#include <utility>

namespace calc {
namespace {

std::string joined_id(const std::string& name, const std::string& id) {
  return id.empty() ? name : name + "." + id;
}

}  // namespace

double held_bytes(double instances, double triangles) {
  constexpr double kInstance = 700.0, kTriangle = 80.0;  // measured with boxes and luminaires
  return kInstance * instances + kTriangle * triangles;
}

double ObjectSet::instances() const {
  return static_cast<double>(bodies.size()) + static_cast<double>(luminaires.size());
}

void ObjectSet::add_body(Body body) {
  triangles += static_cast<double>(body.triangle.size());
  bodies.push_back(std::move(body));
}

double Repeat::copies() const {
  return static_cast<double>(count[0]) * static_cast<double>(count[1]) *
         static_cast<double>(count[2]);
}

void append_placed(const ObjectSet& item, const Placement& placement, const std::string& name,
                   ObjectSet& into) {
  for (const Body& original : item.bodies) {
    Body body = original;
    body.id = joined_id(name, original.id);
    if (!original.housing_of.empty()) body.housing_of = joined_id(name, original.housing_of);
    for (glm::dvec3& vertex : body.vertex_m) vertex = placement.apply(vertex);
    into.add_body(std::move(body));
  }
  for (const Luminaire& original : item.luminaires) {
    Luminaire luminaire = original;
    luminaire.id = joined_id(name, original.id);
    luminaire.position_m = placement.apply(original.position_m);
    luminaire.world_from_luminaire = placement.turn * original.world_from_luminaire;
    into.luminaires.push_back(std::move(luminaire));
  }
  for (const auto& [id, top] : item.box_tops) {
    into.box_tops[joined_id(name, id)] = {placement.apply(top.origin_m), placement.turn * top.u_m,
                                          placement.turn * top.v_m};
  }
}

void append_repeated(const ObjectSet& item, const Placement& placement, const Repeat& repeat,
                     const std::string& name, ObjectSet& into) {
  if (!repeat.is_given) return append_placed(item, placement, name, into);
  if (item.instances() == 0) return;  // else an empty assembly could keep the loops busy for ever
  for (int k = 0; k < repeat.count[2]; ++k) {
    for (int j = 0; j < repeat.count[1]; ++j) {
      for (int i = 0; i < repeat.count[0]; ++i) {
        Placement copy = placement;
        copy.shift_m += glm::dvec3(i, j, k) * repeat.step_m;
        append_placed(item, copy, fmt::format("{}[{},{},{}]", name, i, j, k), into);
      }
    }
  }
}

}  // namespace calc
