#include "report/formats/dxf.h"

#include "report/formats/console.h"
#include "report/formats/dxf_entities.h"
#include "report/formats/dxf_layout.h"
#include "report/formats/dxf_legend.h"
#include "report/formats/dxf_planes.h"
#include "report/formats/dxf_storeys.h"
#include "report/formats/dxf_text.h"
#include "report/html/drawings/flat_box.h"
#include "report/html/drawings/html_isolux.h"
#include "report/html/drawings/html_plan.h"
#include "report/images/heatmap.h"
#include "report/revision/revision_tables.h"
#include "report/text/about_words.h"
#include "report/text/luminaire_aim.h"
#include "report/text/plane_names.h"
#include "report/text/point_thresholds.h"
#include "report/text/room_causes.h"
#include "report/text/room_overview.h"
#include "report/text/room_titles.h"
#include "report/text/storey_title.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr double kGap_m = 1.0;                                // between parts of the drawing
constexpr std::size_t kLegendColumn = 72, kNotesColumn = 96;  // characters
constexpr const char* kUnknown = "-";                         // in the block of a room

// Layers, from which an office takes what it needs.
constexpr const char* kRooms = "LUX_ROOMS";
constexpr const char* kStoreyTitles = "LUX_STOREY_TITLES";  // of storeys beside each other
constexpr const char* kRoomNames = "LUX_ROOM_NAMES";
constexpr const char* kRoomData = "LUX_ROOM_DATA";
constexpr const char* kFurniture = "LUX_FURNITURE";
constexpr const char* kLuminaires = "LUX_LUMINAIRES";
constexpr const char* kNumbers = "LUX_LUMINAIRE_NUMBERS";
constexpr const char* kLegend = "LUX_LEGEND";
constexpr const char* kNotes = "LUX_NOTES";             // frozen
constexpr const char* kMoreValues = "LUX_VALUES_MORE";  // frozen

constexpr const char* kRoomBlock = "LUX_ROOM";

// Names in the order of attributes of a luminaire.
const std::vector<std::string_view> kTags{
    "MARK",     "NUMBER",      "ID",    "ROOM",    "TYPE",       "GROUP",   "HEIGHT_M",
    "TILT_DEG", "HEADING_DEG", "MAKER", "ARTICLE", "PHOTOMETRY", "FLUX_LM", "POWER_W"};

// What a room's block shows, line by line, and what it is called there.
struct RoomLine {
  RoomOverview::Column column;
  std::string_view tag, label;
};
const std::vector<RoomLine> kRoomLines{{RoomOverview::Column::average, "EM", "Em lx"},
                                       {RoomOverview::Column::uniformity, "UO", "Uo"},
                                       {RoomOverview::Column::glare, "UGR", "UGR"},
                                       {RoomOverview::Column::power, "W_M2", "W/m2"}};
constexpr double kRoomLabel = 6.0;  // characters of label and value

struct UnitRow {
  DrawingUnit unit;
  std::string_view name;
  int number;     // of $INSUNITS
  double metres;  // of one
};
constexpr std::array kUnits{
    UnitRow{DrawingUnit::m, "m", 6, 1.0}, UnitRow{DrawingUnit::cm, "cm", 5, 0.01},
    UnitRow{DrawingUnit::mm, "mm", 4, 0.001}, UnitRow{DrawingUnit::in, "in", 1, 0.0254},
    UnitRow{DrawingUnit::ft, "ft", 2, 0.3048}};

const UnitRow& unit_row(DrawingUnit unit) {
  return *std::find_if(kUnits.begin(), kUnits.end(),
                       [unit](const UnitRow& row) { return row.unit == unit; });
}

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

std::vector<std::string> point_words(const Texts& t, const PlanePart& plane) {
  const Thresholds thresholds = point_thresholds(plane);
  std::vector<std::string> words;
  for (const PointRow& point : plane.points)
    words.push_back(dxf_text(dxf_signs(cell_words(t, plane, point.measured, thresholds))));
  return words;
}

// The lowest and the highest value decide, and so stay in sight: before all others the one that a
// limit is for. texts: of all points.
void give_turns(const PlanePart& plane, std::vector<DxfPlacedText>& texts) {
  std::optional<std::size_t> low, high;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const calc::Estimate& measured = plane.points[i].measured;
    if (calc::is_nothing(measured)) continue;
    if (!low || measured.value < plane.points[*low].measured.value) low = i;
    if (!high || measured.value > plane.points[*high].measured.value) high = i;
  }
  if (!low || !high) return;
  const bool is_high_first =
      std::any_of(plane.findings.begin(), plane.findings.end(), [](const auto& finding) {
        return finding.requirement.comparison == rules::Comparison::at_most;
      });
  texts[is_high_first ? *low : *high].turn = DxfTurn::second;
  texts[is_high_first ? *high : *low].turn = DxfTurn::first;
}

std::vector<DxfPlacedText> placed_values(const Texts& t, const PlanePart& plane,
                                         const Placing& placing) {
  const std::vector<std::string> words = point_words(t, plane);
  std::vector<DxfPlacedText> texts;
  for (std::size_t i = 0; i < words.size(); ++i)
    texts.push_back(DxfPlacedText{glm::dvec2(placing.at(plane.points[i].position_m)), words[i]});
  give_turns(plane, texts);
  return texts;
}

double length_of(const IsoluxLine& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points_m.size(); ++i)
    length += glm::distance(line.points_m[i], line.points_m[i + 1]);
  return length;
}

