#include "report/tools/export/radiance_lights.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/photometry/web_resample.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace cli::radiance {

std::string number(double value) { return report::format_shortest(value + 0.0); }

namespace {

constexpr double kPanelGap_m = 1e-4;  // faces of a flat opening stand off a ceiling they may lie in
// From the table's last angle to darkness. Radiance reads angles as float, whose step is 1.5e-5 at
// 180, and refuses two that are the same.
constexpr double kEdge_deg = 1e-4;

std::string vertex(const glm::dvec3& p) {
  return fmt::format(" {} {} {}\n", number(p.x), number(p.y), number(p.z));
}

// The gamma angles of a table in degrees, darkness added beyond both ends; and where each of them
// is in the table (-1: dark).
struct GammaAngles {
  std::vector<double> degrees;
  std::vector<int> index;

  explicit GammaAngles(const calc::PhotometricWeb& web) {
    const std::vector<double>& rad = web.gamma_rad();
    for (std::size_t k = 0; k < rad.size(); ++k) {
      degrees.push_back(rad[k] / calc::kRadiansPerDegree);
      index.push_back(static_cast<int>(k));
    }
    const auto dark = [&](double at, bool is_front) {
      degrees.insert(is_front ? degrees.begin() : degrees.end(), at);
      index.insert(is_front ? index.begin() : index.end(), -1);
    };
    if (degrees.front() > 2.0 * kEdge_deg) {
      dark(degrees.front() - kEdge_deg, true);
      dark(0.0, true);
    }
    if (degrees.back() < 180.0 - 2.0 * kEdge_deg) {
      dark(degrees.back() + kEdge_deg, false);
      dark(180.0, false);
    }
  }
};

// As Radiance reads them.
bool are_increasing(const std::vector<double>& degrees) {
  for (std::size_t k = 1; k < degrees.size(); ++k) {
    if (!(static_cast<float>(degrees[k - 1]) < static_cast<float>(degrees[k]))) return false;
  }
  return true;
}

bool has_light_above(const calc::PhotometricWeb& web) {
  return web.zonal_flux_lm(0.5 * calc::kPi, calc::kPi) > 1e-9 * web.flux_lm();
}

bool has_light_below(const calc::PhotometricWeb& web) {
  return web.zonal_flux_lm(0.0, 0.5 * calc::kPi) > 1e-9 * web.flux_lm();
}

struct Rectangle {
  glm::dvec2 centre_m{0.0}, half_m{0.0};
};

// An ellipse as strips along its first axis: Radiance samples rectangles evenly, but of other
// polygons a square about the middle, and what of it falls beside them is lost. is_within: all
// corners lie in the ellipse; else each strip has the area of its part.
std::vector<Rectangle> strips(double half_x, double half_y, bool is_within) {
  constexpr int kStrips = 8;
  const auto area_to = [](double y) {  // of the unit circle, from the middle, to one side
    return 0.5 * (y * std::sqrt(1.0 - y * y) + calc::asin(y));
  };
  std::vector<Rectangle> all;
  for (int k = 0; k < kStrips; ++k) {
    const double low = 2.0 * k / kStrips - 1.0, high = 2.0 * (k + 1) / kStrips - 1.0;
    double half = (area_to(high) - area_to(low)) / (high - low);
    double y = 0.5 * (low + high), half_height = 0.5 * (high - low);
    if (is_within) {
      // The two at the rim end before it.
      constexpr double kRim = 0.95;
      const double bottom = std::max(low, -kRim), top = std::min(high, kRim);
      const double outer = std::max(std::abs(bottom), std::abs(top));
      half = std::sqrt(1.0 - outer * outer);
      y = 0.5 * (bottom + top);
      half_height = 0.5 * (top - bottom);
    }
    all.push_back({{0.0, half_y * y}, {half_x * half, half_y * half_height}});
  }
  return all;
}

// One luminaire, its frame in the world.
class LightWriter {
 public:
  LightWriter(const calc::PreparedScene& scene, const calc::PlacedLuminaire& luminaire,
              std::size_t number_of_light, std::size_t data, bool is_axial, double level)
      : at_(luminaire.position_m + scene.origin_m),
        x_(luminaire.world_from_luminaire[0]),
        y_(luminaire.world_from_luminaire[1]),
        z_(luminaire.world_from_luminaire[2]),
        id_(fmt::format("light_{}", number_of_light)),
        data_(data),
        is_axial_(is_axial),
        factor_(level * luminaire.flux_scale *
                scene.channels[luminaire.channel].maintenance_factor / kLumensPerWatt) {}

