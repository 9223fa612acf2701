#include "calc/glare/room_ugr.h"

#include "calc/base/elementary.h"
#include "calc/base/glare_limits.h"
#include "calc/base/sentences.h"
#include "calc/base/units.h"
#include "calc/glare/mean_luminance.h"
#include "calc/glare/ugr_table.h"
#include "calc/scene/joined_openings.h"
#include "calc/scene/polygon.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr std::size_t kMostKinds = 16;  // of luminaires: more are no regular array
constexpr double kSmallestRoom = 2.0, kLargestRoom = 12.0;  // of tables, in H
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The room in plan, along its longest wall.
struct Rectangle {
  glm::dvec2 along{1.0, 0.0}, corner_m{0.0};  // the corner with the smallest coordinates
  glm::dvec2 side_m{0.0};

  glm::dvec2 across() const { return {-along.y, along.x}; }
  // From the corner.
  glm::dvec2 place_m(const glm::dvec3& world_m) const {
    const glm::dvec2 from = glm::dvec2(world_m) - corner_m;
    return {glm::dot(from, along), glm::dot(from, across())};
  }
};

// Empty: it is none, but for what drawings are out of square.
std::optional<Rectangle> rectangle_of(const std::vector<glm::dvec2>& footprint_m) {
  constexpr double kMostMissing = 0.01;  // share of its area
  Rectangle found;
  double longest_m = 0.0;
  for (std::size_t i = 0; i < footprint_m.size(); ++i) {
    const glm::dvec2 edge = footprint_m[(i + 1) % footprint_m.size()] - footprint_m[i];
    if (!(glm::length(edge) > longest_m)) continue;
    longest_m = glm::length(edge);
    found.along = edge / longest_m;
  }
  glm::dvec2 lower(kInfinite), upper(-kInfinite);
  for (const glm::dvec2& corner : footprint_m) {
    const glm::dvec2 at(glm::dot(corner, found.along), glm::dot(corner, found.across()));
    lower = glm::min(lower, at);
    upper = glm::max(upper, at);
  }
  found.side_m = upper - lower;
  found.corner_m = lower.x * found.along + lower.y * found.across();
  const double area_m2 = found.side_m.x * found.side_m.y;
  const double missing_m2 = area_m2 - std::abs(signed_area(footprint_m));
  if (!(area_m2 > 0.0) || missing_m2 > kMostMissing * area_m2) return std::nullopt;
  return found;
}

// Mean of the surfaces of the room whose ids begin so, by area.
double mean_reflectance(const Project& project, const Space& space, const std::string& prefix) {
  double area_m2 = 0.0, reflected_m2 = 0.0;
  for (const Body& body : space.bodies) {
    if (!body.id.starts_with(prefix)) continue;
    for (std::size_t i = 0; i < body.triangle.size(); ++i) {
      const glm::uvec3 corner = body.triangle[i];
      const glm::dvec3 a = body.vertex_m[corner.x];
      const double own_m2 =
          0.5 * glm::length(glm::cross(body.vertex_m[corner.y] - a, body.vertex_m[corner.z] - a));
      area_m2 += own_m2;
      reflected_m2 += own_m2 * project.materials[body.material_of[i]].reflectance;
    }
  }
  return area_m2 > 0.0 ? reflected_m2 / area_m2 : 0.0;
}

// No more than the brightest column of tables.
UgrReflectances counted_reflectances(const Project& project, const Space& space) {
  const UgrReflectances& most = kUgrReflectances[0];
  const auto mean = [&](const char* part, double at_most) {
    return std::min(at_most, mean_reflectance(project, space, space.id + part));
  };
  return {mean(".ceiling", most.ceiling), mean(".wall", most.walls), mean(".floor", most.floor)};
}

// Luminaires that give the same light in the same way.
struct Kind {
  const Luminaire* first = nullptr;
  const PhotometricWeb* web = nullptr;
  double flux_scale = 1.0;
  double height_m = 0.0;  // H, above the eyes
  std::vector<glm::dvec2> place_m;
};

constexpr double kLevel = 0.9998;  // cosine of one degree
constexpr double kSameHeight_m = 0.01;

