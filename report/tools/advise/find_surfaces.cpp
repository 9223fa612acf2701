#include "report/check/room_changes.h"
#include "report/text/words.h"
#include "report/tools/advise/find_places.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli {
namespace {

// Of all triangles of a surface: their reflectance by area, and the largest.
struct Finish {
  double area_m2 = 0.0, weighted = 0.0, largest = 0.0, smallest = 1.0;
};

Finish finish_of(const calc::Project& project, const calc::Space& space,
                 const std::string& surface) {
  Finish finish;
  for (const calc::Body& body : space.bodies) {
    if (surface_of_body(space, body.id) != surface) continue;
    for (std::size_t t = 0; t < body.triangle.size(); ++t) {
      const glm::uvec3& corner = body.triangle[t];
      const glm::dvec3 a = body.vertex_m[corner.x];
      const double area_m2 =
          0.5 * glm::length(glm::cross(body.vertex_m[corner.y] - a, body.vertex_m[corner.z] - a));
      const double rho = project.materials[body.material_of[t]].reflectance;
      finish.area_m2 += area_m2;
      finish.weighted += area_m2 * rho;
      finish.largest = std::max(finish.largest, rho);
      finish.smallest = std::min(finish.smallest, rho);
    }
  }
  return finish;
}

class SurfaceSearch {
 public:
  SurfaceSearch(const RoomQuestions& questions, std::size_t part_index, const calc::Space& space,
                const std::string& scene)
      : questions_(questions), part_index_(part_index), space_(space) {
    found_.scene = scene;
    found_.space = report::title_of(questions.part.spaces[part_index].name, space.id);
    found_.space_id = space.id;
  }

  std::optional<RoomSurfaces> search() {
    std::vector<std::string> left_out;
    asked_ = asked_of_room(questions_, part_index_, found_.scene, true, left_out);
    if (asked_.empty()) {
      asked_ = asked_of_room(questions_, part_index_, found_.scene, false, left_out);
    }
    if (asked_.empty()) return std::nullopt;
    for (const AskedOfRoom& one : asked_) found_.requirements.push_back(one.told);
    if (!space_.shell) {
      found_.problem = "surfaces have names only in rooms whose walls are in the project file";
      return std::move(found_);
    }
    find_surfaces();
    std::vector<std::string> names;
    for (const LighterSurface& one : found_.surfaces) names.push_back(one.surface);
    if (names.empty()) {
      found_.problem = "no surface can be that much lighter";
      return std::move(found_);
    }
    const RoomLight light(questions_, space_, found_.scene, asked_, space_.luminaires, names);
    found_.problem = light.problem().english();
    if (!found_.problem.empty()) {
      found_.surfaces.clear();
      return std::move(found_);
    }
    for (std::size_t s = 0; s < names.size(); ++s) {
      LighterSurface& surface = found_.surfaces[s];
      for (const AskedOfRoom& one : asked_) {
        surface.slope_lx.push_back(light.surface_lx(one, s, true));
        surface.step_lx.push_back(light.surface_lx(one, s, false));
      }
      check(surface);
    }
    return std::move(found_);
  }

 private:
  void find_surfaces() {
    for (const std::string name : {"floor", "ceiling", "walls"}) {
      const Finish finish = finish_of(questions_.project, space_, name);
      if (!(finish.area_m2 > 0.0) || finish.largest + kReflectanceStep > 1.0) continue;
      LighterSurface surface;
      surface.surface = name;
      surface.reflectance = finish.weighted / finish.area_m2;
      if (finish.largest != finish.smallest) surface.problem = "it has several materials";
      found_.surfaces.push_back(std::move(surface));
    }
  }

  void check(LighterSurface& surface) const {
    if (!surface.problem.empty()) return;
    // Of the one material: not the mean, which is rounded.
    const double rho =
        finish_of(questions_.project, space_, surface.surface).largest + kReflectanceStep;
    const check::ChangedText changed = check::with_reflectance(
        questions_.bytes, questions_.file, space_.id, surface.surface, std::min(rho, 1.0));
    surface.problem = changed.problem;
    if (!changed.text) return;
    const auto part = questions_.check(*changed.text, surface.problem);
    if (!part) return;
    for (const AskedOfRoom& one : asked_) {
      surface.after.push_back(part->spaces[part_index_].planes[one.plane].findings[one.finding]);
    }
  }

  const RoomQuestions& questions_;
  std::size_t part_index_;
  const calc::Space& space_;
  RoomSurfaces found_;
  std::vector<AskedOfRoom> asked_;
};

}  // namespace

std::vector<RoomSurfaces> find_surfaces(const RoomQuestions& questions) {
  return searched_rooms<SurfaceSearch>(questions, false);
}

}  // namespace cli
