#pragma once
// Plans of storeys and sites as SVG at a drawing scale.

#include "report/document/document.h"
#include "report/html/drawings/flat_box.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {

// A room, or a plane of a site.
struct PlanArea {
  std::vector<glm::dvec2> outline_m;  // three corners or more, finite
  bool is_room = true;                // walls around it; else dashed
  // Labels as lines below each other, the first line bold; the best label first. The last is short:
  // its name is explained in a list below the plan. Not empty.
  std::vector<std::vector<std::string>> labels;
  std::optional<rules::Outcome> outcome;  // its tint; nothing: it has none
  std::string sign = {};                  // of it, where not even the short name has room
};

struct PlanSign {
  const LuminaireMark* luminaire = nullptr;
  std::string letter;  // of its type, where its mark has no room
};

struct PlanContents {
  std::vector<PlanArea> areas;
  std::vector<std::vector<glm::dvec2>> dashed_m;   // outlines without labels
  std::vector<std::array<glm::dvec2, 2>> lines_m;  // of furniture and buildings
  std::vector<PlanSign> luminaires;
  std::optional<double> north_deg;  // from +x counter-clockwise
};

// The scale 1:scale; turned: +x points up.
struct PlanFit {
  double scale = 100.0;
  bool is_turned = false;
};
// Returns the largest of 1:50, 1:100, 1:200, 1:250, 1:500, 1:1000 and so on, but no larger than
// 1:least_scale, at which this size fits on a page beside its heading. Turned only if that makes
// the scale larger. Empty: none fits up to 1:10 000, or the size is not finite.
std::optional<PlanFit> fit_plan(const glm::dvec2& size_m, Paper paper, double least_scale);

struct PlanDrawing {
  std::string svg;
  double width_mm = 0;
  std::vector<bool> is_short;  // by area: it is labelled by its short name, or not at all
  std::size_t outside = 0;     // luminaires that are not drawn
  std::size_t without_letter = 0;
  bool is_as_points = false;  // too many luminaires for outlines and letters
};
// Draws the plan. extent_m: the part that the page shows. title: for screen readers, not escaped.
// anchor: unique in the page.
PlanDrawing draw_plan(const Texts& t, const PlanContents& contents, const FlatBox& extent_m,
                      const PlanFit& fit, const std::string& title, const std::string& anchor);

}  // namespace report
