#include "report/text/json_layout.h"
#include "report/tools/selftest/run_result.h"

#include <nlohmann/json.hpp>

namespace cli::selftest {
namespace {

using Json = nlohmann::ordered_json;

Json number_json(const JudgedNumber& n) {
  Json json = {{"what", n.measured.what},    {"unit", n.measured.unit},
               {"exact", n.measured.exact},  {"known_to", n.measured.known_to},
               {"value", n.stated.value},    {"low_95", n.stated.low},
               {"high_95", n.stated.high},   {"is_sampled", n.is_sampled()},
               {"seeds", n.seeds},           {"held", n.held},
               {"judged_low", n.low},        {"judged_high", n.high},
               {"deviation", n.deviation()}, {"verdict", verdict_name(n.verdict)}};
  return json;
}

}  // namespace

std::string render_json(const RunResult& result, bool has_timing) {
  Json cases = Json::array();
  for (const JudgedCase& item : result.cases) {
    Json numbers = Json::array(), refused = Json::array();
    for (const JudgedNumber& n : item.numbers) numbers.push_back(number_json(n));
    for (const Refused& r : item.result.refused) {
      refused.push_back({{"what", r.what}, {"expected", r.expected}, {"said", r.said}});
    }
    Json json = {{"name", item.test.name},
                 {"kind", item.test.kind},
                 {"title", item.test.title},
                 {"source", item.test.source},
                 {"verdict", verdict_name(item.verdict)},
                 {"problem", item.result.problem}};
    if (has_timing) {
      json["seconds"] = item.seconds;
      json["rays"] = item.result.rays;
    }
    json["numbers"] = numbers;
    json["refused"] = refused;
    cases.push_back(json);
  }
  const Json json = {{"format", "luxgate-selftest"},
                     {"format_version", 1},
                     {"program_version", result.program},
                     {"seed", result.seed},
                     {"seeds", result.seeds},
                     {"family_error", kFamilyError},
                     {"most_numbers", kMostNumbers},
                     {"numbers", result.numbers()},
                     {"sampled", result.sampled()},
                     {"held_95", result.held()},
                     {"wrong", result.wrong()},
                     {"cases", cases}};
  return report::json_layout(json);
}

}  // namespace cli::selftest
