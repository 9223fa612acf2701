#pragma once
// Names of planes for people: a workplace's planes by role and place in the room, all others as the
// project names them. Ids are for data.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>

namespace report {

// Returns a role of a rule pack, or a part of it, in words of the language: "wall 2" for "wall.2".
// An unknown role stays as the pack names it.
std::string role_name(const Texts& t, std::string_view role);

// Returns "wall.2" for a plane made by a workplace; "" for planes that the project describes
// itself.
std::string made_role(const PlanePart& plane);

// Returns a title inside the room: "Wall 2", "Observer 1, looking to wall 4"; with the workplace,
// "Desk: task", if several workplaces of the room have planes.
std::string plane_name(const Texts& t, const SpacePart& space, const PlanePart& plane);

// Returns a short name for use within a sentence: "wall 2", "observer 1".
std::string plane_in_room(const Texts& t, const SpacePart& space, const PlanePart& plane);

// Returns the name of a task among others of its room, by one of its planes: the project's name of
// the workplace, or else of the plane: "Board", "Task", "Carriageway".
std::string area_name(const Texts& t, const PlanePart& task);

}  // namespace report
