#include "report/tools/import/dxf_drawing.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

// Columns are the axes of the coordinates that belong to a normal, in the world.
glm::dmat4 axes_of(const glm::dvec3& normal) {
  const double length = glm::length(normal);
  if (!(length > 0.0)) return glm::dmat4(1.0);
  const glm::dvec3 z = normal / length;
  constexpr double kNearlyUpright = 1.0 / 64.0;  // the format's own number
  const bool is_upright = std::fabs(z.x) < kNearlyUpright && std::fabs(z.y) < kNearlyUpright;
  const glm::dvec3 x =
      glm::normalize(glm::cross(is_upright ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), z));
  glm::dmat4 axes(1.0);
  axes[0] = glm::dvec4(x, 0.0);
  axes[1] = glm::dvec4(glm::cross(z, x), 0.0);
  axes[2] = glm::dvec4(z, 0.0);
  return axes;
}

glm::dmat4 turned(double degrees) {
  // Right angles exactly: most of what people draw.
  const double turn = std::fmod(std::fmod(degrees, 360.0) + 360.0, 360.0);
  double c = 0.0, s = 0.0;
  if (turn == 0.0) {
    c = 1.0;
  } else if (turn == 90.0) {
    s = 1.0;
  } else if (turn == 180.0) {
    c = -1.0;
  } else if (turn == 270.0) {
    s = -1.0;
  } else {
    c = calc::cos(turn * calc::kRadiansPerDegree);
    s = calc::sin(turn * calc::kRadiansPerDegree);
  }
  glm::dmat4 matrix(1.0);
  matrix[0] = glm::dvec4(c, s, 0.0, 0.0);
  matrix[1] = glm::dvec4(-s, c, 0.0, 0.0);
  return matrix;
}

// By how much it makes a distance longer, at most.
double largest_stretch(const glm::dmat4& matrix) {
  const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  const glm::dvec3 length(glm::length(x), glm::length(y), glm::length(z));
  constexpr double kRight = 1.0e-9;
  const bool is_square = std::fabs(glm::dot(x, y)) <= kRight * length.x * length.y &&
                         std::fabs(glm::dot(y, z)) <= kRight * length.y * length.z &&
                         std::fabs(glm::dot(z, x)) <= kRight * length.z * length.x;
  // Blocks stretched in turned blocks lean; no column says then how far that goes.
  return is_square ? std::max({length.x, length.y, length.z}) : glm::length(length);
}

DxfEllipse round_arc(const glm::dvec3& centre, double radius, double from, double angle) {
  return {centre, {radius, 0.0, 0.0}, {0.0, radius, 0.0}, from, angle};
}

// As add_chords().
double add_bulge(const glm::dvec3& from, const glm::dvec3& to, double bulge, double error,
                 std::vector<glm::dvec3>& points) {
  const glm::dvec2 chord(to - from);
  const double length = glm::length(chord);
  if (bulge == 0.0 || length == 0.0) return error;
  // The centre lies beside the middle of the chord.
  const double beside = (1.0 - bulge * bulge) / (4.0 * bulge);
  const glm::dvec2 centre = glm::dvec2(from) + 0.5 * chord + beside * glm::dvec2(-chord.y, chord.x);
  const glm::dvec2 spoke = glm::dvec2(from) - centre;
  const double radius = glm::length(spoke);
  if (!std::isfinite(radius) || radius > 1.0e9 * length) {  // straight, or nearly a whole circle
    return std::max(error, 0.5 * std::fabs(bulge) * length);
  }
  return add_chords(
      round_arc({centre, from.z}, radius, calc::atan2(spoke.y, spoke.x), 4.0 * calc::atan(bulge)),
      error, points);
}

constexpr const char* kNameTooLong = "a name is longer than 1020 bytes";
constexpr const char* kNotJoined = "the edges of its loops do not join";

// The values of one record, from its 0 to the next.
using Record = std::vector<DxfPair>;

class DrawingReader {
 public:
  explicit DrawingReader(std::string_view bytes) : pairs_(bytes) {}

  std::optional<DxfDrawing> read(std::string& problem) {
    drawing_.is_binary = pairs_.is_binary();
    DxfPair pair;
    bool has_section = false;
    while (problem_.empty() && pairs_.next(pair)) {
      if (pair.code == 0) {
        finish_record();
        name_ = calc::trim(pair.text);
        place_ = pair.place;
        has_section = has_section || name_ == "SECTION";
        continue;
      }
      if (section_ == "HEADER" && name_ == "SECTION") {
        take_header(pair);
      } else if (name_ == "SECTION" && pair.code == 2 && section_.empty()) {
        section_ = calc::trim(pair.text);
      } else if (is_wanted(pair.code)) {
        record_.push_back(pair);
      }
    }
    finish_record();
    if (problem_.empty() && pairs_.is_cut() && name_ == "ENDSEC" && has_entities_) {
      drawing_.end_doubt = "the file's last pair, 0 EOF, is missing: it may be cut off";
    } else if (problem_.empty()) {
      problem_ = pairs_.problem();
    }
    if (problem_.empty() && !has_section) problem_ = "line 1: this file has no section";
    if (!problem_.empty()) {
      problem = problem_;
      return std::nullopt;
    }
    close();
    return std::move(drawing_);
  }

