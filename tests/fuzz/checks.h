#pragma once
// What holds for every result of a reader, whatever its input. A check that fails says so and
// aborts, which the fuzzer and the standalone driver count as a crash.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"
#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

void require(bool holds, std::string_view what);

// Every vertex finite, every index in range.
void check_triangles(const std::vector<glm::dvec3>& vertex,
                     const std::vector<glm::uvec3>& triangle);
// As PhotometricWeb and the readers of photometry promise it.
void check_web(const calc::PhotometricWeb& web);
void check_mesh(const calc::TriangleMesh& mesh);

// A result is empty if and only if an error was reported; each message is one line.
void check_messages(bool has_result, const calc::Diagnostics& diagnostics);
// For files that must be readable: prints the messages if there is an error, and aborts.
void require_no_error(const calc::Diagnostics& diagnostics, std::string_view what);
// How often there was a result: seeds of which none is read test little.
std::size_t results();
// For targets whose results check_messages() does not see.
void count_result();

// An input may hold two files, one after the other, with this line between them.
inline constexpr std::string_view kSecondFile = "\n@@SECOND FILE@@\n";
struct TwoFiles {
  std::string_view first;
  std::string second;  // "" = there is none
};
TwoFiles split_files(std::string_view input);

}  // namespace fuzz
