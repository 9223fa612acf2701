#include "report/formats/dxf.h"

#include "calc/scene/polygon.h"
#include "report/formats/console.h"
#include "report/formats/dxf_entities.h"
#include "report/formats/dxf_text.h"
#include "report/html/drawings/flat_box.h"
#include "report/html/drawings/html_isolux.h"
#include "report/html/drawings/html_plan.h"
#include "report/html/drawings/plan_layout.h"
#include "report/images/heatmap.h"
#include "report/text/luminaire_aim.h"
#include "report/text/plane_names.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr double kGap_m = 1.0;       // between parts of the drawing
constexpr double kLineByText = 1.6;  // from base line to base line
constexpr double kLeastText_m = 0.02;
constexpr std::size_t kLegendSigns = 200;  // characters of the legend

// Layers, from which an office takes what it needs.
constexpr const char* kRooms = "LUX_ROOMS";
constexpr const char* kRoomNames = "LUX_ROOM_NAMES";
constexpr const char* kFurniture = "LUX_FURNITURE";
constexpr const char* kLuminaires = "LUX_LUMINAIRES";
constexpr const char* kNumbers = "LUX_LUMINAIRE_NUMBERS";
constexpr const char* kPlanes = "LUX_PLANES";
constexpr const char* kPlaneNames = "LUX_PLANE_NAMES";
constexpr const char* kValues = "LUX_VALUES";
constexpr const char* kIsolux = "LUX_ISOLUX";
constexpr const char* kIsoluxLimits = "LUX_ISOLUX_LIMITS";
constexpr const char* kIsoluxLabels = "LUX_ISOLUX_LABELS";
constexpr const char* kLegend = "LUX_LEGEND";

// In the order of attributes of a luminaire.
const std::vector<std::string_view> kTags{
    "NUMBER",      "ID",    "ROOM",    "TYPE",       "GROUP",   "HEIGHT_M", "TILT_DEG",
    "HEADING_DEG", "MAKER", "ARTICLE", "PHOTOMETRY", "FLUX_LM", "POWER_W"};

DxfColour colour_of(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::pass:
      return DxfColour::green;
    case rules::Outcome::fail:
      return DxfColour::red;
    case rules::Outcome::undecided:
      return DxfColour::orange;
    case rules::Outcome::not_judged:
    case rules::Outcome::warned:
      return DxfColour::magenta;
    case rules::Outcome::waived:
    case rules::Outcome::nothing_asked:
      break;
  }
  return DxfColour::grey;
}

rules::Outcome outcome_of_plane(const PlanePart& plane) {
  if (!plane.is_computed) return rules::Outcome::not_judged;
  rules::Outcome gravest = rules::Outcome::nothing_asked;
  for (const rules::Finding& finding : plane.findings)
    gravest = rules::graver(gravest, rules::outcome_of(finding));
  return gravest;
}

bool is_level(const PlanePart& plane) {
  return is_horizontal(glm::cross(plane.grid.u, plane.grid.v));
}

std::string title_of_plane(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  return fmt::format("{} / {}", title_of(space.name, space.id), plane_name(t, space, plane));
}

std::string plane_label(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  const bool is_outside =
      std::any_of(plane.findings.begin(), plane.findings.end(),
                  [](const auto& finding) { return is_outside_advice(finding); });
  const rules::Outcome outcome = outcome_of_plane(plane);
  std::string words = fmt::format("{}: {}", plane_name(t, space, plane),
                                  is_outside && outcome == rules::Outcome::nothing_asked
                                      ? t[Text::advice_outside]
                                      : outcome_words(t, outcome));
  if (!plane.is_computed) words += std::string(", ") + t[Text::not_computed];
  if (!doubt_words(t, plane).empty()) words += fmt::format(" ({})", t[Text::doubt]);
  return words;
}

// Where a plane is drawn: at its place in the world, or flat beside the plan.
class Placing {
 public:
  static Placing world(const glm::dvec2& shift_m) { return Placing(shift_m); }
  // grid: outlives it. corner_m: where its origin is drawn.
  static Placing flat(const calc::SensorGrid& grid, const glm::dvec2& corner_m) {
    Placing placing(corner_m);
    placing.grid_ = &grid;
    return placing;
  }

