#include "report/tools/import/ifc_profile.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/tools/import/ifc_placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

constexpr int kDeepestCurve = 16;  // curves of curves
constexpr double kFullTurn = 2.0 * calc::kPi;

using Points = std::vector<glm::dvec2>;

double distance(const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 d = a - b;
  return std::sqrt(glm::dot(d, d));
}

glm::dvec2 placed(const glm::dmat4& frame, const glm::dvec2& point) {
  return glm::dvec2(frame * glm::dvec4(point, 0.0, 1.0));
}

class CurveReader {
 public:
  CurveReader(IfcFile& file, std::vector<std::string>& doubt) : file_(file), doubt_(doubt) {}

  IfcProfile profile(const StepValue& reference) {
    const std::uint32_t instance = file_.follow(reference, "profile");
    const std::string& name = file_.text().name(instance);
    if (name == "IFCRECTANGLEPROFILEDEF") return rectangle(instance);
    if (name == "IFCCIRCLEPROFILEDEF") {
      const std::vector<StepValue> a = file_.arguments(instance, 4);
      const double r = file_.positive_length_m(a[3], "radius");
      IfcProfile result;
      result.outer = arc(ifc_axis_placement(file_, a[2]), r, r, 0.0, kFullTurn);
      drop_same_points(result.outer);
      return result;
    }
    const bool has_holes = name == "IFCARBITRARYPROFILEDEFWITHVOIDS";
    if (name != "IFCARBITRARYCLOSEDPROFILEDEF" && !has_holes) {
      throw IfcLeftOut{fmt::format("a profile by {} is not read", name)};
    }
    const std::vector<StepValue> a = file_.arguments(instance, has_holes ? 4 : 3);
    IfcProfile result;
    result.outer = closed(a[2]);
    if (has_holes) {
      for (const StepValue& hole : a[3].items()) result.inner.push_back(closed(hole));
    }
    return result;
  }

 private:
  IfcProfile rectangle(std::uint32_t instance) {
    const std::vector<StepValue> a = file_.arguments(instance, 5);
    const glm::dmat4 frame = ifc_axis_placement(file_, a[2]);
    const double x = 0.5 * file_.positive_length_m(a[3], "width");
    const double y = 0.5 * file_.positive_length_m(a[4], "width");
    IfcProfile result;
    for (const glm::dvec2& corner :
         {glm::dvec2(-x, -y), glm::dvec2(x, -y), glm::dvec2(x, y), glm::dvec2(-x, y)}) {
      result.outer.push_back(placed(frame, corner));
    }
    return result;
  }

  Points closed(const StepValue& reference) {
    Points points = curve(reference, 0);
    if (points.size() < 2) throw IfcLeftOut{"an outline of less than two points"};
    if (distance(points.front(), points.back()) <= kOutlineGap_m) {
      points.pop_back();
    } else {
      doubt_.push_back("its outline is open in the file; a straight line closes it");
    }
    drop_same_points(points);
    return points;
  }

  // Both ends included: those of a closed one are equal.
  Points curve(const StepValue& reference, int depth) {
    if (depth > kDeepestCurve) throw IfcLeftOut{"its curves are nested too deep"};
    const std::uint32_t instance = file_.follow(reference, "curve");
    const std::string& name = file_.text().name(instance);
    if (name == "IFCPOLYLINE") return polyline(instance);
    if (name == "IFCINDEXEDPOLYCURVE") return indexed(instance);
    if (name == "IFCCOMPOSITECURVE" || name == "IFC2DCOMPOSITECURVE") {
      return composite(instance, depth);
    }
    if (name == "IFCTRIMMEDCURVE") return trimmed(instance);
    if (name == "IFCCIRCLE" || name == "IFCELLIPSE") {
      const Conic conic = conic_of(instance);
      return arc(conic.frame, conic.a, conic.b, 0.0, kFullTurn);
    }
    throw IfcLeftOut{fmt::format("a curve by {} is not read", name)};
  }

  Points polyline(std::uint32_t instance) {
    Points points;
    for (const StepValue& point : file_.arguments(instance, 1)[0].items()) {
      add(points, glm::dvec2(file_.point_m(point)));
    }
    return points;
  }

  void add(Points& points, const glm::dvec2& point) const {
    if (points.size() > kMostCorners) {
      throw IfcLeftOut{fmt::format("an outline of more than {} corners", kMostCorners)};
    }
    points.push_back(point);
  }

  // The first point of `more` is the last one so far.
  void go_on(Points& points, const Points& more) const {
    if (more.empty()) throw IfcLeftOut{"a piece of a curve without points"};
    if (points.empty()) {
      add(points, more.front());
    } else if (distance(points.back(), more.front()) > kOutlineGap_m) {
      throw IfcLeftOut{"the pieces of its outline do not meet"};
    }
    for (std::size_t i = 1; i < more.size(); ++i) add(points, more[i]);
  }

