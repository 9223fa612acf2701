// The same laws through the front door: projects and photometry as text, as users and other
// programs write them. A sign, a mirrored plane, lengths and widths exchanged, a unit or a factor
// show here; scenes made in memory pass all of that by.

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/tools/selftest/closed_forms.h"
#include "report/tools/selftest/end_to_end.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace cli::selftest {
namespace {

using calc::kPi;

double rad(double degrees) { return calc::radians_from_degrees(degrees); }

// A luminaire's axes in the world: C 0, C 90 and away from gamma 0.
struct LampAxes {
  glm::dvec3 c0, c90, back;

  glm::dvec3 towards(double c_deg, double gamma_deg) const {
    return calc::sin(rad(gamma_deg)) * (calc::cos(rad(c_deg)) * c0 + calc::sin(rad(c_deg)) * c90) -
           calc::cos(rad(gamma_deg)) * back;
  }
};

// Straight down, C 0 turned from +x towards +y.
LampAxes turned(double degrees) {
  const glm::dvec3 c0(calc::cos(rad(degrees)), calc::sin(rad(degrees)), 0.0);
  return {c0, {-c0.y, c0.x, 0.0}, kUp};
}

// No two directions are alike, nor is any mirrored pair.
double lopsided_cd(double c_deg, double gamma_deg) {
  if (gamma_deg == 0.0) return 900.0;
  return 40.0 + 1.5 * gamma_deg + 0.7 * c_deg + 0.004 * c_deg * gamma_deg;
}

using Light = std::function<double(double c_deg, double gamma_deg)>;

std::string table_text(const std::vector<double>& c_deg, const std::vector<double>& gamma_deg,
                       const Light& light) {
  std::string text;
  for (const double c : c_deg) {
    for (const double gamma : gamma_deg) text += fmt::format("{:.10g}\n", light(c, gamma));
  }
  return text;
}

std::string list_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{:.10g}\n", value);
  return text;
}

// LM-63 type C. opening: "units-of-length width length height".
std::string lm63_text(const std::vector<double>& c_deg, const std::vector<double>& gamma_deg,
                      const Light& light, const std::string& opening = "2 0 0 0",
                      const std::string& factors = "1 1") {
  const auto space = factors.find(' ');
  return fmt::format(
      "IESNA:LM-63-2002\n[TEST] selftest\n[TESTLAB] none\n[ISSUEDATE] 01-JAN-2026\n[MANUFAC] "
      "none\nTILT=NONE\n1 -1 {} {} {} 1 {}\n{} 1 20\n{}{}{}",
      factors.substr(0, space), gamma_deg.size(), c_deg.size(), opening, factors.substr(space + 1),
      list_text(gamma_deg), list_text(c_deg), table_text(c_deg, gamma_deg, light));
}

// EULUMDAT; the light in cd for all lamps together. stored: the planes that the symmetry leaves.
std::string eulumdat_text(int symmetry, double step_deg, const std::vector<double>& stored_deg,
                          const std::vector<double>& gamma_deg, const Light& light,
                          const std::string& opening_mm = "0\n0") {
  constexpr double kLamps_lm = 2.0 * 1500.0;  // two lamps of 1500 lm
  const int planes = static_cast<int>(std::lround(360.0 / step_deg));
  std::vector<double> all_deg;
  for (int i = 0; i < planes; ++i) all_deg.push_back(step_deg * i);
  const auto per_klm = [&](double c, double gamma) { return light(c, gamma) * 1000.0 / kLamps_lm; };
  return fmt::format(
      "none\n1\n{}\n{}\n{}\n{}\n{}\nreport\nname\nnumber\nfile\ndate\n100\n100\n50\n{}"
      "\n0\n0\n0\n0\n"
      "100\n100\n1\n0\n1\n2\nlamp\n3000\n840\n80\n40\n0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n{}{}{}",
      symmetry, planes, step_deg, gamma_deg.size(), gamma_deg[1] - gamma_deg[0], opening_mm,
      list_text(all_deg), list_text(gamma_deg), table_text(stored_deg, gamma_deg, per_klm));
}

