#include "calc/project/warnings/luminaire_warnings.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/photometry/web_measures.h"
#include "calc/project/warnings/room_inside.h"
#include "calc/project/warnings/warning_words.h"
#include "calc/scene/box_shelf.h"
#include "calc/scene/housing.h"
#include "calc/scene/joined_openings.h"
#include "calc/scene/luminaire_sums.h"
#include "calc/scene/opening_fit.h"
#include "calc/scene/polygon.h"
#include "calc/scene/scene_level.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace calc {
namespace {

// The commonest way to be outside is said: ", 0.2 m above its ceiling".
std::string above_ceiling_words(const RoomShell& shell, const glm::dvec3& point_m) {
  const double above_m = point_m.z - shell.floor_z_m - shell.height_m;
  if (above_m <= 0.0 || !contains_point(shell.footprint_m, glm::dvec2(point_m))) return {};
  return fmt::format(", {:.3g} m above its ceiling", above_m);
}

void warn_luminaires_outside(const Space& room, Diagnostics& diagnostics) {
  PerElement outside;
  std::map<std::pair<int, int>, std::string> how;
  for (const Luminaire& luminaire : room.luminaires) {
    if (room_contains(*room.shell, luminaire.position_m)) continue;
    outside.add(luminaire.id, luminaire.where);
    how.try_emplace({luminaire.where.line, luminaire.where.column},
                    above_ceiling_words(*room.shell, luminaire.position_m));
  }
  outside.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_outside_room, first.where, first.id,
                       and_others(first.others), room.id,
                       how.at({first.where.line, first.where.column}));
  });
}

// The same of a room of a mesh, whose shell may have any shape.
void warn_luminaires_outside_mesh(const Space& room, const Body& shell, Diagnostics& diagnostics) {
  PerElement outside;
  const BoundingBox box = bounding_box(shell.vertex_m);
  for (const Luminaire& luminaire : room.luminaires) {
    if (locate_point(shell, box, luminaire.position_m) == SolidSide::outside) {
      outside.add(luminaire.id, luminaire.where);
    }
  }
  outside.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_outside_room, first.where, first.id,
                       and_others(first.others), room.id, "");
  });
}

// In a wall, the floor or the ceiling, and turned the wrong way.
bool is_surface_that_faces_out(const Project& project, const Space& room,
                               const Luminaire& luminaire) {
  constexpr double kBefore_m = 0.01;
  const LuminaireType& type = project.luminaire_types[luminaire.type];
  const bool is_surface = type.photometry_file.empty();  // all others come from a file
  if (!is_surface || !room_contains(*room.shell, luminaire.position_m)) return false;
  return !room_contains(*room.shell,
                        luminaire.position_m - kBefore_m * luminaire.world_from_luminaire[2]);
}

void warn_surfaces_that_face_out(const Project& project, const Space& room,
                                 Diagnostics& diagnostics) {
  PerElement outwards;
  for (const Luminaire& luminaire : room.luminaires) {
    if (is_surface_that_faces_out(project, room, luminaire)) {
      outwards.add(luminaire.id, luminaire.where);
    }
  }
  outwards.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminous_surface_faces_out, first.where, first.id,
                       and_others(first.others), room.id);
  });
}

// The outermost points of the opening as seen from below, in the world.
std::vector<glm::dvec3> opening_edge_m(const LuminousOpening& opening, const Luminaire& luminaire) {
  const LuminousOpening flat = flattened(opening);
  const glm::dvec3 half_m = 0.5 * flat.size_m();
  std::vector<glm::dvec3> edge;
  for (const double side : {-1.0, 1.0}) {
    const std::array<glm::dvec3, 2> ends =
        flat.shape == OpeningShape::disk
            ? std::array{glm::dvec3(side * half_m.x, 0, 0), glm::dvec3(0, side * half_m.y, 0)}
            : std::array{glm::dvec3(side * half_m.x, half_m.y, 0),
                         glm::dvec3(side * half_m.x, -half_m.y, 0)};
    for (const glm::dvec3& end : ends) {
      edge.push_back(luminaire.position_m + luminaire.world_from_luminaire * end);
    }
  }
  return edge;
}

