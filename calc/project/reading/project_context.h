#pragma once
// What all parts of the project reader share, and the attribute types only project files have.

#include "calc/base/budget.h"
#include "calc/base/xml_reader.h"
#include "calc/project/reading/former_ids.h"
#include "calc/project/reading/project_files.h"
#include "calc/scene/housing.h"
#include "calc/scene/polygon_mend.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Ids of one kind, e.g. "material": where each was first given, and its index. Elements with other
// errors are entered too, so that references to them are not reported as well.
class IdTable {
 public:
  explicit IdTable(std::string kind) : kind_(std::move(kind)) {}

  // Reports a repeated id; empty ids (already reported) are ignored.
  void add(ElementReader& reader, const std::string& id, std::size_t index);
  // The index of the id that the attribute names; reports an unknown one, and then returns 0.
  std::size_t find(ElementReader& reader, std::string_view attribute) const;
  std::size_t find(ElementReader& reader, std::string_view attribute, const std::string& id) const;
  // For names in other files: empty if the id is unknown; nothing is reported.
  std::optional<std::size_t> look_up(std::string_view id) const;
  Names ids() const;

 private:
  struct Entry {
    std::size_t index;
    int line;
  };
  std::string kind_;
  std::map<std::string, Entry, std::less<>> entries_;
};

// "there is no <kind> '<id>'; known: a, b; did you mean 'a'?" for an attribute that refers to
// something.
void report_unknown_reference(ElementReader& reader, std::string_view attribute,
                              std::string_view kind, const std::string& id, const Names& known);

// One per load_project() call.
struct ProjectContext {
  Project& project;
  ProjectFiles& files;
  Diagnostics& diagnostics;
  const Budget& budget;
  double metres_per_unit = 1.0;
  std::string_view unit_name = "m";
  std::optional<double> maintenance_factor = {};  // of types that state none
  IdTable materials{"material"};
  IdTable luminaire_types{"luminaire type"};
  // Of luminaire types whose housing is a file: index into Project::luminaire_types.
  std::map<std::size_t, HousingMesh> housing_meshes{};
  IdTable planes{"plane"};
  FormerIds former_planes{"plane"};
  std::set<std::string, std::less<>>
      groups{};  // dimming groups of all luminaires, faulty ones included
  std::set<std::string> planes_on_surfaces{};  // asked for with 'on' or 'on-top-of'
  double instances = 0;                        // of the spaces read so far
  double triangles = 0;
};

// Of the words of kUnitsType.
double metres_per_unit(std::size_t unit_index);

// Attributes of three numbers.
glm::dvec3 read_vector(ElementReader& reader, std::string_view name);     // as written
glm::dvec3 read_direction(ElementReader& reader, std::string_view name);  // unit vector
glm::dvec3 read_point_m(const ProjectContext& context, ElementReader& reader,
                        std::string_view name);
glm::dvec3 read_point_m_or_zero(const ProjectContext& context, ElementReader& reader,
                                std::string_view name);
// Each component > 0.
glm::dvec3 read_size_m(const ProjectContext& context, ElementReader& reader, std::string_view name);
// Says what was mended of an outline that an attribute states, if anything was. also: more words.
void warn_of_mending(ElementReader& reader, std::string_view attribute, const Mending& mending,
                     std::string_view also);
// The corners without doubled ones and spikes, which are said. Empty, and nothing is said, where
// that leaves no simple outline: sides cross, or a hole or another part is joined to it.
std::vector<glm::dvec2> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec2>& corners,
                                       std::string_view also = "");
std::vector<glm::dvec3> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec3>& corners,
                                       std::string_view also = "");

// At least three corners, at most kCornerLimit. Empty on errors.
std::vector<glm::dvec3> read_corners_m(const ProjectContext& context, ElementReader& reader,
                                       std::string_view name);
// Optional angle, degrees in the file.
double read_angle_rad(ElementReader& reader, std::string_view name);

// Attribute `tags`; none without it.
std::vector<std::string> read_tags(ElementReader& reader);

std::uint32_t read_material(const ProjectContext& context, ElementReader& reader,
                            std::string_view name = "material");

// False, and a message at `reader`'s element, when so many more would be too many for the project.
bool check_room_for(ProjectContext& context, ElementReader& reader, double instances,
                    double triangles);

}  // namespace calc