// Of places on a line the one nearest to its middle where the words meet nothing that is taken.
std::optional<glm::dvec2> label_place(const std::vector<glm::dvec3>& line, const std::string& words,
                                      double text_m, const TakenPlaces& taken) {
  constexpr std::size_t kMostTries = 200;
  const std::size_t count = line.size(), middle = count / 2;
  for (std::size_t step = 0; step < std::min(count, kMostTries); ++step) {
    const std::size_t half = (step + 1) / 2;
    const std::size_t i = (step % 2 == 0 ? middle + half : middle + count - half) % count;
    if (!taken.meets(text_box(line[i], words, text_m))) return line[i];
  }
  return {};
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

// "3 labels of isolux lines and 1 mark of a left-out point (x)"; not both are 0.
std::string counted_marks(const Texts& t, std::size_t labels, std::size_t marks) {
  const std::string of_labels = labels == 1 ? t.say<Text::dxf_one_label>(labels)
                                            : t.say<Text::dxf_labels>(labels),
                    of_marks = marks == 1 ? t.say<Text::dxf_one_mark>(marks)
                                          : t.say<Text::dxf_left_out_marks>(marks);
  if (labels == 0) return of_marks;
  return marks == 0 ? of_labels : t.say<Text::dxf_both>(of_labels, of_marks);
}

// The sign of a luminaire, around its place, C0 along +x.
std::string sign_of(const std::vector<glm::dvec2>& outline_m, bool has_direction,
                    double per_metre) {
  constexpr double kRadius_m = 0.08, kArrow_m = 0.3, kHead_m = 0.06;
  DxfText dxf{"", per_metre};
  if (outline_m.empty()) {
    dxf_circle(kLuminaires, {0, 0, 0}, kRadius_m, dxf);
    const double half = 0.7 * kRadius_m;
    dxf_line(kLuminaires, {-half, -half, 0}, {half, half, 0}, dxf);
    dxf_line(kLuminaires, {-half, half, 0}, {half, -half, 0}, dxf);
  }
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& corner : outline_m) corners.emplace_back(corner, 0.0);
  dxf_polyline(kLuminaires, corners, true, DxfColour::by_layer, dxf);
  if (!has_direction) return dxf.bytes;
  const glm::dvec3 tip(kArrow_m, 0, 0);
  dxf_line(kLuminaires, {0, 0, 0}, tip, dxf);
  for (const double side : {-1.0, 1.0})
    dxf_line(kLuminaires, tip, tip + kHead_m * glm::dvec3(-1.0, 0.5 * side, 0.0), dxf);
  return dxf.bytes;
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

// Layers of which each storey has its own where storeys are apart, besides those of its planes.
constexpr std::array kStoreyLayers{kRooms,     kRoomNames,  kRoomData,
                                   kFurniture, kLuminaires, kNumbers};

LabelBox below(const glm::dvec2& corner_m, const glm::dvec2& size_m) {
  return {{corner_m.x, corner_m.y - size_m.y}, {corner_m.x + size_m.x, corner_m.y}};
}

// A plane, and where it is drawn.
struct PlaneDrawing {
  const SpacePart* space = nullptr;
  const PlanePart* plane = nullptr;
  bool is_level = false, is_task = false;
};

class DxfWriter : public FormatWriter {
 public:
  DxfWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
            const PageStyle& style)
      : frame_(frame),
        place_(place),
        t_(t),
        style_(style),
        unit_(unit_row(style.drawing.unit)),
        blocks_(place),
        entities_(place),
        dxf_{"", 1.0 / unit_.metres},
        scale_(style.drawing.scale) {
    TextOptions all;  // the legend says that nothing is missing there
    all.lists_passes = all.shows_notes = true;
    table_ = text_writer(frame, place, all, t);
    for (const auto& [name, colour] :
         {std::pair(kRooms, DxfColour::ink), std::pair(kRoomNames, DxfColour::ink),
          std::pair(kRoomData, DxfColour::ink), std::pair(kFurniture, DxfColour::grey),
          std::pair(kLuminaires, DxfColour::sky), std::pair(kNumbers, DxfColour::sky),
          std::pair(kLegend, DxfColour::ink)}) {
      layers_[name] = {colour, false};
    }
    layers_[kNotes] = {DxfColour::ink, true};
    use_layers(plane_layers(true, 0), false, false);
  }

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  // Of a room of the project that is drawn.
  const std::string& title_of_room(const SpacePart& space) const { return titles_.at(space.id); }
  std::string title_of_plane(const PlaneDrawing& drawing) const {
    return fmt::format("{} / {}", title_of_room(*drawing.space),
                       plane_name(t_, *drawing.space, *drawing.plane));
  }
  void use_layers(const PlaneLayers& layers, bool is_other, bool is_frozen);
  // What is drawn from here on is of that space: it has the shift and the layers of its storey.
  void enter(const SpacePart& space);
  // Of the storey that is drawn.
  std::string layer(const char* name) const { return storeys_.layer(name, storey_); }
  PlaneLayers layers_of(bool is_task, std::size_t tier) const;
  void note(const std::string& words) { notes_.push_back(words); }
  void flush() {
    entities_.write(dxf_.bytes);
    dxf_.bytes.clear();
  }
  void extend(const FlatBox& box) {
    if (box.is_empty()) return;
    extent_.add(box.low);
    extent_.add(box.high);
    right_m_ = std::max(right_m_, box.high.x);
  }

  void choose_scale(const std::vector<PlaneDrawing>& planes, double plan_m);
  void begin_project(const ProjectPart& project);
  // The box of all that is drawn of the project, before it is moved beside the one before it.
  FlatBox put_storeys(const ProjectPart& project);
  std::vector<std::string> title_lines(std::size_t storey) const;
  // Its size, and its upper left corner before the project is moved.
  glm::dvec2 title_size_m(std::size_t storey) const;
  glm::dvec2 title_corner_m(std::size_t storey) const;
  void draw_titles(const ProjectPart& project);
  // The upper left corner of a place of that size right of the plan, which is then taken.
  glm::dvec2 place_aside(const glm::dvec2& size_m);

  void draw_room(const SpacePart& space);
  void draw_luminaires(const ProjectPart& project, const SpacePart& space);
  void draw_mark(const LabelBox& sign, double z_m, const std::string& label);
  // Names of rooms, and their blocks.
  void draw_room_data(const ProjectPart& project);
  void draw_room_block(const SpacePart& space, const std::vector<std::string>& values);
  void insert_room(const SpacePart& space, const glm::dvec2& corner_m, bool has_name,
                   const std::vector<std::string>& values);
  void add_room_block();
  // The name of a block that looks like it.
  std::string block_of(const LuminaireMark& mark, bool has_direction);

  void draw_outlines(const PlanePart& plane, const Placing& placing, const std::string& layer);
  void draw_values(const PlaneDrawing& drawing, const Placing& placing, const PlaneLayers& layers,
                   bool is_visible);
  // How many marks have no free place.
  std::size_t draw_left_out(const PlaneDrawing& drawing, const Placing& placing,
                            const std::string& values, bool is_visible);
  // How many labels have no free place.
  std::size_t draw_isolux(const PlaneDrawing& drawing, const Placing& placing,
                          const PlaneLayers& layers, bool is_visible);
  // All three, of a plane that was computed.
  void draw_contents(const PlaneDrawing& drawing, const Placing& placing, const PlaneLayers& layers,
                     bool is_visible);
  void draw_level(const PlaneDrawing& drawing);
  void draw_plane_name(const PlaneDrawing& drawing);
  // Below the plan.
  void draw_beside(const PlaneDrawing& drawing);

  void add_summary(const ProjectPart& project);
  void write_legend(const DocumentEnd& end);
  void write_notes(const DocumentEnd& end);

  const DocumentFrame& frame_;
  SpillPlace place_;
  Texts t_;
  PageStyle style_;
  const UnitRow& unit_;
  Spill blocks_, entities_;
  std::unique_ptr<FormatWriter> table_;
  std::map<std::string, DxfLayer> layers_;
  std::vector<std::string> notes_;     // of the legend
  DxfColumns summary_{kLegendColumn};  // of the legend: a table for each project
  FlatBox extent_;                     // of all that is drawn and not frozen
  double right_m_ = std::numeric_limits<double>::lowest();  // of that, and of frozen planes
  DxfText dxf_;          // entities that are not yet in entities_
  int scale_ = 0;        // 0: not yet chosen
  double text_m_ = 0.0;  // height of all texts
  bool has_beside_ = false, has_aside_ = false;
  std::map<calc::DiagnosticId, std::size_t> warnings_;

  // Of the project that is drawn.
  std::map<std::string, std::string> titles_;  // of rooms by their ids
  glm::dvec2 project_shift_m_{0.0};
  DxfStoreys storeys_;
  ColourScales scales_;
  std::vector<Tiers> tiers_, other_tiers_;  // of each storey
  std::optional<TakenPlaces> taken_;
  std::map<std::string, std::string> blocks_of_project_;  // names, by type and look
  std::size_t types_ = 0;                                 // blocks of all projects
  glm::dvec2 shelf_m_{0.0};  // where the next plane is drawn below the plan: its upper left corner
  double shelf_left_m_ = 0.0, shelf_right_m_ = 0.0, shelf_height_m_ = 0.0;
  glm::dvec2 aside_m_{0.0};  // likewise right of the plan
  double aside_top_m_ = 0.0, aside_bottom_m_ = 0.0, aside_width_m_ = 0.0;

  // Of the space that is drawn, see enter().
  std::size_t storey_ = 0;
  glm::dvec2 shift_m_{0.0};
};