  glm::dvec3 at(const glm::dvec3& world_m) const {
    if (grid_ == nullptr) return world_m + glm::dvec3(shift_m_, 0.0);
    const glm::dvec3 offset = world_m - grid_->origin_m;
    return {shift_m_.x + glm::dot(offset, grid_->u), shift_m_.y + glm::dot(offset, grid_->v), 0.0};
  }
  // uv_m: from the grid's origin.
  glm::dvec3 at(const calc::SensorGrid& grid, const glm::dvec2& uv_m) const {
    return at(grid.origin_m + uv_m.x * grid.u + uv_m.y * grid.v);
  }

 private:
  explicit Placing(const glm::dvec2& shift_m) : shift_m_(shift_m) {}

  glm::dvec2 shift_m_;
  const calc::SensorGrid* grid_ = nullptr;
};

// What a plane has to say, in the layers of its tier.
struct PlaneLayers {
  std::string values, isolux, limits, labels;
};

// The first of them have plain names.
PlaneLayers layers_of_tier(std::size_t tier) {
  const auto name = [tier](const char* layer) {
    return tier == 0 ? std::string(layer) : fmt::format("{}_{}", layer, tier + 1);
  };
  return {name(kValues), name(kIsolux), name(kIsoluxLimits), name(kIsoluxLabels)};
}

FlatBox box_of(const PlanePart& plane) {
  FlatBox box;
  const calc::SensorGrid& grid = plane.grid;
  for (const glm::dvec2& corner : plane.outline_m)
    box.add(grid.origin_m + corner.x * grid.u + corner.y * grid.v);
  for (const PointRow& point : plane.points) box.add(point.position_m);
  return box;
}

// Points of one lie in the area of the other: their numbers would be mixed.
bool has_points_in(const PlanePart& plane, const PlanePart& area) {
  const calc::SensorGrid& grid = area.grid;
  const auto is_in = [&](const PointRow& point) {
    const glm::dvec3 offset = point.position_m - grid.origin_m;
    const glm::dvec2 uv(glm::dot(offset, grid.u), glm::dot(offset, grid.v));
    return calc::contains_point(area.outline_m, uv) &&
           std::none_of(area.holes_m.begin(), area.holes_m.end(),
                        [&](const auto& hole) { return calc::contains_point(hole, uv); });
  };
  return std::any_of(plane.points.begin(), plane.points.end(), is_in);
}

bool meet(const PlanePart& a, const FlatBox& box_a, const PlanePart& b, const FlatBox& box_b) {
  if (!box_a.meets(box_b)) return false;
  if (a.outline_m.empty() || b.outline_m.empty()) return true;
  return has_points_in(a, b) || has_points_in(b, a);
}

// Levels in which no plane's values lie over another's.
class Tiers {
 public:
  std::size_t tier_of(const PlanePart& plane) {
    const FlatBox box = box_of(plane);
    std::size_t tier = 0;
    for (; tier < tiers_.size(); ++tier) {
      const bool is_free = std::none_of(
          tiers_[tier].begin(), tiers_[tier].end(),
          [&](const auto& other) { return meet(plane, box, *other.first, other.second); });
      if (is_free) break;
    }
    if (tier == tiers_.size()) tiers_.emplace_back();
    tiers_[tier].emplace_back(&plane, box);
    return tier;
  }

 private:
  std::vector<std::vector<std::pair<const PlanePart*, FlatBox>>> tiers_;
};

struct ValueText {
  glm::dvec3 at;
  std::string words;
};

std::vector<ValueText> value_texts(const Texts& t, const PlanePart& plane, const Placing& placing) {
  const Thresholds thresholds = point_thresholds(plane);
  std::vector<ValueText> texts;
  for (const PointRow& point : plane.points) {
    texts.push_back({placing.at(point.position_m),
                     dxf_text(dxf_signs(cell_words(t, plane, point.measured.value, thresholds)))});
  }
  return texts;
}

// So that each number stays in its cell.
double value_height_m(const PlanePart& plane, const std::vector<ValueText>& texts) {
  constexpr double kOfList_m = 0.1, kPartOfHeight = 0.4, kPartOfWidth = 0.85, kLargest_m = 1.0;
  if (plane.grid.columns <= 0) return kOfList_m;
  std::size_t longest = 1;
  for (const ValueText& text : texts) longest = std::max(longest, text.words.size());
  const double height =
      std::min(kPartOfHeight * plane.grid.spacing_v_m,
               kPartOfWidth * plane.grid.spacing_u_m / static_cast<double>(longest));
  return std::clamp(height, kLeastText_m, kLargest_m);
}

