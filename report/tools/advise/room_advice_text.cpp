#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/advise/advice_words.h"
#include "report/tools/advise/room_advice.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

std::string room_heading(const std::string& scene, const std::string& space, const char* about) {
  return fmt::format("{}, {}: {}\n", scene_words(scene), report::printable(space), about);
}

std::string asked_on_plane(const RoomRequirement& one) {
  return fmt::format("{}: {}", report::printable(one.plane), asked_words(one.before.requirement));
}

// Of a least value light was followed from some of its points: elsewhere less may be added.
std::string points_words(const RoomRequirement& one) {
  return one.points > 0 && one.points < one.of_points
             ? fmt::format(", by {} of its {} points", one.points, one.of_points)
             : "";
}

std::string place_words(const AdvisedPlace& place, bool is_by_flux) {
  return fmt::format("{} at {}{}, {}", report::printable(place.type),
                     report::format_position(place.position_m),
                     place.group.empty() ? "" : ", group " + report::printable(place.group),
                     cost_words(place.cost, is_by_flux));
}

std::string place_check_words(const CheckedPlaces& checked,
                              const std::vector<RoomRequirement>& requirements,
                              std::size_t passing_before) {
  if (!checked.problem.empty()) {
    return fmt::format("      not checked: {}\n", report::printable(checked.problem));
  }
  std::string text =
      fmt::format("      checked with other random numbers: {} of {} pass, before {}\n",
                  checked.passing, checked.asked, passing_before);
  for (std::size_t r = 0; r < requirements.size(); ++r) {
    const std::string gain =
        checked.places.size() == 1
            ? fmt::format(" (expected to add {}{})",
                          report::format_measured(checked.places.front().gain_lx[r], "lx"),
                          points_words(requirements[r]))
            : "";
    text += fmt::format("        {}: {}, now {}{}, {}\n", asked_on_plane(requirements[r]),
                        value_words(checked.after[r]), value_words(requirements[r].before), gain,
                        calc::name_of(checked.after[r].verdict));
  }
  for (const std::string& one : checked.broken) {
    text += fmt::format("        no longer met: {}\n", report::printable(one));
  }
  return text;
}

std::string left_out_words(const std::vector<std::string>& left_out) {
  std::string text;
  for (const std::string& one : left_out) {
    text += fmt::format("  Not considered: {}\n", report::printable(one));
  }
  return text;
}

std::string places_text(const RoomPlaces& room) {
  std::string text = room_heading(room.scene, room.space, "where one more luminaire helps most");
  if (!room.problem.empty()) {
    return text + fmt::format("  No advice: {}\n", report::printable(room.problem)) +
           left_out_words(room.left_out);
  }
  text += fmt::format(
      "  {} free places of {}, every {:.2f} x {:.2f} m, mounted as others in this room and at\n  "
      "least {:.2f} m from any of them; the best by the light that each adds for its {}:\n",
      room.places.size(), room.cells, room.step_m.x, room.step_m.y, room.least_distance_m,
      room.is_by_flux ? "lumens (the power of a luminaire is not known)" : "watts");
  for (const CheckedPlaces& one : room.best) {
    text += fmt::format("    {}\n", place_words(one.places.front(), room.is_by_flux)) +
            place_check_words(one, room.requirements, room.passing);
  }
  if (room.together) {
    double cost = 0.0;
    for (const AdvisedPlace& place : room.together->places) cost += place.cost;
    text += fmt::format(
        "    {} together, {}{}:\n", room.together->places.size(), cost_words(cost, room.is_by_flux),
        room.together->broken.empty() ? "" : ", but another requirement is no longer met");
    for (const AdvisedPlace& place : room.together->places) {
      text += fmt::format("      {}\n", place_words(place, room.is_by_flux));
    }
    text += place_check_words(*room.together, room.requirements, room.passing);
  }
  return text + left_out_words(room.left_out);
}

std::string turn_words(const AdvisedTurn& turn) {
  const std::string way =
      turn.tilt_deg == 0.0
          ? fmt::format("turned by {:g} degrees, counter-clockwise from behind", turn.turn_deg)
          : fmt::format("tilted by {:g} degrees towards its C{:g}", turn.tilt_deg,
                        turn.tilt_to_deg);
  return fmt::format("{} ({}) at {}: {}", report::printable(turn.id),
                     report::printable(turn.place.type),
                     report::format_position(turn.place.position_m), way);
}

