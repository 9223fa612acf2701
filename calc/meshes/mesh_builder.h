#pragma once
// Converts faces to triangles, the same way for all mesh formats.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"
#include "calc/scene/polygon_mend.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace calc {

// Most corners of a face, because triangulation takes the square of their number.
inline constexpr std::size_t kMaxFaceCorners = 2000;

// Names in order of first use.
class NameList {
 public:
  std::uint32_t index_of(std::string_view name);
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> index_;
};

// Collects faces. Those with more than three corners are repaired (polygon_mend.h), with one
// warning, and triangulated (concave ones correctly); those not flat are projected along their mean
// normal, with one warning. Faces without area or with crossing sides are omitted, with one warning
// and their area. Only an area of exactly zero is no surface: needles are kept.
class MeshBuilder {
 public:
  // name: the path used in messages.
  MeshBuilder(MeshFormat format, std::string name, Diagnostics& diagnostics);

  // Set the names for the faces that follow.
  void set_material(std::string_view name);
  void set_object(std::string_view name);

  // Returns false, with an error, if so many more vertices exceed the limit.
  bool has_room_for_vertices(std::size_t count);
  // Returns false, with an error, for a position that is not finite or too far away; `what` names
  // it: "object 'desk', vertex 3".
  bool add_vertex(const glm::dvec3& position, const std::function<std::string()>& what);
  void set_vertices(std::vector<glm::dvec3> vertices) { mesh_.vertex = std::move(vertices); }
  std::size_t vertices() const { return mesh_.vertex.size(); }

  // Returns false after an error. corner: indices of vertices, all in range; line 0 = not known.
  bool add_face(std::span<const std::uint32_t> corner, int line);

  // Gives warnings, then returns the mesh; empty, with an error, if it has no triangle.
  std::optional<TriangleMesh> finish();

 private:
  bool is_small_enough(std::size_t corners, int line);
  std::vector<std::uint32_t> distinct_corners(std::span<const std::uint32_t> corner) const;
  bool split_triangle(const std::vector<std::uint32_t>& corner, int line);
  void note_doubled(std::span<const std::uint32_t> corner,
                    const std::vector<std::uint32_t>& distinct, int line);
  void note(const Mending& mending, int line);
  bool split_polygon(std::span<const std::uint32_t> corner, int line, double& area);
  void add_triangle(const glm::uvec3& triangle);
  void leave_out(double area, int line);
  std::string missing_area() const;
  void warn() const;

  struct Place {
    std::size_t face = 0;  // from 1
    int line = 0;
  };

  std::string name_;
  Diagnostics& diagnostics_;
  TriangleMesh mesh_;
  NameList materials_, objects_;
  std::string material_, object_;
  std::optional<std::uint32_t> material_index_, object_index_;
  double corner_pairs_ = 0.0, worst_deviation_ = 0.0;
  std::size_t bent_ = 0;
  Mending mending_;
  Place worst_, first_left_out_, longest_mended_, largest_left_out_;
  double largest_area_left_out_ = 0.0;
};

}  // namespace calc