// Two numbers at one place can be read of neither point.
bool has_stacked_points(const std::vector<ValueText>& texts, double height_m) {
  std::set<std::pair<long long, long long>> places;
  for (const ValueText& text : texts) {
    const glm::dvec2 place(text.at / height_m);
    constexpr double kMost = 1e15;  // what does not fit into a whole number
    if (!(std::abs(place.x) < kMost && std::abs(place.y) < kMost)) continue;
    if (!places.emplace(std::llround(place.x), std::llround(place.y)).second) return true;
  }
  return false;
}

double length_of(const IsoluxLine& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points_m.size(); ++i)
    length += glm::distance(line.points_m[i], line.points_m[i + 1]);
  return length;
}

// On the line, nearest to its middle, where no number stands; its middle where there is no such
// place.
glm::dvec2 label_place(const IsoluxLine& line, const glm::dvec2& size_m,
                       const std::vector<LabelBox>& taken) {
  constexpr std::size_t kMostTaken = 2500, kMostTries = 200;
  const std::size_t count = line.points_m.size(), middle = count / 2;
  if (taken.size() > kMostTaken) return line.points_m[middle];
  for (std::size_t step = 0; step < std::min(count, kMostTries); ++step) {
    const std::size_t half = (step + 1) / 2;
    const std::size_t i = (step % 2 == 0 ? middle + half : middle + count - half) % count;
    const LabelBox box = box_around(line.points_m[i], size_m);
    if (std::none_of(taken.begin(), taken.end(),
                     [&](const LabelBox& other) { return other.meets(box); }))
      return line.points_m[i];
  }
  return line.points_m[middle];
}

// "3 in the margin, 2 outside the room".
std::string dropped_reasons(const Texts& t, const calc::SensorGrid& grid) {
  std::map<calc::DropReason, std::size_t> counts;
  for (const calc::DroppedPoint& point : grid.dropped) ++counts[point.reason];
  std::string words;
  for (const auto& [reason, count] : counts)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, drop_words(t, reason));
  return words;
}

// The sign of a luminaire, around its place, C0 along +x.
std::string sign_of(const std::vector<glm::dvec2>& outline_m, bool has_direction) {
  constexpr double kRadius_m = 0.08, kArrow_m = 0.3, kHead_m = 0.06;
  std::string dxf;
  if (outline_m.empty()) {
    dxf_circle(kLuminaires, {0, 0, 0}, kRadius_m, dxf);
    const double half = 0.7 * kRadius_m;
    dxf_line(kLuminaires, {-half, -half, 0}, {half, half, 0}, dxf);
    dxf_line(kLuminaires, {-half, half, 0}, {half, -half, 0}, dxf);
  }
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& corner : outline_m) corners.emplace_back(corner, 0.0);
  dxf_polyline(kLuminaires, corners, true, DxfColour::by_layer, dxf);
  if (!has_direction) return dxf;
  const glm::dvec3 tip(kArrow_m, 0, 0);
  dxf_line(kLuminaires, {0, 0, 0}, tip, dxf);
  for (const double side : {-1.0, 1.0})
    dxf_line(kLuminaires, tip, tip + kHead_m * glm::dvec3(-1.0, 0.5 * side, 0.0), dxf);
  return dxf;
}

// Of its opening, around its place, turned back so that C0 is along +x. Luminaires of one look have
// one outline: to 10 micrometres, and from the leftmost corner on.
std::vector<glm::dvec2> own_outline(const LuminaireMark& mark, bool has_direction) {
  constexpr double kRounding = 1e5;
  const glm::dvec2 ahead =
      has_direction ? glm::normalize(glm::dvec2(mark.c0)) : glm::dvec2(1.0, 0.0);
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2& corner : mark.outline_m) {
    const glm::dvec2 aside = corner - glm::dvec2(mark.position_m);
    const glm::dvec2 own(glm::dot(aside, ahead), ahead.x * aside.y - ahead.y * aside.x);
    outline.push_back(glm::round(own * kRounding) / kRounding);
  }
  const auto leftmost = std::min_element(outline.begin(), outline.end(),
                                         [](const glm::dvec2& a, const glm::dvec2& b) {
                                           return std::pair(a.x, a.y) < std::pair(b.x, b.y);
                                         });
  std::rotate(outline.begin(), leftmost, outline.end());
  return outline;
}