// How far the opening of one whose centre is within the room reaches out of it; 0 within what
// projects, which are written in millimetres, have from rounding.
double reach_outside_m(const Project& project, const Space& room, const Luminaire& luminaire) {
  constexpr double kTolerated_m = 1.0e-3;
  const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
  double farthest_m = 0.0;
  for (const glm::dvec3& point_m : opening_edge_m(web.opening(), luminaire)) {
    farthest_m = std::max(farthest_m, distance_outside_m(*room.shell, point_m));
  }
  return farthest_m > kTolerated_m ? farthest_m : 0.0;
}

// Those whose centre is within the room: of all others everything is said already.
void warn_luminaires_partly_outside(const Project& project, const Space& room,
                                    Diagnostics& diagnostics) {
  PerElement partly;
  std::map<std::pair<int, int>, double> reach_m;  // the farthest of each element
  for (const Luminaire& luminaire : room.luminaires) {
    if (!room_contains(*room.shell, luminaire.position_m)) continue;
    const double farthest_m = reach_outside_m(project, room, luminaire);
    if (farthest_m == 0.0) continue;
    partly.add(luminaire.id, luminaire.where);
    double& reach = reach_m[{luminaire.where.line, luminaire.where.column}];
    reach = std::max(reach, farthest_m);
  }
  partly.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_partly_outside, first.where, first.id,
                       and_others(first.others), reach_m.at({first.where.line, first.where.column}),
                       room.id);
  });
}

// A millimetre from its rim inwards: what is set into a surface, or stands at one, is not in it.
bool reaches_into_solid(const LuminousOpening& opening, const Luminaire& luminaire,
                        const Body& body, const BoundingBox& box) {
  constexpr double kTolerated_m = 1.0e-3;
  for (const glm::dvec3& point_m : opening_edge_m(opening, luminaire)) {
    const glm::dvec3 inwards = luminaire.position_m - point_m;
    const double reach_m = glm::length(inwards);
    if (reach_m <= kTolerated_m) continue;
    const glm::dvec3 inner_m = point_m + kTolerated_m / reach_m * inwards;
    if (locate_point(body, box, inner_m) == SolidSide::inside) return true;
  }
  return false;
}

// An opening in its very surface may look into it.
bool is_in_solid(const Luminaire& luminaire, const Body& body, const BoundingBox& box) {
  constexpr double kBefore_m = 1.0e-3;
  const glm::dvec3 before_m = luminaire.position_m - kBefore_m * luminaire.world_from_luminaire[2];
  return locate_point(body, box, luminaire.position_m) == SolidSide::inside ||
         locate_point(body, box, before_m) == SolidSide::inside;
}

// What both of the next look for: calls visit(luminaire, body, its box) for the luminaires that may
// have a part in a solid other than their own housing, a solid behind the other.
template <class Visit>
void for_each_near_solid(const Project& project, const Space& space, Visit visit) {
  constexpr double kBeside_m = 1.0e-3;
  std::vector<BoundingBox> around;
  for (const Luminaire& luminaire : space.luminaires) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    const double reach_m = 0.5 * glm::length(web.opening().size_m()) + kBeside_m;
    around.push_back({luminaire.position_m - reach_m, luminaire.position_m + reach_m});
  }
  BoxShelf luminaires(around);
  for (std::size_t i = 0; i < around.size(); ++i) luminaires.add(i);
  luminaires.sort();
  for (const Body& body : space.bodies) {
    if (!body.is_closed) continue;
    const BoundingBox box = bounding_box(body.vertex_m);
    for (const std::size_t i : luminaires.near(box, 0.0)) {
      const Luminaire& luminaire = space.luminaires[i];
      if (!is_housing_of(body, luminaire)) visit(luminaire, body, box);
    }
  }
}

