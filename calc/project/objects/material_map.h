#pragma once
// Reads <map name="..." material="..."/>: names in another file to materials of the project.

#include "calc/project/reading/project_context.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct MaterialMap {
  std::map<std::string, std::uint32_t, std::less<>> of_name;
  std::optional<std::uint32_t> fallback;  // of the attribute "material", for names not mapped

  // Returns the material; empty if the name is neither mapped nor covered by the fallback.
  std::optional<std::uint32_t> find(std::string_view name) const;
};

// Reads the element's children <map> and its attribute "material". kind: "material of the mesh"
// ...; known: names that may be mapped, null if they are not known.
MaterialMap read_material_map(ProjectContext& context, ElementReader& reader, std::string_view kind,
                              const std::vector<std::string>* known);

}  // namespace calc