  std::string point() { return sphere(kPointRadius_m); }

  std::string sphere(double radius_m) {
    modifier("lg_even", factor_ / (calc::kPi * radius_m * radius_m));
    text_ += fmt::format("{0}_shine sphere {0}\n0\n0\n4", id_) +
             fmt::format(" {} {} {} {}\n\n", number(at_.x), number(at_.y), number(at_.z),
                         number(radius_m));
    return text_;
  }

  // A flat opening of several rectangles, that shines down, up or both ways.
  std::string flat(const std::vector<Rectangle>& rectangles, bool below, bool above) {
    double area_m2 = 0.0;
    for (const Rectangle& r : rectangles) area_m2 += 4.0 * r.half_m.x * r.half_m.y;
    modifier("lg_flat", factor_ / area_m2);
    for (std::size_t k = 0; k < rectangles.size(); ++k) {
      const std::string part = rectangles.size() == 1 ? "" : fmt::format("_{}", k + 1);
      if (below) rectangle("below" + part, rectangles[k], at_ - kPanelGap_m * z_, x_, y_, true);
      if (above) rectangle("above" + part, rectangles[k], at_ + kPanelGap_m * z_, x_, y_, false);
    }
    return text_;
  }

  std::string disk(double radius_m, bool below, bool above) {
    modifier("lg_flat", factor_ / (calc::kPi * radius_m * radius_m));
    if (below) ring("below", at_ - kPanelGap_m * z_, -z_, radius_m);
    if (above) ring("above", at_ + kPanelGap_m * z_, z_, radius_m);
    return text_;
  }