void DxfWriter::use_layers(const PlaneLayers& layers, bool is_other, bool is_frozen) {
  layers_[layers.outlines] = {DxfColour::ink, is_other};
  layers_[layers.names] = {DxfColour::ink, is_other};
  layers_[layers.values] = {DxfColour::ink, is_frozen};
  layers_[layers.isolux] = {DxfColour::blue, is_frozen};
  layers_[layers.limits] = {DxfColour::cyan, is_frozen};
  layers_[layers.labels] = {DxfColour::blue, is_frozen};
}

void DxfWriter::enter(const SpacePart& space) {
  storey_ = storeys_.storey_of(space);
  shift_m_ = project_shift_m_ + glm::dvec2(storeys_[storey_].shift_m, 0.0);
}

PlaneLayers DxfWriter::layers_of(bool is_task, std::size_t tier) const {
  PlaneLayers layers = plane_layers(is_task, tier);
  for (std::string* name : {&layers.outlines, &layers.names, &layers.values, &layers.isolux,
                            &layers.limits, &layers.labels})
    *name = storeys_.layer(*name, storey_);
  return layers;
}

// By the first project: a drawing has one height of text.
void DxfWriter::choose_scale(const std::vector<PlaneDrawing>& planes, double plan_m) {
  if (scale_ == 0) {
    std::vector<std::vector<DxfPlacedText>> texts;
    for (const PlaneDrawing& drawing : planes) {
      if (!drawing.is_task) continue;
      const calc::SensorGrid& grid = drawing.plane->grid;
      const Placing placing =
          drawing.is_level ? Placing::world({0.0, 0.0}) : Placing::flat(grid, {0.0, 0.0});
      texts.push_back(placed_values(t_, *drawing.plane, placing));
    }
    scale_ = chosen_scale(texts, plan_m);
  }
  if (text_m_ > 0.0) return;
  text_m_ = text_height_m(scale_);
  add_room_block();
}

glm::dvec2 DxfWriter::place_aside(const glm::dvec2& size_m) {
  if (aside_m_.y < aside_top_m_ && aside_m_.y - size_m.y < aside_bottom_m_) {
    aside_m_ = {aside_m_.x + aside_width_m_ + 2.0 * text_m_, aside_top_m_};
    aside_width_m_ = 0.0;
  }
  const glm::dvec2 corner = aside_m_;
  aside_width_m_ = std::max(aside_width_m_, size_m.x);
  aside_m_.y -= size_m.y + kDxfLine * text_m_;
  FlatBox used;
  used.add(corner);
  used.add(corner + glm::dvec2(size_m.x, -size_m.y));
  extend(used);
  has_aside_ = true;
  return corner;
}

void DxfWriter::draw_room(const SpacePart& space) {
  enter(space);
  const std::string rooms = layer(kRooms), furniture = layer(kFurniture);
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& corner : space.footprint_m)
    corners.emplace_back(corner + shift_m_, space.floor_z_m);
  dxf_polyline(rooms, corners, true, DxfColour::by_layer, dxf_);
  const glm::dvec3 shift(shift_m_, 0.0);
  for (std::size_t i = 0; i + 1 < space.surface_lines_m.size(); i += 2)
    dxf_line(rooms, space.surface_lines_m[i] + shift, space.surface_lines_m[i + 1] + shift, dxf_);
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) {
      dxf_line(furniture, {line[0] + shift_m_, body.high_z_m}, {line[1] + shift_m_, body.high_z_m},
               dxf_);
    }
  }
  const std::string& title = title_of_room(space);
  if (space.surface_lines_left_out > 0) {
    note(fmt::format("{}: {} {}", title, t_[Text::layout_surface_lines],
                     t_.say<Text::layout_lines_left_out>(space.surface_lines_left_out)));
  }
  if (space.bodies_left_out > 0)
    note(fmt::format("{}: {}", title, t_.say<Text::furniture_left_out>(space.bodies_left_out)));
}