void warn_luminaires_partly_in_solids(const Project& project, const Space& space,
                                      Diagnostics& diagnostics) {
  PerElement partly;
  std::map<std::pair<int, int>, std::string> solid;
  for_each_near_solid(
      project, space, [&](const Luminaire& luminaire, const Body& body, const BoundingBox& box) {
        const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
        if (is_in_solid(luminaire, body, box)) return;
        if (!reaches_into_solid(web.opening(), luminaire, body, box)) return;
        partly.add(luminaire.id, luminaire.where);
        solid.try_emplace({luminaire.where.line, luminaire.where.column}, body.id);
      });
  partly.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_partly_in_solid, first.where, first.id,
                       and_others(first.others), solid.at({first.where.line, first.where.column}));
  });
}

void warn_luminaires_in_solids(const Project& project, const Space& space,
                               Diagnostics& diagnostics) {
  PerElement buried;
  std::map<std::pair<int, int>, std::string> solid;
  for_each_near_solid(project, space,
                      [&](const Luminaire& luminaire, const Body& body, const BoundingBox& box) {
                        if (!is_in_solid(luminaire, body, box)) return;
                        buried.add(luminaire.id, luminaire.where);
                        solid.try_emplace({luminaire.where.line, luminaire.where.column}, body.id);
                      });
  buried.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_in_solid, first.where, first.id,
                       and_others(first.others), solid.at({first.where.line, first.where.column}));
  });
}

std::string luminaire_words(const Luminaire& luminaire) {
  if (!luminaire.id.empty()) return "'" + luminaire.id + "'";
  const glm::dvec3& p = luminaire.position_m;
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) m", p.x, p.y, p.z);
}

constexpr double kSamePlace_m = 0.010;
// Of luminaires with an opening it is a quarter of its shorter side: there is one housing only. No
// more than this, so that few luminaires have to be looked at.
constexpr double kMostSamePlace_m = 0.15;

double same_place_m(const PhotometricWeb& one, const PhotometricWeb& other) {
  const auto side_m = [](const PhotometricWeb& web) {
    const glm::dvec3 size_m = web.opening().size_m();
    return std::min(size_m.x, size_m.y);
  };
  return std::clamp(0.25 * std::min(side_m(one), side_m(other)), kSamePlace_m, kMostSamePlace_m);
}

// Two types may name the same file; every luminous surface is a type of its own.
bool have_same_light(const Project& project, std::size_t a, std::size_t b) {
  if (a == b) return true;
  const LuminaireType &first = project.luminaire_types[a], &second = project.luminaire_types[b];
  const PhotometricWeb &one = project.webs[first.web], &other = project.webs[second.web];
  return first.photometry_file == second.photometry_file && first.flux_scale == second.flux_scale &&
         one.flux_lm() == other.flux_lm() && one.max_intensity_cd() == other.max_intensity_cd() &&
         one.opening().size_m() == other.opening().size_m();
}

// Within a tenth: who changes a lumen has not made another luminaire of it.
bool have_about_same_light(const Project& project, std::size_t a, std::size_t b) {
  const LuminaireType &first = project.luminaire_types[a], &second = project.luminaire_types[b];
  const PhotometricWeb &one = project.webs[first.web], &other = project.webs[second.web];
  const auto is_about = [](double x, double y) {
    return std::abs(x - y) <= 0.1 * std::max(std::abs(x), std::abs(y));
  };
  const glm::dvec3 size_m = one.opening().size_m(), other_size_m = other.opening().size_m();
  return is_about(first.flux_scale * one.flux_lm(), second.flux_scale * other.flux_lm()) &&
         is_about(first.flux_scale * one.max_intensity_cd(),
                  second.flux_scale * other.max_intensity_cd()) &&
         is_about(size_m.x, other_size_m.x) && is_about(size_m.y, other_size_m.y);
}

// Of what shines alike all around a turn says nothing.
bool is_symmetric(const PhotometricWeb& web) {
  return web.is_axial() && web.opening().shape == OpeningShape::point;
}

