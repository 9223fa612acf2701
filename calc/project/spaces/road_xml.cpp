#include "calc/project/spaces/road_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/project/objects/frame.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/planes_xml.h"
#include "calc/project/spaces/spaces_xml.h"
#include "calc/road/road_values.h"
#include "calc/scene/luminaire_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr int kMostLanes = 20;
// Beyond that a row is no row, and below it luminaires stand in each other.
constexpr NumberRange kRowSpacing{4.0, 500.0, false, "from 4 m to 500 m"};
constexpr std::size_t kMostRows = 12;
constexpr NumberRange kRoadWidth{1.0, 100.0, false, "from 1 m to 100 m"};
constexpr NumberRange kMountingHeight{2.0, 60.0, false, "from 2 m to 60 m"};
constexpr NumberRange kLaneWidth{1.5, 7.0, false, ""};
constexpr NumberRange kStripWidth{0.5, 100.0, false, "from 0.5 m to 100 m"};
constexpr NumberRange kBeside{0.0, 100.0, false, "from 0 to 100 m"};
constexpr double kLeastEdge_m = 1.0;
constexpr double kMostOfQ0 = 2.0;  // of the surface's own, or the inverse
constexpr NumberRange kShift{-500.0, 500.0, false, "from -500 m to 500 m"};
constexpr NumberRange kOverhang{-100.0, 100.0, false, "from -100 m to 100 m"};

// A length of the file, in metres; range: in metres.
double read_length_m(const ProjectContext& context, ElementReader& reader, std::string_view name,
                     const NumberRange& range) {
  const double length_m = reader.number(name, kCoordinate) * context.metres_per_unit;
  if (reader.ok() && !range.contains(length_m)) {
    reader.report(DiagnosticId::number_out_of_range, reader.where(name), name,
                  reader.element().name, fmt::format("{:.6g} m", length_m), range.words);
  }
  return length_m;
}

double read_length_m_or(const ProjectContext& context, ElementReader& reader, std::string_view name,
                        const NumberRange& range, double otherwise_m) {
  return reader.has(name) ? read_length_m(context, reader, name, range) : otherwise_m;
}

int read_lanes(ElementReader& reader, std::string_view name, int least, int most) {
  const int lanes = reader.integer(name, least);
  if (lanes <= most) return lanes;
  reader.report(DiagnosticId::number_out_of_range, reader.where(name), name, "road", lanes,
                fmt::format("a whole number from {} to {}", least, most));
  return most;
}

// Oncoming ones are on the left where traffic keeps right.
std::vector<bool> read_directions(ElementReader& reader) {
  const int lanes = read_lanes(reader, "lanes", 1, kMostLanes);
  std::vector<bool> is_oncoming(static_cast<std::size_t>(std::max(lanes, 1)), false);
  const bool keeps_left = reader.choice_or("traffic", kTrafficSideType.words, 0) == 1;
  if (!reader.has("oncoming-lanes")) {
    if (reader.has("traffic")) reader.require_together("traffic", "oncoming-lanes");
    return is_oncoming;
  }
  const int oncoming = read_lanes(reader, "oncoming-lanes", 0, lanes);
  for (int i = 0; i < oncoming; ++i) {
    is_oncoming[static_cast<std::size_t>(keeps_left ? i : lanes - 1 - i)] = true;
  }
  return is_oncoming;
}

// Of a strip beside the carriageway that counts for the ratio at its edge: inside it is as wide.
std::optional<double> read_edge_m(const ProjectContext& context, ElementReader& reader,
                                  std::string_view name, const Road& road) {
  const double width_m = read_length_m_or(context, reader, name, kCoordinate, road.lane_m());
  if (width_m == 0.0) return std::nullopt;
  if (reader.ok() && (width_m < kLeastEdge_m || width_m > road.width_m)) {
    reader.report(DiagnosticId::number_out_of_range, reader.where(name), name, "road",
                  fmt::format("{:.6g} m", width_m),
                  "0, or from 1 m to the width of the carriageway");
  }
  return width_m;
}

// Files of road luminaires by LM-63 and its heirs have C 0 on the street side, EULUMDAT has C 90.
double usual_street_c_rad(const PhotometricWeb& web) {
  const bool is_eulumdat = web.source().format.find("EULUMDAT") != std::string::npos;
  return is_eulumdat ? 0.5 * kPi : 0.0;
}