std::string turns_text(const RoomTurns& room) {
  std::string text = room_heading(room.scene, room.space, "which luminaires to turn or tilt");
  if (!room.problem.empty()) {
    return text + fmt::format("  None: {}\n", report::printable(room.problem)) +
           left_out_words(room.left_out);
  }
  text += fmt::format(
      "  {} luminaires in {} other ways; the best by the light that each surely adds:\n",
      room.luminaires, room.tried);
  for (const CheckedTurns& one : room.best) {
    text += fmt::format("    {}\n", turn_words(one.turns.front())) +
            place_check_words(one.check, room.requirements, room.passing);
  }
  if (room.together) {
    text += fmt::format(
        "    {} together{}:\n", room.together->turns.size(),
        room.together->check.broken.empty() ? "" : ", but another requirement is no longer met");
    for (const AdvisedTurn& turn : room.together->turns) {
      text += fmt::format("      {}\n", turn_words(turn));
    }
    text += place_check_words(room.together->check, room.requirements, room.passing);
  }
  return text + left_out_words(room.left_out);
}

std::string spare_text(const RoomSpare& room) {
  std::string text =
      fmt::format("{}: which luminaires can be removed\n", report::printable(room.space));
  if (!room.problem.empty()) {
    return text + fmt::format("  None: {}\n", report::printable(room.problem));
  }
  double cost = 0.0;
  for (const SpareLuminaire& one : room.luminaires) cost += one.cost;
  text += fmt::format(
      "  {} of {}, {}; checked with other random numbers, {} of {} requirements of all rooms and "
      "scenes pass\n",
      room.luminaires.size(), room.of, cost_words(cost, room.is_by_flux), room.passing, room.asked);
  for (const SpareLuminaire& one : room.luminaires) {
    text += fmt::format("    {} ({}) at {}\n", report::printable(one.id),
                        report::printable(one.type), report::format_position(one.position_m));
  }
  return text;
}

std::string surfaces_text(const RoomSurfaces& room) {
  std::string text = room_heading(room.scene, room.space,
                                  "what 0.1 more reflectance adds, with nothing else changed");
  if (!room.problem.empty()) {
    return text + fmt::format("  No advice: {}\n", report::printable(room.problem));
  }
  for (const LighterSurface& surface : room.surfaces) {
    text += fmt::format("    {} ({:.2f} now)\n", surface.surface, surface.reflectance);
    for (std::size_t r = 0; r < room.requirements.size(); ++r) {
      const std::string then =
          surface.after.empty()
              ? ""
              : fmt::format("; checked {}, now {}, {}", value_words(surface.after[r]),
                            value_words(room.requirements[r].before),
                            calc::name_of(surface.after[r].verdict));
      text +=
          fmt::format("      {}: {}, as it begins {}{}{}\n", asked_on_plane(room.requirements[r]),
                      report::format_measured(surface.step_lx[r], "lx"),
                      report::format_measured(surface.slope_lx[r], "lx"),
                      points_words(room.requirements[r]), then);
    }
    if (!surface.problem.empty()) {
      text += fmt::format("      not checked: {}\n", report::printable(surface.problem));
    }
  }
  return text;
}

}  // namespace

std::string render_room_advice_text(const RoomAdvice& advice) {
  std::string text;
  if (advice.places) {
    if (advice.places->empty()) {
      text += "\nNo place was considered: no requirement lacks light that levels cannot give.\n";
    }
    for (const RoomPlaces& room : *advice.places) text += "\n" + places_text(room);
  }
  if (advice.spare) {
    for (const RoomSpare& room : *advice.spare) text += "\n" + spare_text(room);
  }
  if (advice.turns) {
    if (advice.turns->empty()) {
      text += "\nNo luminaire was turned: no requirement lacks light that levels cannot give.\n";
    }
    for (const RoomTurns& room : *advice.turns) text += "\n" + turns_text(room);
  }
  if (advice.surfaces) {
    if (advice.surfaces->empty()) {
      text += "\nNo surface was considered: no requirement is a lower limit of illuminance.\n";
    }
    for (const RoomSurfaces& room : *advice.surfaces) text += "\n" + surfaces_text(room);
  }
  return text;
}

}  // namespace cli