// Other light at one place is the direct and the indirect part of one luminaire, other aims or
// turns are the heads of one mast, and light that is about the same in another group is another
// colour of one luminaire.
bool is_same_luminaire(const Project& project, const Luminaire& a, const Luminaire& b) {
  constexpr double kSameAim = 0.99985, kSameTurn = 0.966;  // cosines of 1 and 15 degrees
  const PhotometricWeb& one = project.webs[project.luminaire_types[a.type].web];
  const PhotometricWeb& other = project.webs[project.luminaire_types[b.type].web];
  const auto cosine = [&](glm::length_t axis) {
    return glm::dot(a.world_from_luminaire[axis], b.world_from_luminaire[axis]);
  };
  return glm::distance(a.position_m, b.position_m) < same_place_m(one, other) &&
         cosine(2) > kSameAim && (cosine(0) > kSameTurn || is_symmetric(one)) &&
         (have_same_light(project, a.type, b.type) ||
          (a.group == b.group && have_about_same_light(project, a.type, b.type)));
}

// Of what is nearer than a cell's size a place is in its own cell or one beside it.
class Cells {
 public:
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  explicit Cells(double size_m) : size_m_(size_m) {}
  Cell of(const glm::dvec3& p) const {
    const auto index = [&](double x_m) { return std::llround(x_m / size_m_); };
    return {index(p.x), index(p.y), index(p.z)};
  }
  template <class Visit>
  void for_each_near(const glm::dvec3& p, Visit visit) const {
    const Cell centre = of(p);
    for (int k = 0; k < 27; ++k) {
      visit(Cell{std::get<0>(centre) + k % 3 - 1, std::get<1>(centre) + k / 3 % 3 - 1,
                 std::get<2>(centre) + k / 9 - 1});
    }
  }

 private:
  double size_m_;
};

// Looks luminaires up by place, in cells of the largest distance that counts as none.
class Places {
 public:
  explicit Places(const Project& project) : project_(project) {}

  const Luminaire* like(const Luminaire& luminaire) const {
    const Luminaire* like = nullptr;
    cells_.for_each_near(luminaire.position_m, [&](const Cells::Cell& cell) {
      const auto found = in_cell_.find(cell);
      if (like != nullptr || found == in_cell_.end()) return;
      for (const Luminaire* other : found->second) {
        if (like == nullptr && is_same_luminaire(project_, *other, luminaire)) like = other;
      }
    });
    return like;
  }
  void add(const Luminaire& luminaire) {
    in_cell_[cells_.of(luminaire.position_m)].push_back(&luminaire);
  }

 private:
  const Project& project_;
  const Cells cells_{kMostSamePlace_m};
  std::map<Cells::Cell, std::vector<const Luminaire*>> in_cell_;
};

std::string place_words(const Luminaire& first, const Luminaire& second) {
  return first.where.file == second.where.file
             ? fmt::format("line {}", first.where.line)
             : fmt::format("{}:{}", first.where.file, first.where.line);
}

// Of so many the exact number tells nobody more.
constexpr std::size_t kMostCounted = 1000;

std::string likewise_words(std::size_t others) {
  if (others == 0) return {};
  const char* whose = others < kMostCounted ? "luminaires of this space likewise"
                                            : "luminaires of this space, or more, likewise";
  return fmt::format(" ({})", and_more(others, whose));
}

void warn_coincident_luminaires(const Project& project, const Space& space,
                                Diagnostics& diagnostics) {
  Places places(project);
  const Luminaire *first = nullptr, *pasted = nullptr;
  std::size_t others = 0;
  for (const Luminaire& luminaire : space.luminaires) {
    // A second emitter of one product may be where its first one is.
    if (!project.luminaire_types[luminaire.type].counts_as_luminaire()) continue;
    const Luminaire* same = places.like(luminaire);
    if (same == nullptr) {
      places.add(luminaire);
    } else if (pasted == nullptr) {
      first = same;
      pasted = &luminaire;
    } else {
      ++others;
    }
  }
  if (pasted == nullptr) return;
  diagnostics.report(
      DiagnosticId::luminaires_coincide, pasted->where, luminaire_words(*pasted),
      luminaire_words(*first), place_words(*first, *pasted),
      1.0e3 * std::max(kSamePlace_m, glm::distance(first->position_m, pasted->position_m)),
      likewise_words(others));
}