 private:
  void fail(std::size_t place, const std::string& why) {
    if (problem_.empty()) problem_ = fmt::format("{}: {}", pairs_.place_words(place), why);
  }

  // Programs' own data are wanted of block records alone.
  bool is_wanted(int code) const { return code < 1000 || name_ == "BLOCK_RECORD"; }

  void skip(const std::string& kind, const std::string& why) {
    const DxfPair* layer = find(8);
    ++drawing_.skipped[{kind, layer == nullptr ? "" : name_of(*layer), why}];
  }

  std::string text_of(const DxfPair& pair) { return texts_.decoded(pair.text); }
  // Names: blanks at their ends are nobody's.
  std::string name_of(const DxfPair& pair) {
    return calc::printable(calc::trim(texts_.decoded(pair.text)));
  }

  void take_header(const DxfPair& pair) {
    if (pair.code == 9) {
      variable_ = calc::trim(pair.text);
    } else if (variable_ == "$ACADVER" && pair.code == 1) {
      drawing_.version = calc::printable(calc::trim(pair.text));
    } else if (variable_ == "$DWGCODEPAGE" && pair.code == 3) {
      code_page_ = calc::printable(calc::trim(pair.text));
    } else if (variable_ == "$INSUNITS" && pair.code == 70) {
      drawing_.unit = dxf_integer(pair);
    }
    texts_.set(drawing_.version, code_page_);
  }

  const DxfPair* find(int code) const {
    for (const DxfPair& pair : record_) {
      if (pair.code == code) return &pair;
    }
    return nullptr;
  }
  // Sets is_broken_ where there is something else than a number.
  double number(int code, double missing = 0.0) {
    const DxfPair* pair = find(code);
    return pair == nullptr ? missing : number(*pair);
  }
  double number(const DxfPair& pair) {
    const std::optional<double> value = dxf_number(pair);
    if (!value || std::fabs(*value) > 1.0e15) is_broken_ = true;
    return is_broken_ ? 0.0 : *value;
  }
  int whole(int code, int missing = 0) {
    const DxfPair* pair = find(code);
    if (pair == nullptr) return missing;
    const std::optional<int> value = dxf_integer(*pair);
    if (!value) is_broken_ = true;
    return value.value_or(missing);
  }
  glm::dvec3 point(int code) { return {number(code), number(code + 10), number(code + 20)}; }

  void finish_record() {
    if (name_ == "ENDSEC") {
      has_entities_ = has_entities_ || section_ == "ENTITIES";
      close_open();
      block_ = nullptr;
      section_.clear();
    } else if (name_ == "SECTION" && !section_.empty()) {
      // its name was taken
    } else if (section_ == "TABLES") {
      take_table_record();
    } else if (section_ == "BLOCKS" || section_ == "ENTITIES") {
      take_entity_record();
    } else if (section_ == "OBJECTS" && name_ == "DICTIONARY") {
      take_dictionary();
    }
    record_.clear();
  }

  void take_table_record() {
    if (name_ == "LAYER" && find(2) != nullptr) {
      DxfLayer layer{name_of(*find(2)), false, false};
      const DxfPair* colour = find(62);
      const DxfPair* flags = find(70);
      layer.is_off = colour != nullptr && dxf_integer(*colour).value_or(0) < 0;
      layer.is_frozen = flags != nullptr && (dxf_integer(*flags).value_or(0) & 1) != 0;
      drawing_.layer.emplace(dxf_key(layer.name), layer);
    } else if (name_ == "BLOCK_RECORD" && find(2) != nullptr && find(5) != nullptr) {
      const std::string name = name_of(*find(2));
      record_name_[name_of(*find(5))] = name;
      // A dynamic block's copy says here of which block it is.
      bool is_of_copy = false;
      for (const DxfPair& pair : record_) {
        if (pair.code == 1001) is_of_copy = calc::trim(pair.text) == "AcDbBlockRepBTag";
        if (pair.code == 1005 && is_of_copy) copied_[dxf_key(name)] = name_of(pair);
      }
    }
  }

  void take_dictionary() {
    const DxfPair* handle = find(5);
    if (handle == nullptr) return;
    for (const DxfPair& pair : record_) {
      if (pair.code == 3 && calc::trim(pair.text) == "ACAD_FILTER")
        filters_.insert(name_of(*handle));
    }
  }

  std::vector<DxfEntity>* entities() {
    if (section_ == "ENTITIES") return &drawing_.entity;
    return block_ == nullptr ? nullptr : &block_->entity;
  }

  void close_open() { open_polyline_ = open_insert_ = is_passing_ = false; }