// Level points below a lamp in directions of its table: I cos / d^2.
std::vector<KnownPoint> below_in_directions(const glm::dvec3& lamp_m, const LampAxes& axes,
                                            const std::vector<std::array<double, 2>>& c_gamma_deg,
                                            const Light& light, double level_m = 0.0) {
  std::vector<KnownPoint> known;
  for (const auto& [c, gamma] : c_gamma_deg) {
    const glm::dvec3 way = axes.towards(c, gamma);
    const double d_m = (level_m - lamp_m.z) / way.z;
    known.push_back({{lamp_m + d_m * way, kUp}, light(c, gamma) * -way.z / (d_m * d_m)});
  }
  return known;
}

const std::vector<double> kGamma_deg{0, 20, 40, 60, 80};
const std::vector<double> kC_deg{0, 90, 180, 270, 360};
// The plane at 360 degrees repeats that at 0.
double lopsided_circle_cd(double c_deg, double gamma_deg) {
  return lopsided_cd(c_deg == 360.0 ? 0.0 : c_deg, gamma_deg);
}
const std::vector<std::array<double, 2>> kDirections{{0, 0},    {0, 40},   {90, 20}, {90, 60},
                                                     {180, 40}, {270, 20}, {270, 80}};

std::string project_of(const std::string& rest) {
  return "<luxgate version=\"1\">\n" + rest + "\n{}\n</luxgate>\n";
}

std::string point_type(const std::string& file, const std::string& more = "") {
  return fmt::format("<luminaire-type id=\"t\" photometry=\"{}\" opening=\"point\" {}/>\n", file,
                     more);
}

CaseResult lm63_turned(const Effort& effort) {
  CaseResult result;
  const std::map<std::string, std::string> files{
      {"lamp.ies", lm63_text(kC_deg, kGamma_deg, lopsided_circle_cd)}};
  const glm::dvec3 lamp(1, 2, 3);
  const auto add = [&](const std::string& label, const std::string& luminaire,
                       const LampAxes& axes) {
    add_points_from_files(
        result,
        project_of(
            point_type("lamp.ies") +
            fmt::format("<luminaire id=\"L\" type=\"t\" position=\"1 2 3\" {}/>", luminaire)),
        files, below_in_directions(lamp, axes, kDirections, lopsided_cd), label, effort);
  };
  add("as it is: ", "", turned(0));
  add("rotation 40: ", "rotation=\"40\"", turned(40));
  add("rotation -130: ", "rotation=\"-130\"", turned(-130));
  add("c0 along -y: ", "c0=\"0 -2 0\"", turned(-90));
  return result;
}

// Aimed at the floor, and lying on its side.
CaseResult lm63_aimed(const Effort& effort) {
  CaseResult result;
  const std::map<std::string, std::string> files{
      {"lamp.ies", lm63_text(kC_deg, kGamma_deg, lopsided_circle_cd)}};
  const glm::dvec3 lamp(1, 2, 3);
  const auto add = [&](const std::string& label, const std::string& luminaire, const LampAxes& axes,
                       const std::vector<std::array<double, 2>>& directions) {
    add_points_from_files(
        result,
        project_of(
            point_type("lamp.ies") +
            fmt::format("<luminaire id=\"L\" type=\"t\" position=\"1 2 3\" {}/>", luminaire)),
        files, below_in_directions(lamp, axes, directions, lopsided_cd), label, effort);
  };
  // Tipped from straight down towards +x by the smallest rotation: about y, C 90 stays.
  const double tip = calc::atan2(2.0, 3.0);
  const LampAxes tipped{
      {calc::cos(tip), 0, calc::sin(tip)}, {0, 1, 0}, {-calc::sin(tip), 0, calc::cos(tip)}};
  add("aim: ", "aim=\"3 2 0\"", tipped, {{0, 0}, {0, 20}, {90, 20}, {180, 60}, {270, 40}});
  const LampAxes level{{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}};  // axis along +x, C 0 down
  add("axis level, c0 down: ", "axis=\"1 0 0\" c0=\"0 0 -1\"", level, {{0, 40}, {0, 80}, {0, 60}});
  return result;
}

