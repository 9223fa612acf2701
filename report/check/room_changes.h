#pragma once
// A project's text with another room: luminaires more, or a lighter surface. All else stays as it
// stands in the file.

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

// room: the id of a <room> that is a prism (with size or corners), else empty and `problem` says
// why. The text is in UTF-8.
struct ChangedText {
  std::optional<std::string> text;
  std::string problem;
};
ChangedText with_luminaires(const std::string& bytes, const std::string& file,
                            const std::string& room, const std::vector<AddedLuminaire>& luminaires);

// The elements at these places of the file, children of the room that place luminaires, and
// luminaires instead of all of theirs.
ChangedText with_luminaires_instead(const std::string& bytes, const std::string& file,
                                    const std::string& room,
                                    const std::vector<calc::SourceLocation>& elements,
                                    const std::vector<AddedLuminaire>& luminaires);

// surface: an attribute of the room, "floor", "ceiling" or "walls", which then names a material of
// its own with this reflectance, [0, 1]. Refused where single walls have materials of their own.
ChangedText with_reflectance(const std::string& bytes, const std::string& file,
                             const std::string& room, std::string_view surface, double reflectance);

}  // namespace check