  void take_entity_record() {
    is_broken_ = false;
    if (name_ == "VERTEX") return take_vertex();
    if (name_ == "ATTRIB") return take_attribute();
    close_open();
    if (name_ == "SEQEND" || name_ == "SECTION") return;
    if (name_ == "BLOCK") {
      block_ = nullptr;
      if (find(2) == nullptr) return skip("BLOCK", "it has no name");
      const std::string name = name_of(*find(2));
      if (name.size() > kLongestDxfName) return skip("BLOCK", kNameTooLong);
      DxfBlock& block = drawing_.block[dxf_key(name)];
      if (!block.name.empty()) return skip("BLOCK", "another one has its name");
      block.name = name;
      block.base = point(10);
      block.is_external = (whole(70) & 12) != 0;
      if (is_broken_) return fail(place_, "a number of this BLOCK cannot be read");
      block_ = &block;
      return;
    }
    if (name_ == "ENDBLK") {
      block_ = nullptr;
      return;
    }
    std::vector<DxfEntity>* list = entities();
    if (list == nullptr) return;
    if (++count_ > kMostDxfEntities) {
      return fail(place_, fmt::format("this file has more than {} entities", kMostDxfEntities));
    }
    DxfEntity entity;
    if (!take_common(entity)) {
      is_passing_ = true;  // what follows it belongs to it
      return;
    }
    if (!take_shape(entity, *list)) return;
    if (is_broken_) {
      is_passing_ = true;
      open_polyline_ = open_insert_ = false;
      return skip(name_, "one of its numbers cannot be read, or is beyond 1e15");
    }
    list->push_back(std::move(entity));
  }

  bool take_common(DxfEntity& entity) {
    entity.place = place_;
    dictionary_.clear();
    bool is_in_group = false, is_in_dictionary = false;
    Record own;  // without what programs put into braces
    for (const DxfPair& pair : record_) {
      if (pair.code == 101) break;  // an object within it, with codes of its own
      if (pair.code == 102) {
        const std::string_view text = calc::trim(pair.text);
        is_in_group = !text.empty() && text.front() == '{';
        is_in_dictionary = text == "{ACAD_XDICTIONARY";
        continue;
      }
      if (is_in_dictionary && pair.code == 360) dictionary_ = name_of(pair);
      if (!is_in_group) own.push_back(pair);
    }
    record_ = std::move(own);
    if (const DxfPair* layer = find(8)) entity.layer = name_of(*layer);
    // Copies of these stand with everything that is placed.
    if (entity.layer.size() > kLongestDxfName) {
      ++drawing_.skipped[{name_, calc::shorten_utf8(entity.layer, 40), kNameTooLong}];
      return false;
    }
    if (entity.layer.empty()) entity.layer = "0";
    if (const DxfPair* handle = find(5)) entity.handle = name_of(*handle);
    if (entity.handle.size() > kLongestDxfHandle) entity.handle.clear();
    if (find(210) != nullptr) {
      entity.normal = {number(210), number(220), number(230, 1.0)};
      if (glm::length(entity.normal) == 0.0) is_broken_ = true;
    }
    if (whole(67) == 1 && section_ == "ENTITIES") {
      skip(name_, "it is in paper space, not in the model");
      return false;
    }
    if (whole(60) == 1) {
      skip(name_, "it is invisible");
      return false;
    }
    return true;
  }

  // False: passed over, which was counted, or there is nothing to add.
  bool take_shape(DxfEntity& entity, std::vector<DxfEntity>& list) {
    using Kind = DxfEntity::Kind;
    if (name_ == "LINE") {
      entity.kind = Kind::line;
      entity.is_in_world = true;
      entity.vertex = {{point(10)}, {point(11)}};
    } else if (name_ == "POINT") {
      entity.is_in_world = true;
      entity.vertex = {{point(10)}};
    } else if (name_ == "CIRCLE" || name_ == "ARC") {
      entity.kind = name_ == "ARC" ? Kind::arc : Kind::circle;
      entity.is_closed = name_ == "CIRCLE";
      entity.vertex = {{point(10)}};
      entity.radius = number(40);
      entity.start_deg = number(50);
      entity.end_deg = number(51);
      if (!(entity.radius > 0.0)) is_broken_ = true;
    } else if (name_ == "3DFACE") {
      entity.kind = Kind::face;
      entity.is_in_world = entity.is_closed = true;
      for (const int code : {10, 11, 12, 13}) entity.vertex.push_back({point(code)});
      if (find(13) == nullptr || entity.vertex[3].at == entity.vertex[2].at) {
        entity.vertex.pop_back();
      }
    } else if (name_ == "SOLID" || name_ == "TRACE") {
      take_solid(entity);
    } else if (name_ == "ELLIPSE") {
      return take_ellipse(entity);
    } else if (name_ == "SPLINE") {
      return take_spline(entity);
    } else if (name_ == "LWPOLYLINE") {
      take_light_polyline(entity);
    } else if (name_ == "POLYLINE") {
      take_polyline(entity);
    } else if (name_ == "INSERT") {
      if (find(2) != nullptr && name_of(*find(2)).size() > kLongestDxfName) {
        is_passing_ = true;
        skip(name_, kNameTooLong);
        return false;
      }
      take_insert(entity);
    } else if (name_ == "TEXT" || name_ == "MTEXT") {
      take_text(entity);
    } else if (name_ == "HATCH") {
      take_hatch(entity, list);
      return false;
    } else {
      is_passing_ = true;
      // Definitions of attributes are not drawn where the block stands.
      if (name_ != "ATTDEF") skip(name_, "not a supported kind");
      return false;
    }
    return true;
  }

  // Its corners come as 1, 2, 4, 3.
  void take_solid(DxfEntity& entity) {
    entity.kind = DxfEntity::Kind::face;
    entity.is_closed = true;
    for (const int code : {10, 11, 13, 12}) {
      if (code == 13 && find(13) == nullptr) continue;
      entity.vertex.push_back({point(code)});
    }
    if (entity.vertex.size() == 4 && entity.vertex[2].at == entity.vertex[3].at) {
      entity.vertex.pop_back();
    }
  }