// What files leave out by symmetry is added on the right side.
CaseResult lm63_symmetries(const Effort& effort) {
  CaseResult result;
  struct Stored {
    const char* label;
    std::vector<double> c_deg;
    std::function<double(double)> plane_of;  // of a direction: the stored plane
  };
  const std::vector<Stored> all{
      {"rotation: ", {0}, [](double) { return 0.0; }},
      {"quadrant: ",
       {0, 45, 90},
       [](double c) {
         return c <= 90 ? c : c <= 180 ? 180 - c : c <= 270 ? c - 180 : 360 - c;
       }},
      {"half: ", {0, 90, 180}, [](double c) { return c <= 180 ? c : 360 - c; }},
      {"half about 90: ", {90, 180, 270}, [](double c) {
         return c < 90 ? 180 - c : c > 270 ? 540 - c : c;
       }}};
  for (const Stored& stored : all) {
    const Light light = [&](double c, double gamma) {
      return lopsided_cd(stored.plane_of(c), gamma);
    };
    std::vector<std::array<double, 2>> directions{{0, 0}};
    for (const double c : {0.0, 90.0, 180.0, 270.0}) directions.push_back({c, 40});
    if (stored.c_deg.size() > 1 && stored.c_deg[1] == 45) directions.push_back({135, 20});
    add_points_from_files(
        result,
        project_of(point_type("lamp.ies") +
                   "<luminaire id=\"L\" type=\"t\" position=\"1 2 3\" rotation=\"25\"/>"),
        {{"lamp.ies", lm63_text(stored.c_deg, kGamma_deg, lopsided_cd)}},
        below_in_directions({1, 2, 3}, turned(25), directions, light), stored.label, effort);
  }
  return result;
}

CaseResult eulumdat_symmetries(const Effort& effort) {
  CaseResult result;
  struct Stored {
    const char* label;
    int symmetry;
    std::vector<double> c_deg;
    std::function<double(double)> plane_of;
  };
  const std::vector<Stored> all{
      {"Isym 0: ", 0, {0, 90, 180, 270}, [](double c) { return c; }},
      {"Isym 1: ", 1, {0}, [](double) { return 0.0; }},
      {"Isym 2: ", 2, {0, 90, 180}, [](double c) { return c <= 180 ? c : 360 - c; }},
      {"Isym 3: ",
       3,
       {270, 0, 90},
       [](double c) { return c > 90 && c < 270 ? (c == 180 ? 0.0 : 540 - c) : c; }},
      {"Isym 4: ", 4, {0, 90}, [](double c) { return c <= 90    ? c
                                                     : c == 180 ? 0.0
                                                                : 90.0; }}};
  for (const Stored& stored : all) {
    const Light light = [&](double c, double gamma) {
      return lopsided_cd(stored.plane_of(c), gamma);
    };
    std::vector<std::array<double, 2>> directions{{0, 0}};
    for (const double c : {0.0, 90.0, 180.0, 270.0}) directions.push_back({c, 40});
    add_points_from_files(
        result,
        project_of(point_type("lamp.ldt") +
                   "<luminaire id=\"L\" type=\"t\" position=\"1 2 3\" rotation=\"25\"/>"),
        {{"lamp.ldt", eulumdat_text(stored.symmetry, 90, stored.c_deg, kGamma_deg, lopsided_cd)}},
        below_in_directions({1, 2, 3}, turned(25), directions, light), stored.label, effort);
  }
  return result;
}

