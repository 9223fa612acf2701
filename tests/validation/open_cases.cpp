#include "tests/validation/open_cases.h"

#include "calc/base/text.h"
#include "calc/scene/receiver_kernel.h"
#include "tests/validation/open_scalars.h"
#include "tests/validation/open_scene.h"
#include "tests/validation/open_tables.h"

#include <exception>
#include <optional>
#include <utility>

namespace validation {

using namespace cli::selftest;

namespace {

constexpr std::uint64_t kPaths = 4096;
constexpr double kWidest = 0.5;
// Of spatial quantities: their lamps are tables of formulas.
constexpr double kTableKnownTo = 1e-4;

struct Quantity {
  Part part;
  calc::ReceiverKernel kernel = calc::ReceiverKernel::planar;
};

std::optional<Quantity> quantity_of(const std::string& quantity) {
  if (quantity == "E direct") return Quantity{Part::direct};
  if (quantity == "E indirect") return Quantity{Part::indirect};
  if (quantity == "E total" || quantity == "E reflected" || quantity == "E vertical") {
    return Quantity{Part::total};
  }
  if (quantity == "E cylindrical") return Quantity{Part::total, calc::ReceiverKernel::cylindrical};
  if (quantity == "E semicylindrical") {
    return Quantity{Part::total, calc::ReceiverKernel::semicylindrical};
  }
  return std::nullopt;
}

Point place_of(const Row& p) {
  return {{number(p, "x"), number(p, "y"), number(p, "z")},
          glm::normalize(glm::dvec3(number(p, "nx"), number(p, "ny"), number(p, "nz")))};
}

Measured measured(const Row& p, const Quantity& quantity, std::vector<double> replicates) {
  Measured m;
  m.what = p.at("point") + " " + p.at("quantity");
  m.exact = number(p, p.at("value_linear_table").empty() ? "value" : "value_linear_table");
  const bool is_plain =
      quantity.kernel == calc::ReceiverKernel::planar && p.at("quantity") != "E vertical";
  const double known = is_plain ? 0.0 : kTableKnownTo;
  m.known_to = calc::parse_number(p.at("uncertainty_rel")).value_or(known) * m.exact;
  m.replicates = std::move(replicates);
  m.widest = kWidest;
  return m;
}

// All points of one kernel together; each alone if one of them cannot be calculated.
void run_points(const std::vector<Row>& rows, const Scene& scene, const Effort& effort,
                CaseResult& result, OpenCase& open) {
  std::vector<Point> places;
  const Quantity first = *quantity_of(rows[0].at("quantity"));
  for (const Row& row : rows) places.push_back(place_of(row));
  const Solution all = solve(scene, places, effort, first.kernel);
  result.rays += all.rays;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Quantity quantity = *quantity_of(rows[i].at("quantity"));
    const bool is_alone = !all.problem.empty();
    const Solution alone = is_alone ? solve(scene, {places[i]}, effort, first.kernel) : Solution{};
    if (is_alone && !alone.problem.empty()) {
      open.left_out.push_back("point " + rows[i].at("point") + ": refused: " + alone.problem);
      continue;
    }
    result.measured.push_back(
        measured(rows[i], quantity,
                 is_alone ? alone.replicates(0, quantity.part) : all.replicates(i, quantity.part)));
    open.printed.push_back(rows[i].at("printed"));
  }
}

void run_points(const std::string& id, const Tables& tables, const Effort& effort,
                CaseResult& result, OpenCase& open) {
  const std::vector<Row> points = rows_of(tables.points, id);
  if (points.empty()) return;
  const Scene scene = open_scene(id, tables, std::nullopt);
  for (const calc::ReceiverKernel kernel :
       {calc::ReceiverKernel::planar, calc::ReceiverKernel::cylindrical,
        calc::ReceiverKernel::semicylindrical}) {
    std::vector<Row> chosen;
    for (const Row& row : points) {
      const auto quantity = quantity_of(row.at("quantity"));
      if (quantity && quantity->kernel == kernel) chosen.push_back(row);
    }
    if (!chosen.empty()) run_points(chosen, scene, effort, result, open);
  }
  for (const Row& row : points) {
    if (quantity_of(row.at("quantity"))) continue;
    open.left_out.push_back("point " + row.at("point") + ": '" + row.at("quantity") +
                            "' is not what luxgate calculates");
  }
}

OpenCase run_case(const Row& row, const Tables& tables, const Effort& effort) {
  OpenCase open;
  const std::string& id = row.at("case_id");
  SelftestCase test;
  test.name = id;
  test.kind = row.at("family");
  test.title = row.at("title");
  test.source = row.at("source");
  CaseResult result;
  try {
    Effort more = effort;
    more.paths = kPaths;
    run_points(id, tables, more, result, open);
    ScalarResult scalars = run_scalars(row, tables, effort);
    result.rays += scalars.result.rays;
    if (result.problem.empty()) result.problem = scalars.result.problem;
    for (Measured& m : scalars.result.measured) result.measured.push_back(std::move(m));
    for (std::string& text : scalars.printed) open.printed.push_back(std::move(text));
    for (std::string& text : scalars.left_out) open.left_out.push_back(std::move(text));
    if (result.measured.empty() && result.problem.empty()) {
      throw NotCovered(open.left_out.empty() ? "no number of it is what luxgate calculates"
                                             : open.left_out[0]);
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
                         const std::function<void(const std::string&)>& announce) {
  OpenCases open;
  try {
    const Tables tables = read_tables(folder, files);
    for (const Row& row : tables.cases) {
      announce(row.at("case_id"));
      open.cases.push_back(run_case(row, tables, effort));
    }
  } catch (const std::exception& error) {  // BadTable, or a column that is not there
    open.problem = error.what();
  }
  return open;
}

}  // namespace validation