  // False: passed over, which was counted.
  bool take_curve(DxfEntity& entity, DxfCurve curve, bool is_whole) {
    entity.kind = DxfEntity::Kind::curve;
    entity.is_in_world = true;
    if (is_broken_) return true;
    if (const std::string why = curve_problem(curve); !why.empty()) {
      skip(name_, why);
      return false;
    }
    entity.vertex = {{curve_start(curve)}};
    entity.is_closed = is_whole;
    if (!is_whole) entity.vertex.push_back({curve_end(curve)});
    entity.side.push_back({0, std::move(curve)});
    return true;
  }

  bool take_ellipse(DxfEntity& entity) {
    DxfEllipse ellipse;
    ellipse.centre = point(10);
    ellipse.x_axis = point(11);
    const double length = glm::length(entity.normal);
    if (length > 0.0) {
      ellipse.y_axis = number(40) * glm::cross(entity.normal / length, ellipse.x_axis);
    }
    ellipse.from = number(41);
    bool is_whole = false;
    ellipse.angle = turn_from(ellipse.from, number(42, 2.0 * calc::kPi), is_whole);
    return take_curve(entity, ellipse, is_whole);
  }

  // Counter-clockwise from one angle to another one; radians.
  static double turn_from(double from, double to, bool& is_whole) {
    constexpr double kSameAngle = 1.0e-9, kRound = 2.0 * calc::kPi;
    double angle = std::fmod(to - from, kRound);
    if (angle <= 0.0) angle += kRound;
    const bool is_just_round = angle < kSameAngle && std::fabs(to - from) > 1.0;
    is_whole = is_just_round || kRound - angle < kSameAngle;
    return is_whole ? kRound : angle;
  }

  bool take_spline(DxfEntity& entity) {
    constexpr int kClosed = 1;
    DxfSpline spline;
    spline.degree = whole(71);
    for (const DxfPair& pair : record_) {
      if (pair.code == 40) spline.knot.push_back(number(pair));
      if (pair.code == 41) spline.weight.push_back(number(pair));
      if (pair.code == 10) spline.control.emplace_back(number(pair), 0.0, 0.0);
      if (spline.control.empty()) continue;
      if (pair.code == 20) spline.control.back().y = number(pair);
      if (pair.code == 30) spline.control.back().z = number(pair);
    }
    const bool is_whole = (whole(70) & kClosed) != 0;
    constexpr double kSame = 1.0e-6;  // of its size
    if (!is_broken_ && is_whole && curve_problem(spline).empty() &&
        glm::distance(curve_start(spline), curve_end(spline)) > kSame * curve_size(spline)) {
      skip(name_, "it is closed, and its ends do not meet");
      return false;
    }
    return take_curve(entity, std::move(spline), is_whole);
  }

  void take_light_polyline(DxfEntity& entity) {
    entity.kind = DxfEntity::Kind::polyline;
    entity.is_closed = (whole(70) & 1) != 0;
    const double z = number(38);
    for (const DxfPair& pair : record_) {
      if (pair.code == 10) entity.vertex.push_back({{number(pair), 0.0, z}, 0.0});
      if (entity.vertex.empty()) continue;
      if (pair.code == 20) entity.vertex.back().at.y = number(pair);
      if (pair.code == 42) entity.vertex.back().bulge = number(pair);
    }
  }

  void take_polyline(DxfEntity& entity) {
    const int flags = whole(70);
    const bool is_mesh = (flags & (16 | 64)) != 0;
    entity.kind = is_mesh ? DxfEntity::Kind::mesh : DxfEntity::Kind::polyline;
    entity.is_closed = !is_mesh && (flags & 1) != 0;
    entity.is_in_world = is_mesh || (flags & 8) != 0;
    elevation_ = number(30);
    open_polyline_ = true;
  }

  void take_vertex() {
    if (is_passing_) return;
    std::vector<DxfEntity>* list = entities();
    if (!open_polyline_ || list == nullptr || list->empty()) {
      return skip("VERTEX", "it does not belong to a POLYLINE");
    }
    if (++count_ > kMostDxfEntities) {
      return fail(place_, fmt::format("this file has more than {} entities", kMostDxfEntities));
    }
    DxfEntity& entity = list->back();
    const int flags = whole(70);
    // The frame of a smoothed polyline is not drawn; faces of a mesh have no place.
    if ((flags & 16) != 0 && entity.kind == DxfEntity::Kind::polyline) return;
    if ((flags & 128) != 0 && (flags & 64) == 0) return;
    DxfVertex vertex{point(10), number(42)};
    if (!entity.is_in_world) vertex.at.z = elevation_;
    if (!is_broken_) {
      entity.vertex.push_back(vertex);
      return;
    }
    list->pop_back();
    open_polyline_ = false;
    is_passing_ = true;
    skip("POLYLINE", "one of its numbers cannot be read, or is beyond 1e15");
  }

  void take_insert(DxfEntity& entity) {
    entity.kind = DxfEntity::Kind::insert;
    entity.vertex = {{point(10)}};
    if (find(2) != nullptr) entity.block_in_file = name_of(*find(2));
    entity.block = entity.block_in_file;
    entity.scale = {number(41, 1.0), number(42, 1.0), number(43, 1.0)};
    entity.rotation_deg = number(50);
    entity.columns = std::max(whole(70, 1), 1);
    entity.rows = std::max(whole(71, 1), 1);
    entity.column_step = number(44);
    entity.row_step = number(45);
    open_insert_ = whole(66) == 1;
    if (!dictionary_.empty()) {
      with_dictionary_.push_back(
          {section_ == "ENTITIES" ? "" : dxf_key(block_->name), entities()->size(), dictionary_});
    }
    dictionary_.clear();
  }