  std::string box(const glm::dvec3& size) {
    modifier("lg_box", factor_, {size.y * size.z, size.x * size.z, size.x * size.y});
    const glm::dvec3 axis[3] = {x_, y_, z_};
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 centre = at_ + 0.5 * side * size[k] * axis[k];
        const glm::dvec3 u = 0.5 * size[a] * axis[a], v = 0.5 * side * size[b] * axis[b];
        if (size[a] > 0.0 && size[b] > 0.0) {
          polygon(fmt::format("{}{}", side < 0.0 ? "low" : "high", k),
                  {centre - u - v, centre + u - v, centre + u + v, centre - u + v});
        }
      }
    }
    return text_;
  }

  // A cylinder about the axis `along` (0 to 2: x, y, z), as a prism of kPrismFaces faces whose
  // outline is as wide as the cylinder's on average over the directions, with ends that stay
  // within it. lg_prism divides by the outline of what is written, so that the intensity is right
  // in every direction.
  std::string prism(const glm::dvec3& size, int along) {
    const int a = (along + 1) % 3, b = (along + 2) % 3;
    const glm::dvec3 axis[3] = {x_, y_, z_};
    const glm::dvec3 half = 0.5 * size;
    const double step = 2.0 * calc::kPi / kPrismFaces;
    // Of a unit circle's prism. Cauchy: the mean width of a convex outline is perimeter / pi.
    const double corner = calc::kPi / (kPrismFaces * calc::sin(0.5 * step));
    const double within = corner * calc::cos(0.5 * step);
    const bool is_round = half[a] == half[b];
    std::vector<Rectangle> end;
    if (!is_round) end = strips(within * half[a], within * half[b], true);
    double end_m2 = calc::kPi * within * within * half[a] * half[b];
    if (!is_round) {
      end_m2 = 0.0;
      for (const Rectangle& r : end) end_m2 += 4.0 * r.half_m.x * r.half_m.y;
    }
    glm::dvec3 ends_m2(0.0);
    ends_m2[along] = end_m2;
    modifier(along == 0   ? "lg_prism_x"
             : along == 1 ? "lg_prism_y"
                          : "lg_prism_z",
             factor_, ends_m2,
             {4.0 * corner * half[along] * half[b], 4.0 * corner * half[along] * half[a]});
    const auto edge = [&](int k) {
      const double angle = (k + 0.5) * step;
      return at_ +
             corner * (half[a] * calc::cos(angle) * axis[a] + half[b] * calc::sin(angle) * axis[b]);
    };
    const glm::dvec3 up = half[along] * axis[along];
    for (int k = 0; k < kPrismFaces; ++k) {
      const glm::dvec3 from = edge(k), to = edge((k + 1) % kPrismFaces);
      polygon(fmt::format("side{}", k + 1), {from - up, to - up, to + up, from + up});
    }
    if (is_round) {
      ring("low", at_ - up, -axis[along], within * half[a]);
      ring("high", at_ + up, axis[along], within * half[a]);
    }
    for (std::size_t k = 0; k < end.size(); ++k) {
      rectangle(fmt::format("low_{}", k + 1), end[k], at_ - up, axis[a], axis[b], true);
      rectangle(fmt::format("high_{}", k + 1), end[k], at_ + up, axis[a], axis[b], false);
    }
    return text_;
  }

 private:
  // areas_m2: see kFunctions.
  void modifier(const char* function, double factor, const glm::dvec3& faces_m2 = glm::dvec3(0.0),
                const std::vector<double>& side_m2 = {}) {
    text_ = fmt::format("void brightdata {}_web\n", id_);
    text_ += is_axial_
                 ? fmt::format("4 {} light-{}.dat luxgate.cal lg_gamma\n", function, data_)
                 : fmt::format("5 {} light-{}.dat luxgate.cal lg_c lg_gamma\n", function, data_);
    text_ += fmt::format("0\n{} {}\n", 13 + side_m2.size(), number(factor)) + vertex(x_) +
             vertex(y_) + vertex(z_) + vertex(faces_m2);
    for (const double m2 : side_m2) text_ += " " + number(m2);
    text_ += "\n";
    text_ += fmt::format("{0}_web light {0}_shine\n0\n0\n3 1 1 1\n\n", id_);
  }

  // In a plane across the luminaire's axis u x v; shines along it, or the other way.
  void rectangle(const std::string& part, const Rectangle& r, const glm::dvec3& at,
                 const glm::dvec3& u, const glm::dvec3& v, bool is_turned) {
    const glm::dvec3 centre = at + r.centre_m.x * u + r.centre_m.y * v;
    const glm::dvec3 du = r.half_m.x * u, dv = (is_turned ? -1.0 : 1.0) * r.half_m.y * v;
    polygon(part, {centre - du - dv, centre + du - dv, centre + du + dv, centre - du + dv});
  }

  void ring(const std::string& part, const glm::dvec3& at, const glm::dvec3& towards,
            double radius_m) {
    text_ += fmt::format("{0}_shine ring {0}_{1}\n0\n0\n8\n", id_, part) + vertex(at) +
             vertex(towards) + " 0 " + number(radius_m) + "\n\n";
  }

  void polygon(const std::string& part, const std::vector<glm::dvec3>& corners) {
    text_ += fmt::format("{0}_shine polygon {0}_{1}\n0\n0\n{2}\n", id_, part, 3 * corners.size());
    for (const glm::dvec3& corner : corners) text_ += vertex(corner);
    text_ += "\n";
  }

  glm::dvec3 at_, x_, y_, z_;
  std::string id_, text_;
  std::size_t data_;
  bool is_axial_;
  double factor_;
};

constexpr double kThinnest_m = 0.002;  // lines and points of flat openings get some area

double level_of(const std::string& group,
                const std::vector<std::pair<std::string, double>>& levels) {
  for (const auto& [name, level] : levels) {
    if (name == group) return level;
  }
  return 1.0;
}

