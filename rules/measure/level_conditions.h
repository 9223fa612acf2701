#pragma once
// Writes a requirement as conditions on dimming levels. Light is linear in the levels, so the known
// channels of a plane give the light at other levels without tracing a ray.

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
  std::size_t asked_by = 0;          // set by the caller: of which requirement

  // Returns how much light is missing at these levels, in lx; <= 0: met. level: [group].
  double lack(const std::vector<double>& level) const;
};

// All conditions of one requirement. There may be as many as pairs of points, so only those that
// given levels break are returned.
class LevelConditions {
 public:
  // groups: whose levels are wanted. Channels of other groups, and of none (""), are at full
  // output. confidence: of the run, as in judge_plane(). problem() says in words why the
  // requirement is not a set of linear conditions.
  LevelConditions(const Requirement& requirement, const calc::SensorGrid& grid,
                  const calc::PlaneField& field, const std::vector<std::string>& groups,
                  double confidence);

  const calc::Message& problem() const { return problem_; }

  // Returns the conditions that these levels break most, worst first, at most `most` of them.
  // safety: half widths of its interval by which a value must be on the good side of its limit; <
  // 0: by which it may be on the bad side, so that a condition no levels meet at -1 surely cannot
  // be met. For a sum of groups the half widths add up, never below the half width of the sum.
  std::vector<LevelCondition> broken(const std::vector<double>& level, double safety,
                                     std::size_t most) const;

  // Returns the light of one of these conditions, at its point or on average: each group at its
  // level, and last the light that no level changes; lx, [group + 1].
  std::vector<double> light_lx(const LevelCondition& condition,
                               const std::vector<double>& level) const;
  // Returns how many lx more its conditions need if the limit rises by 1, with these levels; < 0
  // for an upper limit. 1 or -1 for a limit in lx; for a share the value it is a share of.
  double lx_per_limit(const std::vector<double>& level) const;

 private:
  enum class Kind { each_point, average, of_average, of_maximum };
  // The light that each unit of level adds to a value, and half the width of its interval. [group],
  // then the light that no level changes.
  struct Light {
    std::vector<double> lx, below_lx, above_lx;
    // The same for intervals that all hold together, of every point and group.
    std::vector<double> sure_below_lx, sure_above_lx;
    std::vector<double> own_lx;  // of uniformities: of the point itself; else empty, and lx is

    // Return the light this many half widths below and above the value; < 0: on the other side, by
    // the half width of the intervals that all hold together.
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
