#pragma once
// Changes a room in a project's text: more luminaires, or a lighter surface. Everything else stays
// unchanged.

#include "calc/base/diagnostics.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace check {

struct AddedLuminaire {
  std::string id, type;   // of a <luminaire-type> of the project
  glm::dvec3 position_m;  // world
  glm::dvec3 c0, axis;    // unit, world: directions of C0 and of gamma = 0
  std::string group;      // "" = none
};

// The changed text in UTF-8. room: the id of a <room> that is a prism (with size or corners);
// otherwise the text is empty and `problem` says why.
struct ChangedText {
  std::optional<std::string> text;
  std::string problem;
};
ChangedText with_luminaires(const std::string& bytes, const std::string& file,
                            const std::string& room, const std::vector<AddedLuminaire>& luminaires);

// Replaces all elements at these places of the file, children of the room that place luminaires, by
// other luminaires.
ChangedText with_luminaires_instead(const std::string& bytes, const std::string& file,
                                    const std::string& room,
                                    const std::vector<calc::SourceLocation>& elements,
                                    const std::vector<AddedLuminaire>& luminaires);

// Gives a surface of the room its own material with this reflectance, [0, 1]. surface: an attribute
// of the room, "floor", "ceiling" or "walls". Refused if single walls have their own materials.
ChangedText with_reflectance(const std::string& bytes, const std::string& file,
                             const std::string& room, std::string_view surface, double reflectance);

}  // namespace check
