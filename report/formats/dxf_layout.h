#pragma once
// Places for the texts of a drawing. Lengths in metres; all texts of a drawing have one height.

#include "report/html/drawings/html_isolux.h"

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace report {

// The order in which texts get their places.
enum class DxfTurn { first, second, other };

// A text with the place of its middle.
struct DxfPlacedText {
  glm::dvec2 at{0.0};
  std::string words;
  DxfTurn turn = DxfTurn::other;
};

// Returns the box of a text, with a little air above and below.
LabelBox text_box(const glm::dvec2& middle_m, const std::string& words, double text_m);

// The occupied places. A place far beyond any building is never occupied.
class TakenPlaces {
 public:
  // text_m: > 0, height of the texts that will be tested.
  explicit TakenPlaces(double text_m) : cell_m_(8.0 * text_m) {}

  bool meets(const LabelBox& box) const;
  void add(const LabelBox& box);

 private:
  using Cell = std::pair<long long, long long>;
  // Calls visit(cell) until that returns true, which is then the result.
  template <class Visit>
  bool any_cell(const LabelBox& box, Visit visit) const;

  double cell_m_;
  std::map<Cell, std::vector<LabelBox>> boxes_;
};

// Returns which texts can be shown without overlap: turn by turn and in their order, each that
// overlaps no earlier text.
std::vector<bool> shown_texts(const std::vector<DxfPlacedText>& texts, double text_m);

// Returns the height of texts that are 2.5 mm high on paper at 1:scale.
double text_height_m(int scale);

// Returns the coarsest of 1:20, 1:25, 1:50, 1:100, 1:200, 1:250, 1:500 and 1:1000 at which the plan
// is 150 mm long on paper and at least half of all texts can be shown without overlap. Else 1:20;
// 1:50 without a plan. planes: each has its own texts. plan_m: the longest side of the plan, 0
// without one.
int chosen_scale(const std::vector<std::vector<DxfPlacedText>>& planes, double plan_m);

// Returns the upper left corner of a free place of that size inside the outline: the highest, and
// of these the leftmost. Tries 59 x 59 places; empty for outlines of more than 1,000 corners.
std::optional<glm::dvec2> free_place(const std::vector<glm::dvec2>& outline_m,
                                     const glm::dvec2& size_m, const TakenPlaces& taken);

}  // namespace report