std::string DxfWriter::block_of(const LuminaireMark& mark, bool has_direction) {
  const std::string sign = sign_of(own_outline(mark, has_direction), has_direction, dxf_.per_metre);
  const auto [found, is_new] = blocks_of_project_.try_emplace(mark.type_id + "\n" + sign);
  if (is_new) {
    found->second = dxf_name(fmt::format("LUX_{}_", ++types_), mark.type_id);
    std::vector<DxfAttribute> attributes;
    for (const std::string_view tag : kTags) attributes.push_back({tag, ""});
    DxfText block{"", dxf_.per_metre};
    dxf_block(kLuminaires, found->second, sign, attributes, text_m_, block);
    blocks_.write(block.bytes);
  }
  return found->second;
}

// Beside its sign, where that is free.
void DxfWriter::draw_mark(const LabelBox& sign, double z_m, const std::string& label) {
  const glm::dvec2 half = 0.5 * glm::dvec2(dxf_width_m(label, text_m_), text_m_);
  const double gap = 0.3 * text_m_;
  const glm::dvec2 middle = 0.5 * (sign.low + sign.high);
  const double right = sign.high.x + gap + half.x, left = sign.low.x - gap - half.x,
               above = sign.high.y + gap + half.y, below = sign.low.y - gap - half.y;
  const std::array places{glm::dvec2(right, below),    glm::dvec2(right, above),
                          glm::dvec2(left, above),     glm::dvec2(left, below),
                          glm::dvec2(right, middle.y), glm::dvec2(left, middle.y),
                          glm::dvec2(middle.x, above), glm::dvec2(middle.x, below)};
  const auto* const found = std::find_if(places.begin(), places.end(), [&](const auto& place) {
    return !taken_->meets(box_around(place, 2.0 * half));
  });
  const glm::dvec2 at = found == places.end() ? places.front() : *found;
  taken_->add(box_around(at, 2.0 * half));
  dxf_words(layer(kNumbers), {at - half, z_m}, text_m_, label, DxfAlign::start, DxfColour::by_layer,
            dxf_);
}

void DxfWriter::draw_luminaires(const ProjectPart& project, const SpacePart& space) {
  enter(space);
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
    const std::vector<std::string> values{
        dxf_text(mark.label),
        fmt::format("{}", i + 1),
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
        row.told_lm() > 0.0 ? format_shortest(row.told_lm()) : "",
        row.power_w > 0.0 ? format_shortest(row.power_w) : ""};
    std::vector<DxfAttribute> attributes;
    for (std::size_t k = 0; k < kTags.size(); ++k) attributes.push_back({kTags[k], values[k]});
    const glm::dvec3 at = mark.position_m + glm::dvec3(shift_m_, 0.0);
    dxf_insert(layer(kLuminaires), block_of(mark, aim.turn_deg.has_value()), at,
               aim.turn_deg.value_or(0.0), attributes, text_m_, dxf_);
    LabelBox sign{glm::dvec2(at), glm::dvec2(at)};
    for (const glm::dvec2& corner : mark.outline_m) {
      sign.low = glm::min(sign.low, corner + shift_m_);
      sign.high = glm::max(sign.high, corner + shift_m_);
    }
    draw_mark(sign, at.z, mark.label);
  }
}

// Labels and attributes below each other; the base point is the upper left corner.
void DxfWriter::add_room_block() {
  DxfText sign{"", dxf_.per_metre}, block = sign;
  std::vector<DxfAttribute> attributes{
      {"ROOM", "", {0.0, -text_m_}, true}, {"ID", "", {}, false}, {"VERDICT", "", {}, false}};
  double down = text_m_;
  for (const RoomLine& line : kRoomLines) {
    down += kDxfLine * text_m_;
    dxf_words(kRoomData, {0.0, -down, 0.0}, text_m_, line.label, DxfAlign::start,
              DxfColour::by_layer, sign);
    attributes.push_back({line.tag, kUnknown, {kRoomLabel * text_m_, -down}, true});
  }
  dxf_block(kRoomData, kRoomBlock, sign.bytes, attributes, text_m_, block);
  blocks_.write(block.bytes);
}

// values: verdict, then those of kRoomLines. has_name: else the name is beside it already.
void DxfWriter::insert_room(const SpacePart& space, const glm::dvec2& corner_m, bool has_name,
                            const std::vector<std::string>& values) {
  const std::string name = dxf_text(dxf_signs(title_of_room(space)));
  std::vector<DxfAttribute> attributes{{"ROOM", name, {0.0, -text_m_}, has_name},
                                       {"ID", dxf_text(space.id), {}, false},
                                       {"VERDICT", values.front(), {}, false}};
  double down = text_m_;
  for (std::size_t k = 0; k < kRoomLines.size(); ++k) {
    down += kDxfLine * text_m_;
    attributes.push_back({kRoomLines[k].tag, values[k + 1], {kRoomLabel * text_m_, -down}, true});
  }
  dxf_insert(layer(kRoomData), kRoomBlock, {corner_m, space.floor_z_m}, 0.0, attributes, text_m_,
             dxf_);
}

// Its name and below that its block in a free place of the room; else the name alone, or neither.
void DxfWriter::draw_room_block(const SpacePart& space, const std::vector<std::string>& values) {
  enter(space);
  const std::string name = dxf_text(dxf_signs(title_of_room(space)));
  const double lines = 1.0 + kDxfLine * static_cast<double>(kRoomLines.size());
  double width = kRoomLabel;
  for (std::size_t k = 0; k < kRoomLines.size(); ++k)
    width = std::max(width, kRoomLabel + static_cast<double>(values[k + 1].size()));
  width = std::max(width, static_cast<double>(name.size()));
  const glm::dvec2 size = text_m_ * glm::dvec2(width, lines + 0.5),
                   line(dxf_width_m(name, text_m_), 1.25 * text_m_);
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2& corner : space.footprint_m) outline.push_back(corner + shift_m_);
  const auto draw_name = [&](const glm::dvec2& corner, const glm::dvec2& taken) {
    taken_->add(below(corner, taken));
    dxf_words(layer(kRoomNames), {corner.x, corner.y - text_m_, space.floor_z_m}, text_m_, name,
              DxfAlign::start, DxfColour::by_layer, dxf_);
  };
  if (const auto corner = free_place(outline, size, *taken_)) {
    draw_name(*corner, size);
    return insert_room(space, *corner, false, values);
  }
  const auto alone = free_place(outline, line, *taken_);
  const glm::dvec2 aside = place_aside(size);
  if (alone) draw_name(*alone, line);
  insert_room(space, aside, true, values);
}

