#include "report/tools/import/ifc_shape.h"

#include "calc/scene/polygon.h"
#include "report/tools/import/ifc_placement.h"
#include "report/tools/import/ifc_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace cli {
namespace {

constexpr int kDeepestShape = 32;               // mapped items and clippings
constexpr double kUprightAxis = 1.0e-5;         // sine of the angle to the vertical
constexpr double kLevel_m = 1.0e-3;             // heights that are nearer are one
constexpr double kSameArea = 1.0e-3;            // relative: of ceiling and floor
constexpr std::size_t kComparisonsOfWork = 16;  // of two corners, as long as a byte of text

struct Face {
  std::vector<glm::dvec3> outer;
  std::vector<std::vector<glm::dvec3>> inner;
};

// One body: an upright prism, or else faces.
struct Solid {
  IfcProfile prism;  // seen from above
  double low = 0.0, high = 0.0;
  std::vector<Face> face;

  bool is_prism() const { return !prism.outer.empty(); }
};

void check_near(const glm::dvec3& point) {
  for (const double x : {point.x, point.y, point.z}) {
    if (!(std::fabs(x) <= kFarthestIfc)) throw IfcLeftOut{"one of its points is too far away"};
  }
}

glm::dvec3 placed(const glm::dmat4& frame, const glm::dvec3& point) {
  const glm::dvec3 result(frame * glm::dvec4(point, 1.0));
  check_near(result);
  return result;
}

std::vector<glm::dvec2> from_above(const std::vector<glm::dvec3>& polygon) {
  std::vector<glm::dvec2> result;
  for (const glm::dvec3& p : polygon) result.emplace_back(p.x, p.y);
  return result;
}

class SolidReader {
 public:
  explicit SolidReader(IfcFile& file) : file_(file) {}

  std::vector<Solid> solid;
  std::vector<std::string> doubt;

  void read(const StepValue& representation, const glm::dmat4& frame) {
    for (const StepValue& item : body_items(file_, representation)) read_item(item, frame, 0);
    if (solid.empty()) throw IfcLeftOut{"its body is empty"};
  }

  // What a type has, in its own frame.
  void read_type(std::uint32_t map) {
    read_map(file_.arguments(map, 2)[1], glm::dmat4(1.0), 0);
    if (solid.empty()) throw IfcLeftOut{"its body is empty"};
  }

  // Of the representation that is the body.
  static std::vector<StepValue> body_items(IfcFile& file, const StepValue& representation) {
    const std::uint32_t instance = file.follow(representation, "shape");
    const std::string& name = file.text().name(instance);
    if (name != "IFCPRODUCTDEFINITIONSHAPE" && name != "IFCPRODUCTREPRESENTATION") {
      throw IfcLeftOut{fmt::format("a shape by {} is not read", name)};
    }
    const std::vector<StepValue> shape = file.arguments(instance, 3);
    std::vector<StepValue> body;
    std::size_t bodies = 0;
    for (const StepValue& one : shape[2].items()) {
      const std::vector<StepValue> a = file.arguments(file.follow(one, "representation"), 4);
      if (a[1].text().value_or("") != "Body") continue;
      ++bodies;
      body = a[3].items();
    }
    if (bodies == 0) throw IfcLeftOut{"it has no representation 'Body'"};
    if (bodies > 1) throw IfcLeftOut{"it has several representations 'Body'"};
    return body;
  }

 private:
  void read_item(const StepValue& item, const glm::dmat4& frame, int depth) {
    if (depth > kDeepestShape) throw IfcLeftOut{"its shapes are nested too deep"};
    const std::uint32_t instance = file_.follow(item, "shape");
    const std::string& name = file_.text().name(instance);
    if (name == "IFCEXTRUDEDAREASOLID") return extrusion(instance, frame);
    if (name == "IFCBOOLEANCLIPPINGRESULT" || name == "IFCBOOLEANRESULT") {
      const std::vector<StepValue> a = file_.arguments(instance, 3);
      const std::string operation = a[0].enumeration();
      if (operation != "DIFFERENCE" && operation != "INTERSECTION") {
        throw IfcLeftOut{fmt::format("a shape by {} of {} is not read", name, operation)};
      }
      doubt.push_back("part of its body is cut off; it is read without the cut");
      return read_item(a[1], frame, depth + 1);
    }
    if (name == "IFCMAPPEDITEM") return mapped(instance, frame, depth);
    if (name == "IFCFACETEDBREP" || name == "IFCFACETEDBREPWITHVOIDS") {
      if (name != "IFCFACETEDBREP") doubt.push_back("hollows within its body are omitted");
      Solid& brep = solid.emplace_back();
      return shell(file_.arguments(instance, 1)[0], frame, brep);
    }
    if (name == "IFCFACEBASEDSURFACEMODEL" || name == "IFCSHELLBASEDSURFACEMODEL") {
      Solid& surface = solid.emplace_back();
      for (const StepValue& one : file_.arguments(instance, 1)[0].items()) {
        shell(one, frame, surface);
      }
      return;
    }
    if (name == "IFCPOLYGONALFACESET") return polygonal(instance, frame);
    if (name == "IFCTRIANGULATEDFACESET") return triangulated(instance, frame);
    throw IfcLeftOut{fmt::format("a shape by {} is not read", name)};
  }

