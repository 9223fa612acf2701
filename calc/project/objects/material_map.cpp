#include "calc/project/objects/material_map.h"

#include "calc/project/reading/project_elements.h"

#include <set>

namespace calc {

std::optional<std::uint32_t> MaterialMap::find(std::string_view name) const {
  const auto mapped = of_name.find(name);
  return mapped != of_name.end() ? std::optional(mapped->second) : fallback;
}

MaterialMap read_material_map(ProjectContext& context, ElementReader& reader, std::string_view kind,
                              const std::vector<std::string>* known) {
  MaterialMap materials;
  if (reader.has("material")) materials.fallback = read_material(context, reader);
  std::set<std::string_view> names;
  if (known != nullptr) names.insert(known->begin(), known->end());
  names.erase("");
  IdTable mapped{std::string(kind)};
  for (const XmlElement& child : reader.element().children) {
    if (child.name != "map") continue;
    ElementReader map(child, context.diagnostics);
    map.allow(kMapElement);
    const std::string name = map.text("name");
    mapped.add(map, name, 0);
    if (known != nullptr && !name.empty() && !names.contains(name)) {
      report_unknown_reference(map, "name", kind, name, Names(names.begin(), names.end()));
    }
    materials.of_name[name] = read_material(context, map);
  }
  return materials;
}

}  // namespace calc
