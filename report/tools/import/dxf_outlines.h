#pragma once
// Finds outlines in the lines of a plan.

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

// A piece of a drawing: an open or closed polyline, in the world.
struct PlanPiece {
  std::vector<glm::dvec3> point;
  bool is_closed = false;
  std::string key, place;  // see DesignSource
  std::size_t shape = 0;   // what it is a part of, such as the loops of a hatch; 0: of nothing
};

struct PlanOutline {
  std::vector<glm::dvec2> corner;  // counter-clockwise, simple
  double z = 0.0;                  // the lowest of its pieces
  bool is_level = true;
  std::string key, place;  // of its first piece
  std::string mended;      // what was mended, "" = nothing
  std::size_t shape = 0;   // of its first piece
};
struct PlanOutlines {
  std::vector<PlanOutline> outline;
  struct Failure {
    std::string why, place;
    std::size_t count = 1;
  };
  std::vector<Failure> failure;  // pieces that are part of no outline
};

// Returns outlines. Closed pieces are outlines; open pieces are joined where exactly two ends meet,
// at most `same` apart. closes: before that, an open piece of three points or more is closed by a
// straight line. Order: that of the first pieces.
PlanOutlines find_outlines(const std::vector<PlanPiece>& pieces, double same, bool closes);

}  // namespace cli