  void mapped(std::uint32_t instance, const glm::dmat4& frame, int depth) {
    const std::vector<StepValue> a = file_.arguments(instance, 2);
    const std::vector<StepValue> map = file_.arguments_of(a[0], "IFCREPRESENTATIONMAP", 2);
    const glm::dmat4 origin = ifc_axis_placement(file_, map[0]);
    const glm::dmat4 inner = frame * ifc_operator(file_, a[1]) * glm::inverse(origin);
    for (const glm::length_t i : {0, 1, 2, 3}) check_near(glm::dvec3(inner[i]));
    read_map(map[1], inner, depth + 1);
  }

  void read_map(const StepValue& representation, const glm::dmat4& frame, int depth) {
    const std::vector<StepValue> shape = file_.arguments(file_.follow(representation, "shape"), 4);
    for (const StepValue& item : shape[3].items()) read_item(item, frame, depth);
  }

  void extrusion(std::uint32_t instance, const glm::dmat4& frame) {
    const std::vector<StepValue> a = file_.arguments(instance, 4);
    const glm::dmat4 world = frame * ifc_axis_placement(file_, a[1]);
    const glm::dvec3 way(
        world * glm::dvec4(file_.direction(a[2]) * file_.positive_length_m(a[3], "depth"), 0.0));
    const IfcProfile profile = ifc_profile(file_, a[0], doubt);
    const glm::dvec3 z(world[2]);
    const auto is_upright = [](const glm::dvec3& v) {
      return std::fabs(v.x) + std::fabs(v.y) <= kUprightAxis * std::fabs(v.z);
    };
    Solid& result = solid.emplace_back();
    const auto base = [&](const std::vector<glm::dvec2>& outline) {
      std::vector<glm::dvec3> corners;
      for (const glm::dvec2& p : outline) corners.push_back(placed(world, glm::dvec3(p, 0.0)));
      return corners;
    };
    if (is_upright(z) && is_upright(way)) {
      result.prism.outer = from_above(base(profile.outer));
      for (const auto& hole : profile.inner) result.prism.inner.push_back(from_above(base(hole)));
      check_near(way);
      result.low = std::min(world[3].z, world[3].z + way.z);
      result.high = std::max(world[3].z, world[3].z + way.z);
      return;
    }
    Face bottom{base(profile.outer), {}};
    for (const auto& hole : profile.inner) bottom.inner.push_back(base(hole));
    Face top = bottom;
    for (glm::dvec3& p : top.outer) p += way;
    for (auto& hole : top.inner) {
      for (glm::dvec3& p : hole) p += way;
    }
    const auto sides = [&](const std::vector<glm::dvec3>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec3& p = ring[i];
        const glm::dvec3& q = ring[(i + 1) % ring.size()];
        result.face.push_back({{p, q, q + way, p + way}, {}});
      }
    };
    sides(bottom.outer);
    for (const auto& hole : bottom.inner) sides(hole);
    result.face.push_back(std::move(bottom));
    result.face.push_back(std::move(top));
  }

  void shell(const StepValue& reference, const glm::dmat4& frame, Solid& result) {
    const std::uint32_t instance = file_.follow(reference, "shell");
    const std::string& name = file_.text().name(instance);
    if (name != "IFCCLOSEDSHELL" && name != "IFCOPENSHELL" && name != "IFCCONNECTEDFACESET") {
      throw IfcLeftOut{fmt::format("a shape by {} is not read", name)};
    }
    for (const StepValue& face : file_.arguments(instance, 1)[0].items()) {
      result.face.push_back(face_of(face, frame));
    }
  }

