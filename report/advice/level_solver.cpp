#include "report/advice/level_solver.h"

#include "report/advice/coin_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <string>

namespace cli {
namespace {

// Of branch and bound; so that an answer comes, and hangs on no clock.
constexpr int kMostNodes = 5'000;
// Rounds of asking what is broken. Each brings at least one condition that was not there.
constexpr int kMostRounds = 2'000;
// Prices below this share of the whole cost are rounding.
constexpr double kNoPrice = 1e-6;

// The solvers use whatever BLAS is installed, whose last bits may hang on the processor.
double without_last_bits(double value) { return std::stod(fmt::format("{:.9g}", value)); }

// By the largest number in it: the solver's tolerances are absolute.
double scale_of(const rules::LevelCondition& condition) {
  double most = 0.0;
  for (const double c : condition.coefficient) most = std::max(most, std::abs(c));
  return most > 0.0 ? 1.0 / most : 1.0;
}

// Conditions by rows, as the library wants them: all rows have all columns.
struct Rows {
  explicit Rows(std::size_t columns) : columns_(columns) {}

  void add(const rules::LevelCondition& condition, double step) {
    const double scale = scale_of(condition);
    for (const double c : condition.coefficient) values_.push_back(c * step * scale);
    at_least_.push_back(condition.at_least * scale);
  }
  int count() const { return static_cast<int>(at_least_.size()); }
  double value(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }
  const std::vector<double>& at_least() const { return at_least_; }

  // Column by column.
  struct Columns {
    std::vector<int> start, row;
    std::vector<double> value;
  };
  Columns columns() const {
    Columns result;
    for (std::size_t column = 0; column < columns_; ++column) {
      result.start.push_back(static_cast<int>(result.row.size()));
      for (std::size_t row = 0; row < at_least_.size(); ++row) {
        if (value(row, column) == 0.0) continue;
        result.row.push_back(static_cast<int>(row));
        result.value.push_back(value(row, column));
      }
    }
    result.start.push_back(static_cast<int>(result.row.size()));
    return result;
  }