void DxfWriter::draw_room_data(const ProjectPart& project) {
  const RoomOverview table = room_overview(t_, project, 1, AreaLines::folded);
  for (std::size_t place = 0; place < project.spaces.size(); ++place) {
    const SpacePart& space = project.spaces[place];
    std::vector<std::string> values(1 + kRoomLines.size(), kUnknown);
    if (const auto power = space.power.density_w_m2())
      values.back() = dxf_text(format_fixed(t_, *power, 2));
    for (const RoomOverview::Row& row : table.rows) {
      if (row.space != place) continue;
      values.front() = dxf_text(outcome_words(t_, row.outcome));
      for (std::size_t c = 0; c < table.columns.size(); ++c) {
        for (std::size_t k = 0; k < kRoomLines.size(); ++k) {
          if (kRoomLines[k].column == table.columns[c] && !row.cells[c].empty())
            values[k + 1] = dxf_text(dxf_signs(row.cells[c]));
        }
      }
    }
    draw_room_block(space, values);
  }
}

void DxfWriter::draw_outlines(const PlanePart& plane, const Placing& placing,
                              const std::string& layer) {
  const DxfColour colour = colour_of(gravest_outcome(plane));
  const auto draw = [&](const std::vector<glm::dvec2>& outline) {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& corner : outline) corners.push_back(placing.at(plane.grid, corner));
    dxf_polyline(layer, corners, true, colour, dxf_);
  };
  draw(plane.outline_m);
  for (const auto& hole : plane.holes_m) draw(hole);
}

// Labels that have no free place are with the values that have none.
std::size_t DxfWriter::draw_isolux(const PlaneDrawing& drawing, const Placing& placing,
                                   const PlaneLayers& layers, bool is_visible) {
  const PlanePart& plane = *drawing.plane;
  if (!has_cells(plane)) return 0;
  const std::string title = title_of_plane(drawing);
  if (!has_all_values(plane)) {
    if (is_visible) note(t_.say<Text::dxf_no_isolux>(title));
    return 0;
  }
  const PlanIsolux isolux =
      plan_isolux(t_, *drawing.space, plane, scales_.of(*drawing.space, plane));
  if (!isolux.has_all && is_visible) note(title + ": " + t_[Text::isolux_left_out]);
  std::size_t without_place = 0;
  for (const IsoluxLevel& level : isolux.levels) {
    std::vector<glm::dvec3> longest;
    double length = -1.0;
    for (const IsoluxLine& line : level.lines) {
      std::vector<glm::dvec3> corners;
      for (const glm::dvec2& corner : line.points_m)
        corners.push_back(placing.at(plane.grid, corner));
      // A closed one ends where it starts.
      if (line.is_closed && corners.size() > 2) corners.pop_back();
      dxf_polyline(level.is_required ? layers.limits : layers.isolux, corners, line.is_closed,
                   DxfColour::by_layer, dxf_);
      if (length_of(line) > length) {
        length = length_of(line);
        longest = std::move(corners);
      }
    }
    if (longest.empty()) continue;
    const std::string words = dxf_text(format_level(t_, level.value));
    glm::dvec3 at = longest[longest.size() / 2];
    bool is_free = true;
    if (is_visible) {
      const auto place = label_place(longest, words, text_m_, *taken_);
      is_free = place.has_value();
      if (place) at = {*place, at.z};
      if (place) taken_->add(text_box(*place, words, text_m_));
    }
    dxf_words(is_free ? layers.labels : layer(kMoreValues), at, text_m_, words, DxfAlign::middle,
              DxfColour::by_layer, dxf_);
    without_place += is_free ? 0 : 1;
  }
  return without_place;
}

std::size_t DxfWriter::draw_left_out(const PlaneDrawing& drawing, const Placing& placing,
                                     const std::string& values, bool is_visible) {
  const calc::SensorGrid& grid = drawing.plane->grid;
  const std::string more = layer(kMoreValues);
  std::size_t without_place = 0;
  for (const calc::DroppedPoint& point : grid.dropped) {
    if (point.reason == calc::DropReason::outside_area) continue;  // no point of the plane
    const glm::dvec3 at = placing.at(point.position_m);
    const LabelBox box = text_box(at, "x", text_m_);
    const bool is_free = !is_visible || !taken_->meets(box);
    if (is_visible && is_free) taken_->add(box);
    without_place += is_free ? 0 : 1;
    dxf_words(is_free ? values : more, at, text_m_, "x", DxfAlign::middle, DxfColour::grey, dxf_);
  }
  if (is_visible && !grid.dropped.empty()) {
    note(t_.say<Text::dxf_left_out>(title_of_plane(drawing), dropped_reasons(t_, grid)));
  }
  return without_place;
}

// Of visible ones those that meet others are on a layer of their own.
void DxfWriter::draw_values(const PlaneDrawing& drawing, const Placing& placing,
                            const PlaneLayers& layers, bool is_visible) {
  const std::string more = layer(kMoreValues);
  const std::vector<DxfPlacedText> texts = placed_values(t_, *drawing.plane, placing);
  std::vector<bool> shown(texts.size(), true);
  if (is_visible) shown = shown_texts(texts, text_m_);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const glm::dvec3 at = placing.at(drawing.plane->points[i].position_m);
    dxf_words(shown[i] ? layers.values : more, at, text_m_, texts[i].words, DxfAlign::middle,
              DxfColour::by_layer, dxf_);
    if (is_visible && shown[i]) taken_->add(text_box(texts[i].at, texts[i].words, text_m_));
  }
  const auto count = static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true));
  if (count < texts.size()) {
    layers_[more] = {DxfColour::ink, true};
    note(t_.say<Text::dxf_thinned>(title_of_plane(drawing), count, texts.size(), more));
  }
}