  Face face_of(const StepValue& reference, const glm::dmat4& frame) {
    Face face;
    const std::uint32_t instance = file_.follow(reference, "face");
    const std::string& name = file_.text().name(instance);
    if (name != "IFCFACE") throw IfcLeftOut{fmt::format("a face by {} is not read", name)};
    const std::vector<StepValue> bounds = file_.arguments(instance, 1)[0].items();
    for (const StepValue& bound : bounds) {
      const std::uint32_t one = file_.follow(bound, "bound of a face");
      const std::vector<StepValue> loop = file_.arguments(one, 1);
      std::vector<glm::dvec3> corners;
      for (const StepValue& point : file_.arguments_of(loop[0], "IFCPOLYLOOP", 1)[0].items()) {
        corners.push_back(placed(frame, file_.point_m(point)));
      }
      const bool is_outer = bounds.size() == 1 || file_.text().name(one) == "IFCFACEOUTERBOUND";
      if (!is_outer) {
        face.inner.push_back(std::move(corners));
      } else if (face.outer.empty()) {
        face.outer = std::move(corners);
      } else {
        throw IfcLeftOut{"a face with two outer bounds"};
      }
    }
    if (face.outer.size() < 3) throw IfcLeftOut{"a face with less than three corners"};
    return face;
  }

  std::vector<glm::dvec3> point_list(const StepValue& reference, const glm::dmat4& frame) {
    std::vector<glm::dvec3> points;
    for (const StepValue& point :
         file_.arguments_of(reference, "IFCCARTESIANPOINTLIST3D", 1)[0].items()) {
      points.push_back(placed(frame, file_.coordinates_m(point)));
    }
    return points;
  }

  // Indices count from 1; with a list of indices between, into that.
  std::vector<glm::dvec3> indexed(const StepValue& list, const std::vector<glm::dvec3>& points,
                                  const std::vector<std::size_t>& between) {
    const auto checked = [&](const StepValue& index, std::size_t most) {
      const double i = file_.number(index, "index");
      if (!(i >= 1.0 && i <= static_cast<double>(most))) {
        throw IfcLeftOut{"an index of a face beyond its list"};
      }
      return static_cast<std::size_t>(i) - 1;
    };
    std::vector<glm::dvec3> corners;
    for (const StepValue& index : list.items()) {
      const std::size_t i = checked(index, between.empty() ? points.size() : between.size());
      corners.push_back(points[between.empty() ? i : between[i]]);
    }
    if (corners.size() < 3) throw IfcLeftOut{"a face with less than three corners"};
    return corners;
  }

  std::vector<std::size_t> index_list(const StepValue& list, std::size_t most) {
    std::vector<std::size_t> result;
    for (const StepValue& index : list.items()) {
      const double i = file_.number(index, "index");
      if (!(i >= 1.0 && i <= static_cast<double>(most))) {
        throw IfcLeftOut{"an index of a face beyond its list"};
      }
      result.push_back(static_cast<std::size_t>(i) - 1);
    }
    return result;
  }

  void polygonal(std::uint32_t instance, const glm::dmat4& frame) {
    const std::vector<StepValue> a = file_.arguments(instance, 3);
    const std::vector<glm::dvec3> points = point_list(a[0], frame);
    const std::vector<std::size_t> between =
        a.size() > 3 ? index_list(a[3], points.size()) : std::vector<std::size_t>();
    Solid& result = solid.emplace_back();
    for (const StepValue& one : a[2].items()) {
      const std::uint32_t face = file_.follow(one, "face");
      const std::string& name = file_.text().name(face);
      const bool has_holes = name == "IFCINDEXEDPOLYGONALFACEWITHVOIDS";
      if (name != "IFCINDEXEDPOLYGONALFACE" && !has_holes) {
        throw IfcLeftOut{fmt::format("a face by {} is not read", name)};
      }
      const std::vector<StepValue> b = file_.arguments(face, has_holes ? 2 : 1);
      Face& added = result.face.emplace_back();
      added.outer = indexed(b[0], points, between);
      if (!has_holes) continue;
      for (const StepValue& hole : b[1].items()) {
        added.inner.push_back(indexed(hole, points, between));
      }
    }
  }

