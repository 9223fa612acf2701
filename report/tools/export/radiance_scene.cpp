#include "report/tools/export/radiance_scene.h"

#include "calc/base/text.h"
#include "report/document/program_version.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/export/radiance_lights.h"
#include "report/tools/export/radiance_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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

int ambient_bounces(const calc::PreparedScene& scene) {
  constexpr double kLeft = 0.002;
  constexpr int kMost = 100;
  double area = 0.0, reflecting = 0.0;
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const glm::dvec3 a(scene.vertex_m[scene.triangle[t][0]]),
        b(scene.vertex_m[scene.triangle[t][1]]), c(scene.vertex_m[scene.triangle[t][2]]);
    const double twice = glm::length(glm::cross(b - a, c - a));
    area += twice;
    reflecting += twice * scene.reflectance[t];
  }
  const double mean = area > 0.0 ? reflecting / area : 0.0;
  double left = mean;
  int bounces = 1;
  for (; left > kLeft && bounces < kMost; ++bounces) left *= mean;
  return bounces;
}

std::string write_points(const std::vector<Plane>& planes) {
  std::string text;
  for (const Plane& plane : planes) {
    for (std::size_t i = 0; i < plane.grid->position_m.size(); ++i) {
      for (const Sensor& sensor : sensors_of(*plane.grid, i)) {
        text += vector(sensor.position_m) + " " + vector(sensor.direction) + "\n";
      }
    }
  }
  return text;
}

std::string write_weights(const std::vector<Plane>& planes) {
  std::string text;
  std::size_t row = 0;
  for (const Plane& plane : planes) {
    for (std::size_t i = 0; i < plane.grid->position_m.size(); ++i) {
      ++row;
      for (const Sensor& sensor : sensors_of(*plane.grid, i)) {
        text += fmt::format("{} {}\n", row, number(sensor.weight));
      }
    }
  }
  return text;
}

std::string write_point_table(const std::vector<Plane>& planes) {
  std::string text = "plane,column,row,x,y,z,quantity\n";
  for (const Plane& plane : planes) {
    const std::string_view quantity = calc::quantity_name(plane.grid->kernel, plane.grid->derived);
    for (std::size_t i = 0; i < plane.grid->position_m.size(); ++i) {
      const glm::dvec3& p = plane.grid->position_m[i];
      text +=
          fmt::format("{},{},{},{},{},{},{}\n", report::csv_field(plane.id), plane.grid->column[i],
                      plane.grid->row[i], number(p.x), number(p.y), number(p.z), quantity);
    }
  }
  return text;
}

std::string write_script(const calc::PreparedScene& scene, const Light& light, bool is_partial) {
  std::string script = R"sh(#!/bin/sh
# Illuminance at the points of points.csv by Radiance (https://www.radiance-online.org), in lux, to
# radiance.csv. Options may follow and win: ./run.sh -ad 4096 for half of the scatter.
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
# No ambient interpolation (-aa 0) and no stray ambient light (-av 0 0 0): what is left is scatter,
# which falls with the root of -ad, and light after more than -ab reflections: under 0.2 % of the
# reflected light, by the mean reflectance of these surfaces.
rtrace -h -I -n "${JOBS:-1}" )sh";
  script += fmt::format("-ab {} -ad 1024", ambient_bounces(scene));
  script += R"sh( -as 0 -aa 0 -av 0 0 0 -lr -12 -lw 1e-6 -dt 0 -dc 1 \
  -ds 0.05 -dj 0 "$@" scene.oct < points.txt > irradiance.txt
if [ "$(wc -l < irradiance.txt)" -ne "$(wc -l < points.txt)" ]; then
  echo "run.sh: rtrace did not answer for all points" >&2
  exit 1
fi
# W/m2 of red, green and blue to lux: 179 lm/W and Radiance's weights of luminance; then the sum
# over the directions of each point.
paste -d ' ' weights.txt irradiance.txt | awk '
  $1 != row { if (NR > 1) printf "%.7g\n", sum; row = $1; sum = 0 }
  { sum += $2 * 179 * (0.265 * $3 + 0.670 * $4 + 0.065 * $5) }
  END { printf "%.7g\n", sum }' > lux.txt
{ printf 'plane,column,row,x,y,z,quantity,lx\n'; tail -n +2 points.csv | paste -d , - lux.txt; } \
  > radiance.csv
)sh";
  if (light.scene != nullptr) {
    // Ids are words without quotes or spaces.
    script += fmt::format(
        "echo \"Wrote radiance.csv, of scene '{}'. The points of a result are at full output:\"\n"
        "echo \"luxgate compare does not fit.\"\n",
        light.scene->id);
    return script;
  }
  script +=
      "echo \"Wrote radiance.csv. Next: luxgate compare RESULT.json '$(pwd)/radiance.csv' "
      "--tolerance 2%";
  // What is not exported is only in the result.
  script += is_partial ? " --partial\"\n" : "\"\n";
  return script;
}

