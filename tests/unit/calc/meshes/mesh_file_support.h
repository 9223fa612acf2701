#pragma once
// A mesh file read in a test.

#include "calc/base/diagnostic_ids.h"
#include "calc/meshes/mesh_file.h"
#include "tests/support/mesh_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace calc::tests {

struct Parsed {
  std::optional<TriangleMesh> mesh;
  std::string messages;  // one per line
};

inline Parsed parse(const std::string& bytes, const std::string& name,
                    const std::map<std::string, std::string>& beside = {}) {
  Diagnostics diagnostics;
  Parsed parsed;
  const SideFiles side_files = [&](const std::string& path) -> std::optional<std::string> {
    const auto found = beside.find(path);
    if (found != beside.end()) return found->second;
    diagnostics.report(DiagnosticId::file_not_readable, SourceLocation{name, 0, 0}, path, "absent");
    return std::nullopt;
  };
  parsed.mesh = parse_mesh_file(bytes, name, side_files, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    parsed.messages += (parsed.messages.empty() ? "" : "\n") + format_diagnostic(d);
  }
  EXPECT_EQ(parsed.mesh.has_value(), !diagnostics.has_errors()) << parsed.messages;
  return parsed;
}

inline double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangle) {
    sum += 0.5 * glm::length(glm::cross(mesh.vertex[t.y] - mesh.vertex[t.x],
                                        mesh.vertex[t.z] - mesh.vertex[t.x]));
  }
  return sum;
}

inline glm::dvec3 upper_corner(const TriangleMesh& mesh) {
  glm::dvec3 upper = mesh.vertex.at(0);
  for (const glm::dvec3& v : mesh.vertex) upper = glm::max(upper, v);
  return upper;
}

// Every cut of a file ends in a mesh or an error.
inline void expect_cuts_end_well(const std::string& bytes, const std::string& name,
                                 const std::map<std::string, std::string>& beside = {}) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Parsed parsed = parse(bytes.substr(0, size), name, beside);
    if (parsed.mesh) continue;
    EXPECT_NE(parsed.messages, "") << size;
  }
}

}  // namespace calc::tests