// Multiplier and ballast factors, feet, another flux.
CaseResult factors(const Effort& effort) {
  CaseResult result;
  const auto add = [&](const std::string& label, const std::string& file, const std::string& more,
                       double factor) {
    const Light light = [&](double c, double gamma) { return factor * lopsided_cd(c, gamma); };
    add_points_from_files(result,
                          project_of(point_type("lamp.ies", more) +
                                     "<luminaire id=\"L\" type=\"t\" position=\"1 2 3\"/>"),
                          {{"lamp.ies", file}},
                          below_in_directions({1, 2, 3}, turned(0), kDirections, light), label,
                          effort);
  };
  add("multiplier 1.5, ballast 0.9: ",
      lm63_text(kC_deg, kGamma_deg, lopsided_circle_cd, "2 0 0 0", "1.5 0.9"), "", 1.5 * 0.9);
  // A uniform lamp sends 4 pi I.
  const Light even = [](double, double) { return 250.0; };
  std::vector<KnownPoint> known = below_in_directions({1, 2, 3}, turned(0), {{0, 0}, {90, 60}},
                                                      [](double, double) { return 800.0; });
  add_points_from_files(
      result,
      project_of(point_type("lamp.ies", fmt::format("flux-lm=\"{:.17g}\"", 3200.0 * kPi)) +
                 "<luminaire id=\"L\" type=\"t\" position=\"1 2 3\"/>"),
      {{"lamp.ies", lm63_text({0}, {0, 90, 180}, even)}}, known, "flux-lm: ", effort);
  return result;
}

// A panel that shines as cos gamma, longer than wide, close by: which way its length lies.
CaseResult openings(const Effort& effort) {
  CaseResult result;
  std::vector<double> gamma_deg;
  for (int k = 0; k <= 900; ++k) gamma_deg.push_back(0.1 * k);
  constexpr double kExitance = 3000.0;
  const auto add = [&](const std::string& label, const char* file, const std::string& text,
                       double along_x_m, double along_y_m) {
    const glm::dvec3 corner(-0.5 * along_x_m, -0.5 * along_y_m, 1.0);
    std::vector<KnownPoint> known;
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0.8), glm::dvec3(0.7, 0, 0.6),
                                glm::dvec3(0, 0.7, 0.6), glm::dvec3(0.3, 0.1, 0.0)}) {
      known.push_back(
          {{p, kUp},
           kExitance * rectangle_factor(p, kUp, corner, {along_x_m, 0, 0}, {0, along_y_m, 0})});
    }
    add_points_from_files(
        result,
        project_of(fmt::format("<luminaire-type id=\"t\" photometry=\"{}\"/>\n"
                               "<luminaire id=\"L\" type=\"t\" position=\"0 0 1\"/>",
                               file)),
        {{file, text}}, known, label, effort, 2e-6, 5e-3);
  };
  const Light panel = [](double, double gamma) {
    return gamma == 90.0 ? 0.0 : kExitance / kPi * 1.2 * 0.3 * calc::cos(rad(gamma));
  };
  // LM-63: width across, length along C 0. EULUMDAT: length along C 90.
  add("LM-63: ", "lamp.ies", lm63_text({0}, gamma_deg, panel, "2 0.3 1.2 0"), 1.2, 0.3);
  add("LM-63 in feet: ", "lamp.ies",
      lm63_text({0}, gamma_deg, panel,
                fmt::format("1 {:.12g} {:.12g} 0", 0.3 / 0.3048, 1.2 / 0.3048)),
      1.2, 0.3);
  add("EULUMDAT: ", "lamp.ldt", eulumdat_text(1, 90, {0}, gamma_deg, panel, "1200\n300"), 0.3, 1.2);
  return result;
}

double isotropic_lx(double cd, const glm::dvec3& lamp_m, const Point& point) {
  const glm::dvec3 w = lamp_m - point.position_m;
  return std::max(0.0, cd * glm::dot(w, point.normal)) / calc::pow(glm::length(w), 3);
}