// Why a luminaire that gives light hangs in no way that the method is for; "" = it does.
Message why_misplaced(const Luminaire& luminaire, const Space& space, const Rectangle& room) {
  constexpr double kInRoom_m = 0.05;
  const glm::dmat3& turned = luminaire.world_from_luminaire;
  if (!(std::abs(turned[2].z) >= kLevel)) return say<Sentence::ugr_table_tilted>(luminaire.id);
  const double above_floor_m = luminaire.position_m.z - space.shell->floor_z_m;
  if (!(above_floor_m > kSeatedEye_m)) {
    return say<Sentence::ugr_table_too_low>(luminaire.id, above_floor_m, kSeatedEye_m);
  }
  const glm::dvec2 place_m = room.place_m(luminaire.position_m);
  const bool is_inside = above_floor_m <= space.shell->height_m + kInRoom_m &&
                         glm::all(glm::greaterThanEqual(place_m, glm::dvec2(-kInRoom_m))) &&
                         glm::all(glm::lessThanEqual(place_m, room.side_m + kInRoom_m));
  return is_inside ? Message() : say<Sentence::ugr_table_outside>(luminaire.id);
}

bool shines_down(const Luminaire& luminaire, const PhotometricWeb& web) {
  const bool is_upright = luminaire.world_from_luminaire[2].z > 0.0;
  return (is_upright ? web.zonal_flux_lm(0.0, 0.5 * kPi) : web.zonal_flux_lm(0.5 * kPi, kPi)) > 0.0;
}

// The most that eyes below see of it, whatever way they look.
double seen_area_m2(const Luminaire& luminaire, const PhotometricWeb& web) {
  constexpr int kGammas = 6, kPlanes = 24;  // of 15 degrees
  const double down = luminaire.world_from_luminaire[2].z > 0.0 ? -1.0 : 1.0;
  const MeanLuminance opening(web);
  double most_m2 = 0.0;
  for (int g = 0; g <= kGammas; ++g) {
    const double gamma = 0.5 * kPi * g / kGammas;
    for (int p = 0; p < kPlanes; ++p) {
      const double c = 2.0 * kPi * p / kPlanes;
      most_m2 = std::max(
          most_m2, opening.area_m2({calc::sin(gamma) * calc::cos(c),
                                    calc::sin(gamma) * calc::sin(c), down * calc::cos(gamma)}));
    }
  }
  return most_m2;
}

// Why its opening is none for the formula; "" = it is one, or nobody sees it.
Message why_unfit(const Luminaire& luminaire, const PhotometricWeb& web) {
  if (!shines_down(luminaire, web)) return {};
  const double area_m2 = seen_area_m2(luminaire, web);
  if (!(area_m2 > 0.0)) return say<Sentence::ugr_table_no_area>(luminaire.id);
  return area_m2 > kLargestGlareSource_m2
             ? say<Sentence::ugr_table_too_large>(luminaire.id, area_m2, kLargestGlareSource_m2)
             : Message();
}

// The same of openings that make one, as the tiles of a luminous ceiling do.
Message why_joined_unfit(const Project& project, const std::vector<const Luminaire*>& lit) {
  std::vector<OpeningInPlace> openings;
  std::vector<const Luminaire*> of;
  for (const Luminaire* luminaire : lit) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire->type].web];
    if (!shines_down(*luminaire, web)) continue;
    openings.push_back({luminaire->position_m, luminaire->world_from_luminaire, web.opening()});
    of.push_back(luminaire);
  }
  for (const JoinedOpening& joined : joined_openings(openings)) {
    double area_m2 = 0.0;
    for (const std::size_t i : joined.members) {
      area_m2 += seen_area_m2(*of[i], project.webs[project.luminaire_types[of[i]->type].web]);
    }
    if (area_m2 <= kLargestGlareSource_m2) continue;
    return say<Sentence::ugr_table_joined>(joined.members.size(), of[joined.members.front()]->id,
                                           area_m2, kLargestGlareSource_m2);
  }
  return {};
}

// Give the same light in the same direction from the same height, but for what nobody sees.
bool are_alike(const Kind& kind, const Kind& other) {
  if (kind.web != other.web || kind.flux_scale != other.flux_scale) return false;
  if (std::abs(kind.height_m - other.height_m) > kSameHeight_m) return false;
  const glm::dmat3& a = kind.first->world_from_luminaire;
  const glm::dmat3& b = other.first->world_from_luminaire;
  return glm::dot(a[0], b[0]) >= kLevel && glm::dot(a[2], b[2]) >= kLevel;
}