  void triangulated(std::uint32_t instance, const glm::dmat4& frame) {
    const std::vector<StepValue> a = file_.arguments(instance, 4);
    const std::vector<glm::dvec3> points = point_list(a[0], frame);
    const std::vector<std::size_t> between =
        a.size() > 4 ? index_list(a[4], points.size()) : std::vector<std::size_t>();
    Solid& result = solid.emplace_back();
    for (const StepValue& triangle : a[3].items()) {
      result.face.push_back({indexed(triangle, points, between), {}});
    }
  }

  IfcFile& file_;
};

// Corners within this of each other, by rounding, are one.
using Corner = std::array<std::int64_t, 2>;
Corner corner_of(const glm::dvec2& p) {
  return {std::llround(p.x / kSamePoint_m), std::llround(p.y / kSamePoint_m)};
}

// The outer lines of polygons that lie side by side: what two of them share falls out.
std::vector<std::vector<glm::dvec2>> merged(const std::vector<std::vector<glm::dvec2>>& polygons) {
  std::map<std::pair<Corner, Corner>, int> side;  // how often, less that of the way back
  std::map<Corner, glm::dvec2> place;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner from = corner_of(polygon[i]);
      const Corner to = corner_of(polygon[(i + 1) % polygon.size()]);
      place.emplace(from, polygon[i]);
      if (from == to) continue;
      if (const auto back = side.find({to, from}); back != side.end()) {
        if (--back->second == 0) side.erase(back);
      } else {
        ++side[{from, to}];
      }
    }
  }
  std::map<Corner, Corner> next;
  for (const auto& [ends, count] : side) {
    if (count != 1 || !next.emplace(ends.first, ends.second).second) {
      throw IfcLeftOut{"the pieces of its floor overlap or touch in a corner only"};
    }
  }
  std::vector<std::vector<glm::dvec2>> rings;
  while (!next.empty()) {
    std::vector<glm::dvec2>& ring = rings.emplace_back();
    auto at = next.begin();
    while (at != next.end()) {
      ring.push_back(place.at(at->first));
      const Corner to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return rings;
}

// The floor of a body of faces, and whether the body stands on it as a prism would.
Solid prism_from_faces(IfcFile& file, const std::vector<Face>& faces,
                       std::vector<std::string>& doubt) {
  Solid result;
  result.low = std::numeric_limits<double>::infinity();
  result.high = -result.low;
  std::size_t corners = 0;
  for (const Face& face : faces) {
    corners += face.outer.size();
    for (const glm::dvec3& p : face.outer) {
      result.low = std::min(result.low, p.z);
      result.high = std::max(result.high, p.z);
    }
  }
  const auto is_at = [](const Face& face, double z) {
    return std::all_of(face.outer.begin(), face.outer.end(),
                       [&](const glm::dvec3& p) { return std::fabs(p.z - z) <= kLevel_m; });
  };
  std::vector<std::vector<glm::dvec2>> floor;
  double floor_area = 0.0, ceiling_area = 0.0;
  for (const Face& face : faces) {
    const bool is_floor = is_at(face, result.low);
    if (!is_floor && !is_at(face, result.high)) continue;
    double area = 0.0;
    for (std::size_t i = 0; i <= face.inner.size(); ++i) {
      std::vector<glm::dvec2> ring = from_above(i == 0 ? face.outer : face.inner[i - 1]);
      drop_same_points(ring);
      const double ring_area = calc::signed_area(ring);
      if ((ring_area > 0.0) != (i == 0)) std::reverse(ring.begin(), ring.end());
      area += i == 0 ? std::fabs(ring_area) : -std::fabs(ring_area);
      if (is_floor) floor.push_back(std::move(ring));
    }
    (is_floor ? floor_area : ceiling_area) += area;
  }
  if (floor.empty()) throw IfcLeftOut{"it has no level floor at its lowest place"};
  if (floor.size() > 1) floor = merged(floor);
  double merged_area = 0.0;
  for (auto& ring : floor) {
    const double area = calc::signed_area(ring);
    merged_area += area;
    if (area <= 0.0) {
      result.prism.inner.push_back(std::move(ring));
    } else if (result.prism.outer.empty()) {
      result.prism.outer = std::move(ring);
    } else {
      throw IfcLeftOut{"its floor is in several pieces"};
    }
  }
  if (result.prism.outer.empty() ||
      !(std::fabs(merged_area - floor_area) <= kSameArea * floor_area)) {
    throw IfcLeftOut{"the pieces of its floor overlap"};
  }
  file.work(corners * result.prism.outer.size() / kComparisonsOfWork);
  for (const Face& face : faces) {
    for (const glm::dvec3& p : face.outer) {
      const glm::dvec2 q(p.x, p.y);
      if (!calc::contains_point(result.prism.outer, q) &&
          calc::distance_to_boundary(result.prism.outer, q) > kLevel_m) {
        throw IfcLeftOut{"it is wider further up than on its floor"};
      }
    }
  }
  if (!(std::fabs(ceiling_area - floor_area) <= kSameArea * floor_area)) {
    doubt.push_back(
        "its ceiling is not level or not as large as its floor; it is taken as a room with "
        "upright walls as high as its highest place");
  }
  return result;
}

void check_simple(IfcFile& file, std::vector<glm::dvec2>& ring, bool is_hole) {
  if (ring.size() < 3) throw IfcLeftOut{"an outline of less than three corners"};
  if (ring.size() > kMostCorners) {
    throw IfcLeftOut{fmt::format("an outline of more than {} corners", kMostCorners)};
  }
  file.work(ring.size() * ring.size() / kComparisonsOfWork);
  if (!calc::is_simple_polygon(ring)) {
    throw IfcLeftOut{"its outline crosses or touches itself, or has no area"};
  }
  if ((calc::signed_area(ring) < 0.0) != is_hole) std::reverse(ring.begin(), ring.end());
}

}  // namespace

