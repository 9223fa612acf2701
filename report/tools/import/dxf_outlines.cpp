#include "report/tools/import/dxf_outlines.h"

#include "calc/project/reading/project_elements.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_mend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace cli {
namespace {

// So that no file takes all time: 25 outlines of 2000 corners, 40,000 of 50.
constexpr double kMostMending = 1.0e8;

// Places that are the same within a distance get one number.
class PlaceTable {
 public:
  explicit PlaceTable(double same) : same_(same) {}

  std::size_t number_of(const glm::dvec2& at) {
    const auto x = static_cast<std::int64_t>(std::floor(at.x / same_));
    const auto y = static_cast<std::int64_t>(std::floor(at.y / same_));
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t k = y - 1; k <= y + 1; ++k) {
        const auto cell = cells_.find({i, k});
        if (cell == cells_.end()) continue;
        for (const std::size_t number : cell->second) {
          if (glm::distance(place_[number], at) <= same_) return number;
        }
      }
    }
    cells_[{x, y}].push_back(place_.size());
    place_.push_back(at);
    return place_.size() - 1;
  }
  std::size_t size() const { return place_.size(); }

 private:
  double same_;
  std::vector<glm::dvec2> place_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells_;
};

// mending: what may still be done, as pairs of sides; becomes less.
void take_ring(std::vector<glm::dvec3> ring, const PlanPiece& first, double same, double& mending,
               PlanOutlines& found) {
  while (ring.size() > 1 &&
         glm::distance(glm::dvec2(ring.front()), glm::dvec2(ring.back())) <= same) {
    ring.pop_back();
  }
  PlanOutline outline;
  outline.key = first.key;
  outline.place = first.place;
  outline.shape = first.shape;
  outline.z = ring.empty() ? 0.0 : ring.front().z;
  for (const glm::dvec3& point : ring) {
    outline.corner.emplace_back(point);
    outline.is_level = outline.is_level && std::fabs(point.z - ring.front().z) <= same;
    outline.z = std::min(outline.z, point.z);
  }
  if (outline.corner.size() > calc::kCornerLimit) {
    found.failure.push_back(
        {fmt::format("it has more than {} corners", calc::kCornerLimit), first.place});
    return;
  }
  if (!calc::is_simple_polygon(outline.corner)) {
    const auto sides = static_cast<double>(outline.corner.size());
    mending -= sides * sides;
    if (mending < 0.0) {
      found.failure.push_back(
          {"its sides may cross or touch each other; this was not checked, because so many others "
           "do",
           first.place});
      return;
    }
    const std::optional<calc::MendedPolygon> mended = calc::mend_polygon(outline.corner);
    if (!mended || mended->ring.size() != 1) {
      found.failure.push_back(
          {outline.corner.size() < 3 || calc::enclosed_area(outline.corner) == 0.0
               ? "it encloses no area"
               : "its sides cross or touch each other",
           first.place});
      return;
    }
    std::vector<glm::dvec2> corner;
    for (const std::uint32_t index : mended->ring[0]) corner.push_back(outline.corner[index]);
    outline.corner = std::move(corner);
    outline.mended = mended->mending.words();
  }
  if (calc::signed_area(outline.corner) < 0.0) {
    std::reverse(outline.corner.begin(), outline.corner.end());
  }
  found.outline.push_back(std::move(outline));
}

}  // namespace

PlanOutlines find_outlines(const std::vector<PlanPiece>& pieces, double same, bool closes) {
  PlanOutlines found;
  struct Open {
    std::size_t piece, from, to;
    bool is_taken = false;
  };
  std::vector<Open> open;
  PlaceTable places(same);
  // Rings in the order of their first pieces: closed ones wait for their turn.
  std::vector<std::pair<std::size_t, std::vector<glm::dvec3>>> rings;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PlanPiece& piece = pieces[i];
    if (piece.point.empty()) continue;
    const bool meets =
        glm::distance(glm::dvec2(piece.point.front()), glm::dvec2(piece.point.back())) <= same;
    if (piece.is_closed || (piece.point.size() > 3 && meets) ||
        (closes && piece.point.size() > 2)) {
      rings.emplace_back(i, piece.point);
    } else if (meets) {
      found.failure.push_back({"it has no length", piece.place});
    } else {
      open.push_back(
          {i, places.number_of(piece.point.front()), places.number_of(piece.point.back())});
    }
  }
  std::vector<std::vector<std::size_t>> at(places.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    at[open[i].from].push_back(i);
    at[open[i].to].push_back(i);
  }
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (open[start].is_taken) continue;
    // Follow the line as long as exactly two pieces meet.
    std::vector<glm::dvec3> ring;
    std::vector<std::size_t> way;
    std::size_t current = start, node = open[start].from;
    bool is_closed = false;
    while (true) {
      Open& piece = open[current];
      piece.is_taken = true;
      way.push_back(current);
      const std::vector<glm::dvec3>& point = pieces[piece.piece].point;
      const bool is_forward = piece.from == node;
      for (std::size_t k = 0; k + 1 < point.size(); ++k) {
        ring.push_back(is_forward ? point[k] : point[point.size() - 1 - k]);
      }
      node = is_forward ? piece.to : piece.from;
      if (at[node].size() != 2) break;
      const std::size_t next = at[node][0] == current ? at[node][1] : at[node][0];
      if (next == start) {
        is_closed = at[open[start].from].size() == 2 && node == open[start].from;
        break;
      }
      if (open[next].is_taken) break;
      current = next;
    }
    if (is_closed) {
      rings.emplace_back(open[start].piece, std::move(ring));
    } else {
      found.failure.push_back({"lines do not meet, or more than two meet at a point",
                               pieces[open[start].piece].place, way.size()});
    }
  }
  std::sort(rings.begin(), rings.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  double mending = kMostMending;
  for (auto& [first, ring] : rings) {
    take_ring(std::move(ring), pieces[first], same, mending, found);
  }
  return found;
}

}  // namespace cli
