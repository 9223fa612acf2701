#include "calc/project/warnings/doubled_faces.h"

#include "calc/project/warnings/flat_pieces.h"
#include "calc/scene/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <map>
#include <utility>

namespace calc {
namespace {

// Of planes that are compared at all. What is rounded into two of them is missed, so that limits
// lie where no drawing has its planes.
constexpr double kPlaneStep_m = 1.0e-3, kNormalStep = 1.0e-3, kOffStep = 0.3717;
// Pairs of triangles that are looked at, for each triangle; of real models it is a few.
constexpr std::size_t kMostPairsPerTriangle = 200;

std::int64_t step_of(double value, double step) {
  return static_cast<std::int64_t>(std::floor(value / step + kOffStep));
}

struct PlaneFace {
  std::array<std::int64_t, 4> plane;  // direction, either way round, and distance
  std::uint32_t triangle;
  auto operator<=>(const PlaneFace&) const = default;
};

struct CellFace {
  std::array<std::int64_t, 2> cell;
  std::uint32_t triangle;
  auto operator<=>(const CellFace&) const = default;
};

// Calls visit(begin, end) for each run of faces that are in one place by `key`.
template <class Face, class Key, class Visit>
void for_each_run(const std::vector<Face>& sorted, Key key, Visit visit) {
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(),
                                  [&](const Face& face) { return (*begin).*key != face.*key; });
    visit(begin, end);
    begin = end;
  }
}

class Doubles {
 public:
  Doubles(Body& body, const std::vector<Material>& materials, double tolerance_m)
      : body_(body), materials_(materials), tolerance_m_(tolerance_m) {}

