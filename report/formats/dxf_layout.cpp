#include "report/formats/dxf_layout.h"

#include "calc/scene/polygon.h"
#include "report/formats/dxf_entities.h"
#include "report/html/drawings/flat_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace report {
namespace {

constexpr std::array kScales{1000, 500, 250, 200, 100, 50, 25, 20};
constexpr int kUsualScale = 50;

std::size_t shown_count(const std::vector<std::vector<DxfPlacedText>>& planes, double text_m) {
  std::size_t count = 0;
  for (const std::vector<DxfPlacedText>& texts : planes) {
    const std::vector<bool> shown = shown_texts(texts, text_m);
    count += static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true));
  }
  return count;
}

// Its corners and its middle are in the outline, and no corner of the outline is in it.
bool is_inside(const LabelBox& box, const std::vector<glm::dvec2>& outline_m) {
  const std::array corners{box.low, glm::dvec2(box.low.x, box.high.y), box.high,
                           glm::dvec2(box.high.x, box.low.y), 0.5 * (box.low + box.high)};
  const auto is_in = [&](const glm::dvec2& corner) {
    return calc::contains_point(outline_m, corner);
  };
  return std::all_of(corners.begin(), corners.end(), is_in) &&
         std::none_of(outline_m.begin(), outline_m.end(), [&](const glm::dvec2& corner) {
           return box.meets({corner, corner});
         });
}

}  // namespace

LabelBox text_box(const glm::dvec2& middle_m, const std::string& words, double text_m) {
  constexpr double kAir = 1.25;
  return box_around(middle_m, {dxf_width_m(words, text_m), kAir * text_m});
}

template <class Visit>
bool TakenPlaces::any_cell(const LabelBox& box, Visit visit) const {
  constexpr double kMost = 1e12;  // what does not fit into a whole number
  constexpr long long kMostCells = 4096;
  const glm::dvec2 low = glm::floor(box.low / cell_m_), high = glm::floor(box.high / cell_m_);
  for (const double edge : {low.x, low.y, high.x, high.y}) {
    if (!(std::abs(edge) < kMost)) return false;
  }
  const auto columns = static_cast<long long>(high.x - low.x) + 1,
             rows = static_cast<long long>(high.y - low.y) + 1;
  if (columns > kMostCells || rows > kMostCells) return false;
  const auto left = static_cast<long long>(low.x), bottom = static_cast<long long>(low.y);
  for (long long column = left; column < left + columns; ++column) {
    for (long long row = bottom; row < bottom + rows; ++row) {
      if (visit(Cell(column, row))) return true;
    }
  }
  return false;
}

bool TakenPlaces::meets(const LabelBox& box) const {
  return any_cell(box, [&](const Cell& cell) {
    const auto found = boxes_.find(cell);
    return found != boxes_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const LabelBox& other) { return other.meets(box); });
  });
}

void TakenPlaces::add(const LabelBox& box) {
  any_cell(box, [&](const Cell& cell) {
    boxes_[cell].push_back(box);
    return false;
  });
}

std::vector<bool> shown_texts(const std::vector<DxfPlacedText>& texts, double text_m) {
  TakenPlaces taken(text_m);
  std::vector<bool> shown(texts.size(), false);
  for (const DxfTurn turn : {DxfTurn::first, DxfTurn::second, DxfTurn::other}) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (texts[i].turn != turn) continue;
      const LabelBox box = text_box(texts[i].at, texts[i].words, text_m);
      shown[i] = !taken.meets(box);
      if (shown[i]) taken.add(box);
    }
  }
  return shown;
}

double text_height_m(int scale) {
  constexpr double kOnPaper_m = 0.0025;
  return kOnPaper_m * scale;
}

int chosen_scale(const std::vector<std::vector<DxfPlacedText>>& planes, double plan_m) {
  constexpr double kLeastOnPaper_m = 0.15;
  if (!(plan_m > 0.0)) return kUsualScale;
  std::size_t all = 0;
  for (const std::vector<DxfPlacedText>& texts : planes) all += texts.size();
  const auto* const found = std::find_if(kScales.begin(), kScales.end(), [&](int scale) {
    return kLeastOnPaper_m * scale <= plan_m &&
           2 * shown_count(planes, text_height_m(scale)) >= all;
  });
  return found == kScales.end() ? kScales.back() : *found;
}

std::optional<glm::dvec2> free_place(const std::vector<glm::dvec2>& outline_m,
                                     const glm::dvec2& size_m, const TakenPlaces& taken) {
  constexpr int kMostSteps = 60;
  // Each place is held against all corners.
  constexpr std::size_t kMostCorners = 1000;
  FlatBox box;
  for (const glm::dvec2& corner : outline_m) box.add(corner);
  if (box.is_empty() || outline_m.size() > kMostCorners) return {};
  const glm::dvec2 ways = box.size() - size_m;
  if (!(ways.x >= 0.0 && ways.y >= 0.0)) return {};
  for (int row = 1; row < kMostSteps; ++row) {
    for (int column = 1; column < kMostSteps; ++column) {
      const glm::dvec2 corner(box.low.x + ways.x * column / kMostSteps,
                              box.high.y - ways.y * row / kMostSteps);
      const LabelBox place{{corner.x, corner.y - size_m.y}, {corner.x + size_m.x, corner.y}};
      if (!taken.meets(place) && is_inside(place, outline_m)) return corner;
    }
  }
  return {};
}

}  // namespace report
