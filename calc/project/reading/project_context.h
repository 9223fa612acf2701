#pragma once
// State that all parts of the project reader share, and attribute types of project files only.

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

// The ids of a kind, e.g. "material": the place of each definition, and its index. Elements with
// other errors are entered too, so that references to them are not reported as well.
class IdTable {
 public:
  explicit IdTable(std::string kind) : kind_(std::move(kind)) {}

  // Reports a repeated id; empty ids (already reported) are ignored.
  void add(ElementReader& reader, const std::string& id, std::size_t index);
  // Returns the index of the id that the attribute names; reports an unknown id and returns 0.
  std::size_t find(ElementReader& reader, std::string_view attribute) const;
  std::size_t find(ElementReader& reader, std::string_view attribute, const std::string& id) const;
  // Returns the index for names in other files; empty if the id is unknown; reports nothing.
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

// Reports "there is no <kind> '<id>'; known: a, b; did you mean 'a'?" for an attribute that refers
// to something.
void report_unknown_reference(ElementReader& reader, std::string_view attribute,
                              std::string_view kind, const std::string& id, const Names& known);

// The state of one load_project() call.
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
  // Luminaire types whose housing is a file, by index into Project::luminaire_types.
  std::map<std::size_t, HousingMesh> housing_meshes{};
  IdTable planes{"plane"};
  FormerIds former_planes{"plane"};
  std::set<std::string, std::less<>>
      groups{};  // dimming groups of all luminaires, faulty ones included
  std::set<std::string> planes_on_surfaces{};  // asked for with 'on' or 'on-top-of'
  double instances = 0;                        // of the spaces read so far
  double triangles = 0;
};

// Returns the metres of a word of kUnitsType.
double metres_per_unit(std::size_t unit_index);

// Return attributes of three numbers.
glm::dvec3 read_vector(ElementReader& reader, std::string_view name);     // as written
glm::dvec3 read_direction(ElementReader& reader, std::string_view name);  // unit vector
glm::dvec3 read_point_m(const ProjectContext& context, ElementReader& reader,
                        std::string_view name);
glm::dvec3 read_point_m_or_zero(const ProjectContext& context, ElementReader& reader,
                                std::string_view name);
// Returns a size; requires each component > 0.
glm::dvec3 read_size_m(const ProjectContext& context, ElementReader& reader, std::string_view name);
// Warns of repairs of an outline that an attribute states, if there were any. also: more words.
void warn_of_mending(ElementReader& reader, std::string_view attribute, const Mending& mending,
                     std::string_view also);
// Returns the corners without doubled ones and spikes, with a warning. Empty, without a warning,
// where that leaves no simple outline: sides cross, or a hole or another part is joined to it.
std::vector<glm::dvec2> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec2>& corners,
                                       std::string_view also = "");
std::vector<glm::dvec3> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec3>& corners,
                                       std::string_view also = "");

// Returns three to kCornerLimit corners; empty on errors.
std::vector<glm::dvec3> read_corners_m(const ProjectContext& context, ElementReader& reader,
                                       std::string_view name);
// Returns an optional angle, in degrees in the file.
double read_angle_rad(ElementReader& reader, std::string_view name);

// Returns the attribute `tags`; empty without it.
std::vector<std::string> read_tags(ElementReader& reader);

std::uint32_t read_material(const ProjectContext& context, ElementReader& reader,
                            std::string_view name = "material");

// Returns false, with a message at `reader`'s element, if so many more exceed the project's budget.
bool check_room_for(ProjectContext& context, ElementReader& reader, double instances,
                    double triangles);

}  // namespace calc