  Points composite(std::uint32_t instance, int depth) {
    Points points;
    for (const StepValue& segment : file_.arguments(instance, 1)[0].items()) {
      const std::vector<StepValue> a = file_.arguments_of(segment, "IFCCOMPOSITECURVESEGMENT", 3);
      Points piece = curve(a[2], depth + 1);
      if (a[1].enumeration() == "F") std::reverse(piece.begin(), piece.end());
      go_on(points, piece);
    }
    return points;
  }

  Points indexed(std::uint32_t instance) {
    const std::vector<StepValue> a = file_.arguments(instance, 2);
    Points all;
    for (const StepValue& point :
         file_.arguments_of(a[0], "IFCCARTESIANPOINTLIST2D", 1)[0].items()) {
      all.push_back(glm::dvec2(file_.coordinates_m(point)));
    }
    if (a[1].is_null()) {
      if (all.size() > kMostCorners) add(all, {});  // says that it is too many
      return all;
    }
    const auto at = [&](const StepValue& index) {
      const double i = file_.number(index, "index");
      if (!(i >= 1.0 && i <= static_cast<double>(all.size()))) {
        throw IfcLeftOut{"an index of its outline beyond the list of points"};
      }
      return all[static_cast<std::size_t>(i) - 1];
    };
    Points points;
    for (const StepValue& segment : a[1].items()) {
      const std::string kind = segment.type_name();
      const std::vector<StepValue> lists = segment.items();
      const std::vector<StepValue> index =
          lists.size() == 1 ? lists[0].items() : std::vector<StepValue>();
      if (kind == "IFCARCINDEX" && index.size() == 3) {
        go_on(points, arc_through(at(index[0]), at(index[1]), at(index[2])));
      } else if (kind == "IFCLINEINDEX" && index.size() >= 2) {
        Points line;
        for (const StepValue& i : index) add(line, at(i));
        go_on(points, line);
      } else {
        throw IfcLeftOut{"a piece of an IFCINDEXEDPOLYCURVE that cannot be read"};
      }
    }
    return points;
  }

  struct Conic {
    glm::dmat4 frame{1.0};
    double a = 0.0, b = 0.0;  // half axes
  };

  Conic conic_of(std::uint32_t instance) {
    const bool is_circle = file_.text().name(instance) == "IFCCIRCLE";
    const std::vector<StepValue> a = file_.arguments(instance, is_circle ? 2 : 3);
    Conic conic;
    conic.frame = ifc_axis_placement(file_, a[0]);
    conic.a = file_.positive_length_m(a[1], "radius");
    conic.b = is_circle ? conic.a : file_.positive_length_m(a[2], "radius");
    return conic;
  }

  // One of a trim's ways to say where it is.
  struct Trim {
    std::optional<double> parameter;
    std::optional<glm::dvec2> point;
  };

  Trim trim(const StepValue& list, const std::string& master) {
    Trim trim;
    for (const StepValue& way : list.items()) {
      if (way.kind() == StepValue::Kind::reference) {
        trim.point = glm::dvec2(file_.point_m(way));
      } else {
        trim.parameter = file_.number(way, "trim");
      }
    }
    if (!trim.point && !trim.parameter) throw IfcLeftOut{"a trimmed curve without its ends"};
    if (trim.point && trim.parameter) {  // the other one is only said besides
      if (master == "CARTESIAN") {
        trim.parameter.reset();
      } else {
        trim.point.reset();
      }
    }
    return trim;
  }

