#include "tests/fuzz/checks.h"

#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/photometry/web_hermite.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fuzz {
namespace {

std::size_t result_count = 0;

bool is_at_least_0(double value) { return std::isfinite(value) && value >= 0.0; }

void check_source(const calc::PhotometrySource& source) {
  for (const std::string* text : {&source.format, &source.luminaire_name, &source.manufacturer,
                                  &source.applied_factors, &source.axis_rule}) {
    require(!calc::first_invalid_utf8(*text), "text of a web's source is UTF-8");
  }
  require(is_at_least_0(source.rated_lamp_flux_lm), "rated lamp flux >= 0");
  require(is_at_least_0(source.input_power_w), "input power >= 0");
  if (!source.lamp_tilt) return;
  const calc::LampTilt& tilt = *source.lamp_tilt;
  require(tilt.geometry >= 1 && tilt.geometry <= 3, "lamp geometry is known");
  require(!tilt.angle_rad.empty() && tilt.angle_rad.size() == tilt.factor.size(),
          "tilt angles and factors are as many");
  require(std::is_sorted(tilt.angle_rad.begin(), tilt.angle_rad.end()), "tilt angles ascend");
  for (const double angle : {-4.0, 0.0, 0.7, 4.0}) {
    const double factor = calc::tilt_factor(tilt, angle);
    require(std::isfinite(factor) && factor > 0.0, "tilt factor > 0");
  }
}

void check_light(const calc::PhotometricWeb& web) {
  const double most = web.max_intensity_cd();
  require(std::isfinite(web.flux_lm()) && web.flux_lm() > 0.0, "flux > 0");
  require(std::isfinite(most) && most > 0.0, "maximum intensity > 0");
  for (int c = -2; c <= 13; ++c) {
    for (int gamma = 0; gamma <= 6; ++gamma) {
      const double cd = web.intensity_cd(c * 0.51, gamma * calc::kPi / 6.0);
      require(is_at_least_0(cd) && cd <= most * (1.0 + 1e-9), "intensity from 0 to the maximum");
    }
  }
  for (const std::array<double, 3>& direction :
       {std::array{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, -0.6, 0.8}}) {
    require(is_at_least_0(web.intensity_cd(direction)), "intensity of a direction >= 0");
  }
}

}  // namespace

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

void check_triangles(const std::vector<glm::dvec3>& vertex,
                     const std::vector<glm::uvec3>& triangle) {
  for (const glm::dvec3& p : vertex) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "vertices are finite");
  }
  for (const glm::uvec3& t : triangle) {
    require(std::max({t.x, t.y, t.z}) < vertex.size(), "indices are in range");
  }
}

void check_web(const calc::PhotometricWeb& web) {
  check_source(web.source());
  check_light(web);
  const glm::dvec3 size = web.opening().size_m();
  require(is_at_least_0(size.x) && is_at_least_0(size.y) && is_at_least_0(size.z),
          "opening's size >= 0");
  if (web.axis() == calc::TableAxis::vertical) {  // about other axes it takes long
    const double below = web.zonal_flux_lm(0.0, calc::kPi / 2.0);
    const double above = web.zonal_flux_lm(calc::kPi / 2.0, calc::kPi);
    require(is_at_least_0(below) && is_at_least_0(above), "zonal flux >= 0");
    require(std::abs(below + above - web.flux_lm()) <= 1e-6 * web.flux_lm(), "zones add up");
  }
  constexpr std::size_t kSmallTable = 500;  // entries; refined to 32 times as many
  if (web.c_rad().size() * web.gamma_rad().size() <= kSmallTable) {
    check_light(calc::hermite_refined(web));
  }
}

void check_mesh(const calc::TriangleMesh& mesh) {
  check_triangles(mesh.vertex, mesh.triangle);
  require(!mesh.triangle.empty(), "a mesh has triangles");
  require(mesh.material_of.size() == mesh.triangle.size(), "a material for each triangle");
  require(mesh.object_of.size() == mesh.triangle.size(), "an object for each triangle");
  for (const glm::dvec3& p : mesh.vertex) {
    require(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= calc::kMaxMeshCoordinate,
            "coordinates are in range");
  }
  for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
    require(mesh.material_of[i] < mesh.material_name.size(), "material indices are in range");
    require(mesh.object_of[i] < mesh.object_name.size(), "object indices are in range");
  }
  require(mesh.faces_left_out < mesh.faces, "a face is left");
}

std::size_t results() { return result_count; }
void count_result() { ++result_count; }

void check_messages(bool has_result, const calc::Diagnostics& diagnostics) {
  if (has_result) ++result_count;
  require(has_result != diagnostics.has_errors(), "no result if and only if there is an error");
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    const bool is_clean =
        std::none_of(diagnostic.message.begin(), diagnostic.message.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7F'; });
    require(is_clean, "a message is one line");
  }
}

void require_no_error(const calc::Diagnostics& diagnostics, std::string_view what) {
  if (!diagnostics.has_errors()) return;
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    std::fprintf(stderr, "%s\n", calc::format_diagnostic(diagnostic).c_str());
  }
  require(false, what);
}

TwoFiles split_files(std::string_view input) {
  const std::size_t at = input.find(kSecondFile);
  if (at == std::string_view::npos) return {input, ""};
  return {input.substr(0, at), std::string(input.substr(at + kSecondFile.size()))};
}

}  // namespace fuzz