std::string one_light(LightWriter& writer, const calc::PlacedLuminaire& luminaire,
                      std::vector<std::string>& changed) {
  const calc::LuminousOpening& o = luminaire.opening;
  const calc::PhotometricWeb& web = *luminaire.web;
  const double x = std::max(o.along_c0_m, kThinnest_m), y = std::max(o.along_c90_m, kThinnest_m);
  const bool below = has_light_below(web), above = has_light_above(web);
  const glm::dvec3 body(x, y, std::max(o.height_m, kThinnest_m));
  switch (o.shape) {
    case calc::OpeningShape::point:
      return writer.point();
    case calc::OpeningShape::rectangle:
      return writer.flat({{glm::dvec2(0.0), {0.5 * x, 0.5 * y}}}, below, above);
    case calc::OpeningShape::disk:
      if (x == y) return writer.disk(0.5 * x, below, above);
      changed.emplace_back(
          "a flat elliptical opening is written as eight rectangles with the same total area");
      return writer.flat(strips(0.5 * x, 0.5 * y, false), below, above);
    case calc::OpeningShape::cylinder:
    case calc::OpeningShape::cylinder_c0:
    case calc::OpeningShape::cylinder_c90: {
      const int along = o.shape == calc::OpeningShape::cylinder_c0    ? 0
                        : o.shape == calc::OpeningShape::cylinder_c90 ? 1
                                                                      : 2;
      const bool is_round = body[(along + 1) % 3] == body[(along + 2) % 3];
      changed.push_back(fmt::format(
          "a luminous cylinder is written as a prism of {} faces{}: its intensities are the same, "
          "its shape differs by up to 2 % of its radius{}",
          kPrismFaces, is_round ? " with round ends" : " with rectangles for its elliptical ends",
          is_round ? "" : ", that of its ends by more"));
      return writer.prism(body, along);
    }
    case calc::OpeningShape::ellipsoid:
      if (o.along_c0_m == o.along_c90_m && o.along_c0_m == o.height_m) {
        return writer.sphere(0.5 * o.along_c0_m);
      }
      changed.emplace_back(
          "a luminous ellipsoid that is not a sphere is written as the box around it: its "
          "intensities are the same, but its light differs nearby");
      [[fallthrough]];
    case calc::OpeningShape::box:
      break;
  }
  return writer.box(body);
}

}  // namespace

const char* const kFunctions =
    R"cal({ Luminaires of luxgate. D is the direction of a ray towards the source, light goes along -D.
  arg(1): W/(sr m2) per cd; arg(2) to arg(4): C 0; to arg(7): C 90; to arg(10): gamma 180, in the
  world; of bodies arg(11) to arg(13): their flat faces across those three, m2; of prisms of 16
  faces arg(14), arg(15): what the side shows along the two directions across the axis, m2. }
lg_x = -(arg(2)*Dx + arg(3)*Dy + arg(4)*Dz);
lg_y = -(arg(5)*Dx + arg(6)*Dy + arg(7)*Dz);
lg_z = -(arg(8)*Dx + arg(9)*Dy + arg(10)*Dz);
lg_unit(v) : if(v - 1, 1, if(-1 - v, -1, v));
lg_abs(v) : if(v, v, -v);
lg_turn(a) : if(-a, a + 360, a);
lg_gamma = acos(lg_unit(-lg_z)) * 180 / PI;
lg_c = lg_turn(atan2(lg_y, lg_x) * 180 / PI);
lg_even(v) = arg(1) * v;
lg_flat(v) = arg(1) * v / if(lg_abs(lg_z) - 1e-5, lg_abs(lg_z), 1e-5);
lg_faces = arg(11)*lg_abs(lg_x) + arg(12)*lg_abs(lg_y) + arg(13)*lg_abs(lg_z);
lg_box(v) = arg(1) * v / lg_faces;
{ The width of a prism of 16 faces by the direction across its axis. }
lg_part(t) = t - floor(t);
lg_width(a) = cos((lg_part(16*a/(2*PI)) - .5) * 2*PI/16);
lg_side(p, q) = sqrt(p*p + q*q) * lg_width(atan2(q, p));
lg_prism_x(v) = arg(1) * v / (lg_faces + lg_side(arg(14)*lg_y, arg(15)*lg_z));
lg_prism_y(v) = arg(1) * v / (lg_faces + lg_side(arg(14)*lg_z, arg(15)*lg_x));
lg_prism_z(v) = arg(1) * v / (lg_faces + lg_side(arg(14)*lg_x, arg(15)*lg_y));
)cal";