// In order of their first luminaires.
std::vector<Kind> kinds_of(const Project& project, const Space& space, const LightScene* scene,
                           const Rectangle& room, Message& problem) {
  std::vector<Kind> kinds;
  std::vector<const Luminaire*> lit;
  for (const Luminaire& luminaire : space.luminaires) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    const double flux_scale =
        installed_flux_scale(project, luminaire) * level_in_scene(scene, luminaire.group);
    if (!(web.flux_lm() * flux_scale > 0.0)) continue;
    problem = why_misplaced(luminaire, space, room);
    if (!problem.empty()) return {};
    Kind kind{&luminaire,
              &web,
              flux_scale,
              luminaire.position_m.z - space.shell->floor_z_m - kSeatedEye_m,
              {}};
    const auto same = std::find_if(kinds.begin(), kinds.end(),
                                   [&](const Kind& other) { return are_alike(kind, other); });
    if (same == kinds.end()) {
      problem = kinds.size() < kMostKinds ? why_unfit(luminaire, web)
                                          : say<Sentence::ugr_table_many>(kMostKinds);
      if (!problem.empty()) return {};
    }
    Kind& found = same == kinds.end() ? kinds.emplace_back(std::move(kind)) : *same;
    found.place_m.push_back(room.place_m(luminaire.position_m));
    lit.push_back(&luminaire);
  }
  problem = why_joined_unfit(project, lit);
  if (!problem.empty()) return {};
  return kinds;
}

// Places along one side of the room as lines, each with how many stand on it. Ascending.
std::vector<std::pair<double, int>> lines_of(const std::vector<glm::dvec2>& places, int axis) {
  constexpr double kSameLine_m = 0.1;
  std::vector<double> all;
  for (const glm::dvec2& place : places) all.push_back(place[axis]);
  std::sort(all.begin(), all.end());
  std::vector<std::pair<double, int>> lines;
  for (const double at_m : all) {
    if (lines.empty() || at_m - lines.back().first > kSameLine_m) lines.emplace_back(at_m, 0);
    ++lines.back().second;
  }
  return lines;
}

// Every line has as many, and neither a gap between two nor twice the one to a wall is more than
// half as wide again as if they were spread exactly.
bool is_even(const std::vector<std::pair<double, int>>& lines, double side_m) {
  constexpr double kWidest = 1.5;
  const double most_m = kWidest * side_m / static_cast<double>(lines.size());
  if (2.0 * lines.front().first > most_m || 2.0 * (side_m - lines.back().first) > most_m) {
    return false;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].second != lines[0].second) return false;
    if (i > 0 && lines[i].first - lines[i - 1].first > most_m) return false;
  }
  return true;
}

// Luminaires of one photometry, however they are turned and dimmed.
bool is_even(const std::vector<glm::dvec2>& places_m, const Rectangle& room) {
  const auto columns = lines_of(places_m, 0), rows = lines_of(places_m, 1);
  return columns.size() * rows.size() == places_m.size() && is_even(columns, room.side_m.x) &&
         is_even(rows, room.side_m.y);
}

// Of eyes that look one way: of all kinds together, and of the worst alone.
struct Rating {
  double together, worst;
};

// luminaires: of the kinds, as these eyes see them.
Rating rating_of(const std::vector<Kind>& kinds, const std::vector<UgrLuminaire>& luminaires,
                 const UgrReflectances& reflectances, const glm::dvec2& across_and_along_m) {
  double sources = 0.0, background = 0.0, worst = -kInfinite;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Kind& kind = kinds[k];
    const glm::dvec2 room =
        glm::clamp(across_and_along_m / kind.height_m, kSmallestRoom, kLargestRoom);
    const UgrArray array = luminaires[k].in_room(room.x, room.y);
    const double own_sources = array.sources * kind.flux_scale * kind.flux_scale;
    const double own_background = array.background(reflectances) * kind.flux_scale;
    worst = std::max(worst, ugr_of(own_sources, own_background));
    const double weight =
        static_cast<double>(kind.place_m.size()) / (kind.height_m * kind.height_m);
    sources += weight * own_sources;
    background += weight * own_background;
  }
  return {ugr_of(sources, background), worst};
}

