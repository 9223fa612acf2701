#include "report/text/plane_names.h"

#include "report/document/looked_at_wall.h"
#include "report/text/words.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace report {
namespace {

std::string with_blanks(std::string_view role) {
  std::string words(role);
  std::replace(words.begin(), words.end(), '.', ' ');
  return words;
}

// "Desk [0,0]" of "Desk [0,0]: task"; "" of a plane that no workplace has made, or that several
// share.
std::string place_of(const PlanePart& plane) {
  const std::string role = made_role(plane);
  const std::string title(title_of(plane.name, plane.id));
  if (role.empty() || title.size() == role.size()) return {};
  return title.substr(0, title.size() - role.size() - std::string_view(": ").size());
}

// The room's planes that workplaces have made are all of one place, which need not be named.
bool is_of_only_place(const SpacePart& space, const std::string& own) {
  return std::all_of(space.planes.begin(), space.planes.end(), [&](const PlanePart& other) {
    const std::string place = place_of(other);
    return place.empty() || place == own;
  });
}

// The first letter of texts of ours: ASCII, or one of Latin-1 with its small letter 0x20 behind;
// \xB7 is the sign of division.
std::string with_capital(std::string words) {
  const auto lower = [](char& c, char first, char last) {
    if (c >= first && c <= last) c = static_cast<char>(c - 0x20);
  };
  if (words.size() > 1 && words[0] == '\xC3' && words[1] != '\xB7') {
    lower(words[1], '\xA0', '\xBE');
  } else if (!words.empty()) {
    lower(words[0], 'a', 'z');
  }
  return words;
}

std::string in_place(const Texts& t, const SpacePart& space, const PlanePart& plane,
                     const std::string& words) {
  const std::string place = place_of(plane);
  return place.empty() || is_of_only_place(space, place) ? words : place + t[Text::colon] + words;
}

// Of "wall.2" that of walls; nothing of roles that only rule packs of the user's own have.
std::optional<Text> known_role(std::string_view role) {
  constexpr std::pair<std::string_view, Text> kRoles[] = {{"task", Text::role_task},
                                                          {"surround", Text::role_surround},
                                                          {"background", Text::role_background},
                                                          {"wall", Text::role_wall},
                                                          {"ceiling", Text::role_ceiling},
                                                          {"cylinder", Text::role_cylinder},
                                                          {"modelling", Text::role_modelling},
                                                          {"observer", Text::role_observer},
                                                          {"lamp", Text::role_lamp},
                                                          {"glare", Text::role_glare},
                                                          {"room", Text::role_room},
                                                          {"floor", Text::role_floor},
                                                          {"window", Text::role_window},
                                                          {"vertical", Text::role_vertical},
                                                          {"route", Text::role_route},
                                                          {"open-area", Text::role_open_area},
                                                          {"high-risk", Text::role_high_risk},
                                                          {"safety-item", Text::role_safety_item},
                                                          {"carriageway", Text::role_carriageway},
                                                          {"footway", Text::role_footway},
                                                          {"luminaire", Text::role_luminaire},
                                                          {"shelf", Text::role_shelf}};
  const auto* const row = std::find_if(
      std::begin(kRoles), std::end(kRoles),
      [&](const auto& known) { return known.first == role.substr(0, role.find('.')); });
  return row == std::end(kRoles) ? std::nullopt : std::optional<Text>(row->second);
}

}  // namespace

std::string role_name(const Texts& t, std::string_view role) {
  const std::optional<Text> known = known_role(role);
  if (!known) return with_blanks(role);
  const std::size_t dot = role.find('.');
  return t[*known] + (dot == role.npos ? "" : with_blanks(role.substr(dot)));
}

std::string made_role(const PlanePart& plane) {
  if (plane.made_by.empty()) return {};
  // "desk.wall.2" is "Desk: wall 2", or "wall 2" where workplaces share it. A workplace's id may
  // have dots of its own.
  const std::string_view title = title_of(plane.name, plane.id), id = plane.id;
  for (std::size_t dot = id.find('.'); dot != id.npos; dot = id.find('.', dot + 1)) {
    const std::string_view role = id.substr(dot + 1);
    const std::string words = with_blanks(role);
    if (title == words || title.ends_with(": " + words)) return std::string(role);
  }
  return {};
}

std::string plane_in_room(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  const std::string role = made_role(plane);
  if (role.empty()) return std::string(title_of(plane.name, plane.id));
  return in_place(t, space, plane, role_name(t, role));
}

std::string plane_name(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  const std::string role = made_role(plane);
  if (role.empty()) return std::string(title_of(plane.name, plane.id));
  std::string words = role_name(t, role);
  if (const std::size_t wall = looked_at_wall(space, plane); wall > 0)
    words = t.say<Text::role_looking_to_wall>(words, wall);
  // Names of workplaces and of roles of the user's own packs stay as they are.
  const std::string named = in_place(t, space, plane, words);
  return named == words && known_role(role) ? with_capital(words) : named;
}

std::string area_name(const Texts& t, const PlanePart& task) {
  const std::string role = made_role(task), place = place_of(task);
  if (role.empty()) return std::string(title_of(task.name, task.id));
  if (!place.empty()) return place;
  return known_role(role) ? with_capital(role_name(t, role)) : role_name(t, role);
}

}  // namespace report
