#include "calc/project/coincident_surfaces.h"

#include "calc/project/warning_words.h"
#include "calc/scene/box_shelf.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr double kSamePlane_m = 1.0e-6;

using Corners3 = std::array<glm::dvec3, 3>;

Corners3 corners_of(const Body& body, std::size_t triangle) {
  const glm::uvec3& t = body.triangle[triangle];
  return {body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z]};
}

// A triangle's plane with axes in it.
struct PlaneFrame {
  glm::dvec3 origin_m, u, v, normal;
  bool is_valid = false;

  explicit PlaneFrame(const Corners3& t) : origin_m(t[0]) {
    const glm::dvec3 side = t[1] - t[0], across = glm::cross(side, t[2] - t[0]);
    const double length_m = glm::length(side), area = glm::length(across);
    is_valid = area > kSamePlane_m * length_m;
    if (!is_valid) return;
    normal = across / area;
    u = side / length_m;
    v = glm::cross(normal, u);
  }
  double height_m(const glm::dvec3& p) const { return glm::dot(normal, p - origin_m); }
  bool holds(const Corners3& t, double tolerance_m) const {
    return std::all_of(t.begin(), t.end(),
                       [&](const glm::dvec3& p) { return std::abs(height_m(p)) <= tolerance_m; });
  }
  glm::dvec2 flat(const glm::dvec3& p) const {
    return {glm::dot(u, p - origin_m), glm::dot(v, p - origin_m)};
  }
  glm::dvec3 raised(const glm::dvec2& p) const { return origin_m + p.x * u + p.y * v; }
};

using FlatPiece = std::vector<glm::dvec2>;  // convex

double twice_area_m2(const FlatPiece& piece) {
  double sum = 0.0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const glm::dvec2 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// Divides a piece by the line through a and b: what is to the left of it, and the rest.
struct Halves {
  FlatPiece left, right;
};

Halves divided(const FlatPiece& piece, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = (b - a) / glm::length(b - a);
  const auto side_m = [&](const glm::dvec2& p) {
    const double m = along.x * (p.y - a.y) - along.y * (p.x - a.x);
    return std::abs(m) <= 0.1 * kSamePlane_m ? 0.0 : m;
  };
  Halves halves;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const glm::dvec2 &p = piece[i], &q = piece[(i + 1) % piece.size()];
    const double sp = side_m(p), sq = side_m(q);
    if (sp >= 0.0) halves.left.push_back(p);
    if (sp <= 0.0) halves.right.push_back(p);
    if (sp * sq < 0.0) {
      const glm::dvec2 cut = p + (sp / (sp - sq)) * (q - p);
      halves.left.push_back(cut);
      halves.right.push_back(cut);
    }
  }
  return halves;
}

bool has_area(const FlatPiece& piece) {
  // A strip of a micrometre is not worth a triangle.
  double longest_m = 0.0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    longest_m = std::max(longest_m, glm::length(piece[i] - piece[(i + 1) % piece.size()]));
  }
  return piece.size() >= 3 && std::abs(twice_area_m2(piece)) > kSamePlane_m * longest_m;
}

// `piece` less the triangle, and what they share; shared is empty if they share no area.
struct Cut {
  std::vector<FlatPiece> outside;
  FlatPiece shared;
};

Cut cut_by(FlatPiece piece, std::array<glm::dvec2, 3> triangle) {
  const glm::dvec2 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
  if (ab.x * ac.y - ab.y * ac.x < 0.0) std::swap(triangle[1], triangle[2]);
  Cut cut;
  for (std::size_t k = 0; k < 3; ++k) {
    Halves halves = divided(piece, triangle[k], triangle[(k + 1) % 3]);
    if (!has_area(halves.left)) return {};
    if (has_area(halves.right)) cut.outside.push_back(std::move(halves.right));
    piece = std::move(halves.left);
  }
  cut.shared = std::move(piece);
  return cut;
}

void append_fan(Body& body, const PlaneFrame& frame, const FlatPiece& piece,
                std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(body.vertex_m.size());
  for (const glm::dvec2& p : piece) body.vertex_m.push_back(frame.raised(p));
  for (std::uint32_t i = 1; i + 1 < piece.size(); ++i) {
    body.triangle.emplace_back(first, first + i, first + i + 1);
    body.material_of.push_back(material);
  }
}