// Whether it gives other light behind than before: a head of a mast, and no panel.
bool looks_one_way(const PhotometricWeb& web) {
  constexpr double kNoted = 0.2;  // of the largest intensity
  for (int c = 0; c < 12; ++c) {
    for (int gamma = 1; gamma < 6; ++gamma) {
      const double c_rad = c * kPi / 12.0, gamma_rad = gamma * kPi / 12.0;
      const double before_cd = web.intensity_cd(c_rad, gamma_rad);
      const double behind_cd = web.intensity_cd(c_rad + kPi, gamma_rad);
      if (std::abs(before_cd - behind_cd) > kNoted * web.max_intensity_cd()) return true;
    }
  }
  return false;
}

// Two heads of one mast, which is one place in a plan.
bool are_back_to_back(const PhotometricWeb& web, const Luminaire& a, const Luminaire& b) {
  constexpr double kOtherWay = -0.966;  // cosine of 165 degrees
  return glm::distance(a.position_m, b.position_m) < kSamePlace_m &&
         glm::dot(a.world_from_luminaire[0], b.world_from_luminaire[0]) < kOtherWay &&
         looks_one_way(web);
}

// Whether the light of both may count where one covers the other. Another light at one place is the
// other part of one luminaire, and so is what looks the other way; a small one in a large one may
// be a spot in a panel.
bool may_be_two_parts(const Project& project, const Luminaire& a, const Luminaire& b) {
  const PhotometricWeb& one = project.webs[project.luminaire_types[a.type].web];
  const PhotometricWeb& other = project.webs[project.luminaire_types[b.type].web];
  if (are_back_to_back(one, a, b)) return true;
  if (have_same_light(project, a.type, b.type)) return false;
  if (a.group != b.group) return true;
  if (have_about_same_light(project, a.type, b.type)) return false;
  const auto area_m2 = [](const PhotometricWeb& web) {
    const glm::dvec3 size_m = web.opening().size_m();
    return size_m.x * size_m.y;
  };
  const double smaller_m2 = std::min(area_m2(one), area_m2(other));
  return glm::distance(a.position_m, b.position_m) < same_place_m(one, other) ||
         (downward_share(one) > 0.5) != (downward_share(other) > 0.5) ||
         smaller_m2 < 0.25 * std::max(area_m2(one), area_m2(other));
}