// A luminaire on the right side, whose street side looks to +y: turned so that this C does, then
// lifted on that side.
glm::dmat3 road_from_luminaire(double street_c_rad, double tilt_rad) {
  const glm::dvec3 lifted_y(0.0, calc::cos(tilt_rad), calc::sin(tilt_rad));
  const glm::dvec3 lifted_z(0.0, -calc::sin(tilt_rad), calc::cos(tilt_rad));
  const glm::dmat3 tilt(glm::dvec3(1.0, 0.0, 0.0), lifted_y, lifted_z);
  return tilt * rotation_about_z(0.5 * kPi - street_c_rad);
}

// Most of the light of a road luminaire goes to the street: a photometry that sends it elsewhere is
// turned the other way than this project has it.
void warn_if_turned(const PhotometricWeb& web, ElementReader& reader, double street_c_rad) {
  constexpr int kDirections = 4;
  constexpr int kSteps = 45, kAround = 9;
  std::array<double, kDirections> quarter{};  // light to the quarter about C0, C90, C180 and C270
  double all = 0.0;
  for (int q = 0; q < kDirections; ++q) {
    for (int a = 0; a < kAround; ++a) {
      const double c_rad = 0.5 * kPi * (q + (a + 0.5) / kAround - 0.5);
      for (int g = 0; g < kSteps; ++g) {
        const double gamma_rad = 0.5 * kPi * (g + 0.5) / kSteps;
        quarter[static_cast<std::size_t>(q)] +=
            web.intensity_cd(c_rad, gamma_rad) * calc::sin(gamma_rad) * calc::sin(gamma_rad);
      }
    }
    all += quarter[static_cast<std::size_t>(q)];
  }
  // How much more light goes to each of these sides than to the opposite one.
  const auto beyond = [&](std::size_t q) { return (quarter[q] - quarter[(q + 2) % 4]) / all; };
  const auto street =
      static_cast<std::size_t>(std::lround(street_c_rad / (0.5 * kPi))) % kDirections;
  std::size_t brightest = 0;
  for (std::size_t q = 1; q < kDirections; ++q) {
    if (beyond(q) > beyond(brightest)) brightest = q;
  }
  constexpr double kClear = 0.05;
  if (!(all > 0.0) || brightest == street || beyond(brightest) < kClear ||
      beyond(street) > 0.5 * beyond(brightest)) {
    return;
  }
  reader.report(DiagnosticId::road_luminaire_turned, reader.where(),
                reader.element().find("id")->value, 90 * brightest, 90 * street, 90 * brightest,
                90 * street);
}

class RoadReader {
 public:
  RoadReader(ProjectContext& context, ElementReader& reader, Space& space)
      : context_(context), reader_(reader), space_(space) {}

  void read() {
    CalcPlane plane = read_named_plane(context_, reader_);
    plane.usual_role = kCarriagewayRole;
    space_.id = plane.id;
    space_.was = plane.was;
    space_.name = plane.name;
    space_.tags = plane.tags;
    Road road = read_carriageway();
    const bool is_good = reader_.ok();
    read_rows(road, is_good);
    if (is_good) lay(plane, road, 0.0, road.width_m);
    space_.planes.push_back(std::move(plane));
    read_strips(road, is_good);
    if (is_good) space_.notes.push_back(road_method_words(road));
    road.is_street_assumed = is_street_assumed_;
    space_.road = std::move(road);
    space_.notes.push_back(say<Sentence::road_rows_go_on>(kRoadReach_heights));
  }

 private:
  Road read_carriageway() {
    Road road;
    road.origin_m = read_point_m_or_zero(context_, reader_, "origin");
    road.world_from_road =
        rotation_about_z(radians_from_degrees(reader_.number_or("rotation", kTurn, 0.0)));
    road.spacing_m = read_length_m(context_, reader_, "spacing", kRowSpacing);
    road.width_m = read_length_m(context_, reader_, "width", kRoadWidth);
    road.is_oncoming = read_directions(reader_);
    check_lanes(road);
    road.surface = kRoadSurfaceType.words[reader_.choice("surface", kRoadSurfaceType.words)];
    road.q0 = reader_.optional_number("q0", kQ0);
    check_q0(road);
    road.right_strip_m = read_edge_m(context_, reader_, "right-strip", road);
    road.left_strip_m = read_edge_m(context_, reader_, "left-strip", road);
    return road;
  }

