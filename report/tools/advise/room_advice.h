#pragma once
// Results of `advise` about places and surfaces of a room: plain data.

#include "calc/base/field.h"
#include "rules/catalogue/finding.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// A requirement of the scene in this room.
struct RoomRequirement {
  std::string plane;  // as reports title it
  rules::Finding before;
  std::size_t points = 0;     // of the plane that light was followed from; 0: their mean
  std::size_t of_points = 0;  // that count
};

struct AdvisedPlace {
  std::string type, group;
  glm::dvec3 position_m{0.0}, c0{0.0}, axis{0.0};  // world
  double cost = 0.0;                               // W or lm
  // [requirement]: the gain from this luminaire alone, by reciprocity.
  std::vector<calc::Estimate> gain_lx;
  // Share of the missing light, by the lower ends of gains, on average over the requirements, in
  // [0, 1].
  double share = 0.0;
};

// The project with these additional luminaires, checked with other random numbers.
struct CheckedPlaces {
  std::vector<AdvisedPlace> places;
  std::vector<rules::Finding> after;   // [requirement]; empty: there was no check
  std::size_t passing = 0, asked = 0;  // of all that count in the scene, in all rooms
  std::vector<std::string> broken;     // what passed and no longer does, in words
  std::string problem;                 // why it could not be checked
};

struct RoomPlaces {
  std::string scene, space, space_id;
  // For a map: outline and existing luminaires of the room, world.
  std::vector<glm::dvec2> outline_m, luminaires_m;
  bool is_by_flux = false;                    // costs are lumens
  std::string problem;                        // why there is no advice; "" = there is
  std::vector<RoomRequirement> requirements;  // that more light would help
  glm::dvec2 step_m{0.0};                     // of the grid of places
  double least_distance_m = 0.0;              // from luminaires
  std::size_t cells = 0;                      // of the grid, for all ways of mounting together
  std::vector<std::string> left_out;          // types that were not looked at, and why
  std::size_t passing = 0, asked = 0;         // as of CheckedPlaces, before
  std::vector<AdvisedPlace> places;           // free ones, best first
  std::vector<CheckedPlaces> best;            // one luminaire more
  std::optional<CheckedPlaces> together;      // as many as it takes, by the same light
};

// An existing luminaire with another aim.
struct AdvisedTurn {
  std::string id;
  std::size_t luminaire = 0;  // of the room, from 0
  AdvisedPlace place;         // as it would hang; gains against now, no cost
  // Turn about its axis, counter-clockwise seen from behind (from above, if it shines down); or
  // tilt of its axis towards its own C plane `tilt_to_deg`. Degrees; one of the two is 0.
  double turn_deg = 0.0, tilt_deg = 0.0, tilt_to_deg = 0.0;
};

struct CheckedTurns {
  std::vector<AdvisedTurn> turns;
  CheckedPlaces check;  // its places are those of the turns
};

struct RoomTurns {
  std::string scene, space, space_id;
  std::string problem;  // why there is no advice; "" = there is
  std::vector<RoomRequirement> requirements;
  std::vector<std::string> left_out;      // luminaires that were not looked at, and why
  std::size_t luminaires = 0, tried = 0;  // that were looked at, and in how many ways together
  std::size_t passing = 0, asked = 0;     // as of CheckedPlaces, before
  std::vector<AdvisedTurn> turns;         // that surely mend something, best first
  std::vector<CheckedTurns> best;         // one luminaire; those that mend most
  std::optional<CheckedTurns> together;   // of several, each as it mends most
};

struct LighterSurface {
  std::string surface;       // "floor", "ceiling", "walls"
  double reflectance = 0.0;  // by area
  // [requirement]: the gain of 0.1 more reflectance at the initial slope, and the real gain.
  std::vector<calc::Estimate> slope_lx, step_lx;
  std::vector<rules::Finding> after;  // [requirement], checked; empty: it was not
  std::string problem;                // why it was not
};
inline constexpr double kReflectanceStep = 0.1;

struct RoomSurfaces {
  std::string scene, space, space_id;
  std::string problem;
  std::vector<RoomRequirement> requirements;
  std::vector<LighterSurface> surfaces;
};

struct SpareLuminaire {
  std::string id, type, group;
  glm::dvec3 position_m{0.0};
  double cost = 0.0;  // W or lm
};

// A room in which all requirements are met in all scenes.
struct RoomSpare {
  std::string space, space_id;
  bool is_by_flux = false;
  std::string problem;                     // why there is no advice; "" = there is
  std::vector<SpareLuminaire> luminaires;  // that can go together, as a check has confirmed
  std::size_t of = 0;                      // that the room has
  std::size_t passing = 0, asked = 0;      // of all scenes and rooms in that check
};

struct RoomAdvice {
  // Empty: not requested.
  std::optional<std::vector<RoomPlaces>> places;
  std::optional<std::vector<RoomSpare>> spare;  // together with places
  std::optional<std::vector<RoomSurfaces>> surfaces;
  std::optional<std::vector<RoomTurns>> turns;
};

std::string render_room_advice_text(const RoomAdvice& advice);

}  // namespace cli
