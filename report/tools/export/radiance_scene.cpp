#include "report/tools/export/radiance_scene.h"

#include "report/document/program_version.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/export/radiance_lights.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli::radiance {
namespace {

std::string vector(const glm::dvec3& v) {
  return number(v.x) + " " + number(v.y) + " " + number(v.z);
}

std::vector<double> reflectances(const calc::PreparedScene& scene) {
  std::vector<double> values = scene.reflectance;
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

std::string write_materials(const calc::PreparedScene& scene) {
  std::string text = "# Diffuse and grey: reflectance without gloss.\n\n";
  const std::vector<double> values = reflectances(scene);
  for (std::size_t m = 0; m < values.size(); ++m) {
    const std::string rho = number(values[m]);
    text += fmt::format("void plastic surface_{}\n0\n0\n5 {} {} {} 0 0\n\n", m + 1, rho, rho, rho);
  }
  return text;
}

std::string write_surfaces(const calc::PreparedScene& scene) {
  std::string text = "# Triangles in metres, z up; both sides reflect.\n\n";
  const std::vector<double> values = reflectances(scene);
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const auto m = std::lower_bound(values.begin(), values.end(), scene.reflectance[t]);
    text += fmt::format("surface_{} polygon triangle_{}\n0\n0\n9\n", m - values.begin() + 1, t + 1);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 local(scene.vertex_m[scene.triangle[t][k]]);
      text += " " + vector(local + scene.origin_m) + "\n";
    }
    text += "\n";
  }
  return text;
}

std::string write_points(const std::vector<Plane>& planes) {
  std::string text;
  for (const Plane& plane : planes) {
    for (std::size_t i = 0; i < plane.grid->position_m.size(); ++i) {
      const glm::dvec3& n = plane.grid->normal[i];
      text += vector(plane.grid->position_m[i] + kLift_m * n) + " " + vector(n) + "\n";
    }
  }
  return text;
}

std::string write_point_table(const std::vector<Plane>& planes) {
  std::string text = "plane,column,row,x,y,z\n";
  for (const Plane& plane : planes) {
    for (std::size_t i = 0; i < plane.grid->position_m.size(); ++i) {
      const glm::dvec3& p = plane.grid->position_m[i];
      text += fmt::format("{},{},{},{},{},{}\n", report::csv_field(plane.id), plane.grid->column[i],
                          plane.grid->row[i], number(p.x), number(p.y), number(p.z));
    }
  }
  return text;
}

std::string write_script(bool is_partial) {
  std::string script = R"sh(#!/bin/sh
# Illuminance at the points of points.txt by Radiance (https://www.radiance-online.org), in lux, to
# radiance.csv. Options may follow and win: ./run.sh -ab 12 -ad 8192
set -e
LC_ALL=C
export LC_ALL  # numbers with points
CDPATH= cd -- "$(dirname -- "$0")"
# Where RAYPATH is not set, Radiance looks here and then in its own library.
if [ -n "${RAYPATH:-}" ]; then
  RAYPATH=".:$RAYPATH"
  export RAYPATH
else
  unset RAYPATH
fi
oconv materials.rad surfaces.rad luminaires.rad > scene.oct
# No ambient interpolation (-aa 0) and no stray ambient light (-av 0 0 0): the error falls with -ad.
rtrace -h -I -ab 8 -ad 4096 -as 0 -aa 0 -av 0 0 0 -lr -12 -lw 1e-6 -dt 0 -dc 1 -ds 0.05 -dj 0 \
  "$@" scene.oct < points.txt > irradiance.txt
# W/m2 of red, green and blue to lux: 179 lm/W and Radiance's weights of luminance.
awk '{ printf "%.7g\n", 179 * (0.265 * $1 + 0.670 * $2 + 0.065 * $3) }' irradiance.txt > lux.txt
{ printf 'plane,column,row,x,y,z,lx\n'; tail -n +2 points.csv | paste -d , - lux.txt; } > radiance.csv
echo "Wrote radiance.csv. Next: luxgate compare RESULT.json '$(pwd)/radiance.csv' --tolerance 2%)sh";
  // What is not exported is only in the result.
  script += is_partial ? " --partial\"\n" : "\"\n";
  return script;
}

std::string write_readme(const calc::Project& project, const calc::Space& space,
                         const calc::PreparedScene& scene, const std::vector<Plane>& planes,
                         bool is_partial, const std::vector<std::string>& changed) {
  std::size_t points = 0;
  for (const Plane& plane : planes) points += plane.grid->position_m.size();
  std::string text = fmt::format(
      "# {}, for Radiance\n\nWritten by luxgate {} from `{}`, space `{}`: {} triangles, {} "
      "luminaires, {} points.\n\n",
      report::printable(project.name.empty() ? project.path : project.name),
      report::program_version(), report::printable(project.path), report::printable(space.id),
      scene.triangle.size(), scene.luminaires.size(), points);
  text += fmt::format(
      "`./run.sh` needs oconv and rtrace and writes `radiance.csv`, which `luxgate compare "
      "RESULT.json radiance.csv{}` reads.\n",
      is_partial ? " --partial" : "");
  text += R"md(
| file | what it is |
|---|---|
| `materials.rad` | one plastic per reflectance: grey, no gloss |
| `surfaces.rad` | triangles, m, z up |
| `luminaires.rad` | sources: `brightdata` with `light-N.dat` (C, gamma in degrees; cd) and `luxgate.cal`; no ies2rad is needed |
| `points.txt` | for `rtrace -I`: x y z nx ny nz |
| `points.csv` | the same points by plane, column and row |
| `run.sh` | oconv, rtrace, and lux |

Units: Radiance counts in W/(sr m2); intensities are divided by 179 lm/W here and multiplied again in `run.sh`. C 0 is the
luminaire's x axis, C 90 its y axis, gamma 0 its aim. All luminaires are at full output and multiplied with their
maintenance factors: results are those that luxgate calls maintained.

)md";
  text += fmt::format(
      "Luminaires without size are spheres of {} m radius. Flat openings shine as I / (A cos "
      "gamma) from each "
      "side that the photometry lights. Points are lifted by {} m along their normals, off the "
      "surfaces they may lie "
      "in. In Radiance a source hides what lies behind it, in luxgate it does not.\n",
      number(kPointRadius_m), number(kLift_m));
  if (!changed.empty()) {
    text += "\nNot as in luxgate:\n\n";
    for (const std::string& item : changed) text += "- " + report::printable(item) + "\n";
  }
  return text;
}

}  // namespace cli::radiance
