#include "calc/scene/polygon_cut.h"

#include "calc/scene/polygon.h"

#include <cstddef>
#include <utility>

namespace calc {
namespace {

// > 0 on the left of the line from a to b.
double side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// The parts of a piece on the left and on the right of the line.
std::pair<ConvexPiece, ConvexPiece> split(const ConvexPiece& piece, glm::dvec2 a, glm::dvec2 b) {
  ConvexPiece left, right;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const glm::dvec2 p = piece[i], q = piece[(i + 1) % piece.size()];
    const double sp = side(a, b, p), sq = side(a, b, q);
    if (sp >= 0.0) left.push_back(p);
    if (sp <= 0.0) right.push_back(p);
    if ((sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0)) {
      const glm::dvec2 on_line = p + sp / (sp - sq) * (q - p);
      left.push_back(on_line);
      right.push_back(on_line);
    }
  }
  return {std::move(left), std::move(right)};
}

}  // namespace

std::vector<ConvexPiece> convex_pieces(const std::vector<glm::dvec2>& polygon) {
  std::vector<ConvexPiece> pieces;
  const auto triangles = triangulate_polygon(polygon);
  if (!triangles) return pieces;
  for (const glm::uvec3& t : *triangles) {
    ConvexPiece piece{polygon[t.x], polygon[t.y], polygon[t.z]};
    if (signed_area(piece) < 0.0) std::swap(piece[1], piece[2]);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<ConvexPiece> cut_out(const std::vector<ConvexPiece>& pieces, const ConvexPiece& hole) {
  constexpr double kSliver = 1.0e-12;
  const double least = kSliver * area(pieces);
  std::vector<ConvexPiece> left_over;
  for (const ConvexPiece& piece : pieces) {
    std::vector<ConvexPiece> outside;
    ConvexPiece inside = piece;
    for (std::size_t i = 0; i < hole.size() && !inside.empty(); ++i) {
      auto [left, right] = split(inside, hole[i], hole[(i + 1) % hole.size()]);
      if (signed_area(right) > least) outside.push_back(std::move(right));
      inside = signed_area(left) > least ? std::move(left) : ConvexPiece();
    }
    if (inside.empty()) {
      left_over.push_back(piece);  // untouched: not to be cut along the hole's lines
    } else {
      for (ConvexPiece& part : outside) left_over.push_back(std::move(part));
    }
  }
  return left_over;
}

double area(const std::vector<ConvexPiece>& pieces) {
  double sum = 0.0;
  for (const ConvexPiece& piece : pieces) sum += signed_area(piece);
  return sum;
}

}  // namespace calc
