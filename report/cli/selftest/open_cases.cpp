#include "report/cli/selftest/open_cases.h"

#include "calc/photometry/photometry_file.h"
#include "calc/text.h"
#include "calc/units.h"
#include "report/cli/csv_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cli::selftest {
namespace {

using Row = std::map<std::string, std::string>;

// A table that cannot be read ends the list: nothing is guessed.
struct BadTable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::vector<Row> read_table(const std::string& path, const calc::FileReader& files) {
  const calc::FileContent content = files.read(path);
  if (!content.ok()) throw BadTable(fmt::format("cannot read '{}': {}", path, content.error));
  std::vector<std::string> names;
  std::vector<Row> rows;
  std::string_view text = content.bytes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string> cells = csv_cells(calc::trim(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (cells.size() == 1 && cells[0].empty()) continue;
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (cells.size() != names.size()) {
      throw BadTable(fmt::format("'{}': line {} has {} values for {} names", path, rows.size() + 2,
                                 cells.size(), names.size()));
    }
    Row& row = rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) row[names[c]] = cells[c];
  }
  return rows;
}

double number(const Row& row, const std::string& name) {
  const auto found = row.find(name);
  const std::optional<double> value =
      found == row.end() ? std::nullopt : calc::parse_number(found->second);
  if (!value) throw BadTable(fmt::format("column '{}' of a table has no number", name));
  return *value;
}

glm::dvec3 vector(std::string_view text) {
  const std::vector<std::string_view> words = calc::split_words(text);
  if (words.size() != 3) throw BadTable("three numbers are needed: " + std::string(text));
  glm::dvec3 v;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> value = calc::parse_number(words[static_cast<std::size_t>(k)]);
    if (!value) throw BadTable("no number: " + std::string(text));
    v[k] = *value;
  }
  return v;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = std::string(calc::trim(part));
  return parts;
}

// What the program has no word for.
struct NotCovered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Its own light: rectangles, discs and spheres.
void add_emission(const Row& row, const std::vector<glm::dvec3>& corners, Scene& scene) {
  const double exitance = number(row, "exitance_lm_m2");
  const std::string& shape = row.at("shape");
  if (shape == "polygon") {
    if (corners.size() != 4 ||
        glm::length(corners[0] + corners[2] - corners[1] - corners[3]) > 1e-9 ||
        std::abs(glm::dot(corners[1] - corners[0], corners[3] - corners[0])) > 1e-9) {
      throw NotCovered("a luminous surface that is no rectangle");
    }
    Rectangle face{corners[0], corners[1] - corners[0], corners[3] - corners[0], glm::dvec3(0.0)};
    face.normal = glm::normalize(glm::cross(face.u, face.v));
    const bool reflects = number(row, "reflectance") > 0.0;
    const double inset = 1e-5 * std::min(glm::length(face.u), glm::length(face.v));
    if (reflects) face.corner += inset * face.normal;
    scene.add_luminous(face, exitance);
    return;
  }
  std::map<std::string, std::string> parts;
  for (const std::string& part : split(row.at("geometry"), ';')) {
    parts[part.substr(0, part.find(' '))] = part.substr(part.find(' ') + 1);
  }
  const double r = calc::parse_number(parts["radius"]).value_or(0.0);
  const double luminance = exitance / calc::kPi, cd = luminance * calc::kPi * r * r;
  if (shape == "disc") {
    const glm::dvec3 normal = vector(parts["normal"]);
    if (glm::length(normal - kDown) > 1e-9) throw NotCovered("a luminous disc that looks aside");
    scene.add_luminaire(lambert_web(cd, {calc::OpeningShape::disk, 2 * r, 2 * r, 0.0}),
                        vector(parts["centre"]));
  } else if (shape == "sphere") {
    scene.add_luminaire(isotropic_web(cd, {calc::OpeningShape::ellipsoid, 2 * r, 2 * r, 2 * r}),
                        vector(parts["centre"]));
  } else {
    throw NotCovered("a surface of shape '" + shape + "'");
  }
}

void add_surface(const Row& row, Scene& scene) {
  if (row.at("reflectance").empty()) throw NotCovered("it is run with several reflectances");
  const double rho = number(row, "reflectance");
  std::vector<glm::dvec3> corners;
  if (row.at("shape") == "polygon") {
    for (const std::string& corner : split(row.at("geometry"), ';')) {
      corners.push_back(vector(corner));
    }
  } else if (rho > 0.0 || number(row, "exitance_lm_m2") == 0.0) {
    throw NotCovered("a reflecting surface of shape '" + row.at("shape") + "'");
  }
  if (number(row, "exitance_lm_m2") > 0.0) add_emission(row, corners, scene);
  if (number(row, "exitance_lm_m2") > 0.0 && rho == 0.0) return;  // nothing behind a source
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    scene.add_triangle(corners[0], corners[k], corners[k + 1], rho);
  }
}

