#include "report/tools/advise/advice_json_parts.h"

#include <cmath>

namespace cli {

using report::at_least_type;
using report::described_key;
using report::JsonKeys;
using report::list_of_keys;
using report::number_or_null_type;
using report::one_of_names;
using report::schema_of_keys;
using report::type_of;

namespace {

JsonKeys gain_keys(const calc::Estimate& gain) {
  return {{"value", number_or_null(gain.value), number_or_null_type()},
          {"low", number_or_null(gain.low), number_or_null_type()},
          {"high", number_or_null(gain.high), number_or_null_type()}};
}

}  // namespace

AdviceJson number_or_null(double value) {
  return std::isfinite(value) ? AdviceJson(value) : AdviceJson(nullptr);
}

AdviceJson vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

AdviceJson vector_type() {
  return {{"type", "array"}, {"items", type_of("number")}, {"minItems", 3}, {"maxItems", 3}};
}

AdviceJson index_type() {
  return described_key(at_least_type("integer", 0), "Of requirements, from 0.");
}

JsonKeys finding_keys(const rules::Finding& finding) {
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  const auto end = [&](double value) { return is_judged ? number_or_null(value) : AdviceJson(); };
  return {{"verdict", calc::name_of(finding.verdict), one_of_names<rules::Verdict>()},
          {"value", end(finding.measured.value), number_or_null_type()},
          {"low", end(finding.measured.low), number_or_null_type()},
          {"high", end(finding.measured.high), number_or_null_type()},
          {"place_m", vector_json(finding.place_m.value_or(glm::dvec3(0.0))), vector_type(), false,
           finding.place_m.has_value()},
          {"reason", finding.reason.english(), type_of("string"), false, !finding.reason.empty()}};
}

AdviceJson gains_json(const std::vector<calc::Estimate>& gains) {
  return list_by_keys(gains, gain_keys);
}

AdviceJson gains_type(const char* words) {
  return described_key(list_of_keys(schema_of_keys(gain_keys({}))), words);
}

}  // namespace cli