  void take_attribute() {
    if (is_passing_) return;
    std::vector<DxfEntity>* list = entities();
    if (!open_insert_ || list == nullptr || list->empty()) {
      return skip("ATTRIB", "it does not belong to an INSERT");
    }
    // Of an attribute of several lines the first value is the one that counts.
    const DxfPair* tag = find(2);
    const DxfPair* value = find(1);
    if (tag == nullptr) return skip("ATTRIB", "it has no tag");
    if (++count_ > kMostDxfEntities) {
      return fail(place_, fmt::format("this file has more than {} entities", kMostDxfEntities));
    }
    list->back().attribute.emplace_back(
        name_of(*tag), value == nullptr ? "" : calc::printable(plain_dxf_mtext(text_of(*value))));
  }

  void take_text(DxfEntity& entity) {
    entity.kind = DxfEntity::Kind::text;
    const bool is_long = name_ == "MTEXT";
    entity.is_in_world = is_long;
    const bool is_aligned = !is_long && (whole(72) != 0 || whole(73) != 0) && find(11) != nullptr;
    entity.vertex = {{point(is_aligned ? 11 : 10)}};
    std::string raw;
    for (const DxfPair& pair : record_) {
      if (pair.code == 1 || (is_long && pair.code == 3)) raw += pair.text;
    }
    const std::string text = texts_.decoded(raw);
    entity.text = calc::printable(is_long ? plain_dxf_mtext(text) : plain_dxf_text(text));
  }

  // Each loop is an outline.
  void take_hatch(const DxfEntity& start, std::vector<DxfEntity>& list) {
    const double z = number(30);
    std::size_t i = 0;
    while (i < record_.size() && record_[i].code != 91) ++i;
    const auto next = [&](int code) -> std::optional<double> {
      if (i >= record_.size() || record_[i].code != code) return std::nullopt;
      const std::optional<double> value = dxf_number(record_[i]);
      ++i;
      return value && std::fabs(*value) <= 1.0e15 ? value : std::nullopt;
    };
    const std::optional<double> loops = next(91);
    if (!loops) return skip("HATCH", "its loops cannot be read");
    for (double loop = 0.0; loop < *loops; ++loop) {
      while (i < record_.size() && record_[i].code != 92) ++i;
      const std::optional<double> flags = next(92);
      if (!flags) return skip("HATCH", "its loops cannot be read");
      if (++count_ > kMostDxfEntities) {
        return fail(place_, fmt::format("this file has more than {} entities", kMostDxfEntities));
      }
      DxfEntity outline = start;
      outline.kind = DxfEntity::Kind::outline;
      outline.is_closed = true;
      if (loop > 0.0 && !outline.handle.empty()) outline.handle += fmt::format("_{:.0f}", loop);
      std::string why;
      if (std::fmod(std::floor(*flags / 2.0), 2.0) != 0.0) {
        if (!read_loop(next, i, outline, z)) why = "its loops cannot be read";
      } else {
        // Programs do not agree on what the angles of ellipses are: those count that close the
        // loop.
        const std::size_t begin = i;
        why = read_edges(next, i, outline, z, true);
        if (why == kNotJoined) {
          i = begin;
          outline.vertex.clear();
          outline.side.clear();
          why = read_edges(next, i, outline, z, false);
        }
      }
      if (why.empty()) {
        list.push_back(std::move(outline));
      } else {
        skip("HATCH", why);
      }
    }
  }

  template <class Next>
  bool read_loop(const Next& next, std::size_t& i, DxfEntity& outline, double z) {
    next(72);
    next(73);
    const std::optional<double> count = next(93);
    if (!count) return false;
    for (double k = 0.0; k < *count; ++k) {
      const std::optional<double> x = next(10), y = next(20);
      if (!x || !y) return false;
      outline.vertex.push_back({{*x, *y, z}, 0.0});
      if (i < record_.size() && record_[i].code == 42) {
        outline.vertex.back().bulge = next(42).value_or(0.0);
      }
    }
    return true;
  }