FlatBox box_of(const ProjectPart& project) {
  FlatBox box;
  for (const SpacePart& space : project.spaces) {
    for (const glm::dvec2& corner : space.footprint_m) box.add(corner);
    for (const LuminaireMark& mark : space.luminaires) {
      box.add(mark.position_m);
      for (const glm::dvec2& corner : mark.outline_m) box.add(corner);
    }
    for (const glm::dvec3& end : space.surface_lines_m) box.add(end);
    for (const BodyMark& body : space.bodies) {
      for (const auto& line : body.lines_m) {
        for (const glm::dvec2& end : line) box.add(end);
      }
    }
    for (const PlanePart& plane : space.planes) {
      const FlatBox of_plane = box_of(plane);
      if (of_plane.is_empty()) continue;
      box.add(of_plane.low);
      box.add(of_plane.high);
    }
  }
  return box;
}

bool has_storeys(const ProjectPart& project) {
  constexpr double kOverlap_m = 0.01;
  std::vector<FlatBox> boxes;
  for (const SpacePart& space : project.spaces) {
    FlatBox box;
    for (const glm::dvec2& corner : space.footprint_m) box.add(corner);
    if (box.is_empty()) continue;
    box.low += kOverlap_m;
    box.high -= kOverlap_m;
    if (std::any_of(boxes.begin(), boxes.end(),
                    [&](const FlatBox& other) { return other.meets(box); }))
      return true;
    boxes.push_back(box);
  }
  return false;
}

class DxfWriter : public FormatWriter {
 public:
  DxfWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
            ScaleSharing sharing)
      : place_(place), t_(t), sharing_(sharing), blocks_(place), entities_(place) {
    TextOptions options;
    options.lists_passes = true;
    table_ = text_writer(frame, place, options, t);
    for (const auto& [name, colour] :
         {std::pair(kRooms, DxfColour::ink), std::pair(kRoomNames, DxfColour::ink),
          std::pair(kFurniture, DxfColour::grey), std::pair(kLuminaires, DxfColour::sky),
          std::pair(kNumbers, DxfColour::sky), std::pair(kPlanes, DxfColour::ink),
          std::pair(kPlaneNames, DxfColour::ink), std::pair(kLegend, DxfColour::ink)}) {
      layers_[name] = {colour, false};
    }
    use_tier(0);
  }

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  void use_tier(std::size_t tier);
  void note(std::string words) { notes_.push_back(std::move(words)); }
  void flush() {
    entities_.write(dxf_);
    dxf_.clear();
  }
  void extend(const FlatBox& box) {
    if (box.is_empty()) return;
    extent_.add(box.low);
    extent_.add(box.high);
  }

  void draw_room(const SpacePart& space, const glm::dvec2& shift_m, double text_m);
  void draw_luminaires(const ProjectPart& project, const SpacePart& space,
                       const glm::dvec2& shift_m);
  // The name of a block that looks like it.
  std::string block_of(const LuminaireMark& mark, bool has_direction);
  void draw_outlines(const PlanePart& plane, const Placing& placing);
  void draw_values(const SpacePart& space, const PlanePart& plane, const Placing& placing,
                   const PlaneLayers& layers);
  void draw_isolux(const SpacePart& space, const PlanePart& plane, const Placing& placing,
                   const PlaneLayers& layers, std::vector<LabelBox> taken, double text_m);
  void draw_level(const SpacePart& space, const PlanePart& plane, const glm::dvec2& shift_m,
                  double text_m);
  // Below the plan.
  void draw_beside(const SpacePart& space, const PlanePart& plane, double text_m);
  void write_legend(const DocumentEnd& end, Spill& legend);

  SpillPlace place_;
  Texts t_;
  ScaleSharing sharing_;
  Spill blocks_, entities_;
  std::unique_ptr<FormatWriter> table_;
  std::map<std::string, DxfLayer> layers_;
  std::vector<std::string> notes_;  // of the legend
  FlatBox extent_;                  // of all that is drawn
  std::string dxf_;                 // entities that are not yet in entities_
  bool has_beside_ = false;

  // Of the project that is drawn.
  ColourScales scales_;
  Tiers tiers_;
  std::map<std::string, std::string> blocks_of_project_;  // names, by type and look
  std::size_t types_ = 0;                                 // blocks of all projects
  std::map<std::pair<long long, long long>, int> labels_at_;
  glm::dvec2 shelf_m_{0.0};  // where the next plane is drawn beside the plan: its upper left corner
  double shelf_left_m_ = 0.0, shelf_right_m_ = 0.0, shelf_height_m_ = 0.0;
};

void DxfWriter::use_tier(std::size_t tier) {
  const PlaneLayers layers = layers_of_tier(tier);
  const bool is_off = tier > 0;
  layers_[layers.values] = {DxfColour::ink, is_off};
  layers_[layers.isolux] = {DxfColour::blue, is_off};
  layers_[layers.limits] = {DxfColour::cyan, is_off};
  layers_[layers.labels] = {DxfColour::blue, is_off};
}

