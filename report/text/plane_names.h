#pragma once
// What planes are called, for people: those that a workplace has made by their role and their
// place in the room, all others as the project names them. Their ids are for data.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>

namespace report {

// A role of a rule pack, or a part of it, in words of any language: "wall 2" of "wall.2". What is
// not known here is as the pack names it.
std::string role_name(const Texts& t, std::string_view role);

// "wall.2" of a plane that a workplace has made; "" of what the project describes itself.
std::string made_role(const PlanePart& plane);

// As a title inside its room: "Wall 2", "Observer 1, looking to wall 4". With its place, "Desk:
// task", where several workplaces of the room have planes.
std::string plane_name(const Texts& t, const SpacePart& space, const PlanePart& plane);

// The same within a sentence, and short: "wall 2", "observer 1".
std::string plane_in_room(const Texts& t, const SpacePart& space, const PlanePart& plane);

// A task among others of its room, by one of its planes: the workplace as the project names it, or
// else the plane: "Board", "Task", "Carriageway".
std::string area_name(const Texts& t, const PlanePart& task);

}  // namespace report