// Of eyes that look along the room, across it, and back both ways.
Rating rating_of(const std::vector<Kind>& kinds, const UgrReflectances& reflectances,
                 const Rectangle& room) {
  const glm::dmat3 world_from_room(glm::dvec3(-room.across(), 0.0), glm::dvec3(room.along, 0.0),
                                   glm::dvec3(0.0, 0.0, 1.0));
  std::vector<UgrLuminaire> luminaires;
  for (const Kind& kind : kinds) {
    luminaires.emplace_back(*kind.web,
                            glm::transpose(world_from_room) * kind.first->world_from_luminaire);
  }
  Rating most{-kInfinite, -kInfinite};
  glm::dvec2 across_and_along_m(room.side_m.y, room.side_m.x);
  constexpr int kDirections = 4;
  for (int turns = 0; turns < kDirections; ++turns) {
    const Rating rating = rating_of(kinds, luminaires, reflectances, across_and_along_m);
    most.together = std::max(most.together, rating.together);
    most.worst = std::max(most.worst, rating.worst);
    for (UgrLuminaire& luminaire : luminaires) luminaire = luminaire.from_a_quarter_turn();
    std::swap(across_and_along_m.x, across_and_along_m.y);
  }
  return most;
}

// What a rating is calculated from.
struct Arrays {
  Message problem;
  Rectangle room;
  std::vector<Kind> kinds;
};

Arrays arrays_of(const Project& project, const Space& space, const LightScene* scene) {
  Arrays arrays;
  const auto refuse = [&arrays](Message why) {
    arrays.problem = std::move(why);
    return arrays;
  };
  if (!space.shell) return refuse(say<Sentence::ugr_table_no_room>());
  const std::optional<Rectangle> room = rectangle_of(space.shell->footprint_m);
  if (!room) return refuse(say<Sentence::ugr_table_not_rectangular>());
  arrays.room = *room;
  arrays.kinds = kinds_of(project, space, scene, *room, arrays.problem);
  if (!arrays.problem.empty()) return arrays;
  if (arrays.kinds.empty()) {
    return refuse(space.luminaires.empty() ? say<Sentence::no_luminaire>()
                                           : say<Sentence::ugr_table_unlit>());
  }
  for (const Kind& kind : arrays.kinds) {
    std::vector<glm::dvec2> places_m;
    for (const Kind& other : arrays.kinds) {
      if (other.web != kind.web || std::abs(other.height_m - kind.height_m) > kSameHeight_m)
        continue;
      places_m.insert(places_m.end(), other.place_m.begin(), other.place_m.end());
    }
    if (!is_even(places_m, *room)) return refuse(say<Sentence::ugr_table_uneven>(kind.first->id));
  }
  return arrays;
}

}  // namespace

Message why_no_room_ugr(const Project& project, const Space& space, const LightScene* scene) {
  return arrays_of(project, space, scene).problem;
}

RoomUgr room_ugr(const Project& project, const Space& space, const LightScene* scene) {
  RoomUgr result;
  const Arrays arrays = arrays_of(project, space, scene);
  result.problem = arrays.problem;
  if (!result.problem.empty()) return result;
  const Rectangle& room = arrays.room;
  const UgrReflectances reflectances = counted_reflectances(project, space);
  const Rating most = rating_of(arrays.kinds, reflectances, room);
  if (most.together == kInfinite || most.worst == kInfinite) {
    result.problem = say<Sentence::ugr_table_dark>();
    return result;
  }
  const bool is_mixture = arrays.kinds.size() > 1;
  result.ugr = {most.together, most.together,
                is_mixture ? std::max(most.together, most.worst) : most.together};
  double lowest_m = kInfinite;
  for (const Kind& kind : arrays.kinds) lowest_m = std::min(lowest_m, kind.height_m);
  const glm::dvec2 sides = room.side_m / lowest_m;
  result.words = say<Sentence::ugr_by_table>(sides.x, sides.y, lowest_m, kSeatedEye_m,
                                             reflectances.ceiling, reflectances.walls,
                                             reflectances.floor, kUgrSpacing, kUgrTablesDiffer);
  const glm::dvec2 counted = glm::clamp(sides, kSmallestRoom, kLargestRoom);
  if (counted != sides) {
    result.words +=
        "; " + say<Sentence::ugr_table_ends>(counted.x, counted.y, kSmallestRoom, kLargestRoom);
  }
  if (is_mixture) result.words += "; " + say<Sentence::ugr_table_mixture>(arrays.kinds.size());
  return result;
}

}  // namespace calc
