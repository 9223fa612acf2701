#pragma once
// A requirement as conditions on dimming levels. Light is linear in them: of a plane whose channels
// are known, no ray is needed to say what other levels give.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/requirement.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// sum over groups of coefficient * level >= at_least; lx.
struct LevelCondition {
  std::vector<double> coefficient;  // [group]
  double at_least = 0.0;
  std::optional<std::size_t> point;  // of the grid, which it is about
  std::size_t asked_by = 0;          // for whoever collects them: of which requirement

  // How much the levels have too little, lx; <= 0: met. level: [group].
  double lack(const std::vector<double>& level) const;
};

// All conditions of one requirement; there may be as many as pairs of points, so they are asked for
// where levels break them.
class LevelConditions {
 public:
  // groups: whose levels are looked for. Channels of others, and of none (""), are at full output.
  // confidence: of the run, as judge_plane() takes it.
  // problem() says why it is no set of linear conditions, in words.
  LevelConditions(const Requirement& requirement, const calc::SensorGrid& grid,
                  const calc::PlaneField& field, const std::vector<std::string>& groups,
                  double confidence);

  const calc::Message& problem() const { return problem_; }

  // Those that these levels break most, worst first, `most` of them at most. safety: how many half
  // widths of its interval a value has to lie on the good side of its limit; < 0: how many of them
  // it may lie on the bad side, so that with -1 what no levels meet surely cannot be met. Of a sum
  // of groups they are added up, which is never less than the half width of the sum.
  std::vector<LevelCondition> broken(const std::vector<double>& level, double safety,
                                     std::size_t most) const;

  // What gives the light that one of these conditions is about, at its point or on average: each
  // group with its level, and last what no level changes; lx, [group + 1].
  std::vector<double> light_lx(const LevelCondition& condition,
                               const std::vector<double>& level) const;
  // How many lx more its conditions ask for if the limit is greater by one, with these levels; < 0
  // of a limit from above. Of a limit in lx 1 or -1; of a share what it is a share of.
  double lx_per_limit(const std::vector<double>& level) const;

 private:
  enum class Kind { each_point, average, of_average, of_maximum };
  // What each unit of level adds to a value, and half the width of its interval. [group], then the
  // light that no level changes.
  struct Light {
    std::vector<double> lx, below_lx, above_lx;
    // Likewise of intervals that hold all together, of every point and group.
    std::vector<double> sure_below_lx, sure_above_lx;
    std::vector<double> own_lx;  // of uniformities: of the point itself; else empty, and lx is

    // So many half widths below and above the value; < 0: on the other side of it, by the half
    // width that it has there where all intervals are to hold together.
    double lower_lx(std::size_t g, double half_widths) const;
    double upper_lx(std::size_t g, double half_widths) const;
  };

  LevelCondition condition(const Light& light, double safety) const;
  LevelCondition pair_condition(std::size_t least, std::size_t greatest, double safety) const;
  std::vector<LevelCondition> all(const std::vector<double>& level, double safety) const;

  Kind kind_ = Kind::each_point;
  bool is_upper_ = false;
  double limit_ = 0.0;
  std::size_t groups_ = 0;
  std::vector<Light> light_;        // one for each condition, or for each point
  std::vector<std::size_t> point_;  // of the grid; as many, but of averages none
  std::vector<double> average_lx_;  // of a share of the average; [group + 1]
  calc::Message problem_;
};

}  // namespace rules