std::string write_readme(const calc::Project& project, const calc::Space& space,
                         const calc::PreparedScene& scene, const std::vector<Plane>& planes,
                         bool is_partial, const Light& light) {
  std::size_t points = 0;
  for (const Plane& plane : planes) points += plane.grid->position_m.size();
  std::string text = fmt::format(
      "# {}, for Radiance\n\nWritten by luxgate {} from `{}`, space `{}`: {} triangles, {} "
      "luminaires, {} points.\n\n",
      report::printable(project.name.empty() ? project.path : project.name),
      report::program_version(), report::printable(project.path), report::printable(space.id),
      scene.triangle.size(), scene.luminaires.size(), points);
  text += "`./run.sh` needs oconv and rtrace and writes `radiance.csv`";
  text += light.scene != nullptr
              ? ". The points of a result are at full output: `luxgate compare` does not fit.\n"
              : fmt::format(", which `luxgate compare RESULT.json radiance.csv{}` reads.\n",
                            is_partial ? " --partial" : "");
  text += fmt::format(
      "`JOBS=4 ./run.sh` takes four cores. Its options: {} reflections, after which less than "
      "0.2 % of the reflected light is under way, and 1024 rays from each point, which leave a "
      "scatter of about 0.5 % at a point and less in averages; `-ad 4096` makes it half of that, "
      "in four times the time.\n",
      ambient_bounces(scene));
  text += R"md(
| file | what it is |
|---|---|
| `materials.rad` | one plastic per reflectance: grey, no gloss |
| `surfaces.rad` | triangles, m, z up |
| `luminaires.rad` | sources: `brightdata` with `light-N.dat` (C, gamma in degrees; cd) and `luxgate.cal`; no ies2rad is needed |
| `points.csv` | points by plane, column and row, and what each measures |
| `points.txt` | for `rtrace -I`: x y z nx ny nz, a line for each direction in which a point is measured |
| `weights.txt` | line by line: which point of `points.csv`, from 1, and what this direction counts in its sum |
| `run.sh` | oconv, rtrace, sums, and lux |

Units: Radiance counts in W/(sr m2); intensities are divided by 179 lm/W here and multiplied again in `run.sh`. C 0 is the
luminaire's x axis, C 90 its y axis, gamma 0 its aim. Luminaires are multiplied with their maintenance factors: results are
those that luxgate calls maintained.
)md";
  if (light.scene == nullptr) {
    text += "All luminaires are at full output";
    if (!project.scenes.empty()) {
      std::vector<std::string> ids;
      for (const calc::LightScene& one : project.scenes) ids.push_back(one.id);
      text += "; `--scene` takes the levels of a scene (" + calc::list_names(ids, 8) + ")";
    }
    text += ".\n\n";
  } else {
    text += fmt::format("Levels are those of scene `{}`:", light.scene->id);
    for (const auto& [group, level] : light.scene->level_of_group) {
      text += fmt::format(" group `{}` at {},", group, number(level));
    }
    text += " all else at 1.\n\n";
  }
  text += fmt::format(
      "Luminaires without size are spheres of {} m radius. Flat openings shine as I / (A cos "
      "gamma) from each "
      "side that the photometry lights. Points are lifted by {} m along their normals, off the "
      "surfaces they may lie "
      "in. In Radiance a source hides objects behind it, in luxgate only a source with a "
      "`<housing>`: large openings "
      "before a bright ceiling take some of the reflected light away.\n",
      number(kPointRadius_m), number(kLift_m));
  if (!light.changed.empty()) {
    text += "\nNot as in luxgate:\n\n";
    for (const std::string& item : light.changed) text += "- " + report::printable(item) + "\n";
  }
  return text;
}

}  // namespace cli::radiance