void DxfWriter::draw_room(const SpacePart& space, const glm::dvec2& shift_m, double text_m) {
  std::vector<glm::dvec3> corners;
  FlatBox box;
  for (const glm::dvec2& corner : space.footprint_m) {
    corners.emplace_back(corner + shift_m, space.floor_z_m);
    box.add(corners.back());
  }
  dxf_polyline(kRooms, corners, true, DxfColour::by_layer, dxf_);
  const glm::dvec3 shift(shift_m, 0.0);
  for (std::size_t i = 0; i + 1 < space.surface_lines_m.size(); i += 2) {
    dxf_line(kRooms, space.surface_lines_m[i] + shift, space.surface_lines_m[i + 1] + shift, dxf_);
    if (space.footprint_m.empty()) box.add(space.surface_lines_m[i] + shift);
  }
  if (!box.is_empty()) {
    const glm::dvec3 at(box.low + 0.5 * text_m, space.floor_z_m);
    dxf_words(kRoomNames, at, text_m, dxf_text(dxf_signs(title_of(space.name, space.id))),
              DxfAlign::start, DxfColour::by_layer, dxf_);
  }
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) {
      dxf_line(kFurniture, {line[0] + shift_m, body.high_z_m}, {line[1] + shift_m, body.high_z_m},
               dxf_);
    }
  }
  if (space.surface_lines_left_out > 0) {
    note(fmt::format("{}: {} {}", title_of(space.name, space.id), t_[Text::layout_surface_lines],
                     t_.say<Text::layout_lines_left_out>(space.surface_lines_left_out)));
  }
  if (space.bodies_left_out > 0) {
    note(fmt::format("{}: {}", title_of(space.name, space.id),
                     t_.say<Text::furniture_left_out>(space.bodies_left_out)));
  }
}

std::string DxfWriter::block_of(const LuminaireMark& mark, bool has_direction) {
  const std::string sign = sign_of(own_outline(mark, has_direction), has_direction);
  const auto [found, is_new] = blocks_of_project_.try_emplace(mark.type_id + "\n" + sign);
  if (is_new) {
    found->second = dxf_name(fmt::format("LUX_{}_", ++types_), mark.type_id);
    std::string dxf;
    dxf_block(kLuminaires, found->second, sign, kTags, dxf);
    blocks_.write(dxf);
  }
  return found->second;
}

void DxfWriter::draw_luminaires(const ProjectPart& project, const SpacePart& space,
                                const glm::dvec2& shift_m) {
  constexpr double kNumber_m = 0.12;
  const auto known = [](const std::optional<double>& value) {
    return value ? format_shortest(*value) : "";
  };
  for (std::size_t i = 0; i < space.luminaires.size(); ++i) {
    const LuminaireMark& mark = space.luminaires[i];
    const LuminaireAim aim = aim_of(mark);
    const auto type =
        std::find_if(project.luminaires.begin(), project.luminaires.end(),
                     [&](const LuminaireRow& row) { return row.type_id == mark.type_id; });
    const LuminaireRow row = type == project.luminaires.end() ? LuminaireRow{} : *type;
    const bool has_floor = !space.footprint_m.empty();
    const std::string number = fmt::format("{}", i + 1);
    const std::vector<std::string> values{
        number,
        dxf_text(mark.id),
        dxf_text(space.id),
        dxf_text(mark.type_id),
        dxf_text(mark.group),
        has_floor ? format_shortest(mark.position_m.z - space.floor_z_m) : "",
        known(aim.tilt_deg),
        known(aim.heading_deg),
        dxf_text(row.maker),
        dxf_text(row.article()),
        dxf_text(row.photometry_file),
        row.flux_lm > 0.0 ? format_shortest(row.flux_lm) : "",
        row.power_w > 0.0 ? format_shortest(row.power_w) : ""};
    std::vector<DxfAttribute> attributes;
    for (std::size_t k = 0; k < kTags.size(); ++k) attributes.emplace_back(kTags[k], values[k]);
    const glm::dvec3 at = mark.position_m + glm::dvec3(shift_m, 0.0);
    dxf_insert(kLuminaires, block_of(mark, aim.turn_deg.has_value()), at,
               aim.turn_deg.value_or(0.0), attributes, dxf_);
    FlatBox sign;
    sign.add(at);
    for (const glm::dvec2& corner : mark.outline_m) sign.add(corner + shift_m);
    dxf_words(kNumbers, {sign.high.x + 0.5 * kNumber_m, sign.low.y - kNumber_m, at.z}, kNumber_m,
              number, DxfAlign::start, DxfColour::by_layer, dxf_);
  }
}

