#pragma once
// Ids of the requirements of one plane or building: given ids must differ; the others are the
// quantity's name, numbered from the second on ("average", "average-2").

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/metric.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace rules {

class RequirementIds {
 public:
  // Reports ids that are given twice.
  RequirementIds(const std::vector<calc::RequirementText>& texts, calc::Diagnostics& diagnostics);

  std::string next_for(Metric metric);

 private:
  std::map<std::string, int> line_of_given_;
  std::set<std::string> made_;
};

}  // namespace rules
