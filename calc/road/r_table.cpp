#include "calc/road/r_table.h"

#include <algorithm>

namespace calc {
namespace {

constexpr RTable kRTables[] = {
#define LUXGATE_R_TABLE(name, q0, is_wet, ...) {#name, q0, is_wet, {{__VA_ARGS__}}},
#include "calc/road/r_tables.def"
#undef LUXGATE_R_TABLE
};

constexpr double kTanRounding = 1.0e-9;

// The interval of ascending nodes that holds x, and where in it x lies, 0 to 1.
struct NodeInterval {
  std::size_t index;
  double fraction;
};

template <std::size_t N>
NodeInterval node_interval(const std::array<double, N>& nodes, double x) {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  const auto index = static_cast<std::size_t>(above - nodes.begin()) - 1;
  const double fraction = (x - nodes[index]) / (nodes[index + 1] - nodes[index]);
  return {index, std::clamp(fraction, 0.0, 1.0)};
}

}  // namespace

const RTable* r_table(std::string_view name) {
  const auto* found = std::find_if(std::begin(kRTables), std::end(kRTables),
                                   [&](const RTable& table) { return table.name == name; });
  return found == std::end(kRTables) ? nullptr : found;
}

std::vector<std::string_view> r_table_names() {
  std::vector<std::string_view> names;
  for (const RTable& table : kRTables) names.push_back(table.name);
  return names;
}

double r_1e4(const RTable& table, double tan_epsilon, double beta_deg) {
  if (!(tan_epsilon <= kRTableTan.back() + kTanRounding)) return 0.0;
  const NodeInterval tan = node_interval(kRTableTan, tan_epsilon);
  const NodeInterval beta = node_interval(kRTableBeta_deg, beta_deg);
  const auto between = [&](std::size_t row) {
    const auto& r = table.r_1e4[row];
    return r[beta.index] * (1.0 - beta.fraction) + r[beta.index + 1] * beta.fraction;
  };
  return between(tan.index) * (1.0 - tan.fraction) + between(tan.index + 1) * tan.fraction;
}

}  // namespace calc
