#include "calc/project/project_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_kind.h"
#include "calc/base/units.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/base/xml_reader.h"
#include "calc/project/about_xml.h"
#include "calc/project/objects/library_xml.h"
#include "calc/project/objects/maintenance_plan_xml.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/reading/project_files.h"
#include "calc/project/spaces/building_xml.h"
#include "calc/project/spaces/energy_xml.h"
#include "calc/project/spaces/spaces_xml.h"
#include "calc/project/warnings/project_warnings.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace calc {
namespace {

// version, name and units; and whatever does not belong into a project file.
void read_root(ProjectContext& context, const XmlElement& root) {
  ElementReader reader(root, context.diagnostics);
  Names for_editors;
  // What editors need to find the schema.
  for (const std::string_view name : {"xmlns:xsi", "xsi:noNamespaceSchemaLocation"}) {
    if (reader.has(name)) for_editors.push_back(name);
  }
  if (reader.has("xmlns:xsi")) {
    reader.choice("xmlns:xsi", {"http://www.w3.org/2001/XMLSchema-instance"});
  } else if (reader.has("xsi:noNamespaceSchemaLocation")) {
    reader.require_together("xmlns:xsi", "xsi:noNamespaceSchemaLocation");
  }
  reader.allow_attributes(kProjectElement, for_editors);
  reader.allow_children(kProjectElement);
  reader.choice("version", kVersionType.words);
  context.project.name = reader.text_or("name", "");
  context.maintenance_factor = reader.optional_number("maintenance-factor", kPositiveFraction);
  context.project.north_deg = reader.optional_number("north", kTurn);
  const std::size_t unit = reader.choice_or("units", kUnitsType.words, 0);
  context.metres_per_unit = kLengthUnits.at(unit).metres;
  context.unit_name = kLengthUnits.at(unit).name;
}

void read_contents(ProjectContext& context, const XmlElement& root) {
  read_root(context, root);
  read_about(context, root);
  read_maintenance_plan(context, root);
  read_materials(context, root);
  read_luminaire_types(context, root);
  read_rooms(context, root);
  read_open_space(context, root);
  context.former_planes.check(context.diagnostics);
  read_energy(context, root);  // names groups of all luminaires
  read_light_scenes(context, root);
  read_buildings(context, root);
}

// Of the tree of elements that is made of these bytes, about.
double xml_bytes(std::string_view bytes) {
  constexpr double kElement = 400.0, kAttribute = 250.0;  // and what the parser has beside
  const auto count = [&](char of) {
    return static_cast<double>(std::count(bytes.begin(), bytes.end(), of));
  };
  return kElement * count('<') + kAttribute * count('=') + 3.0 * static_cast<double>(bytes.size());
}

}  // namespace

std::optional<ReadProject> read_project(const FileReader& files, const std::string& path,
                                        Diagnostics& diagnostics, const Budget& budget) {
  const std::size_t errors_before = diagnostics.error_count();
  ReadProject read;
  Project& project = read.project;
  project.path = path;
  ProjectFiles project_files(files, project, diagnostics, budget);
  ProjectContext context{project, project_files, diagnostics, budget};
  std::optional<std::string> bytes = project_files.read_project();
  if (!bytes) return std::nullopt;
  if (!check_file_kind(*bytes, path, FileUse::project, diagnostics, looks_like_xml(*bytes))) {
    return std::nullopt;
  }
  if (!project_files.take(xml_bytes(*bytes), {path, 0, 0}, "the elements of the project take")) {
    return std::nullopt;
  }
  // Of a foreign file nothing is said but that.
  const XmlText text = has_first_element(*bytes, "luxgate") ? XmlText::refuse : XmlText::keep;
  const std::optional<XmlElement> root = parse_xml(std::move(*bytes), path, diagnostics, text);
  if (!root) return std::nullopt;
  if (root->name != "luxgate") {
    diagnostics.report(DiagnosticId::wrong_root_element, root->where, root->name, "luxgate");
    return std::nullopt;
  }
  read_contents(context, *root);
  read.is_good = diagnostics.error_count() == errors_before;
  if (read.is_good) {
    const std::size_t first_warning = diagnostics.all().size();
    warn_about_project(project, context.planes_on_surfaces, diagnostics);
    diagnostics.sort_by_line(path, first_warning);
  }
  return read;
}

std::optional<Project> load_project(const FileReader& files, const std::string& path,
                                    Diagnostics& diagnostics) {
  const std::size_t first = diagnostics.all().size();
  std::optional<ReadProject> read = read_project(files, path, diagnostics);
  if (read && read->is_good) return std::move(read->project);
  diagnostics.sort_by_line(path, first);
  return std::nullopt;
}

}  // namespace calc
