#pragma once
// The conditions that the owner of a gate sets for every project, whatever the project itself
// states: permitted exceptions, required rows, accepted factors. The policy is outside of the
// projects, so that a change of a project cannot change it.

#include "calc/base/diagnostics.h"
#include "calc/base/names.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// The persons who may permit an exception.
struct PolicyPermit {
  std::vector<std::string> by;   // exactly these names; empty: anybody
  std::optional<int> most_days;  // from the day of judging to its last day
};

// Spaces whose id or name matches a shell pattern ("office-*").
struct PolicySpaces {
  std::string pattern = "*";
  bool has(const std::string& id, const std::string& name) const;
};

// The planes on which a row is judged.
enum class PolicyZones {
  any,        // planes of the project's own, too
  workplace,  // made by a <workplace> as the pack wants them, around the task that it states
  unchanged,  // likewise, and the project changes none of them
};

// A row of a rule pack that each of these spaces must require as a whole.
struct PolicyRow {
  std::string pack;  // with its edition: "en12464-1:2021"
  std::string row;
  std::string projects = "*";  // a pattern of a shell for their paths, without './'
  PolicySpaces spaces;
  int at_least = 1;  // so many spaces of each of these projects must be like the pattern
  PolicyZones zones = PolicyZones::any;
  // Planes of this role of the row must cover this share of the room's floor.
  std::string role = "task";
  std::optional<double> floor_share;

  bool is_for(const std::string& project_path) const;
};

enum class PolicyBoundOf {
  maintenance_factor,  // of a luminaire type
  reflectance,         // of a material
  flux_ratio,          // of a luminaire type: the project's flux to that of the photometry file
  power_ratio,         // likewise its power
};

struct PolicyBound {
  PolicyBoundOf of = PolicyBoundOf::reflectance;
  std::optional<double> at_least, at_most;
};

// A fact that projects may state, whose value changes a limit of the pack.
struct PolicyFact {
  std::string pack, id;
  std::optional<double> at_least, at_most;  // in the pack's base unit
};

// The requirements that every space must have.
enum class PolicyEverySpace {
  row,       // what an <asked> wants of it; if there is none at all, anything
  anything,  // something that counts
  nothing,
};

struct Policy {
  std::string file, sha256;
  std::string name;
  // Empty: not permitted.
  std::optional<PolicyPermit> waivers, deviations, left_out;
  bool allows_lowered_levels = false;  // rows may be asked below what they require
  PolicyEverySpace every_space = PolicyEverySpace::row;
  std::vector<std::string> projects;  // that must be in the batch, as ends of their paths
  std::vector<PolicyRow> rows;
  std::vector<PolicyBound> bounds;
  std::vector<PolicyFact> facts;
  std::vector<std::string> photometry;  // SHA-256 of the files that may be used; empty: any
  // Loosest allowed calculation; empty: as requested.
  std::optional<double> confidence, tolerance;
  std::optional<int> replicates;
  std::optional<std::uint64_t> max_paths;
  std::vector<calc::DiagnosticId> fatal_warnings;
  bool are_all_warnings_fatal = false;
  std::vector<std::string> formats;  // that must be written
};

// Returns the policy; empty exactly if an error was reported. formats: known names.
std::optional<Policy> parse_policy(const std::string& bytes, const std::string& file,
                                   const std::vector<std::string_view>& formats,
                                   calc::Diagnostics& diagnostics);

// Returns the policy in words, a line each, as `luxgate policy explain` prints it.
std::string explain_policy(const Policy& policy);

// Returns the XML schema of policies, which `luxgate policy schema` prints.
std::string policy_schema();

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::PolicyBoundOf> {
  static constexpr EnumName<report::PolicyBoundOf> list[] = {
      {report::PolicyBoundOf::maintenance_factor, "maintenance-factor"},
      {report::PolicyBoundOf::reflectance, "reflectance"},
      {report::PolicyBoundOf::flux_ratio, "flux-ratio"},
      {report::PolicyBoundOf::power_ratio, "power-ratio"}};
};

template <>
struct EnumNames<report::PolicyZones> {
  static constexpr EnumName<report::PolicyZones> list[] = {
      {report::PolicyZones::any, "any"},
      {report::PolicyZones::workplace, "workplace"},
      {report::PolicyZones::unchanged, "unchanged"}};
};

template <>
struct EnumNames<report::PolicyEverySpace> {
  static constexpr EnumName<report::PolicyEverySpace> list[] = {
      {report::PolicyEverySpace::row, "row"},
      {report::PolicyEverySpace::anything, "anything"},
      {report::PolicyEverySpace::nothing, "nothing"}};
};

}  // namespace calc
