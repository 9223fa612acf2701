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

// One luminaire, its frame in the world.
class LightWriter {
 public:
  LightWriter(const calc::PreparedScene& scene, const calc::PlacedLuminaire& luminaire,
              std::size_t number_of_light, std::size_t data, bool is_axial)
      : at_(luminaire.position_m + scene.origin_m),
        x_(luminaire.world_from_luminaire[0]),
        y_(luminaire.world_from_luminaire[1]),
        z_(luminaire.world_from_luminaire[2]),
        id_(fmt::format("light_{}", number_of_light)),
        data_(data),
        is_axial_(is_axial),
        factor_(luminaire.flux_scale * scene.channels[luminaire.channel].maintenance_factor /
                kLumensPerWatt) {}

  std::string point() { return sphere(kPointRadius_m); }

  std::string sphere(double radius_m) {
    modifier("lg_even", factor_ / (calc::kPi * radius_m * radius_m), glm::dvec3(0.0));
    text_ += fmt::format("{0}_shine sphere {0}\n0\n0\n4", id_) +
             fmt::format(" {} {} {} {}\n\n", number(at_.x), number(at_.y), number(at_.z),
                         number(radius_m));
    return text_;
  }

  // corners: along (x, y) of the luminaire, counter-clockwise as seen from above.
  std::string flat(const std::vector<glm::dvec2>& corners, double area_m2, bool below, bool above) {
    modifier("lg_flat", factor_ / area_m2, glm::dvec3(0.0));
    if (below) {
      std::vector<glm::dvec3> face;
      for (auto it = corners.rbegin(); it != corners.rend(); ++it) {
        face.push_back(at_ + it->x * x_ + it->y * y_ - kPanelGap_m * z_);
      }
      polygon("below", face);
    }
    if (above) {
      std::vector<glm::dvec3> face;
      for (const glm::dvec2& c : corners)
        face.push_back(at_ + c.x * x_ + c.y * y_ + kPanelGap_m * z_);
      polygon("above", face);
    }
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

 private:
  void modifier(const char* function, double factor, const glm::dvec3& areas) {
    text_ = fmt::format("void brightdata {}_web\n", id_);
    text_ += is_axial_
                 ? fmt::format("4 {} light-{}.dat luxgate.cal lg_gamma\n", function, data_)
                 : fmt::format("5 {} light-{}.dat luxgate.cal lg_c lg_gamma\n", function, data_);
    text_ += "0\n13 " + number(factor) + "\n" + vertex(x_) + vertex(y_) + vertex(z_) +
             vertex(areas) + "\n";
    text_ += fmt::format("{0}_web light {0}_shine\n0\n0\n3 1 1 1\n\n", id_);
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

std::vector<glm::dvec2> rectangle(double along_x, double along_y) {
  const double x = 0.5 * along_x, y = 0.5 * along_y;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

// A polygon of 32 corners with the ellipse's area.
std::vector<glm::dvec2> ellipse(double along_x, double along_y) {
  constexpr int kCorners = 32;
  const double step = 2.0 * calc::kPi / kCorners;
  const double grow = std::sqrt(step / calc::sin(step));
  std::vector<glm::dvec2> corners;
  for (int k = 0; k < kCorners; ++k) {
    corners.emplace_back(0.5 * grow * along_x * calc::cos((k + 0.5) * step),
                         0.5 * grow * along_y * calc::sin((k + 0.5) * step));
  }
  return corners;
}

constexpr double kThinnest_m = 0.002;  // lines and points of flat openings get some area

std::string one_light(LightWriter& writer, const calc::PlacedLuminaire& luminaire,
                      std::vector<std::string>& changed) {
  const calc::LuminousOpening& o = luminaire.opening;
  const calc::PhotometricWeb& web = *luminaire.web;
  const double x = std::max(o.along_c0_m, kThinnest_m), y = std::max(o.along_c90_m, kThinnest_m);
  switch (o.shape) {
    case calc::OpeningShape::point:
      return writer.point();
    case calc::OpeningShape::rectangle:
      return writer.flat(rectangle(x, y), x * y, has_light_below(web), has_light_above(web));
    case calc::OpeningShape::disk:
      return writer.flat(ellipse(x, y), 0.25 * calc::kPi * x * y, has_light_below(web),
                         has_light_above(web));
    case calc::OpeningShape::ellipsoid:
      if (o.along_c0_m == o.along_c90_m && o.along_c0_m == o.height_m) {
        return writer.sphere(0.5 * o.along_c0_m);
      }
      [[fallthrough]];
    case calc::OpeningShape::cylinder:
    case calc::OpeningShape::cylinder_c0:
    case calc::OpeningShape::cylinder_c90:
      changed.emplace_back(
          "a luminous body that is no box and no sphere is written as the box around it: near by, "
          "its light differs");
      [[fallthrough]];
    case calc::OpeningShape::box:
      break;
  }
  return writer.box({x, y, std::max(o.height_m, kThinnest_m)});
}

}  // namespace

const char* const kFunctions =
    R"cal({ Luminaires of luxgate. D is the direction of a ray towards the source, light goes along -D.
  arg(1): W/(sr m2) per cd; arg(2) to arg(4): C 0; to arg(7): C 90; to arg(10): gamma 180, in the
  world; arg(11) to arg(13): faces of a box across those three, m2. }
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
lg_box(v) = arg(1) * v / (arg(11)*lg_abs(lg_x) + arg(12)*lg_abs(lg_y) + arg(13)*lg_abs(lg_z));
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

LightFiles write_lights(const calc::PreparedScene& scene) {
  LightFiles files;
  std::vector<const calc::PhotometricWeb*> webs;
  std::vector<bool> is_axial;
  files.scene =
      "# Luminaires at full output with their maintenance factors, written by luxgate export.\n\n";
  for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
    const calc::PlacedLuminaire& luminaire = scene.luminaires[k];
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
    LightWriter writer(scene, luminaire, k + 1, web + 1, is_axial[web]);
    files.scene += one_light(writer, luminaire, files.changed);
  }
  std::sort(files.changed.begin(), files.changed.end());
  files.changed.erase(std::unique(files.changed.begin(), files.changed.end()), files.changed.end());
  return files;
}

}  // namespace cli::radiance