void add_lamp(const Row& row, const std::string& folder, const calc::FileReader& files,
              Scene& scene) {
  if (row.at("ies_file").empty()) throw NotCovered("a luminaire without a photometry file");
  const std::string path = folder + "/" + row.at("ies_file");
  const calc::FileContent content = files.read(path);
  calc::Diagnostics diagnostics;
  const std::optional<calc::PhotometricWeb> web =
      content.ok() ? calc::parse_photometry(content.bytes, path, diagnostics) : std::nullopt;
  if (!web) throw BadTable(fmt::format("'{}' cannot be read", path));
  const glm::dvec3 back = -glm::normalize(vector(row.at("aim")));
  const glm::dvec3 c0 = glm::normalize(vector(row.at("c0_direction")));
  scene.add_luminaire(*web, {number(row, "x"), number(row, "y"), number(row, "z")},
                      glm::dmat3(c0, glm::cross(back, c0), back));
}

std::optional<Part> part_of(const std::string& quantity) {
  if (quantity == "E direct") return Part::direct;
  if (quantity == "E indirect") return Part::indirect;
  if (quantity == "E total" || quantity == "E reflected") return Part::total;
  return std::nullopt;
}

std::vector<Row> rows_of(const std::vector<Row>& rows, const std::string& id) {
  std::vector<Row> chosen;
  for (const Row& row : rows) {
    if (row.at("case_id") == id) chosen.push_back(row);
  }
  return chosen;
}

struct Tables {
  std::vector<Row> cases, points, surfaces, luminaires;
};

OpenCase run_case(const Row& row, const Tables& tables, const std::string& folder,
                  const calc::FileReader& files, const Effort& effort) {
  OpenCase open;
  const std::string& id = row.at("case_id");
  SelftestCase test;
  test.name = id;
  test.kind = row.at("family");
  test.title = row.at("title");
  test.source = row.at("source");
  CaseResult result;
  try {
    const std::vector<Row> points = rows_of(tables.points, id);
    if (points.empty()) throw NotCovered("it has averages or fluxes only, no points");
    Scene scene;
    bool has_luminous = false;
    for (const Row& surface : rows_of(tables.surfaces, id)) {
      add_surface(surface, scene);
      has_luminous = has_luminous || number(surface, "exitance_lm_m2") > 0.0;
    }
    // Beside a luminous surface the table of luminaires describes the same source once more.
    for (const Row& lamp : rows_of(tables.luminaires, id)) {
      if (!has_luminous) add_lamp(lamp, folder, files, scene);
    }
    std::vector<Point> places;
    for (const Row& p : points) {
      if (!part_of(p.at("quantity"))) {
        throw NotCovered("'" + p.at("quantity") + "' is not what this compares");
      }
      places.push_back(
          {{number(p, "x"), number(p, "y"), number(p, "z")},
           glm::normalize(glm::dvec3(number(p, "nx"), number(p, "ny"), number(p, "nz")))});
    }
    Effort more = effort;
    more.paths = 4096;
    const Solution solution = solve(scene, places, more);
    result.note(solution);
    for (std::size_t i = 0; i < points.size() && result.problem.empty(); ++i) {
      const Row& p = points[i];
      Measured m;
      m.what = p.at("point") + " " + p.at("quantity");
      m.exact = number(p, p.at("value_linear_table").empty() ? "value" : "value_linear_table");
      const std::optional<double> known = calc::parse_number(p.at("uncertainty_rel"));
      m.known_to = known.value_or(0.0) * m.exact;
      m.replicates = solution.replicates(i, *part_of(p.at("quantity")));
      m.widest = 0.5;
      result.measured.push_back(std::move(m));
      open.printed.push_back(p.at("printed"));
    }
  } catch (const NotCovered& reason) {
    open.not_covered = reason.what();
  }
  open.judged = judge(std::move(test), std::move(result));
  return open;
}

}  // namespace

OpenCases run_open_cases(const std::string& folder, const calc::FileReader& files,
                         const Effort& effort,
                         const std::function<bool(const std::string&)>& go_on) {
  OpenCases open;
  try {
    const Tables tables{
        read_table(folder + "/cases.csv", files), read_table(folder + "/points.csv", files),
        read_table(folder + "/surfaces.csv", files), read_table(folder + "/luminaires.csv", files)};
    for (const Row& row : tables.cases) {
      if (!go_on(row.at("case_id"))) return open;
      open.cases.push_back(run_case(row, tables, folder, files, effort));
    }
  } catch (const std::exception& error) {  // BadTable, or a column that is not there
    open.problem = error.what();
  }
  return open;
}

}  // namespace cli::selftest