  // "" or why not. are_angles: those of ellipses are as seen from the centre, else parameters.
  template <class Next>
  std::string read_edges(const Next& next, std::size_t& i, DxfEntity& outline, double z,
                         bool are_angles) {
    const std::string unreadable = "its loops cannot be read";
    const std::optional<double> count = next(93);
    if (!count) return unreadable;
    glm::dvec2 first(0.0), end(0.0);
    double gap = 0.0;
    for (double k = 0.0; k < *count; ++k) {
      const std::optional<double> kind = next(72);
      if (!kind) return unreadable;
      glm::dvec2 from(0.0), to(0.0);
      std::vector<DxfVertex> added;
      std::optional<DxfCurve> curve;
      if (*kind == 1.0) {
        const std::optional<double> x = next(10), y = next(20), x1 = next(11), y1 = next(21);
        if (!x || !y || !x1 || !y1) return unreadable;
        from = {*x, *y};
        to = {*x1, *y1};
        added = {{{from, z}, 0.0}};
      } else if (*kind == 2.0) {
        const std::optional<double> x = next(10), y = next(20), radius = next(40), start = next(50),
                                    last = next(51), direction = next(73);
        if (!x || !y || !radius || !start || !last || !direction) return unreadable;
        // Of clockwise arcs the angles are counted clockwise, too.
        const double sign = *direction != 0.0 ? 1.0 : -1.0;
        double angle = std::fmod(*last - *start, 360.0);
        if (angle <= 0.0) angle += 360.0;
        const auto at = [&](double degrees) {
          const double a = sign * degrees * calc::kRadiansPerDegree;
          return glm::dvec2(*x, *y) + *radius * glm::dvec2(calc::cos(a), calc::sin(a));
        };
        from = at(*start);
        to = at(*start + angle);
        const double bulge =
            sign * calc::tan(angle * calc::kRadiansPerDegree / 8.0);  // of half of it
        added = {{{from, z}, bulge}, {{at(*start + angle / 2.0), z}, bulge}};
      } else {
        if (*kind == 3.0) {
          curve = read_ellipse_edge(next, z, are_angles);
        } else if (*kind == 4.0) {
          curve = read_spline_edge(next, i, z);
        }
        if (!curve) return unreadable;
        if (const std::string why = curve_problem(*curve); !why.empty()) {
          return "a curve of its loops: " + why;
        }
        from = glm::dvec2(curve_start(*curve));
        to = glm::dvec2(curve_end(*curve));
        added = {{{from, z}, 0.0}};
      }
      gap = 1.0e-6 * (1.0 + glm::length(from));
      if (k == 0.0) {
        first = from;
      } else if (glm::distance(from, end) > gap) {
        return kNotJoined;
      }
      if (curve) outline.side.push_back({outline.vertex.size(), std::move(*curve)});
      outline.vertex.insert(outline.vertex.end(), added.begin(), added.end());
      end = to;
    }
    if (!outline.side.empty() && glm::distance(first, end) > gap) return kNotJoined;
    return outline.vertex.empty() ? "its loops have no edges" : "";
  }

  template <class Next>
  static std::optional<DxfCurve> read_ellipse_edge(const Next& next, double z, bool are_angles) {
    const std::optional<double> x = next(10), y = next(20), u = next(11), v = next(21),
                                ratio = next(40), start = next(50), last = next(51),
                                direction = next(73);
    if (!x || !y || !u || !v || !ratio || !start || !last || !direction) return std::nullopt;
    DxfEllipse ellipse;
    ellipse.centre = {*x, *y, z};
    ellipse.x_axis = {*u, *v, 0.0};
    ellipse.y_axis = *ratio * glm::dvec3(-*v, *u, 0.0);
    bool is_whole = false;
    const auto parameter = [&](double degrees) {
      const double angle = degrees * calc::kRadiansPerDegree;
      if (!are_angles) return angle;
      return calc::atan2(calc::sin(angle), *ratio * calc::cos(angle));
    };
    const double from = parameter(*start);
    const double turn = turn_from(from, parameter(*last), is_whole);
    const double sign = *direction != 0.0 ? 1.0 : -1.0;  // as of arcs
    ellipse.from = sign * from;
    ellipse.angle = sign * turn;
    return ellipse;
  }

  template <class Next>
  std::optional<DxfCurve> read_spline_edge(const Next& next, std::size_t& i, double z) const {
    const std::optional<double> degree = next(94), is_rational = next(73), is_periodic = next(74),
                                knots = next(95), points = next(96);
    if (!degree || !is_rational || !is_periodic || !knots || !points) return std::nullopt;
    DxfSpline spline;
    spline.degree =
        *degree >= 1.0 && *degree <= kHighestSplineDegree ? static_cast<int>(*degree) : 0;
    for (double k = 0.0; k < *knots; ++k) {
      const std::optional<double> knot = next(40);
      if (!knot) return std::nullopt;
      spline.knot.push_back(*knot);
    }
    for (double k = 0.0; k < *points; ++k) {
      const std::optional<double> x = next(10), y = next(20);
      if (!x || !y) return std::nullopt;
      spline.control.emplace_back(*x, *y, z);
      if (*is_rational == 0.0) continue;
      const std::optional<double> weight = next(42);
      if (!weight) return std::nullopt;
      spline.weight.push_back(*weight);
    }
    // From 2010 on the points that somebody drew, which do not count, and tangents.
    const auto is_of_fit = [](int code) {
      return code == 11 || code == 21 || code == 12 || code == 22 || code == 13 || code == 23;
    };
    std::size_t after = i;
    if (after < record_.size() && record_[after].code == 97) ++after;
    while (after < record_.size() && is_of_fit(record_[after].code)) ++after;
    i = after;
    return spline;
  }

  // What is known only when all is read.
  void close() {
    texts_.decoded(pairs_.first_comment());  // nobody reads it, but its letters may be in doubt
    drawing_.text_doubt = texts_.doubt();
    for (const HasDictionary& one : with_dictionary_) {
      if (filters_.count(one.dictionary) == 0) continue;
      std::vector<DxfEntity>& list =
          one.block.empty() ? drawing_.entity : drawing_.block[one.block].entity;
      if (one.index < list.size()) list[one.index].is_clipped = true;
    }
    const auto rename = [&](std::vector<DxfEntity>& list) {
      for (DxfEntity& entity : list) {
        const auto copy = copied_.find(dxf_key(entity.block_in_file));
        if (entity.block_in_file.empty() || copy == copied_.end()) continue;
        const auto record = record_name_.find(copy->second);
        if (record != record_name_.end()) entity.block = record->second;
      }
    };
    rename(drawing_.entity);
    for (auto& [key, block] : drawing_.block) rename(block.entity);
  }