// Values first, then marks, then labels: each where the ones before it leave a place.
void DxfWriter::draw_contents(const PlaneDrawing& drawing, const Placing& placing,
                              const PlaneLayers& layers, bool is_visible) {
  draw_values(drawing, placing, layers, is_visible);
  const std::size_t marks = draw_left_out(drawing, placing, layers.values, is_visible),
                    labels = draw_isolux(drawing, placing, layers, is_visible);
  if (marks + labels == 0) return;
  const std::string more = layer(kMoreValues);
  layers_[more] = {DxfColour::ink, true};
  note(t_.say<Text::dxf_more_marks>(title_of_plane(drawing), counted_marks(t_, labels, marks),
                                    more));
}

void DxfWriter::draw_level(const PlaneDrawing& drawing) {
  enter(*drawing.space);
  const PlanePart& plane = *drawing.plane;
  const Placing placing = Placing::world(shift_m_);
  std::size_t tier = 0;
  if (plane.is_computed) tier = (drawing.is_task ? tiers_ : other_tiers_)[storey_].tier_of(plane);
  const PlaneLayers layers = layers_of(drawing.is_task, tier);
  const bool is_visible = drawing.is_task && tier == 0;
  use_layers(layers, !drawing.is_task, !is_visible);
  draw_outlines(plane, placing, layers.outlines);
  if (!plane.is_computed) return;
  if (drawing.is_task && tier > 0) {
    note(t_.say<Text::dxf_behind>(title_of_plane(drawing), layers.values));
  }
  draw_contents(drawing, placing, layers, is_visible);
}

// Above or below the plane, or inside it, or anywhere in the room where nothing else is written;
// else right of the plan, with the room's name.
void DxfWriter::draw_plane_name(const PlaneDrawing& drawing) {
  enter(*drawing.space);
  const PlanePart& plane = *drawing.plane;
  const PlaneLayers layers = layers_of(drawing.is_task, 0);
  const DxfColour colour = colour_of(gravest_outcome(plane));
  std::string label = dxf_text(dxf_signs(plane_label(t_, *drawing.space, plane)));
  const glm::dvec2 size(dxf_width_m(label, text_m_), 1.25 * text_m_);
  FlatBox box = drawn_box(plane);
  // A plane of which nothing is known is at least named in its room.
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2& corner : drawing.space->footprint_m) {
    if (drawn_box(plane).is_empty()) box.add(corner);
    outline.push_back(corner + shift_m_);
  }
  if (box.is_empty()) return;
  box.low += shift_m_;
  box.high += shift_m_;
  const double gap = 0.3 * text_m_;
  // Upper left corners.
  const std::array places{glm::dvec2(box.low.x + gap, box.high.y + size.y + gap),
                          glm::dvec2(box.low.x + gap, box.high.y - gap),
                          glm::dvec2(box.low.x + gap, box.low.y + size.y + gap),
                          glm::dvec2(box.low.x + gap, box.low.y - gap)};
  const auto* const found = std::find_if(places.begin(), places.end(), [&](const auto& corner) {
    return !taken_->meets(below(corner, size));
  });
  std::optional<glm::dvec2> corner;
  if (found != places.end()) corner = *found;
  if (!drawing.is_task) corner = places.front();
  if (!corner) corner = free_place(outline, size, *taken_);
  if (!corner) {
    label = dxf_text(dxf_signs(fmt::format("{} / {}", title_of_room(*drawing.space),
                                           plane_label(t_, *drawing.space, plane))));
    corner = place_aside({dxf_width_m(label, text_m_), size.y});
  }
  if (drawing.is_task) taken_->add(below(*corner, size));
  dxf_words(layers.names, {corner->x, corner->y - text_m_, plane.grid.origin_m.z}, text_m_, label,
            DxfAlign::start, colour, dxf_);
}

void DxfWriter::draw_beside(const PlaneDrawing& drawing) {
  enter(*drawing.space);
  const PlanePart& plane = *drawing.plane;
  const calc::SensorGrid& grid = plane.grid;
  const PlaneLayers layers = layers_of(drawing.is_task, 0);
  use_layers(layers, !drawing.is_task, !drawing.is_task);
  draw_outlines(plane, Placing::world(shift_m_), layers.outlines);
  FlatBox box;
  for (const glm::dvec2& corner : plane.outline_m) box.add(corner);
  for (const PointRow& point : plane.points) {
    const glm::dvec3 offset = point.position_m - grid.origin_m;
    box.add({glm::dot(offset, grid.u), glm::dot(offset, grid.v)});
  }
  if (box.is_empty()) box.add({0.0, 0.0});
  const std::vector<std::string> lines{
      dxf_text(dxf_signs(title_of_room(*drawing.space))),
      dxf_text(dxf_signs(plane_label(t_, *drawing.space, plane))),
      dxf_text(dxf_signs(orientation_words(t_, glm::cross(grid.u, grid.v))))};
  double width = box.size().x;
  for (const std::string& line : lines) width = std::max(width, dxf_width_m(line, text_m_));
  const double above = kDxfLine * text_m_ * static_cast<double>(lines.size());
  if (shelf_m_.x > shelf_left_m_ && shelf_m_.x + width > shelf_right_m_) {
    shelf_m_ = {shelf_left_m_, shelf_m_.y - shelf_height_m_ - kGap_m};
    shelf_height_m_ = 0.0;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double down = kDxfLine * text_m_ * static_cast<double>(i + 1);
    dxf_words(layers.names, {shelf_m_ - glm::dvec2(0.0, down), 0.0}, text_m_, lines[i],
              DxfAlign::start, i == 1 ? colour_of(gravest_outcome(plane)) : DxfColour::by_layer,
              dxf_);
  }
  const glm::dvec2 corner =
      shelf_m_ - glm::dvec2(0.0, above + text_m_) - glm::dvec2(box.low.x, box.high.y);
  const Placing placing = Placing::flat(grid, corner);
  draw_outlines(plane, placing, layers.outlines);
  if (plane.is_computed) draw_contents(drawing, placing, layers, drawing.is_task);
  const double height = above + text_m_ + box.size().y;
  FlatBox used;
  used.add(shelf_m_);
  used.add(shelf_m_ + glm::dvec2(width, -height));
  if (drawing.is_task) extend(used);
  right_m_ = std::max(right_m_, used.high.x);
  shelf_m_.x += width + kGap_m;
  shelf_height_m_ = std::max(shelf_height_m_, height);
}