// Units, arrays of luminaires, assemblies: where things stand.
CaseResult places(const Effort& effort) {
  CaseResult result;
  const std::map<std::string, std::string> files{
      {"lamp.ies", lm63_text({0}, {0, 90, 180}, [](double, double) { return 100.0; })}};
  const std::vector<Point> points{
      {{0.3, 0.2, 0}, kUp}, {{2.5, 0.4, 0}, kUp}, {{1, 3, 0.5}, {0, -1, 0}}};
  const auto add = [&](const std::string& label, const std::string& units,
                       const std::string& objects, const std::vector<glm::dvec3>& lamps_m) {
    std::vector<KnownPoint> known;
    for (const Point& point : points) {
      double sum = 0.0;
      for (const glm::dvec3& lamp_m : lamps_m) sum += isotropic_lx(100.0, lamp_m, point);
      known.push_back({point, sum});
    }
    add_points_from_files(result,
                          "<luxgate version=\"1\"" + units + ">\n" + point_type("lamp.ies") +
                              objects + "\n{}\n</luxgate>\n",
                          files, known, label, effort);
  };
  add("grid of 3 x 2: ", "",
      "<luminaire-grid id=\"G\" type=\"t\" origin=\"0 0 2.5\" size=\"3 4\" columns=\"3\" "
      "rows=\"2\"/>",
      {{0.5, 1, 2.5}, {1.5, 1, 2.5}, {2.5, 1, 2.5}, {0.5, 3, 2.5}, {1.5, 3, 2.5}, {2.5, 3, 2.5}});
  add("grid turned 90: ", "",
      "<luminaire-grid id=\"G\" type=\"t\" origin=\"4 0 2.5\" size=\"2 1\" columns=\"2\" "
      "rows=\"1\" array-rotation=\"90\"/>",
      {{3.5, 0.5, 2.5}, {3.5, 1.5, 2.5}});
  add("line of 2: ", "",
      "<luminaire-line id=\"G\" type=\"t\" from=\"0 0 2\" to=\"4 2 2\" count=\"2\"/>",
      {{1, 0.5, 2}, {3, 1.5, 2}});
  add("ring of 4: ", "",
      "<luminaire-ring id=\"G\" type=\"t\" centre=\"1 1 3\" radius=\"2\" count=\"4\" "
      "start=\"30\"/>",
      {{1 + 2 * calc::cos(rad(30)), 1 + 2 * calc::sin(rad(30)), 3},
       {1 + 2 * calc::cos(rad(120)), 1 + 2 * calc::sin(rad(120)), 3},
       {1 + 2 * calc::cos(rad(210)), 1 + 2 * calc::sin(rad(210)), 3},
       {1 + 2 * calc::cos(rad(300)), 1 + 2 * calc::sin(rad(300)), 3}});
  add("assembly, turned and repeated: ", "",
      "<assembly id=\"A\" position=\"1 2 0\" rotation=\"90\" repeat=\"2 1 1\" step=\"0.5 0 0\">"
      "<luminaire id=\"L\" type=\"t\" position=\"1 0 3\"/></assembly>",
      {{1, 3, 3}, {1.5, 3, 3}});
  return result;
}

CaseResult unit_of_length(const Effort& effort) {
  CaseResult result;
  for (const auto& [name, metres] : {std::pair("mm", 1e-3), std::pair("cm", 1e-2),
                                     std::pair("ft", 0.3048), std::pair("in", 0.0254)}) {
    const auto length = [&, unit = metres](double m) { return fmt::format("{:.15g}", m / unit); };
    // A grid of two points, 2 m above which a lamp hangs.
    const std::string project = fmt::format(
        "<luxgate version=\"1\" units=\"{}\">\n{}<luminaire id=\"L\" type=\"t\" position=\"{} {} "
        "{}\"/>\n<plane id=\"p\" origin=\"0 0 {}\" u=\"{} 0 0\" v=\"0 {} 0\" count=\"2 "
        "1\"/>\n</luxgate>\n",
        name, point_type("lamp.ies"), length(1), length(0.5), length(2.5), length(0.5), length(4),
        length(1));
    std::vector<KnownPoint> known;
    for (const double x : {1.0, 3.0}) {
      const Point point{{x, 0.5, 0.5}, kUp};
      known.push_back({point, isotropic_lx(100.0, {1, 0.5, 2.5}, point)});
    }
    add_from_files(
        result,
        {{"project.xml", project},
         {"lamp.ies", lm63_text({0}, {0, 90, 180}, [](double, double) { return 100.0; })}},
        known, std::string(name) + ": ", effort);
  }
  return result;
}