// Panels that lie in one another, turned or beside each other: a grid that was pasted and turned,
// or light that no ceiling has room for.
void warn_overlapping_luminaires(const Project& project, const Space& space,
                                 Diagnostics& diagnostics) {
  constexpr double kRims = 0.1;  // openings are stated with their frames
  struct Found {
    const Luminaire *first = nullptr, *second = nullptr;
    double share = 0.0;
  } found;
  std::size_t others = 0;
  const auto in_place = [&](const Luminaire& luminaire) {
    return OpeningInPlace{luminaire.position_m, luminaire.world_from_luminaire,
                          project.webs[project.luminaire_types[luminaire.type].web].opening()};
  };
  double largest_m = 0.0;
  std::vector<const Luminaire*> flat, large;
  for (const Luminaire& luminaire : space.luminaires) {
    const glm::dvec3 size_m = in_place(luminaire).opening.size_m();
    if (!(size_m.x * size_m.y > 0.0)) continue;
    if (!project.luminaire_types[luminaire.type].counts_as_luminaire()) continue;
    // Few are: they are compared with all.
    constexpr double kLarge_m = 4.0;
    const double across_m = glm::length(size_m);
    flat.push_back(&luminaire);
    if (across_m > kLarge_m) {
      large.push_back(&luminaire);
    } else {
      largest_m = std::max(largest_m, across_m);
    }
  }
  const Cells cells(largest_m + kOneBehind_m);
  std::map<Cells::Cell, std::vector<const Luminaire*>> in_cell;
  for (const Luminaire* luminaire : flat) {
    if (others >= kMostCounted) break;
    const auto covers = [&](const Luminaire* other) {
      if (may_be_two_parts(project, *other, *luminaire)) return false;
      if (is_same_luminaire(project, *other, *luminaire)) return false;  // told of as pasted
      const double share = overlap_share(in_place(*other), in_place(*luminaire));
      if (share < kRims) return false;
      if (found.second == nullptr) {
        found = {other, luminaire, share};
      } else {
        ++others;
      }
      return true;
    };
    const bool is_large = std::find(large.begin(), large.end(), luminaire) != large.end();
    const auto before = [&](const Luminaire* other) { return other < luminaire; };  // of one vector
    bool is_over_another = false;
    const auto look_at = [&](const std::vector<const Luminaire*>& others_here) {
      for (const Luminaire* other : others_here) {
        if (is_over_another || !before(other)) continue;
        is_over_another = covers(other);
      }
    };
    look_at(is_large ? flat : large);
    if (is_large) continue;
    cells.for_each_near(luminaire->position_m, [&](const Cells::Cell& cell) {
      if (const auto here = in_cell.find(cell); here != in_cell.end()) look_at(here->second);
    });
    in_cell[cells.of(luminaire->position_m)].push_back(luminaire);
  }
  if (found.second == nullptr) return;
  diagnostics.report(DiagnosticId::luminaires_overlap, found.second->where,
                     luminaire_words(*found.second), 100.0 * found.share,
                     luminaire_words(*found.first), place_words(*found.first, *found.second),
                     likewise_words(others));
}

void warn_lamp_tilts(const Project& project, const Space& space, Diagnostics& diagnostics) {
  constexpr double kDegrees = 180.0 / kPi;
  PerElement outside;
  std::map<std::pair<int, int>, const Luminaire*> first_at;
  for (const Luminaire& luminaire : space.luminaires) {
    const auto& tilt = project.webs[project.luminaire_types[luminaire.type].web].source().lamp_tilt;
    if (!tilt || covers(*tilt, lamp_tilt_rad(*tilt, luminaire.world_from_luminaire))) continue;
    outside.add(luminaire.id, luminaire.where);
    first_at.try_emplace({luminaire.where.line, luminaire.where.column}, &luminaire);
  }
  outside.report([&](const FirstOfElement& first) {
    const Luminaire& luminaire = *first_at.at({first.where.line, first.where.column});
    const auto& tilt =
        *project.webs[project.luminaire_types[luminaire.type].web].source().lamp_tilt;
    const double tilt_rad = lamp_tilt_rad(tilt, luminaire.world_from_luminaire);
    diagnostics.report(DiagnosticId::photometry_tilt_outside, first.where, first.id,
                       and_others(first.others), tilt_rad * kDegrees,
                       tilt.angle_rad.front() * kDegrees, tilt.angle_rad.back() * kDegrees,
                       tilt_factor(tilt, tilt_rad));
  });
}

void warn_cut_openings(const Project& project, const Space& space, Diagnostics& diagnostics) {
  PerElement cut;
  OpeningFit fit(space);
  for (const Luminaire& luminaire : space.luminaires) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    if (fit.is_cut(web.opening(), luminaire)) cut.add(luminaire.id, luminaire.where);
  }
  cut.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminous_body_cut, first.where, first.id,
                       and_others(first.others));
  });
}

}  // namespace