void DxfWriter::draw_outlines(const PlanePart& plane, const Placing& placing) {
  const DxfColour colour = colour_of(outcome_of_plane(plane));
  const auto draw = [&](const std::vector<glm::dvec2>& outline) {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& corner : outline) corners.push_back(placing.at(plane.grid, corner));
    dxf_polyline(kPlanes, corners, true, colour, dxf_);
  };
  draw(plane.outline_m);
  for (const auto& hole : plane.holes_m) draw(hole);
}

void DxfWriter::draw_isolux(const SpacePart& space, const PlanePart& plane, const Placing& placing,
                            const PlaneLayers& layers, std::vector<LabelBox> taken, double text_m) {
  if (!has_cells(plane)) return;
  const std::string title = title_of_plane(t_, space, plane);
  if (!has_all_values(plane)) return note(t_.say<Text::dxf_no_isolux>(title));
  const PlanIsolux isolux = plan_isolux(t_, space, plane, scales_.of(space, plane));
  if (!isolux.has_all) note(title + ": " + t_[Text::isolux_left_out]);
  for (const IsoluxLevel& level : isolux.levels) {
    const IsoluxLine* longest = nullptr;
    for (const IsoluxLine& line : level.lines) {
      std::vector<glm::dvec3> corners;
      for (const glm::dvec2& corner : line.points_m)
        corners.push_back(placing.at(plane.grid, corner));
      // A closed one ends where it starts.
      if (line.is_closed && corners.size() > 2) corners.pop_back();
      dxf_polyline(level.is_required ? layers.limits : layers.isolux, corners, line.is_closed,
                   DxfColour::by_layer, dxf_);
      if (longest == nullptr || length_of(line) > length_of(*longest)) longest = &line;
    }
    if (longest == nullptr || longest->points_m.empty()) continue;
    const std::string words = dxf_text(format_shortest(t_, level.value));
    const glm::dvec2 size(dxf_width_m(words, text_m), text_m);
    const glm::dvec2 place = label_place(*longest, size, taken);
    taken.push_back(box_around(place, size));
    dxf_words(layers.labels, placing.at(plane.grid, place), text_m, words, DxfAlign::middle,
              DxfColour::by_layer, dxf_);
  }
}

void DxfWriter::draw_values(const SpacePart& space, const PlanePart& plane, const Placing& placing,
                            const PlaneLayers& layers) {
  const calc::SensorGrid& grid = plane.grid;
  const std::vector<ValueText> texts = value_texts(t_, plane, placing);
  const double text_m = value_height_m(plane, texts);
  std::vector<LabelBox> taken;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const ValueText& text = texts[i];
    dxf_words(layers.values, text.at, text_m, text.words, DxfAlign::middle, DxfColour::by_layer,
              dxf_);
    const glm::dvec3 offset = plane.points[i].position_m - grid.origin_m;
    taken.push_back(box_around({glm::dot(offset, grid.u), glm::dot(offset, grid.v)},
                               {dxf_width_m(text.words, text_m), text_m}));
  }
  for (const calc::DroppedPoint& point : grid.dropped) {
    if (point.reason == calc::DropReason::outside_area) continue;  // no point of the plane
    dxf_words(layers.values, placing.at(point.position_m), text_m, "x", DxfAlign::middle,
              DxfColour::grey, dxf_);
  }
  const std::string title = title_of_plane(t_, space, plane);
  if (!grid.dropped.empty()) note(t_.say<Text::dxf_left_out>(title, dropped_reasons(t_, grid)));
  if (has_stacked_points(texts, text_m)) note(t_.say<Text::dxf_stacked>(title));
  draw_isolux(space, plane, placing, layers, std::move(taken), text_m);
}