// The second line says how far the storey is from its true place.
std::vector<std::string> DxfWriter::title_lines(std::size_t storey) const {
  const DxfStorey& one = storeys_[storey];
  std::vector<std::string> lines{storey_title(t_, one.floor_z_m)};
  if (one.shift_m > 0.0) {
    lines.push_back(
        t_.say<Text::dxf_storey_moved>(format_metres(t_, project_shift_m_.x + one.shift_m)));
  }
  for (std::string& line : lines) line = dxf_text(dxf_signs(line));
  return lines;
}

glm::dvec2 DxfWriter::title_size_m(std::size_t storey) const {
  const std::vector<std::string> lines = title_lines(storey);
  double width = 0.0;
  for (const std::string& line : lines) width = std::max(width, dxf_width_m(line, text_m_));
  return {width, kDxfLine * text_m_ * static_cast<double>(lines.size())};
}

// A line and a half are free for names of planes at the edge.
glm::dvec2 DxfWriter::title_corner_m(std::size_t storey) const {
  const DxfStorey& one = storeys_[storey];
  return one.box.low + glm::dvec2(one.shift_m, -1.5 * kDxfLine * text_m_);
}

FlatBox DxfWriter::put_storeys(const ProjectPart& project) {
  storeys_ = DxfStoreys(project);
  if (!storeys_.are_apart()) return drawn_box(project);
  // As wide as any title, whose second line is not known before the storeys have their places.
  constexpr const char* kLongShift = "00000.000";
  double width = dxf_width_m(dxf_text(t_.say<Text::dxf_storey_moved>(kLongShift)), text_m_);
  for (std::size_t i = 0; i < storeys_.count(); ++i) width = std::max(width, title_size_m(i).x);
  storeys_.put_beside(width);
  FlatBox box;
  const auto add = [&box](const glm::dvec2& low, const glm::dvec2& high) {
    box.add(low);
    box.add(high);
  };
  for (const SpacePart& space : project.spaces) {
    const FlatBox of_space = drawn_box(space);
    const glm::dvec2 shift(storeys_[storeys_.storey_of(space)].shift_m, 0.0);
    if (!of_space.is_empty()) add(of_space.low + shift, of_space.high + shift);
  }
  for (std::size_t i = 0; i < storeys_.count(); ++i) {
    if (storeys_[i].box.is_empty()) continue;
    const LabelBox title = below(title_corner_m(i), title_size_m(i));
    add(title.low, title.high);
  }
  return box;
}

void DxfWriter::draw_titles(const ProjectPart& project) {
  if (!storeys_.are_apart()) return;
  const std::string name(title_of(project.name, project.path));
  note(t_.say<Text::dxf_storeys_beside>(name, storeys_.layer("LUX_...", 0)));
  for (storey_ = 0; storey_ < storeys_.count(); ++storey_) {
    const DxfStorey& storey = storeys_[storey_];
    if (storey.box.is_empty()) continue;
    layers_[layer(kStoreyTitles)] = {DxfColour::ink, false};
    for (const char* one : kStoreyLayers) layers_[layer(one)] = layers_[one];
    use_layers(layers_of(true, 0), false, false);
    const std::vector<std::string> lines = title_lines(storey_);
    const glm::dvec2 corner = title_corner_m(storey_) + project_shift_m_;
    taken_->add(below(corner, title_size_m(storey_)));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double down = kDxfLine * text_m_ * static_cast<double>(i) + text_m_;
      dxf_words(layer(kStoreyTitles), {corner.x, corner.y - down, storey.floor_z_m}, text_m_,
                lines[i], DxfAlign::start, DxfColour::by_layer, dxf_);
    }
    if (storey.shift_m > 0.0) {
      note(fmt::format(
          "{}, {}: {}", name, storey_title(t_, storey.floor_z_m),
          t_.say<Text::dxf_storey_moved>(format_metres(t_, project_shift_m_.x + storey.shift_m))));
    }
  }
}

// Where it is drawn, so that it is not over the one before it.
void DxfWriter::begin_project(const ProjectPart& project) {
  constexpr double kWidest_m = 20.0;
  project_shift_m_ = glm::dvec2(0.0);
  FlatBox box = put_storeys(project);
  if (!extent_.is_empty() && right_m_ + kGap_m > box.low.x) {
    project_shift_m_.x = right_m_ + kGap_m - box.low.x;
    note(t_.say<Text::dxf_moved>(title_of(project.name, project.path),
                                 format_metres(t_, project_shift_m_.x)));
  }
  box.low += project_shift_m_;
  box.high += project_shift_m_;
  extend(box);
  shelf_left_m_ = box.low.x;
  shelf_right_m_ = std::max(box.high.x, box.low.x + kWidest_m);
  shelf_m_ = {box.low.x, box.low.y - kGap_m};
  shelf_height_m_ = 0.0;
  aside_m_ = {box.high.x + kGap_m, box.high.y};
  aside_top_m_ = box.high.y;
  aside_bottom_m_ = box.low.y;
  aside_width_m_ = 0.0;
  scales_ = ColourScales(project, style_.scale);
  tiers_ = other_tiers_ = std::vector<Tiers>(storeys_.count());
  taken_.emplace(text_m_);
  blocks_of_project_.clear();
  draw_titles(project);
  if (has_overlap_in_storey(project, storeys_))
    note(fmt::format("{}: {}", title_of(project.name, project.path), t_[Text::dxf_storeys]));
}

