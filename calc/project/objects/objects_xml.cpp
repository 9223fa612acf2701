#include "calc/project/objects/objects_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/objects/bodies_xml.h"
#include "calc/project/objects/frame.h"
#include "calc/project/objects/luminaires_xml.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/housing.h"
#include "calc/scene/luminaire_sums.h"

#include <algorithm>
#include <map>
#include <utility>

namespace calc {
namespace {

ObjectSet read_children(ProjectContext& context, const XmlElement& parent, int depth);

Repeat read_repeat(const ProjectContext& context, ElementReader& reader) {
  Repeat repeat;
  if (!reader.require_together("repeat", "step") || !reader.has("repeat")) return repeat;
  repeat.is_given = true;
  const std::vector<int> count =
      reader.integers("repeat", 3, "3 whole numbers (copies along x y z)", 1);
  repeat.count = {count[0], count[1], count[2]};
  repeat.step_m = read_point_m(context, reader, "step");
  if (!reader.ok()) return repeat;
  for (int i = 0; i < 3; ++i) {
    if (count[static_cast<std::size_t>(i)] == 1 || repeat.step_m[i] != 0.0) continue;
    reader.report(DiagnosticId::number_out_of_range, reader.where("step"), "step",
                  reader.element().name, 0, "a distance other than 0 wherever 'repeat' is above 1");
  }
  return repeat;
}

// The parts, and where they are to be placed.
ObjectSet read_assembly(ProjectContext& context, ElementReader& reader, int depth,
                        Placement& placement) {
  reader.allow(kAssemblyElement);
  if (depth > kAssemblyDepthLimit) {
    reader.report(DiagnosticId::assemblies_too_deep, reader.where(), kAssemblyDepthLimit);
    return {};
  }
  placement = {rotation_about_z(read_angle_rad(reader, "rotation")),
               read_point_m_or_zero(context, reader, "position")};
  return read_children(context, reader.element(), depth);
}

ObjectSet read_body_or_assembly(ProjectContext& context, ElementReader& reader, int depth,
                                Placement& placement) {
  const std::string& name = reader.element().name;
  if (name == "box") return read_box(context, reader);
  if (name == "quad") return read_quad(context, reader);
  if (name == "polygon") return read_polygon(context, reader);
  if (name == "mesh") return read_mesh(context, reader);
  return read_assembly(context, reader, depth, placement);
}

std::vector<Luminaire> read_luminaires(ProjectContext& context, ElementReader& reader) {
  const std::string& name = reader.element().name;
  if (name == "luminaire") return read_luminaire(context, reader);
  if (name == "luminaire-grid") return read_luminaire_grid(context, reader);
  if (name == "luminaire-line") return read_luminaire_line(context, reader);
  if (name == "luminaires") return read_luminaire_list(context, reader);
  return read_luminaire_ring(context, reader);
}

bool is_object(std::string_view name) {
  const std::vector<ChildRow>& objects = kObjects.children;
  return std::any_of(objects.begin(), objects.end(),
                     [&](const ChildRow& object) { return object.name == name; });
}

void add_luminaires(ProjectContext& context, ElementReader& reader, IdTable& ids, ObjectSet& into) {
  ids.add(reader, reader.id(), 0);
  const std::vector<Luminaire> luminaires =
      with_all_emitters(context.project, read_luminaires(context, reader));
  const auto mesh_of = [&](const Luminaire& luminaire) {
    const auto mesh = context.housing_meshes.find(luminaire.type);
    return mesh == context.housing_meshes.end() ? nullptr : &mesh->second;
  };
  double housings = 0.0, triangles = 0.0;
  std::map<std::size_t, double> triangles_of;  // of a type
  for (const Luminaire& luminaire : luminaires) {
    const LuminaireType& type = context.project.luminaire_types[luminaire.type];
    if (!type.housing) continue;
    housings += 2.0;  // a face and a prism at most
    const auto [count, is_new] = triangles_of.try_emplace(luminaire.type, 0.0);
    if (is_new) {
      count->second =
          static_cast<double>(housing_triangles(context.project, type, mesh_of(luminaire)));
    }
    triangles += count->second;
  }
  const double instances = into.instances() + static_cast<double>(luminaires.size()) + housings;
  if (!check_room_for(context, reader, instances, into.triangles + triangles)) return;
  into.luminaires.insert(into.luminaires.end(), luminaires.begin(), luminaires.end());
  for (const Luminaire& luminaire : luminaires) {
    for (Body& body : housing_bodies(context.project, luminaire, mesh_of(luminaire))) {
      into.add_body(std::move(body));
    }
  }
}

void add_bodies(ProjectContext& context, ElementReader& reader, IdTable& ids, int depth,
                ObjectSet& into) {
  const std::string id = reader.id();
  ids.add(reader, id, 0);
  const Repeat repeat = read_repeat(context, reader);
  Placement placement;
  const ObjectSet item = read_body_or_assembly(context, reader, depth, placement);
  if (!reader.ok()) return;
  const double instances = into.instances() + repeat.copies() * item.instances();
  const double triangles = into.triangles + repeat.copies() * item.triangles;
  if (!check_room_for(context, reader, instances, triangles)) return;
  append_repeated(item, placement, repeat, id, into);
}

ObjectSet read_children(ProjectContext& context, const XmlElement& parent, int depth) {
  ObjectSet set;
  IdTable object_ids("object");
  IdTable luminaire_ids("luminaire");
  for (const XmlElement& child : parent.children) {
    if (!is_object(child.name)) continue;
    ElementReader reader(child, context.diagnostics);
    if (child.name.starts_with("luminaire")) {
      add_luminaires(context, reader, luminaire_ids, set);
    } else {
      add_bodies(context, reader, object_ids, depth + 1, set);
    }
  }
  return set;
}

}  // namespace

ObjectSet read_objects(ProjectContext& context, const XmlElement& parent) {
  return read_children(context, parent, 0);
}

}  // namespace calc
