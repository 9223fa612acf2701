// What has no right answer is refused, and the message says why.

#include "calc/project/project_xml.h"
#include "calc/scene/sensor_grid.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/end_to_end.h"

#include <fmt/format.h>

namespace cli::selftest {
namespace {

std::string lm63(const std::string& angles, const std::string& candela, int count) {
  return fmt::format(
      "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 -1 1 {} 1 1 2 0 0 0\n1 1 10\n{}\n0\n"
      "{}\n",
      count, angles, candela);
}

// What is said about a project, up to the points of its planes.
std::string said_about(const std::string& plane, const std::string& photometry) {
  const TextFiles files(
      {{"project.xml",
        fmt::format("<luxgate version=\"1\">\n<material id=\"grey\" reflectance=\"0\"/>\n"
                    "<luminaire-type id=\"lamp\" photometry=\"lamp.ies\"/>\n"
                    "<luminaire id=\"L\" type=\"lamp\" position=\"0 0 2\"/>\n"
                    "<box id=\"block\" size=\"2 2 1\" position=\"-1 -1 0\" material=\"grey\"/>\n"
                    "{}\n</luxgate>\n",
                    plane)},
       {"lamp.ies", photometry}});
  calc::Diagnostics diagnostics;
  const auto project = calc::load_project(files, "project.xml", diagnostics);
  if (project) {
    for (const calc::Space& space : project->spaces) {
      for (const calc::CalcPlane& p : space.planes) calc::make_sensor_grid(p, space, diagnostics);
    }
  }
  return errors_in(diagnostics);
}

CaseResult no_steady_state(const Effort& effort) {
  CaseResult result;
  for (const double rho : {1.0 - 1e-6, 1.0}) {
    Scene scene;
    scene.add_box({0, 0, 0}, {4, 3, 2.5}, rho);
    scene.add_luminaire(isotropic_web(100.0), {1, 1, 2});
    Effort little = effort;
    little.paths = 16;
    const Solution solution = solve(scene, {{{2, 1.5, 0.75}, kUp}}, little);
    result.rays += solution.rays;
    result.refused.push_back(
        {fmt::format("closed room of reflectance {}", rho), "no steady state", solution.problem});
  }
  return result;
}

CaseResult bad_input(const Effort&) {
  const std::string good = lm63("0 90 180", "100 100 100", 3);
  const std::string plane =
      "<plane id=\"p\" origin=\"2 2 0\" u=\"1 0 0\" v=\"0 1 0\" count=\"2 2\"/>";
  CaseResult result;
  const auto expect = [&](const std::string& what, const std::string& message,
                          const std::string& planes, const std::string& photometry) {
    result.refused.push_back({what, message, said_about(planes, photometry)});
  };
  expect("plane with a normal of zero", "parallel-vectors",
         "<plane id=\"p\" origin=\"0 0 0\" u=\"2 0 0\" v=\"4 0 0\" count=\"3 3\"/>", good);
  expect("plane without any point left", "grid-without-points",
         "<plane id=\"p\" origin=\"-0.5 -0.5 0.5\" u=\"1 0 0\" v=\"0 1 0\" count=\"2 2\"/>", good);
  expect("photometry with one vertical angle", "photometry", plane, lm63("0", "100", 1));
  expect("photometry with angles that go back", "photometry", plane,
         lm63("0 100 90", "100 100 100", 3));
  expect("photometry without any light", "photometry", plane, lm63("0 90 180", "0 0 0", 3));
  // The same project is accepted where nothing is wrong.
  const std::string accepted = said_about(plane, good);
  result.refused.push_back(
      {"the same project without a mistake", "accepted", accepted.empty() ? "accepted" : accepted});
  return result;
}

// Points that rays cannot tell from a surface, at the distances at which they once got a number.
CaseResult too_close(const Effort& effort) {
  CaseResult result;
  Scene scene;
  scene.add_box({0, 0, 0}, {4, 3, 2.5}, 0.5);
  scene.add_quad({1, 1, 1}, {1, 0, 0}, {0, 1, 0}, 0.5);
  scene.add_luminaire(isotropic_web(100.0), {1.5, 1.5, 2});
  const auto expect = [&](const char* what, const Point& point, const char* expected) {
    Effort little = effort;
    little.paths = 16;
    const Solution solution = solve(scene, {point}, little);
    result.rays += solution.rays;
    result.refused.push_back(
        {what, expected, solution.problem.empty() ? std::string("computed") : solution.problem});
  };
  constexpr const char* kRefused = "but not in it";
  expect("10 um before a wall, facing it", {{1e-5, 1.5, 1.2}, {-1, 0, 0}}, kRefused);
  expect("1.5 um under a plate, facing it", {{1.3, 1.4, 1.0 - 1.5e-6}, kUp}, kRefused);
  expect("5 um beside a wall", {{5e-6, 1.5, 1.2}, kUp}, kRefused);
  expect("the same, 20 um", {{2e-5, 1.5, 1.2}, kUp}, "computed");
  expect("on the plate", {{1.3, 1.4, 1.0}, kUp}, "computed");
  expect("under the plate, facing down", {{1.3, 1.4, 1.0 - 1.5e-6}, kDown}, "computed");
  expect("on the floor", {{1.3, 1.4, 0.0}, kUp}, "computed");
  return result;
}

}  // namespace

std::vector<SelftestCase> refused_cases() {
  return {{"no-steady-state", "refused", "Closed room of reflectance 1 - 1e-6 and of 1",
           "without absorption there is no steady state", no_steady_state},
          {"bad-input", "refused", "Planes and photometry that cannot be intended",
           "no number is better than a wrong one", bad_input},
          {"too-close", "refused", "Points that rays cannot tell from a surface, and points in one",
           "no number is better than a wrong one", too_close}};
}

}  // namespace cli::selftest