void DxfWriter::draw_level(const SpacePart& space, const PlanePart& plane,
                           const glm::dvec2& shift_m, double text_m) {
  constexpr double kSmallest_m = 0.05, kSameCorner_m = 0.1;
  constexpr double kMost = 1e15;  // what does not fit into a whole number
  const Placing placing = Placing::world(shift_m);
  draw_outlines(plane, placing);
  FlatBox box = box_of(plane);
  const std::string label = dxf_text(dxf_signs(plane_label(t_, space, plane)));
  if (box.is_empty()) {
    // A plane of which nothing is known is at least named in its room.
    for (const glm::dvec2& corner : space.footprint_m) box.add(corner);
    if (box.is_empty()) return;
  }
  const std::string quantity = dxf_text(dxf_signs(values_words(t_, plane)));
  // Above the plane where the room goes on there, else inside; as large as it is wide.
  const double own_m =
      std::clamp(box.size().x / static_cast<double>(std::max(label.size(), quantity.size())),
                 kSmallest_m, text_m);
  FlatBox room;
  for (const glm::dvec2& corner : space.footprint_m) room.add(corner);
  const double lines_m = 2.0 * kLineByText * own_m;
  const bool is_above = !room.is_empty() && box.high.y + lines_m < room.high.y;
  // Those of planes with one corner stand below or above each other.
  const glm::dvec2 corner(box.low.x, box.high.y);
  const glm::dvec2 place = corner / kSameCorner_m;
  int line = 0;
  if (std::abs(place.x) < kMost && std::abs(place.y) < kMost)
    line = labels_at_[{std::llround(place.x), std::llround(place.y)}]++;
  const double up_m = is_above ? lines_m * (line + 1) - own_m : -lines_m * line - 1.5 * own_m;
  glm::dvec3 at(corner + shift_m + glm::dvec2(0.5 * own_m, up_m), plane.grid.origin_m.z);
  dxf_words(kPlaneNames, at, own_m, label, DxfAlign::start, colour_of(outcome_of_plane(plane)),
            dxf_);
  if (!plane.is_computed) return;
  at.y -= kLineByText * own_m;
  dxf_words(kPlaneNames, at, 0.8 * own_m, quantity, DxfAlign::start, DxfColour::by_layer, dxf_);
  const std::size_t tier = tiers_.tier_of(plane);
  use_tier(tier);
  const PlaneLayers layers = layers_of_tier(tier);
  if (tier > 0) note(t_.say<Text::dxf_behind>(title_of_plane(t_, space, plane), layers.values));
  draw_values(space, plane, placing, layers);
}

void DxfWriter::draw_beside(const SpacePart& space, const PlanePart& plane, double text_m) {
  const calc::SensorGrid& grid = plane.grid;
  draw_outlines(plane, Placing::world({0.0, 0.0}));
  FlatBox box;
  for (const glm::dvec2& corner : plane.outline_m) box.add(corner);
  for (const PointRow& point : plane.points) {
    const glm::dvec3 offset = point.position_m - grid.origin_m;
    box.add({glm::dot(offset, grid.u), glm::dot(offset, grid.v)});
  }
  if (box.is_empty()) box.add({0.0, 0.0});
  const std::vector<std::string> lines{
      dxf_text(dxf_signs(title_of_plane(t_, space, plane))),
      dxf_text(dxf_signs(plane_label(t_, space, plane))),
      dxf_text(dxf_signs(orientation_words(t_, glm::cross(grid.u, grid.v)))),
      dxf_text(dxf_signs(values_words(t_, plane)))};
  double width = box.size().x;
  for (const std::string& line : lines) width = std::max(width, dxf_width_m(line, text_m));
  const double above = kLineByText * text_m * static_cast<double>(lines.size());
  if (shelf_m_.x > shelf_left_m_ && shelf_m_.x + width > shelf_right_m_) {
    shelf_m_ = {shelf_left_m_, shelf_m_.y - shelf_height_m_ - kGap_m};
    shelf_height_m_ = 0.0;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double down = kLineByText * text_m * static_cast<double>(i + 1);
    dxf_words(kPlaneNames, {shelf_m_ - glm::dvec2(0.0, down), 0.0}, text_m, lines[i],
              DxfAlign::start, i == 1 ? colour_of(outcome_of_plane(plane)) : DxfColour::by_layer,
              dxf_);
  }
  const glm::dvec2 corner =
      shelf_m_ - glm::dvec2(0.0, above + text_m) - glm::dvec2(box.low.x, box.high.y);
  const Placing placing = Placing::flat(grid, corner);
  draw_outlines(plane, placing);
  if (plane.is_computed) draw_values(space, plane, placing, layers_of_tier(0));
  const double height = above + text_m + box.size().y;
  FlatBox used;
  used.add(shelf_m_);
  used.add(shelf_m_ + glm::dvec2(width, -height));
  extend(used);
  shelf_m_.x += width + kGap_m;
  shelf_height_m_ = std::max(shelf_height_m_, height);
}