  DoubledFaces settle() {
    if (!has_unlike(body_.material_of)) return {};
    pairs_left_ = kMostPairsPerTriangle * body_.triangle.size();
    const std::vector<PlaneFace> faces = faces_by_plane();
    for_each_run(faces, &PlaneFace::plane, [&](auto begin, auto end) { look_at(begin, end); });
    // The lightest first: what covers it is darker, so that it is still whole.
    std::vector<std::uint32_t> lightest_first;
    for (const auto& [lighter, covers] : covers_of_) lightest_first.push_back(lighter);
    std::stable_sort(lightest_first.begin(), lightest_first.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       return reflectance(body_.material_of[a]) > reflectance(body_.material_of[b]);
                     });
    DoubledFaces doubled;
    for (const std::uint32_t lighter : lightest_first) cover(lighter, doubled);
    return doubled;
  }

 private:
  double reflectance(std::uint32_t material) const { return materials_[material].reflectance; }

  bool has_unlike(const std::vector<std::uint32_t>& materials) const {
    return std::any_of(materials.begin(), materials.end(), [&](std::uint32_t material) {
      return reflectance(material) != reflectance(materials.front());
    });
  }

  std::vector<PlaneFace> faces_by_plane() const {
    // No plane of a drawing is at right angles to this, so that rounding turns no normal round.
    constexpr glm::dvec3 kAside(1.0, 0.381966, 0.1458980);
    const glm::dvec3 centre_m = bounding_box(body_.vertex_m).centre();
    std::vector<PlaneFace> faces;
    faces.reserve(body_.triangle.size());
    for (std::uint32_t i = 0; i < body_.triangle.size(); ++i) {
      const PlaneFrame frame(corners_of(body_, i));
      if (!frame.is_valid) continue;
      const glm::dvec3 normal = glm::dot(frame.normal, kAside) < 0.0 ? -frame.normal : frame.normal;
      faces.push_back({{step_of(normal.x, kNormalStep), step_of(normal.y, kNormalStep),
                        step_of(normal.z, kNormalStep),
                        step_of(glm::dot(normal, frame.origin_m - centre_m), kPlaneStep_m)},
                       i});
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  // A triangle's box in the two directions that its plane goes most along.
  struct Box {
    glm::dvec2 low_m, high_m;
  };
  Box box_of(std::uint32_t triangle, glm::length_t across) const {
    const Corners3 corners = corners_of(body_, triangle);
    const auto flat = [&](const glm::dvec3& p) {
      return glm::dvec2(p[(across + 1) % 3], p[(across + 2) % 3]);
    };
    const glm::dvec2 a = flat(corners[0]), b = flat(corners[1]), c = flat(corners[2]);
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
  }

  // Faces of about one plane.
  template <class Faces>
  void look_at(Faces begin, Faces end) {
    std::vector<std::uint32_t> in_use;
    for (Faces face = begin; face != end; ++face) {
      in_use.push_back(body_.material_of[face->triangle]);
    }
    if (!has_unlike(in_use)) return;
    const glm::dvec3 normal = glm::abs(PlaneFrame(corners_of(body_, begin->triangle)).normal);
    glm::length_t across = 0;
    for (const glm::length_t axis : {1, 2}) {
      if (normal[axis] > normal[across]) across = axis;
    }
    // With cells of that size, all faces together are in four times as many cells as they are.
    double sum_m2 = 0.0;
    for (Faces face = begin; face != end; ++face) {
      const Box box = box_of(face->triangle, across);
      const glm::dvec2 size_m = box.high_m - box.low_m;
      sum_m2 += std::max(size_m.x, size_m.y) * std::max(size_m.x, size_m.y);
    }
    const double side_m =
        std::max(kSamePlane_m, std::sqrt(sum_m2 / static_cast<double>(in_use.size())));
    std::vector<CellFace> in_cells;
    for (Faces face = begin; face != end; ++face) {
      const Box box = box_of(face->triangle, across);
      for (std::int64_t x = step_of(box.low_m.x, side_m); x <= step_of(box.high_m.x, side_m); ++x) {
        for (std::int64_t y = step_of(box.low_m.y, side_m); y <= step_of(box.high_m.y, side_m);
             ++y) {
          in_cells.push_back({{x, y}, face->triangle});
        }
      }
    }
    std::sort(in_cells.begin(), in_cells.end());
    for_each_run(in_cells, &CellFace::cell, [&](auto first, auto last) {
      for (auto one = first; one != last; ++one) {
        for (auto other = first; other != one && pairs_left_ > 0; ++other) {
          --pairs_left_;
          compare(other->triangle, one->triangle);
        }
      }
    });
  }

  void compare(std::uint32_t a, std::uint32_t b) {
    const double of_a = reflectance(body_.material_of[a]), of_b = reflectance(body_.material_of[b]);
    if (of_a == of_b) return;
    const std::uint32_t lighter = of_a > of_b ? a : b, darker = of_a > of_b ? b : a;
    const Corners3 corners = corners_of(body_, lighter), cover = corners_of(body_, darker);
    const PlaneFrame frame(corners);
    if (!lie_in_one_plane(frame, corners, cover, tolerance_m_)) return;
    const std::array<glm::dvec2, 3> flat = frame.flat(corners);
    if (cut_by({flat.begin(), flat.end()}, frame.flat(cover)).shared.empty()) return;
    covers_of_[lighter].push_back(darker);
  }

  struct Piece {
    FlatPiece shape;
    std::uint32_t material;
  };

  // The part of the pieces that the triangle covers gets its material, where that is darker.
  std::vector<Piece> covered(const std::vector<Piece>& pieces, const PlaneFrame& frame,
                             std::uint32_t triangle) const {
    const std::uint32_t material = body_.material_of[triangle];
    std::vector<Piece> left;
    for (const Piece& piece : pieces) {
      if (reflectance(piece.material) <= reflectance(material)) {
        left.push_back(piece);
        continue;
      }
      PieceCut cut = cut_by(piece.shape, frame.flat(corners_of(body_, triangle)));
      if (cut.shared.empty()) {
        left.push_back(piece);
        continue;
      }
      for (FlatPiece& shape : cut.outside) left.push_back({std::move(shape), piece.material});
      left.push_back({std::move(cut.shared), material});
    }
    return left;
  }

  // What divides a triangle is added behind the body's others, whose numbers stay.
  void cover(std::uint32_t lighter, DoubledFaces& doubled) {
    std::vector<std::uint32_t>& covers = covers_of_[lighter];
    // A pair may be in several cells. The darkest first: what it covers is not cut any more.
    std::sort(covers.begin(), covers.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(reflectance(body_.material_of[a]), a) <
             std::pair(reflectance(body_.material_of[b]), b);
    });
    covers.erase(std::unique(covers.begin(), covers.end()), covers.end());
    const Corners3 corners = corners_of(body_, lighter);
    const PlaneFrame frame(corners);
    const std::array<glm::dvec2, 3> flat = frame.flat(corners);
    const FlatPiece whole(flat.begin(), flat.end());
    if (++doubled.triangles == 1) doubled.first_m = corners[0];
    doubled.area_m2 += 0.5 * std::abs(twice_area_m2(whole));
    std::vector<Piece> pieces{{whole, body_.material_of[lighter]}};
    for (const std::uint32_t triangle : covers) pieces = covered(pieces, frame, triangle);
    if (pieces.size() == 1) {
      body_.material_of[lighter] = pieces.front().material;
      return;
    }
    for (const Piece& piece : pieces) append_fan(body_, frame, piece.shape, piece.material);
    remove_triangle(body_, lighter);
  }

  Body& body_;
  const std::vector<Material>& materials_;
  double tolerance_m_;
  std::size_t pairs_left_ = 0;
  std::map<std::uint32_t, std::vector<std::uint32_t>> covers_of_;  // of each lighter triangle
};

}  // namespace

DoubledFaces settle_doubled_faces(Body& body, const std::vector<Material>& materials,
                                  double tolerance_m) {
  return Doubles(body, materials, tolerance_m).settle();
}

}  // namespace calc
