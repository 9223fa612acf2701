#include "calc/project/warnings/flat_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace calc {

Corners3 corners_of(const Body& body, std::size_t triangle) {
  const glm::uvec3& t = body.triangle[triangle];
  return {body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z]};
}

PlaneFrame::PlaneFrame(const Corners3& t) : origin_m(t[0]) {
  const glm::dvec3 side = t[1] - t[0], across = glm::cross(side, t[2] - t[0]);
  const double length_m = glm::length(side), area = glm::length(across);
  is_valid = area > kSamePlane_m * length_m;
  if (!is_valid) return;
  normal = across / area;
  u = side / length_m;
  v = glm::cross(normal, u);
}

bool PlaneFrame::holds(const Corners3& t, double tolerance_m) const {
  return std::all_of(t.begin(), t.end(),
                     [&](const glm::dvec3& p) { return std::abs(height_m(p)) <= tolerance_m; });
}

bool lie_in_one_plane(const PlaneFrame& frame, const Corners3& one, const Corners3& other,
                      double tolerance_m) {
  if (!frame.is_valid) return false;
  if (frame.holds(other, tolerance_m)) return true;
  const PlaneFrame of_other(other);
  return of_other.is_valid && of_other.holds(one, tolerance_m);
}

double twice_area_m2(const FlatPiece& piece) {
  double sum = 0.0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const glm::dvec2 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

namespace {

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

}  // namespace

PieceCut cut_by(FlatPiece piece, std::array<glm::dvec2, 3> triangle) {
  const glm::dvec2 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
  if (ab.x * ac.y - ab.y * ac.x < 0.0) std::swap(triangle[1], triangle[2]);
  PieceCut cut;
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

void remove_triangle(Body& body, std::size_t triangle) {
  body.triangle[triangle] = body.triangle.back();
  body.material_of[triangle] = body.material_of.back();
  body.triangle.pop_back();
  body.material_of.pop_back();
}

}  // namespace calc
