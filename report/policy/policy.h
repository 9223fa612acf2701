#pragma once
// What whoever owns the gate wants of every project, whatever the project itself says: who may live
// with what, which rows must be asked, which factors are believed. It lies outside of the projects,
// so that nobody who changes one changes what it is judged by.

#include "calc/base/diagnostics.h"
#include "calc/base/names.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Who may live with something that is not as it should be.
struct PolicyPermit {
  std::vector<std::string> by;   // exactly these names; empty: anybody
  std::optional<int> most_days;  // from the day of judging to its last day
};

// Spaces whose id or name is like a pattern of a shell ("office-*").
struct PolicySpaces {
  std::string pattern = "*";
  bool has(const std::string& id, const std::string& name) const;
};

// A row of a rule pack that each of these spaces must be asked, as a whole.
struct PolicyRow {
  std::string pack;  // with its edition: "en12464-1:2021"
  std::string row;
  std::string projects = "*";  // a pattern of a shell for their paths, without './'
  PolicySpaces spaces;
  int at_least = 1;  // so many spaces of each of these projects must be like the pattern

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

struct Policy {
  std::string file, sha256;
  std::string name;
  // Empty: nobody may.
  std::optional<PolicyPermit> waivers, deviations, left_out;
  bool allows_lowered_levels = false;  // rows may be asked below what they require
  bool asks_every_space = true;        // each space must be asked something
  std::vector<std::string> projects;   // that must be in the batch, as ends of their paths
  std::vector<PolicyRow> rows;
  std::vector<PolicyBound> bounds;
  // How loose the calculation may be; empty: as asked for.
  std::optional<double> confidence, tolerance;
  std::optional<int> replicates;
  std::optional<std::uint64_t> max_paths;
  std::vector<calc::DiagnosticId> fatal_warnings;
  std::vector<std::string> formats;  // that must be written
};

// Empty if and only if an error was reported. formats: names that are known.
std::optional<Policy> parse_policy(const std::string& bytes, const std::string& file,
                                   const std::vector<std::string_view>& formats,
                                   calc::Diagnostics& diagnostics);

// In words, a line each: what `luxgate policy explain` prints.
std::string explain_policy(const Policy& policy);

// The XML schema of such files, which `luxgate policy schema` prints.
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

}  // namespace calc