  // One lane that is three wide would be looked at from one place, and lanes of a foot from many.
  void check_lanes(const Road& road) {
    if (!reader_.ok() || kLaneWidth.contains(road.lane_m())) return;
    reader_.report(
        DiagnosticId::number_out_of_range, reader_.where("lanes"), "lanes", "road",
        road.is_oncoming.size(),
        fmt::format("lanes that are {:g} m to {:g} m wide; these lanes are {:.3g} m wide",
                    kLaneWidth.low, kLaneWidth.high, road.lane_m()));
  }

  // Surfaces of one class differ, but not by more.
  void check_q0(const Road& road) {
    if (!reader_.ok() || !road.q0) return;
    const double own = r_table(road.surface)->q0;
    if (*road.q0 <= kMostOfQ0 * own && *road.q0 >= own / kMostOfQ0) return;
    reader_.report(
        DiagnosticId::number_out_of_range, reader_.where("q0"), "q0", "road", *road.q0,
        fmt::format("a number from {:.4g} to {:.4g}, half to twice the value of surface {}",
                    own / kMostOfQ0, kMostOfQ0 * own, road.surface));
  }

  void read_rows(Road& road, bool is_good) {
    IdTable ids("row of luminaires");
    std::size_t rows = 0;
    bool begins_field = false;
    for (const XmlElement& child : reader_.element().children) {
      if (child.name != "luminaire-row") continue;
      ++rows;
      ElementReader row(child, context_.diagnostics);
      ids.add(row, row.id(), 0);
      const std::vector<Luminaire> one = read_row(row, road);
      begins_field = begins_field || one.empty() || one.front().position_m.x == 0.0;
      const std::vector<Luminaire> first = with_all_emitters(context_.project, one);
      check_emitters(row, first);
      road.rows.insert(road.rows.end(), first.begin(), first.end());
      if (row.ok() && is_good) stand(row, road, first);
    }
    if (rows > kMostRows) {
      reader_.report(DiagnosticId::missing_form, reader_.where(), "road",
                     fmt::format("at most {} <luminaire-row>", kMostRows));
    }
    if (rows > 0 && begins_field) return;
    reader_.report(DiagnosticId::missing_form, reader_.where(), "road",
                   rows == 0
                       ? "a <luminaire-row>"
                       : "a <luminaire-row> without 'shift': the field begins at its luminaire");
  }

  // Files may have them anywhere.
  void check_emitters(ElementReader& row, const std::vector<Luminaire>& emitters) {
    constexpr double kLowest_m = 1.6, kFarthest_m = 200.0;  // above the eyes of drivers
    for (const Luminaire& emitter : emitters) {
      const glm::dvec3& at_m = emitter.position_m;
      if (at_m.z >= kLowest_m && at_m.z <= kFarthest_m && std::abs(at_m.y) <= 2.0 * kFarthest_m) {
        continue;
      }
      row.report(
          DiagnosticId::number_out_of_range, row.where("height"), "height", row.element().name,
          row.text("height"),
          fmt::format("a height that puts every emitter from {:g} m to {:g} m above the road; '{}' "
                      "is {:.4g} m above it and {:.4g} m from its right edge",
                      kLowest_m, kFarthest_m, emitter.id, at_m.z, at_m.y));
      return;
    }
  }

  // Null after an error in the luminaire type, which was reported where it stands.
  const PhotometricWeb* web_of(std::size_t type) const {
    const Project& project = context_.project;
    if (type >= project.luminaire_types.size()) return nullptr;
    const std::size_t web = project.luminaire_types[type].web;
    return web < project.webs.size() ? &project.webs[web] : nullptr;
  }