class Settler {
 public:
  Settler(Space& space, std::size_t shell_bodies)
      : space_(space),
        tolerance_m_(std::max(kSamePlane_m, touching_m(extent_m(space)))),
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

  void cover() {
    for (const std::size_t sheet : sheets_.all()) {
      for (const BoxShelf* shelf : {&shell_, &solids_}) {
        for (const std::size_t below : shelf->near(box_[sheet], tolerance_m_)) {
          for (std::size_t t = 0; t < space_.bodies[sheet].triangle.size(); ++t) {
            cover_by(space_.bodies[sheet], t, space_.bodies[below]);
          }
        }
      }
    }
  }

  void warn_of_sheets_in_sheets(Diagnostics& diagnostics) const {
    std::vector<std::pair<const Body*, const Body*>> pairs;
    for (const std::size_t sheet : sheets_.all()) {
      for (const std::size_t other : sheets_.near(box_[sheet], tolerance_m_)) {
        const Body &upper = space_.bodies[sheet], &lower = space_.bodies[other];
        if (other < sheet && share(upper, lower)) pairs.emplace_back(&upper, &lower);
      }
    }
    std::sort(pairs.begin(), pairs.end());  // in the order of the file
    warn_of_first_few<std::pair<const Body*, const Body*>>(
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
  bool lies_in(const PlaneFrame& frame, const Corners3& one, const Corners3& other) const {
    if (!frame.is_valid) return false;
    if (frame.holds(other, tolerance_m_)) return true;
    const PlaneFrame of_other(other);
    return of_other.is_valid && of_other.holds(one, tolerance_m_);
  }

  void cover_by(const Body& sheet, std::size_t triangle, Body& below) const {
    const Corners3 cover = corners_of(sheet, triangle);
    const std::uint32_t material = sheet.material_of[triangle];
    for (std::size_t t = 0, count = below.triangle.size(); t < count; ++t) {
      if (below.material_of[t] == material) continue;
      const Corners3 corners = corners_of(below, t);
      const PlaneFrame frame(corners);
      if (!lies_in(frame, corners, cover)) continue;
      const Cut cut =
          cut_by({frame.flat(corners[0]), frame.flat(corners[1]), frame.flat(corners[2])},
                 {frame.flat(cover[0]), frame.flat(cover[1]), frame.flat(cover[2])});
      if (cut.shared.empty()) continue;
      if (cut.outside.empty()) {
        below.material_of[t] = material;
        continue;
      }
      const std::uint32_t own = below.material_of[t];
      for (const FlatPiece& piece : cut.outside) append_fan(below, frame, piece, own);
      append_fan(below, frame, cut.shared, material);
      // The last one takes the divided triangle's place.
      below.triangle[t] = below.triangle.back();
      below.material_of[t] = below.material_of.back();
      below.triangle.pop_back();
      below.material_of.pop_back();
    }
  }

  bool share(const Body& a, const Body& b) const {
    for (std::size_t i = 0; i < a.triangle.size(); ++i) {
      const Corners3 one = corners_of(a, i);
      const PlaneFrame frame(one);
      for (std::size_t k = 0; k < b.triangle.size(); ++k) {
        const Corners3 other = corners_of(b, k);
        if (a.material_of[i] == b.material_of[k] || !lies_in(frame, one, other)) continue;
        const Cut cut = cut_by({frame.flat(one[0]), frame.flat(one[1]), frame.flat(one[2])},
                               {frame.flat(other[0]), frame.flat(other[1]), frame.flat(other[2])});
        if (!cut.shared.empty()) return true;
      }
    }
    return false;
  }

  Space& space_;
  double tolerance_m_;
  std::vector<BoundingBox> box_;
  BoxShelf shell_, solids_, sheets_;
};

}  // namespace

void settle_coincident_surfaces(Space& space, std::size_t shell_bodies, Diagnostics& diagnostics) {
  Settler settler(space, shell_bodies);
  settler.warn_of_sheets_in_sheets(diagnostics);
  settler.cover();
}

}  // namespace calc