bool web_data(const calc::PhotometricWeb& given, std::string& text, bool& is_axial) {
  std::optional<calc::ResampledWeb> resampled;
  if (given.axis() != calc::TableAxis::vertical) {
    resampled = calc::resampled_over_c_gamma(given);
    if (!resampled) return false;
  }
  const calc::PhotometricWeb& web = resampled ? resampled->web : given;
  const GammaAngles gamma(web);
  is_axial = web.is_axial();
  std::vector<double> c_degrees;
  for (const double rad : web.c_rad()) c_degrees.push_back(rad / calc::kRadiansPerDegree);
  if (!are_increasing(gamma.degrees) || (!is_axial && !are_increasing(c_degrees))) return false;
  const auto axis = [](const std::vector<double>& degrees) {
    std::string line = fmt::format("0 0 {}\n", degrees.size());
    for (const double d : degrees) line += " " + number(d);
    return line + "\n";
  };
  text = is_axial ? "1\n" : "2\n";
  if (!is_axial) text += axis(c_degrees);
  text += axis(gamma.degrees);
  for (std::size_t c = 0; c < web.c_rad().size(); ++c) {
    for (std::size_t k = 0; k < gamma.index.size(); ++k) {
      double cd = 0.0;
      if (gamma.index[k] >= 0) {
        const bool is_pole = gamma.degrees[k] < 1e-9 || gamma.degrees[k] > 180.0 - 1e-9;
        const auto entry = static_cast<std::size_t>(gamma.index[k]);
        // At a pole all planes have one value, as luxgate takes it.
        cd = is_pole ? web.intensity_cd(0.0, web.gamma_rad()[entry]) : web.table_cd(c, entry);
      }
      text += " " + number(cd);
    }
    text += "\n";
  }
  return true;
}

LightFiles write_lights(const calc::PreparedScene& scene,
                        const std::vector<std::pair<std::string, double>>& levels) {
  LightFiles files;
  std::vector<const calc::PhotometricWeb*> webs;
  std::vector<bool> is_axial;
  files.scene =
      "# Luminaires with their levels and maintenance factors, written by luxgate export.\n\n";
  for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
    const calc::PlacedLuminaire& luminaire = scene.luminaires[k];
    const double level = level_of(scene.channels[luminaire.channel].group, levels);
    if (level == 0.0) {
      files.scene += fmt::format("# light_{}: its group is at level 0.\n\n", k + 1);
      continue;
    }
    auto found = std::find(webs.begin(), webs.end(), luminaire.web);
    if (found == webs.end()) {
      std::string text;
      bool axial = false;
      if (!web_data(*luminaire.web, text, axial)) {
        files.changed.emplace_back(
            "a luminaire whose photometry cannot be tabulated over C and gamma (a narrow beam "
            "about "
            "another axis, or angles that Radiance cannot tell apart) is missing");
        continue;
      }
      if (luminaire.web->axis() != calc::TableAxis::vertical) {
        files.changed.emplace_back("photometry about another axis was tabulated over C and gamma");
      }
      webs.push_back(luminaire.web);
      is_axial.push_back(axial);
      files.data.push_back({fmt::format("light-{}.dat", webs.size()), std::move(text)});
      found = std::prev(webs.end());
    }
    const auto web = static_cast<std::size_t>(found - webs.begin());
    LightWriter writer(scene, luminaire, k + 1, web + 1, is_axial[web], level);
    files.scene += one_light(writer, luminaire, files.changed);
  }
  std::sort(files.changed.begin(), files.changed.end());
  files.changed.erase(std::unique(files.changed.begin(), files.changed.end()), files.changed.end());
  return files;
}

}  // namespace cli::radiance
