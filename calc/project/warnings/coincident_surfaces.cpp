#include "calc/project/warnings/coincident_surfaces.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/warnings/doubled_faces.h"
#include "calc/project/warnings/flat_pieces.h"
#include "calc/project/warnings/warning_words.h"
#include "calc/scene/box_shelf.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

class Settler {
 public:
  Settler(Space& space, std::size_t shell_bodies, const std::vector<Material>& materials)
      : space_(space),
        materials_(materials),
        tolerance_m_(std::max(kSamePlane_m, touching_m(scale_of(space).ray_offset_m()))),
        box_(boxes_of(space)),
        shell_(box_),
        solids_(box_),
        sheets_(box_) {
    for (std::size_t i = 0; i < space.bodies.size(); ++i) {
      if (i < shell_bodies) {
        shell_.add(i);
      } else if (space.bodies[i].is_closed) {
        solids_.add(i);
      } else if (space.bodies[i].triangle.size() <= kMostSheetTriangles) {
        sheets_.add(i);
      }
    }
    for (BoxShelf* shelf : {&shell_, &solids_, &sheets_}) shelf->sort();
  }

  void settle_doubled(Diagnostics& diagnostics) {
    std::vector<std::pair<const Body*, DoubledFaces>> found;
    for (Body& body : space_.bodies) {
      const DoubledFaces doubled = settle_doubled_faces(body, materials_, tolerance_m_);
      if (doubled.triangles > 0) found.emplace_back(&body, doubled);
    }
    warn_of_first_few<std::pair<const Body*, DoubledFaces>>(
        found, "objects of this space", [&](const auto& one, const std::string& more) {
          const auto& [body, doubled] = one;
          diagnostics.report(DiagnosticId::faces_coincide, body->where, body->id, doubled.triangles,
                             more, doubled.area_m2, doubled.first_m.x, doubled.first_m.y,
                             doubled.first_m.z);
        });
  }

  void cover() {
    for (const std::size_t sheet : sheets_.all()) {
      for (const BoxShelf* shelf : {&shell_, &solids_}) {
        for (const std::size_t below : shelf->near(box_[sheet], tolerance_m_)) {
          for (std::size_t t = 0; t < space_.bodies[sheet].triangle.size(); ++t) {
            cover_by(space_.bodies[sheet], t, space_.bodies[below], Covered::all);
          }
        }
      }
    }
  }

  void settle_sheets_in_sheets(Diagnostics& diagnostics) {
    std::vector<std::pair<Body*, Body*>> pairs;
    for (const std::size_t sheet : sheets_.all()) {
      for (const std::size_t other : sheets_.near(box_[sheet], tolerance_m_)) {
        Body &upper = space_.bodies[sheet], &lower = space_.bodies[other];
        if (other < sheet && share(upper, lower)) pairs.emplace_back(&upper, &lower);
      }
    }
    std::sort(pairs.begin(), pairs.end());  // in the order of the file
    for (const auto& [upper, lower] : pairs) {
      cover_lighter(*upper, *lower);
      cover_lighter(*lower, *upper);
    }
    warn_of_first_few<std::pair<Body*, Body*>>(
        pairs, "pairs of this space", [&](const auto& pair, const std::string& more) {
          diagnostics.report(DiagnosticId::surfaces_coincide, pair.first->where, pair.first->id,
                             pair.second->id, pair.second->where.line, more);
        });
  }

 private:
  static std::vector<BoundingBox> boxes_of(const Space& space) {
    std::vector<BoundingBox> boxes;
    for (const Body& body : space.bodies) boxes.push_back(bounding_box(body.vertex_m));
    return boxes;
  }
  void cover_lighter(const Body& sheet, Body& other) const {
    for (std::size_t t = 0, count = sheet.triangle.size(); t < count; ++t) {
      cover_by(sheet, t, other, Covered::lighter);
    }
  }
  // What a sheet covers of a surface: all, or what is lighter than itself.
  enum class Covered { all, lighter };
  void cover_by(const Body& sheet, std::size_t triangle, Body& below, Covered covered) const {
    const Corners3 cover = corners_of(sheet, triangle);
    const std::uint32_t material = sheet.material_of[triangle];
    for (std::size_t t = 0, count = below.triangle.size(); t < count; ++t) {
      if (below.material_of[t] == material) continue;
      if (covered == Covered::lighter &&
          materials_[below.material_of[t]].reflectance <= materials_[material].reflectance) {
        continue;
      }
      const Corners3 corners = corners_of(below, t);
      const PlaneFrame frame(corners);
      if (!lie_in_one_plane(frame, corners, cover, tolerance_m_)) continue;
      const std::array<glm::dvec2, 3> flat = frame.flat(corners);
      const PieceCut cut = cut_by({flat.begin(), flat.end()}, frame.flat(cover));
      if (cut.shared.empty()) continue;
      if (cut.outside.empty()) {
        below.material_of[t] = material;
        continue;
      }
      const std::uint32_t own = below.material_of[t];
      for (const FlatPiece& piece : cut.outside) append_fan(below, frame, piece, own);
      append_fan(below, frame, cut.shared, material);
      remove_triangle(below, t);
    }
  }

  bool share(const Body& a, const Body& b) const {
    for (std::size_t i = 0; i < a.triangle.size(); ++i) {
      const Corners3 one = corners_of(a, i);
      const PlaneFrame frame(one);
      for (std::size_t k = 0; k < b.triangle.size(); ++k) {
        const Corners3 other = corners_of(b, k);
        if (a.material_of[i] == b.material_of[k] ||
            !lie_in_one_plane(frame, one, other, tolerance_m_)) {
          continue;
        }
        const std::array<glm::dvec2, 3> flat = frame.flat(one);
        if (!cut_by({flat.begin(), flat.end()}, frame.flat(other)).shared.empty()) return true;
      }
    }
    return false;
  }

  Space& space_;
  const std::vector<Material>& materials_;
  double tolerance_m_;
  std::vector<BoundingBox> box_;
  BoxShelf shell_, solids_, sheets_;
};

}  // namespace

void settle_coincident_surfaces(Space& space, std::size_t shell_bodies,
                                const std::vector<Material>& materials, Diagnostics& diagnostics) {
  Settler settler(space, shell_bodies, materials);
  settler.settle_doubled(diagnostics);
  settler.settle_sheets_in_sheets(diagnostics);
  settler.cover();
}

}  // namespace calc
