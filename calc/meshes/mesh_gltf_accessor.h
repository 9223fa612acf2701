#pragma once
// Reads numbers in the buffers of a glTF model: every index and every range of bytes is checked.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tinygltf {
class Model;
}

namespace calc::gltf {

// Thrown for an error in the file; caught in parse_gltf().
struct Broken {
  std::string what;
};

template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
  throw Broken{fmt::format(text, std::forward<Args>(args)...)};
}

template <class T>
const T& checked(const std::vector<T>& list, int index, const char* kind) {
  if (index < 0 || static_cast<std::size_t>(index) >= list.size()) {
    fail("{} {} is named, but there are {}", kind, index, list.size());
  }
  return list[static_cast<std::size_t>(index)];
}

// Returns the numbers of one accessor, `components` per element, normalised if the file says so.
// type: TINYGLTF_TYPE_VEC3 ..., which the accessor must have, with at most `most` elements. Throws
// Broken.
std::vector<double> read_accessor(const tinygltf::Model& model, int index, int type,
                                  std::size_t components, std::size_t most);

}  // namespace calc::gltf