void DxfWriter::add(const ProjectPart& project) {
  constexpr double kPartOfPlan = 1.0 / 80.0, kSmallest_m = 0.08, kLargest_m = 0.25;
  table_->add(project);
  scales_ = ColourScales(project, sharing_);
  tiers_ = {};
  blocks_of_project_.clear();
  labels_at_.clear();
  FlatBox box = box_of(project);
  if (box.is_empty()) return;
  glm::dvec2 shift_m(0.0);
  if (!extent_.is_empty() && extent_.high.x + kGap_m > box.low.x) {
    shift_m.x = extent_.high.x + kGap_m - box.low.x;
    note(t_.say<Text::dxf_moved>(title_of(project.name, project.path),
                                 format_metres(t_, shift_m.x)));
  }
  box.low += shift_m;
  box.high += shift_m;
  extend(box);
  const double text_m = std::clamp(kPartOfPlan * box.longest(), kSmallest_m, kLargest_m);
  shelf_left_m_ = box.low.x;
  shelf_right_m_ = std::max(box.high.x, box.low.x + 20.0);
  shelf_m_ = {box.low.x, box.low.y - kGap_m};
  shelf_height_m_ = 0.0;
  if (has_storeys(project))
    note(fmt::format("{}: {}", title_of(project.name, project.path), t_[Text::dxf_storeys]));
  for (const SpacePart& space : project.spaces) {
    draw_room(space, shift_m, text_m);
    draw_luminaires(project, space, shift_m);
    flush();
    for (const PlanePart& plane : space.planes) {
      if (is_level(plane)) {
        draw_level(space, plane, shift_m, text_m);
      } else {
        draw_beside(space, plane, text_m);
        has_beside_ = true;
      }
      flush();
    }
  }
}

void DxfWriter::write_legend(const DocumentEnd& end, Spill& legend) {
  constexpr double kPartOfPlan = 1.0 / 120.0, kSmallest_m = 0.08, kLargest_m = 0.35;
  if (extent_.is_empty()) extent_.add({0.0, 0.0});
  const double text_m = std::clamp(kPartOfPlan * extent_.longest(), kSmallest_m, kLargest_m);
  const glm::dvec2 corner(extent_.high.x + kGap_m, extent_.high.y);
  std::size_t count = 0;
  const auto add = [&](std::string_view words, DxfColour colour = DxfColour::by_layer) {
    for (const std::string& line : dxf_lines(dxf_signs(words), kLegendSigns)) {
      const double down = kLineByText * text_m * static_cast<double>(++count);
      const glm::dvec2 at = corner - glm::dvec2(0.0, down);
      std::string dxf;
      dxf_words(kLegend, {at, 0.0}, text_m, line, DxfAlign::start, colour, dxf);
      legend.write(dxf);
      extent_.add(at);
      extent_.add(at + glm::dvec2(dxf_width_m(line, text_m), 0.0));
    }
  };
  add(t_[Text::dxf_title]);
  add(t_.say<Text::dxf_confidence>(format_percent(t_, end.provenance.confidence)));
  using enum rules::Outcome;
  add(t_.say<Text::dxf_colours>(
      outcome_words(t_, pass), outcome_words(t_, fail), outcome_words(t_, undecided),
      outcome_words(t_, not_judged),
      fmt::format("{}, {}", outcome_words(t_, waived), outcome_words(t_, nothing_asked))));
  add(t_[Text::dxf_marks]);
  if (has_beside_) add(t_[Text::dxf_beside]);
  for (const std::string& words : notes_) add(words);
  add("");
  TextSink table;
  table_->finish(end, table);
  for (std::string_view left = table.text; !left.empty();) {
    const std::size_t line = left.find('\n');
    add(left.substr(0, line));
    left.remove_prefix(line == std::string_view::npos ? left.size() : line + 1);
  }
}

void DxfWriter::finish(const DocumentEnd& end, Sink& sink) {
  Spill legend(place_);
  write_legend(end, legend);
  std::string dxf;
  dxf_head(layers_, extent_.low, extent_.high, dxf);
  dxf_section("BLOCKS", dxf);
  sink.write(dxf);
  blocks_.copy_to(sink);
  dxf.clear();
  dxf_section_end(dxf);
  dxf_section("ENTITIES", dxf);
  sink.write(dxf);
  entities_.copy_to(sink);
  legend.copy_to(sink);
  dxf.clear();
  dxf_section_end(dxf);
  dxf_group(0, "EOF", dxf);
  sink.write(dxf);
}

}  // namespace

std::unique_ptr<FormatWriter> dxf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, ScaleSharing sharing) {
  return std::make_unique<DxfWriter>(frame, place, t, sharing);
}

}  // namespace report