IfcRoomShape ifc_room_shape(IfcFile& file, const StepValue& representation,
                            const glm::dmat4& world_from_product) {
  SolidReader reader(file);
  reader.read(representation, world_from_product);
  if (reader.solid.size() > 1) throw IfcLeftOut{"its body is in several pieces"};
  Solid& body = reader.solid[0];
  if (!body.is_prism()) body = prism_from_faces(file, body.face, reader.doubt);
  check_simple(file, body.prism.outer, false);
  for (auto& hole : body.prism.inner) {
    check_simple(file, hole, true);
    file.work(hole.size() * body.prism.outer.size() / kComparisonsOfWork);
    for (const glm::dvec2& p : hole) {
      if (!calc::contains_point(body.prism.outer, p)) {
        throw IfcLeftOut{"a hole of its outline is outside of it"};
      }
    }
  }
  if (!(body.high - body.low > kLevel_m)) throw IfcLeftOut{"it has no height"};
  IfcRoomShape shape;
  shape.outline = std::move(body.prism.outer);
  shape.hole = std::move(body.prism.inner);
  shape.floor_z_m = body.low;
  shape.height_m = body.high - body.low;
  shape.doubt = std::move(reader.doubt);
  return shape;
}

IfcTypeFrame ifc_type_frame(IfcFile& file, const StepValue& representation) {
  try {
    const std::vector<StepValue> items = SolidReader::body_items(file, representation);
    if (items.size() != 1) return {};
    const std::uint32_t item = file.follow(items[0], "shape");
    if (file.text().name(item) != "IFCMAPPEDITEM") return {};
    const std::vector<StepValue> a = file.arguments(item, 2);
    const std::vector<StepValue> map = file.arguments_of(a[0], "IFCREPRESENTATIONMAP", 2);
    const glm::dmat4 origin = ifc_axis_placement(file, map[0]);
    return {ifc_operator(file, a[1]) * glm::inverse(origin), file.follow(a[0], "map")};
  } catch (const IfcLeftOut&) {
    return {};
  }
}

IfcExtent ifc_extent(IfcFile& file, const StepValue& representation, const IfcTypeFrame& type) {
  SolidReader reader(file);
  if (type.map) {
    reader.read_type(*type.map);
  } else {
    reader.read(representation, glm::dmat4(1.0));
  }
  IfcExtent extent;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  extent.low = glm::dvec3(kFar);
  extent.high = glm::dvec3(-kFar);
  const auto add = [&](const glm::dvec3& p) {
    extent.low = glm::min(extent.low, p);
    extent.high = glm::max(extent.high, p);
  };
  for (const Solid& solid : reader.solid) {
    for (const glm::dvec2& p : solid.prism.outer) {
      add(glm::dvec3(p, solid.low));
      add(glm::dvec3(p, solid.high));
    }
    for (const Face& face : solid.face) {
      for (const glm::dvec3& p : face.outer) add(p);
    }
  }
  if (!(extent.low.x <= extent.high.x)) throw IfcLeftOut{"its body is empty"};
  extent.doubt = std::move(reader.doubt);
  return extent;
}

}  // namespace cli