// Values first: they have their places, and what else is written goes where there are none.
void DxfWriter::add(const ProjectPart& project) {
  titles_.clear();
  const std::vector<std::string> titles = room_titles(project);
  for (std::size_t i = 0; i < titles.size(); ++i) titles_.emplace(project.spaces[i].id, titles[i]);
  table_->add(project);
  add_summary(project);
  if (drawn_box(project).is_empty()) return;
  std::vector<PlaneDrawing> planes;
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes)
      planes.push_back({&space, &plane, is_level_plane(plane), is_task_area(space, plane)});
  }
  choose_scale(planes, drawn_box(project).longest());
  begin_project(project);
  std::stable_sort(planes.begin(), planes.end(), [this](const auto& a, const auto& b) {
    if (a.is_task != b.is_task) return a.is_task;
    return storeys_.storey_of(*a.space) < storeys_.storey_of(*b.space);
  });
  for (const SpacePart& space : project.spaces) draw_room(space);
  for (const PlaneDrawing& drawing : planes) {
    if (drawing.is_level) draw_level(drawing);
    flush();
  }
  for (const SpacePart& space : project.spaces) draw_luminaires(project, space);
  draw_room_data(project);
  for (const PlaneDrawing& drawing : planes) {
    if (drawing.is_level) {
      draw_plane_name(drawing);
    } else {
      draw_beside(drawing);
      has_beside_ = has_beside_ || drawing.is_task;
    }
    flush();
  }
  const auto others = std::count_if(planes.begin(), planes.end(),
                                    [](const PlaneDrawing& drawing) { return !drawing.is_task; });
  if (others > 0) {
    const std::string layers =
        fmt::format("LUX_...{}{}", kOtherLayers, storeys_.are_apart() ? "_S..." : "");
    note(others == 1 ? t_.say<Text::dxf_one_other>(others, layers)
                     : t_.say<Text::dxf_others>(others, layers));
  }
}

// For the legend: a line for each room, and why it does not pass.
void DxfWriter::add_summary(const ProjectPart& project) {
  for (const calc::Diagnostic& diagnostic : project.diagnostics) ++warnings_[diagnostic.id];
  summary_.add(title_of(project.name, project.path));
  if (const std::string about = about_line(t_, project.about); !about.empty()) summary_.add(about);
  if (!project.is_judged) summary_.add(t_[Text::not_judged_see_errors]);
  RoomOverview table = room_overview(t_, project, 1);
  // Beside the plan there is no room for more; all of it is in the notes.
  for (const RoomOverview::Column column :
       {RoomOverview::Column::use, RoomOverview::Column::walls, RoomOverview::Column::cylindrical,
        RoomOverview::Column::leni})
    table.drop(column);
  std::vector<std::vector<std::string>> rows;
  std::vector<DxfColour> colours;
  for (const RoomOverview::Row& row : table.rows) {
    rows.push_back(row.cells);
    if (row.is_area) rows.back()[1].insert(0, "    ");
    colours.push_back(colour_of(row.outcome));
  }
  if (!rows.empty()) summary_.add_table(table.head, rows, colours);
  for (const RoomSummary& room : room_summaries(project)) {
    for (const RoomCause& cause : room.causes) {
      summary_.add(
          fmt::format("{} / {}", title_of_room(*room.space), cause_words(t_, room, cause).what),
          colour_of(cause.outcome));
    }
  }
  summary_.add("");
}

void DxfWriter::write_legend(const DocumentEnd& end) {
  DxfColumns legend(kLegendColumn);
  legend.add(t_.say<Text::dxf_title>(scale_, unit_.name));
  legend.add(summary_words(t_, end.totals));
  if (const std::string words = provenance_remarks(end.provenance, t_); !words.empty())
    legend.add(words);
  for (const calc::Diagnostic& error : document_errors(end))
    legend.add(calc::format_diagnostic(error));
  if (frame_.revised != nullptr) {
    for (const std::string& remark : revision_remarks(*frame_.revised, t_)) legend.add(remark);
  }
  legend.add("");
  legend.add(summary_);
  legend.add(t_.say<Text::dxf_confidence>(format_percent(t_, end.provenance.confidence)));
  using enum rules::Outcome;
  legend.add(t_.say<Text::dxf_colours>(
      outcome_words(t_, pass), outcome_words(t_, fail), outcome_words(t_, undecided),
      outcome_words(t_, not_judged),
      fmt::format("{}, {}", outcome_words(t_, waived), outcome_words(t_, nothing_asked))));
  legend.add(t_[Text::dxf_marks]);
  if (has_beside_) legend.add(t_[Text::dxf_beside]);
  if (has_aside_) legend.add(t_[Text::dxf_blocks_aside]);
  for (const std::string& words : notes_) legend.add(words);
  std::string warnings;
  for (const auto& [id, count] : warnings_) {
    warnings += fmt::format("{}[{}]", warnings.empty() ? "" : ", ", calc::diagnostic_name(id));
    if (count > 1) warnings += fmt::format(" x {}", count);
  }
  if (!warnings.empty()) legend.add(t_.say<Text::dxf_warnings>(warnings));
  legend.add(t_.say<Text::dxf_notes>(kNotes));
  const glm::dvec2 corner(extent_.high.x + kGap_m, extent_.high.y);
  extend(legend.draw(kLegend, corner, extent_.size().y, text_m_, dxf_));
  flush();
}

// What `text` says, right of the legend.
void DxfWriter::write_notes(const DocumentEnd& end) {
  DxfColumns notes(kNotesColumn);
  TextSink table;
  table_->finish(end, table);
  for (std::string_view left = table.text; !left.empty();) {
    const std::size_t line = left.find('\n');
    notes.add(left.substr(0, line));
    left.remove_prefix(line == std::string_view::npos ? left.size() : line + 1);
  }
  const glm::dvec2 corner(extent_.high.x + kGap_m, extent_.high.y);
  notes.draw(kNotes, corner, extent_.size().y, text_m_, dxf_);
  flush();
}

void DxfWriter::finish(const DocumentEnd& end, Sink& sink) {
  choose_scale({}, 0.0);
  if (extent_.is_empty()) extent_.add({0.0, 0.0});
  write_legend(end);
  write_notes(end);
  DxfText dxf{"", dxf_.per_metre};
  dxf_head({layers_, extent_.low, extent_.high, text_m_, unit_.number}, dxf);
  dxf_section("BLOCKS", dxf);
  sink.write(dxf.bytes);
  blocks_.copy_to(sink);
  dxf.bytes.clear();
  dxf_section_end(dxf);
  dxf_section("ENTITIES", dxf);
  sink.write(dxf.bytes);
  entities_.copy_to(sink);
  dxf.bytes.clear();
  dxf_section_end(dxf);
  dxf_group(0, "EOF", dxf);
  sink.write(dxf.bytes);
}

}  // namespace

std::unique_ptr<FormatWriter> dxf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, const PageStyle& style) {
  return std::make_unique<DxfWriter>(frame, place, t, style);
}

}  // namespace report