  // Its luminaire at or behind x = 0; empty after an error.
  std::vector<Luminaire> read_row(ElementReader& row, const Road& road) {
    row.allow(kLuminaireRowElement);
    Luminaire luminaire;
    luminaire.id = row.text_or("id", "");
    luminaire.where = row.where();
    luminaire.type = context_.luminaire_types.find(row, "type");
    if (row.has("group")) {
      luminaire.group = trim(row.text("group"));
      context_.groups.insert(luminaire.group);
    }
    const bool is_left = row.choice("side", kRoadSideType.words) == 1;
    const double height_m = read_length_m(context_, row, "height", kMountingHeight);
    const double overhang_m = read_length_m_or(context_, row, "overhang", kOverhang, 0.0);
    const double tilt_rad = radians_from_degrees(row.number_or("tilt", kTilt, 0.0));
    double shift_m = read_length_m_or(context_, row, "shift", kShift, 0.0);
    const std::optional<std::size_t> street =
        row.has("street") ? std::optional(row.choice("street", kStreetPlaneType.words))
                          : std::nullopt;
    const PhotometricWeb* web = web_of(luminaire.type);
    if (!row.ok() || !(road.spacing_m > 0.0) || web == nullptr) return {};
    const double street_c_rad =
        street ? 0.5 * kPi * static_cast<double>(*street) : usual_street_c_rad(*web);
    if (!street) {
      is_street_assumed_ = true;
      warn_if_turned(*web, row, street_c_rad);
      space_.notes.push_back(say<Sentence::road_street>(
          luminaire.id, static_cast<int>(std::lround(degrees_from_radians(street_c_rad)))));
    }
    shift_m -= road.spacing_m * std::floor(shift_m / road.spacing_m);
    if (!(shift_m < road.spacing_m)) shift_m = 0.0;  // of a hair below 0
    luminaire.position_m = {shift_m, is_left ? road.width_m - overhang_m : overhang_m, height_m};
    luminaire.world_from_luminaire = road_from_luminaire(street_c_rad, tilt_rad);
    if (is_left) {
      luminaire.world_from_luminaire =
          glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)) *
          luminaire.world_from_luminaire;
    }
    return {luminaire};
  }

  // Those of a row that count for the field. first: its emitters near x = 0.
  void stand(ElementReader& row, const Road& road, const std::vector<Luminaire>& first) {
    if (first.empty()) return;
    const double shift_m = first.front().position_m.x;
    const double reach_m = kRoadReach_heights * first.front().position_m.z;
    const int from = static_cast<int>(std::ceil((-reach_m - shift_m) / road.spacing_m));
    const int to =
        static_cast<int>(std::floor((road.spacing_m + reach_m - shift_m) / road.spacing_m));
    const double count = static_cast<double>(first.size()) * std::max(0, to - from + 1);
    if (!check_room_for(context_, row, static_cast<double>(space_.luminaires.size()) + count, 0)) {
      return;
    }
    for (int k = from; k <= to; ++k) {
      for (Luminaire luminaire : first) {
        luminaire.id = fmt::format("{}[{}]", luminaire.id, k);
        luminaire.position_m =
            road.origin_m + road.world_from_road *
                                (luminaire.position_m + glm::dvec3(k * road.spacing_m, 0.0, 0.0));
        luminaire.world_from_luminaire = road.world_from_road * luminaire.world_from_luminaire;
        space_.luminaires.push_back(std::move(luminaire));
      }
    }
  }

  void read_strips(const Road& road, bool is_good) {
    for (const XmlElement& child : reader_.element().children) {
      if (child.name != "strip") continue;
      ElementReader strip(child, context_.diagnostics);
      strip.allow(kRoadStripElement);
      CalcPlane plane = read_named_plane(context_, strip);
      plane.usual_role = kFootwayRole;
      const bool is_left = strip.choice("side", kRoadSideType.words) == 1;
      const double gap_m = read_length_m_or(context_, strip, "gap", kBeside, 0.0);
      const double width_m = read_length_m(context_, strip, "width", kStripWidth);
      if (strip.ok() && is_good) {
        lay(plane, road, is_left ? road.width_m + gap_m : -gap_m - width_m, width_m);
      }
      space_.planes.push_back(std::move(plane));
    }
  }

  // As long as the field, from y on.
  static void lay(CalcPlane& plane, const Road& road, double y_m, double width_m) {
    PlanarArea area;
    area.origin_m = road.origin_m + road.world_from_road * glm::dvec3(0.0, y_m, 0.0);
    area.u = road.world_from_road[0];
    area.v = road.world_from_road[1];
    area.outline_m = {{0.0, 0.0}, {road.spacing_m, 0.0}, {road.spacing_m, width_m}, {0.0, width_m}};
    area.grid = GridByCount{road_points_along(road.spacing_m), road_points_across(width_m)};
    plane.travel = area.u;
    plane.area = std::move(area);
  }

  ProjectContext& context_;
  ElementReader& reader_;
  Space& space_;
  bool is_street_assumed_ = false;
};

}  // namespace

void read_road(ProjectContext& context, ElementReader& reader, IdTable& ids) {
  reader.allow(kRoadElement);
  Space space;
  space.where = reader.where();
  RoadReader(context, reader, space).read();
  ids.add(reader, space.id, 0);
  if (space.id == kOpenSpaceId) {
    reader.report(DiagnosticId::reserved_id, reader.where("id"), space.id);
  }
  context.instances += static_cast<double>(space.luminaires.size());
  context.project.spaces.push_back(std::move(space));
}

}  // namespace calc