  struct HasDictionary {
    std::string block;  // key, "" = model space
    std::size_t index;
    std::string dictionary;
  };

  DxfPairs pairs_;
  DxfTexts texts_;
  DxfDrawing drawing_;
  std::string problem_, section_, name_, variable_, code_page_, dictionary_;
  std::size_t place_ = 0, count_ = 0;
  Record record_;
  DxfBlock* block_ = nullptr;  // that is open
  bool has_entities_ = false;
  bool open_polyline_ = false, open_insert_ = false, is_passing_ = false, is_broken_ = false;
  double elevation_ = 0.0;
  std::map<std::string, std::string> record_name_;  // by handle
  std::map<std::string, std::string> copied_;       // key of a copy -> handle of the block
  std::set<std::string> filters_;
  std::vector<HasDictionary> with_dictionary_;
};

class Visitor {
 public:
  Visitor(const DxfDrawing& drawing, const std::function<bool(const DxfPlaced&)>& visit,
          DxfSkipped& skipped)
      : drawing_(drawing), visit_(visit), skipped_(skipped) {}

  std::string run() {
    DxfPlaced top;
    go(drawing_.entity, top, 0);
    return problem_;
  }
  // By a visit.
  void stop(const std::string& why) { problem_ = why; }
  // What stands in one block, in its coordinates.
  std::string run(const DxfBlock& block) {
    DxfPlaced top;
    top.layer = "0";
    go(block.entity, top, 1);
    return problem_;
  }

 private:
  bool count() {
    if (++count_ > kMostDxfPlaced) {
      problem_ =
          fmt::format("with all blocks, this drawing has more than {} entities", kMostDxfPlaced);
    }
    return problem_.empty();
  }

  // parent: the reference whose block these are of, with the matrix of their coordinates.
  void go(const std::vector<DxfEntity>& entities, const DxfPlaced& parent, std::size_t depth) {
    if (depth > kDeepestDxfBlock) {
      problem_ = fmt::format("blocks are nested more than {} deep, or contain themselves",
                             kDeepestDxfBlock);
      return;
    }
    for (const DxfEntity& entity : entities) {
      if (!problem_.empty() || !count()) return;
      DxfPlaced placed;
      placed.entity = &entity;
      placed.layer = depth > 0 && entity.layer == "0" ? parent.layer : entity.layer;
      if (!entity.handle.empty() && (depth == 0 || !parent.key.empty())) {
        placed.key = parent.key.empty() ? entity.handle : parent.key + "." + entity.handle;
      }
      const auto layer = drawing_.layer.find(dxf_key(placed.layer));
      const bool is_frozen = layer != drawing_.layer.end() && layer->second.is_frozen;
      placed.is_off = is_frozen || (layer != drawing_.layer.end() && layer->second.is_off);
      placed.to_world =
          entity.is_in_world ? parent.to_world : parent.to_world * axes_of(entity.normal);
      if (entity.kind == DxfEntity::Kind::insert) {
        if (is_frozen) {
          ++skipped_[{"INSERT", placed.layer, "its layer is frozen"}];
        } else {
          go_into(entity, placed, depth);
        }
      } else if (placed.is_off) {
        ++skipped_[{"entity", placed.layer, "its layer is off or frozen"}];
      } else {
        visit_(placed);
      }
    }
  }

  void go_into(const DxfEntity& entity, const DxfPlaced& start, std::size_t depth) {
    const auto block = drawing_.block.find(dxf_key(entity.block_in_file));
    const bool is_there = block != drawing_.block.end();
    const glm::dmat4 at =
        glm::translate(start.to_world, entity.vertex[0].at) * turned(entity.rotation_deg);
    for (int row = 0; row < entity.rows; ++row) {
      for (int column = 0; column < entity.columns; ++column) {
        if (!problem_.empty() || !count()) return;
        DxfPlaced placed = start;
        placed.row = row;
        placed.column = column;
        placed.to_world =
            glm::scale(glm::translate(at, {column * entity.column_step, row * entity.row_step, 0}),
                       entity.scale);
        if (!placed.key.empty() && (entity.rows > 1 || entity.columns > 1)) {
          placed.key += fmt::format("_{}_{}", column, row);
        }
        if (placed.is_off) {
          ++skipped_[{"INSERT", placed.layer, "its layer is off"}];
        } else if (!visit_(placed)) {
          continue;
        }
        if (!is_there || block->second.is_external) {
          ++skipped_[{
              "INSERT", placed.layer,
              is_there ? "its block is in another file (xref)" : "its block is not in this file"}];
          continue;
        }
        placed.to_world = glm::translate(placed.to_world, -block->second.base);
        go(block->second.entity, placed, depth + 1);
      }
    }
  }

  const DxfDrawing& drawing_;
  const std::function<bool(const DxfPlaced&)>& visit_;
  DxfSkipped& skipped_;
  std::size_t count_ = 0;
  std::string problem_;
};

}  // namespace