void warn_efficacies(const Project& project, Diagnostics& diagnostics) {
  // Less than any incandescent lamp in a shade, more than any luminaire on sale.
  constexpr double kLowest_lm_w = 5.0, kHighest_lm_w = 250.0;
  std::set<std::size_t> used;
  for (const Space& space : project.spaces) {
    for (const Luminaire& luminaire : space.luminaires) used.insert(luminaire.type);
  }
  struct Efficacy {
    const LuminaireType* type = nullptr;
    std::string name;  // within the quotes of the message
    double flux_lm = 0.0, power_w = 0.0;
    double lm_w() const { return flux_lm / power_w; }
  };
  std::vector<Efficacy> unusual;
  const auto look_at = [&](const Efficacy& one) {
    if (!(one.power_w > 0.0)) return;
    if (one.lm_w() < kLowest_lm_w || one.lm_w() > kHighest_lm_w) unusual.push_back(one);
  };
  for (const std::size_t index : used) {
    const LuminaireType& type = project.luminaire_types[index];
    look_at({&type, type.id, luminaire_flux_lm(project, type), type.power_w});
    for (std::size_t p = 0; p < type.packages.size(); ++p) {
      if (p == type.package) continue;
      const LampPackage& package = type.packages[p];
      look_at({&type, fmt::format("{}' with '{}", type.id, package.article), package.flux_lm,
               package.power_w});
    }
  }
  warn_of_first_few<Efficacy>(unusual, "types", [&](const Efficacy& one, const std::string& more) {
    diagnostics.report(DiagnosticId::efficacy_unusual, one.type->where, one.name, more, one.flux_lm,
                       one.power_w, one.lm_w(), kLowest_lm_w, kHighest_lm_w);
  });
}

void warn_luminaires(const Project& project, const Space& space, Diagnostics& diagnostics) {
  if (space.shell) {
    warn_luminaires_outside(space, diagnostics);
    warn_luminaires_partly_outside(project, space, diagnostics);
    warn_surfaces_that_face_out(project, space, diagnostics);
  }
  for (const Body& body : space.bodies) {
    if (body.encloses_room) warn_luminaires_outside_mesh(space, body, diagnostics);
  }
  warn_luminaires_in_solids(project, space, diagnostics);
  warn_luminaires_partly_in_solids(project, space, diagnostics);
  warn_coincident_luminaires(project, space, diagnostics);
  warn_overlapping_luminaires(project, space, diagnostics);
  warn_lamp_tilts(project, space, diagnostics);
  warn_cut_openings(project, space, diagnostics);
}

const Luminaire* luminaire_of_lost_light(const Project& project, const Space& space,
                                         const LightScene* scene) {
  const auto is_lit = [&](const Luminaire& luminaire) {
    return level_in_scene(scene, luminaire.group) > 0.0;
  };
  const auto loses_a_part = [&](const Luminaire& luminaire) {
    constexpr double kTrifle = 0.01;  // of its size: panels beside walls reach into them by as much
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    return reach_outside_m(project, space, luminaire) >
           kTrifle * glm::length(web.opening().size_m());
  };
  const Body* around = nullptr;
  for (const Body& body : space.bodies) {
    if (body.encloses_room) around = &body;
  }
  const BoundingBox box_around = around == nullptr ? BoundingBox{} : bounding_box(around->vertex_m);
  for (const Luminaire& luminaire : space.luminaires) {
    if (!is_lit(luminaire)) continue;
    if (space.shell &&
        (!room_contains(*space.shell, luminaire.position_m) || loses_a_part(luminaire) ||
         is_surface_that_faces_out(project, space, luminaire))) {
      return &luminaire;
    }
    if (around != nullptr &&
        locate_point(*around, box_around, luminaire.position_m) == SolidSide::outside) {
      return &luminaire;
    }
  }
  const Luminaire* in_solid = nullptr;
  for_each_near_solid(
      project, space, [&](const Luminaire& luminaire, const Body& body, const BoundingBox& box) {
        if (in_solid != nullptr || !is_lit(luminaire)) return;
        const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
        if (is_in_solid(luminaire, body, box) ||
            reaches_into_solid(web.opening(), luminaire, body, box)) {
          in_solid = &luminaire;
        }
      });
  return in_solid;
}

}  // namespace calc
