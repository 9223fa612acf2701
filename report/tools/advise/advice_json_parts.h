#pragma once
// Keys that the JSON of levels and of rooms share.

#include "report/text/json_keys.h"
#include "rules/catalogue/finding.h"

#include <glm/glm.hpp>

#include <vector>

namespace cli {

using AdviceJson = report::KeyedJson;

// Returns the number; null if it is not finite.
AdviceJson number_or_null(double value);
AdviceJson vector_json(const glm::dvec3& v);
AdviceJson vector_type();  // of three numbers
// Returns the type of indices of requirements, from 0.
AdviceJson index_type();

// Returns the measured value and the verdict.
report::JsonKeys finding_keys(const rules::Finding& finding);
// Returns value, low and high; [requirement].
AdviceJson gains_json(const std::vector<calc::Estimate>& gains);
AdviceJson gains_type(const char* words);

// Returns a list. keys(item): the keys of an item.
template <class Item, class Keys>
AdviceJson list_by_keys(const std::vector<Item>& items, const Keys& keys) {
  AdviceJson json = AdviceJson::array();
  for (const Item& item : items) json.push_back(report::object_of_keys(keys(item)));
  return json;
}

}  // namespace cli
