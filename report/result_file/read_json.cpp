#include "report/result_file/read_json.h"

#include "report/document/same_bits.h"
#include "report/result_file/json_cursor.h"
#include "report/result_file/read_json_parts.h"

#include <array>
#include <nlohmann/json.hpp>

namespace report {
namespace {

Provenance provenance(const JsonCursor& at) {
  Provenance p;
  p.program_version = at["program_version"].text();
  p.command_line = at["command_line"].text();
  p.seed = at["seed"].count();
  p.confidence = at["confidence"].finite();
  p.goal =
      at["goal"].one_of(std::array{rules::Goal::verdict, rules::Goal::accuracy}, rules::goal_name);
  p.tolerance = at["tolerance"].finite();
  p.max_paths = at["max_paths"].count();
  p.replicates = read_whole(at["replicates"]);
  p.backend = at["backend"].text();
  p.numbers_version = read_whole(at["numbers_version"]);
  p.same_bits = at["same_bits_on"].one_of(
      std::array{SameBits::any_processor, SameBits::same_device, SameBits::nowhere},
      same_bits_name);
  if (const auto timestamp = at.find("timestamp")) p.timestamp = timestamp->text();
  if (const auto redacted = at.find("redacted")) p.is_redacted = redacted->flag();
  return p;
}

calc::Diagnostic diagnostic(const JsonCursor& at) {
  const std::optional<calc::DiagnosticId> id = calc::diagnostic_from_name(at["id"].text());
  if (!id) at["id"].refuse("no message of this program has that id");
  return {*id, read_location(at["where"]), at["message"].text()};
}

PhaseTimes times(const JsonCursor& at) {
  PhaseTimes t;
  t.load_s = at["load_s"].finite();
  t.prepare_s = at["prepare_s"].finite();
  t.direct_s = at["direct_s"].finite();
  t.pool_s = at["pool_s"].finite();
  t.connect_s = at["connect_s"].finite();
  t.near_s = at["near_s"].finite();
  if (const auto maps = at.find("maps_s")) t.maps_s = maps->finite();
  t.judge_s = at["judge_s"].finite();
  t.total_s = at["total_s"].finite();
  return t;
}

ProjectPart project(const JsonCursor& at) {
  ProjectPart p;
  p.path = at["path"].text();
  p.name = at["name"].text();
  p.is_judged = at["is_judged"].flag();
  p.diagnostics = at["diagnostics"].list_of(diagnostic);
  p.luminaires = at["luminaires"].list_of(read_luminaire);
  p.spaces = at["spaces"].list_of(read_space);
  p.inputs = at["inputs"].list_of([](const JsonCursor& input) {
    return calc::InputFile{input["path"].text(), input["sha256"].text()};
  });
  if (const auto found = at.find("aggregates")) p.aggregates = found->list_of(read_aggregate);
  if (const auto found = at.find("times")) p.times = times(*found);
  return p;
}

Document document(const JsonCursor& at) {
  if (at["format"].text() != "luxgate-result") at["format"].refuse("'luxgate-result' is needed");
  at["format_version"].whole(1, 1);
  return {provenance(at["provenance"]), at["projects"].list_of(project)};
}

}  // namespace

std::optional<Document> read_json(std::string_view bytes, std::string& problem) {
  try {
    const nlohmann::json json = nlohmann::json::parse(bytes);
    return document(JsonCursor(json));
  } catch (const BadJson& bad) {
    problem = bad.what();
  } catch (const nlohmann::json::exception& error) {
    problem = std::string("it is not JSON: ") + error.what();
  }
  return std::nullopt;
}

}  // namespace report