  Points trimmed(std::uint32_t instance) {
    const std::vector<StepValue> a = file_.arguments(instance, 5);
    const std::string master = a[4].enumeration();
    const Trim from = trim(a[1], master), to = trim(a[2], master);
    const std::uint32_t basis = file_.follow(a[0], "curve");
    const std::string& name = file_.text().name(basis);
    if (name == "IFCLINE") {
      const std::vector<StepValue> line = file_.arguments(basis, 2);
      const glm::dvec2 origin(file_.point_m(line[0]));
      const std::vector<StepValue> vector = file_.arguments_of(line[1], "IFCVECTOR", 2);
      const glm::dvec2 step =
          glm::dvec2(file_.direction(vector[0])) * file_.length_m(vector[1], "length");
      const auto at = [&](const Trim& t) {
        return t.point ? *t.point : origin + *t.parameter * step;
      };
      return checked({at(from), at(to)});
    }
    if (name != "IFCCIRCLE" && name != "IFCELLIPSE") {
      throw IfcLeftOut{fmt::format("a curve by {}, trimmed, is not read", name)};
    }
    const Conic conic = conic_of(basis);
    const auto angle = [&](const Trim& t) {
      if (t.parameter) {
        if (!file_.units().has_angle) {
          doubt_.push_back("the file names no unit of angle; radians are taken for its arcs");
        }
        return *t.parameter * file_.units().radians;
      }
      const glm::dvec2 d = *t.point - glm::dvec2(conic.frame[3]);
      const double x = glm::dot(d, glm::dvec2(conic.frame[0])) / conic.a;
      const double y = glm::dot(d, glm::dvec2(conic.frame[1])) / conic.b;
      return calc::atan2(y, x);
    };
    const bool is_forward = a[3].enumeration() != "F";
    const double begin = angle(from), end = angle(to);
    if (!(std::fabs(begin) <= 1.0e6 && std::fabs(end) <= 1.0e6)) {
      throw IfcLeftOut{"an arc whose angles are not plausible"};
    }
    double sweep = std::fmod(is_forward ? end - begin : begin - end, kFullTurn);
    if (sweep <= 1.0e-12) sweep += kFullTurn;
    return arc(conic.frame, conic.a, conic.b, begin, is_forward ? sweep : -sweep);
  }

  Points checked(Points points) const {
    for (const glm::dvec2& p : points) {
      if (!(std::fabs(p.x) <= kFarthestIfc && std::fabs(p.y) <= kFarthestIfc)) {
        throw IfcLeftOut{"a point too far away for a building"};
      }
    }
    return points;
  }

  // Chords whose corners lie on the arc: the arc is at most kChordError_m away from them.
  Points arc(const glm::dmat4& frame, double a, double b, double begin, double sweep) {
    const double radius = std::max(a, b);
    const double most =
        kChordError_m < radius ? 2.0 * calc::acos(1.0 - kChordError_m / radius) : calc::kPi;
    // At least four chords of a turn, so that a small column stays one.
    const double count = std::ceil(std::fabs(sweep) / std::min(most, 0.5 * calc::kPi));
    if (!(count <= static_cast<double>(kMostCorners))) {
      throw IfcLeftOut{fmt::format("an outline of more than {} corners", kMostCorners)};
    }
    file_.work(static_cast<std::size_t>(count) * 64);
    Points points;
    for (double i = 0.0; i <= count; i += 1.0) {
      const double t = begin + sweep * (i / std::max(count, 1.0));
      points.push_back(placed(frame, {a * calc::cos(t), b * calc::sin(t)}));
    }
    return points;
  }

  Points arc_through(const glm::dvec2& from, const glm::dvec2& by, const glm::dvec2& to) {
    const glm::dvec2 p = by - from, q = to - from;
    const double cross = p.x * q.y - p.y * q.x;
    const double lengths = std::sqrt(glm::dot(p, p) * glm::dot(q, q));
    if (!(std::fabs(cross) > 1.0e-9 * lengths)) return {from, by, to};  // straight
    const double pp = glm::dot(p, p), qq = glm::dot(q, q);
    const glm::dvec2 centre = glm::dvec2(q.y * pp - p.y * qq, p.x * qq - q.x * pp) / (2.0 * cross);
    const double radius = std::sqrt(glm::dot(centre, centre));
    const auto angle = [&](const glm::dvec2& at) {
      return calc::atan2(at.y - centre.y, at.x - centre.x);
    };
    const double begin = angle({0.0, 0.0});
    double sweep = angle(q) - begin;
    if (cross > 0.0 && sweep <= 0.0) sweep += kFullTurn;
    if (cross < 0.0 && sweep >= 0.0) sweep -= kFullTurn;
    glm::dmat4 frame(1.0);
    frame[3] = glm::dvec4(from + centre, 0.0, 1.0);
    Points points = arc(frame, radius, radius, begin, sweep);
    points.front() = from;
    points.back() = to;
    return points;
  }

  IfcFile& file_;
  std::vector<std::string>& doubt_;
};

}  // namespace

void drop_same_points(std::vector<glm::dvec2>& outline) {
  const auto is_same = [](const glm::dvec2& a, const glm::dvec2& b) {
    return distance(a, b) <= kSamePoint_m;
  };
  outline.erase(std::unique(outline.begin(), outline.end(), is_same), outline.end());
  while (outline.size() > 1 && is_same(outline.front(), outline.back())) outline.pop_back();
}

IfcProfile ifc_profile(IfcFile& file, const StepValue& reference, std::vector<std::string>& doubt) {
  return CurveReader(file, doubt).profile(reference);
}

}  // namespace cli
