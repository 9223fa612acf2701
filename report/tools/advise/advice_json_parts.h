#pragma once
// Keys of parts that the JSON of levels and that of rooms have in common.

#include "report/text/json_keys.h"
#include "rules/catalogue/finding.h"

#include <glm/glm.hpp>

#include <vector>

namespace cli {

using AdviceJson = report::KeyedJson;

// Not finite: null.
AdviceJson number_or_null(double value);
AdviceJson vector_json(const glm::dvec3& v);
AdviceJson vector_type();  // of three numbers
// Of requirements, from 0.
AdviceJson index_type();

// What was measured, and the verdict.
report::JsonKeys finding_keys(const rules::Finding& finding);
// value, low and high; [requirement].
AdviceJson gains_json(const std::vector<calc::Estimate>& gains);
AdviceJson gains_type(const char* words);

// keys(item): of one of them.
template <class Item, class Keys>
AdviceJson list_by_keys(const std::vector<Item>& items, const Keys& keys) {
  AdviceJson json = AdviceJson::array();
  for (const Item& item : items) json.push_back(report::object_of_keys(keys(item)));
  return json;
}

}  // namespace cli