// One wall of a room reflects, the others, floor and ceiling do not: at the foot of a wall the wall
// is half of the sky, and shines with its own exitance there.
CaseResult walls(const Effort& effort) {
  CaseResult result;
  const glm::dvec3 lamp(2.5, 1.0, 2.0);
  constexpr double kCd = 500.0, kReflectance = 0.7;
  struct Wall {
    glm::dvec3 foot_m, inwards;
  };
  const std::vector<Wall> all{{{1.5, 0, 0}, {0, 1, 0}},
                              {{6, 1.5, 0}, {-1, 0, 0}},
                              {{3.5, 4, 0}, {0, -1, 0}},
                              {{0, 2.0, 0}, {1, 0, 0}}};
  for (std::size_t w = 0; w < all.size(); ++w) {
    std::string materials;
    for (std::size_t k = 0; k < all.size(); ++k) {
      materials += std::string(k > 0 ? " " : "") + (k == w ? "grey" : "black");
    }
    const Point foot{all[w].foot_m, kUp};
    const double lx =
        isotropic_lx(kCd, lamp, foot) +
        0.5 * kReflectance * isotropic_lx(kCd, lamp, {foot.position_m, all[w].inwards});
    const std::string project =
        "<luxgate version=\"1\">\n<material id=\"black\" reflectance=\"0\"/>\n" +
        fmt::format("<material id=\"grey\" reflectance=\"{}\"/>\n", kReflectance) +
        point_type("lamp.ies") +
        "<room id=\"R\" size=\"6 4 3\" floor=\"black\" ceiling=\"black\" walls=\"black\" "
        "wall-materials=\"" +
        materials +
        "\">\n"
        "<luminaire id=\"L\" type=\"t\" position=\"2.5 1 2\"/>\n{}\n</room>\n</luxgate>\n";
    add_points_from_files(
        result, project,
        {{"lamp.ies", lm63_text({0}, {0, 90, 180}, [](double, double) { return kCd; })}},
        {{foot, lx}}, fmt::format("wall {}: ", w + 1), effort, 1e-4, 0.02);
  }
  return result;
}

}  // namespace

std::vector<SelftestCase> files_cases() {
  const char* const law = "I cos / d^2 in directions of the table";
  return {{"lm63-turned", "files", "LM-63, turned by rotation and by c0", law, lm63_turned},
          {"lm63-aimed", "files", "LM-63, aimed and lying on its side", law, lm63_aimed},
          {"lm63-symmetries", "files", "LM-63 that leaves planes out", law, lm63_symmetries},
          {"eulumdat-symmetries", "files", "EULUMDAT of each symmetry", law, eulumdat_symmetries},
          {"factors", "files", "Multiplier, ballast factor and another flux", law, factors},
          {"openings", "files", "Direction of an opening's length, from nearby", "[Lambert1760]",
           openings},
          {"places", "files", "Grids, lines, rings and assemblies of luminaires",
           "inverse square and cosine law", places},
          {"units", "files", "Projects in mm, cm, ft and in", "inverse square and cosine law",
           unit_of_length},
          {"walls", "files", "Which wall of a room has which material; points at its foot",
           "half of the sky is the wall", walls}};
}

}  // namespace cli::selftest