std::string DxfDrawing::place_words(std::size_t place) const {
  return fmt::format("{} {}", is_binary ? "byte" : "line", place);
}

std::string dxf_key(std::string_view name) { return calc::ascii_lowered(name); }

std::optional<DxfDrawing> read_dxf(std::string_view bytes, std::string& problem) {
  return DrawingReader(bytes).read(problem);
}

glm::dvec3 DxfPlaced::at(std::size_t vertex) const {
  // That of an INSERT is in its matrix already.
  const glm::dvec3 own =
      entity->kind == DxfEntity::Kind::insert ? glm::dvec3(0.0) : entity->vertex[vertex].at;
  return glm::dvec3(to_world * glm::dvec4(own, 1.0));
}

std::vector<glm::dvec3> DxfPlaced::corners(double largest_error, double* reached) const {
  const double stretch = largest_stretch(to_world);
  const double error = stretch > 0.0 ? largest_error / stretch : largest_error;
  double farthest = error;
  std::vector<glm::dvec3> own;
  const std::vector<DxfVertex>& vertex = entity->vertex;
  if (entity->kind == DxfEntity::Kind::circle || entity->kind == DxfEntity::Kind::arc) {
    const bool is_whole = entity->is_closed;
    const double from = is_whole ? 0.0 : entity->start_deg * calc::kRadiansPerDegree;
    double angle = is_whole ? 360.0 : std::fmod(entity->end_deg - entity->start_deg, 360.0);
    if (angle <= 0.0) angle += 360.0;
    angle *= calc::kRadiansPerDegree;
    const auto end = [&](double at) {
      return vertex[0].at + entity->radius * glm::dvec3(calc::cos(at), calc::sin(at), 0.0);
    };
    own.push_back(end(from));
    farthest = add_chords(round_arc(vertex[0].at, entity->radius, from, angle), error, own);
    if (!is_whole) own.push_back(end(from + angle));
  } else {
    auto side = entity->side.begin();
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      own.push_back(vertex[i].at);
      if (side != entity->side.end() && side->vertex == i) {
        farthest = std::max(farthest, add_chords(side->curve, error, own));
        ++side;
      } else if (i + 1 < vertex.size() || entity->is_closed) {
        const glm::dvec3& to = vertex[(i + 1) % vertex.size()].at;
        farthest = std::max(farthest, add_bulge(vertex[i].at, to, vertex[i].bulge, error, own));
      }
    }
  }
  for (glm::dvec3& point : own) point = glm::dvec3(to_world * glm::dvec4(point, 1.0));
  if (reached != nullptr) *reached = farthest > error ? farthest * stretch : largest_error;
  return own;
}

std::string visit_dxf(const DxfDrawing& drawing, const std::function<bool(const DxfPlaced&)>& visit,
                      DxfSkipped& skipped) {
  return Visitor(drawing, visit, skipped).run();
}

std::size_t corner_work(const DxfEntity& entity) {
  std::size_t work = 1 + entity.vertex.size();
  for (const DxfCurvedSide& side : entity.side) work += curve_work(side.curve);
  return work;
}

DxfExtent extent_of_block(const DxfDrawing& drawing, const std::string& block_in_file,
                          std::size_t& work) {
  DxfExtent extent;
  const auto block = drawing.block.find(dxf_key(block_in_file));
  if (block == drawing.block.end()) return extent;
  constexpr double kFine = 1.0e-3;  // of the radius: extents need no more
  DxfSkipped skipped;
  Visitor* visitor = nullptr;
  const auto take = [&](std::size_t amount) {
    work -= std::min(work, amount);
    if (work == 0) visitor->stop("measuring the blocks of this drawing takes too long");
    return work > 0;
  };
  const std::function<bool(const DxfPlaced&)> visit = [&](const DxfPlaced& placed) {
    using Kind = DxfEntity::Kind;
    const DxfEntity& entity = *placed.entity;
    if (entity.kind == Kind::insert) return take(1);
    if (!take(corner_work(entity)) || entity.kind == Kind::text || entity.kind == Kind::point) {
      return false;
    }
    double size = entity.radius;
    for (const DxfVertex& vertex : entity.vertex) {
      size = std::max(size, glm::distance(vertex.at, entity.vertex[0].at));
    }
    for (const DxfCurvedSide& side : entity.side) size = std::max(size, curve_size(side.curve));
    size *= largest_stretch(placed.to_world);
    double reached = 0.0;
    const std::vector<glm::dvec3> corners = placed.corners(kFine * size, &reached);
    if (reached > kFine * size)
      visitor->stop("one of its arcs or curves is far larger than the distance of its ends");
    take(corners.size());
    for (const glm::dvec3& point : corners) {
      extent.low = extent.is_any ? glm::min(extent.low, point) : point;
      extent.high = extent.is_any ? glm::max(extent.high, point) : point;
      extent.is_any = true;
    }
    if (entity.kind == Kind::face) ++extent.faces;
    if (entity.kind == Kind::mesh) ++extent.meshes;
    return false;
  };
  Visitor of_block(drawing, visit, skipped);
  visitor = &of_block;
  extent.problem = of_block.run(block->second);
  if (!extent.problem.empty()) extent.is_any = false;
  return extent;
}

}  // namespace cli