 private:
  std::size_t columns_;
  std::vector<double> values_, at_least_;
};

// Levels as the library has them: numbers of steps, or levels themselves.
struct Unknowns {
  std::vector<double> cost, low, high;
  double step = 1.0;
};

Unknowns unknowns_of(const LevelProblem& problem) {
  Unknowns result;
  result.step = problem.steps > 0 ? 1.0 / problem.steps : 1.0;
  for (std::size_t g = 0; g < problem.cost.size(); ++g) {
    // Of levels that cost the same the same ones are taken everywhere: those of the first groups.
    result.cost.push_back(problem.cost[g] * result.step * (1.0 + 1e-7 * static_cast<double>(g)));
    result.low.push_back(std::round(problem.range[g].low / result.step * 1e9) * 1e-9);
    result.high.push_back(std::round(problem.range[g].high / result.step * 1e9) * 1e-9);
  }
  return result;
}

// Both solvers take a program in the same way.
template <class Model, class LoadProblem>
void load(Model* model, LoadProblem load_problem, const Unknowns& unknowns, const Rows& rows) {
  const Rows::Columns columns = rows.columns();
  const std::vector<double> open(rows.at_least().size(), std::numeric_limits<double>::max());
  load_problem(model, static_cast<int>(unknowns.cost.size()), rows.count(), columns.start.data(),
               columns.row.data(), columns.value.data(), unknowns.low.data(), unknowns.high.data(),
               unknowns.cost.data(), rows.at_least().data(), open.data());
}

// What a solver says of a program.
struct Solution {
  std::optional<std::vector<double>> unknown;
  bool is_proven = false;         // the best; or, without any, that there are none
  double bound = 0.0;             // no solution costs less
  std::vector<double> row_price;  // of levels of any size; [row], as scaled
};

// CBC keeps state of its own beside its models, and projects of a batch are advised on at the same
// time.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

Solution solve_any(const Unknowns& unknowns, const Rows& rows) {
  const std::scoped_lock lock(one_at_a_time());
  constexpr int kOptimal = 0, kInfeasible = 1;  // Clp_status()
  const CoinLibrary& coin = coin_library();
  const std::unique_ptr<Clp_Simplex, decltype(&Clp_deleteModel)> model(coin.Clp_newModel(),
                                                                       coin.Clp_deleteModel);
  coin.Clp_setLogLevel(model.get(), 0);
  load(model.get(), coin.Clp_loadProblem, unknowns, rows);
  coin.Clp_dual(model.get(), 0);
  if (coin.Clp_status(model.get()) != kOptimal) coin.Clp_primal(model.get(), 0);
  Solution answer;
  const int status = coin.Clp_status(model.get());
  answer.is_proven = status == kOptimal || status == kInfeasible;
  if (status != kOptimal) return answer;
  const double* solution = coin.Clp_getColSolution(model.get());
  answer.unknown.emplace(solution, solution + unknowns.cost.size());
  const double* price = coin.Clp_getRowPrice(model.get());
  answer.row_price.assign(price, price + rows.count());
  return answer;
}

Solution solve_steps(const Unknowns& unknowns, const Rows& rows) {
  const std::scoped_lock lock(one_at_a_time());
  const CoinLibrary& coin = coin_library();
  const std::unique_ptr<Cbc_Model, decltype(&Cbc_deleteModel)> model(coin.Cbc_newModel(),
                                                                     coin.Cbc_deleteModel);
  coin.Cbc_setLogLevel(model.get(), 0);
  load(model.get(), coin.Cbc_loadProblem, unknowns, rows);
  for (int i = 0; i < static_cast<int>(unknowns.cost.size()); ++i) {
    coin.Cbc_setInteger(model.get(), i);
  }
  coin.Cbc_setMaximumNodes(model.get(), kMostNodes);
  coin.Cbc_setParameter(model.get(), "randomSeed", "1");
  coin.Cbc_setParameter(model.get(), "threads", "0");
  coin.Cbc_solve(model.get());
  Solution answer;
  const bool is_infeasible = coin.Cbc_isProvenInfeasible(model.get()) != 0;
  answer.is_proven = is_infeasible || coin.Cbc_isProvenOptimal(model.get()) != 0;
  if (is_infeasible) return answer;
  if (coin.Cbc_numberSavedSolutions(model.get()) == 0) {
    answer.is_proven = false;
    return answer;
  }
  answer.bound = coin.Cbc_getBestPossibleObjValue(model.get());
  const double* solution = coin.Cbc_getColSolution(model.get());
  answer.unknown.emplace(solution, solution + unknowns.cost.size());
  for (double& one : *answer.unknown) one = std::round(one);
  return answer;
}

std::vector<double> levels_of_steps(const std::vector<double>& steps, const LevelProblem& problem) {
  std::vector<double> level;
  for (std::size_t g = 0; g < steps.size(); ++g) {
    const double one = problem.steps > 0 ? std::round(steps[g]) / problem.steps : steps[g];
    level.push_back(std::clamp(one, problem.range[g].low, problem.range[g].high));
  }
  return level;
}

double cost_of(const LevelProblem& problem, const std::vector<double>& level) {
  double sum = 0.0;
  for (std::size_t g = 0; g < level.size(); ++g) sum += problem.cost[g] * level[g];
  return sum;
}

}  // namespace

std::string solver_problem() { return coin_library().problem; }

LevelAnswer least_levels(const LevelProblem& problem, const BrokenConditions& broken) {
  LevelProblem any = problem;
  any.steps = 0;
  const Unknowns of_any = unknowns_of(any), of_steps = unknowns_of(problem);
  const std::size_t groups = problem.cost.size();
  std::vector<rules::LevelCondition> known;
  const auto rows_with = [&](double step) {
    Rows rows(groups);
    for (const rules::LevelCondition& condition : known) rows.add(condition, step);
    return rows;
  };
  // Any numbers first: quick, and a proof where there are none.
  std::vector<double> level;
  for (const LevelRange& range : problem.range) level.push_back(range.low);
  double least_cost = cost_of(problem, level);
  std::vector<ConditionPrice> price;
  for (int round = 0;; ++round) {
    std::vector<rules::LevelCondition> more = broken(level);
    if (more.empty()) break;
    if (round == kMostRounds || problem.is_stopped()) return {};
    for (rules::LevelCondition& one : more) known.push_back(std::move(one));
    const Solution found = solve_any(of_any, rows_with(1.0));
    if (!found.unknown) return {std::nullopt, found.is_proven};
    level = levels_of_steps(*found.unknown, any);
    least_cost = cost_of(problem, level);
    price.clear();
    for (std::size_t i = 0; i < known.size(); ++i) {
      const double cost_per_lx = found.row_price[i] * scale_of(known[i]);
      // Less than what decides between levels of the same cost is none.
      if (cost_per_lx * std::abs(known[i].at_least) > kNoPrice * least_cost ||
          cost_per_lx > kNoPrice * least_cost) {
        price.push_back({known[i], without_last_bits(cost_per_lx)});
      }
    }
  }
  if (problem.steps == 0) return {Levels{level, least_cost, least_cost, price}, false};
  for (int round = 0; round < kMostRounds && !problem.is_stopped(); ++round) {
    const Solution answer = solve_steps(of_steps, rows_with(of_steps.step));
    if (!answer.unknown) return {std::nullopt, answer.is_proven};
    level = levels_of_steps(*answer.unknown, problem);
    std::vector<rules::LevelCondition> more = broken(level);
    if (more.empty()) {
      const double cost = cost_of(problem, level);
      const double least =
          answer.is_proven ? cost : without_last_bits(std::max(least_cost, answer.bound));
      return {Levels{level, cost, least, price}, false};
    }
    for (rules::LevelCondition& one : more) known.push_back(std::move(one));
  }
  return {};
}

}  // namespace cli
