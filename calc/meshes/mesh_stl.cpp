#include "calc/meshes/mesh_stl.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/mesh_builder.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace calc {
namespace {

constexpr std::size_t kStlHeaderBytes = 84;  // 80 of comment, 4 of count
constexpr std::size_t kTriangleBytes = 50;
static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

std::uint32_t binary_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlHeaderBytes - sizeof count, sizeof count);
  return count;
}

// Words of STL files may be in capitals.
bool is_word(std::string_view word, std::string_view lower_case) {
  if (word.size() != lower_case.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c =
        word[i] >= 'A' && word[i] <= 'Z' ? static_cast<char>(word[i] - 'A' + 'a') : word[i];
    if (c != lower_case[i]) return false;
  }
  return true;
}

std::optional<TriangleMesh> parse_binary(std::string_view bytes, const std::string& name,
                                         Diagnostics& diagnostics) {
  MeshBuilder builder(MeshFormat::stl, name, diagnostics);
  builder.set_material(kDefaultMeshMaterial);
  const std::uint32_t count = binary_count(bytes);
  if (!builder.has_room_for_vertices(std::size_t{3} * count)) return std::nullopt;
  for (std::uint32_t t = 0; t < count; ++t) {
    const char* data = bytes.data() + kStlHeaderBytes + kTriangleBytes * t;
    std::array<float, 12> number;  // the normal, then three corners
    std::memcpy(number.data(), data, sizeof number);
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const float* p = &number[3 * corner];
      if (!builder.add_vertex(glm::dvec3(p[0], p[1], p[2]), [&] {
            return fmt::format("triangle {}, corner {}", t + 1, corner);
          })) {
        return std::nullopt;
      }
    }
    const std::array<std::uint32_t, 3> face{3 * t, 3 * t + 1, 3 * t + 2};
    if (!builder.add_face(face, 0)) return std::nullopt;
  }
  return builder.finish();
}

// The statements of a text STL, each of which has its place.
class StlText {
 public:
  StlText(const std::string& name, Diagnostics& diagnostics)
      : name_(name), diagnostics_(diagnostics), builder_(MeshFormat::stl, name, diagnostics) {
    builder_.set_material(kDefaultMeshMaterial);
  }

  bool read(std::string_view bytes) {
    LineCursor lines(bytes);
    while (const std::optional<std::string_view> text = lines.next()) {
      line_ = lines.line();
      const std::vector<std::string_view> words = split_words(*text);
      if (!words.empty() && !statement(trim(*text), words)) return false;
    }
    if (state_ != State::outside) return broken("it ends within a solid");
    return true;
  }

  std::optional<TriangleMesh> finish() { return builder_.finish(); }

 private:
  enum class State { outside, solid, facet, loop, closed_loop };

  bool statement(std::string_view text, const std::vector<std::string_view>& words) {
    const std::string_view word = words[0];
    const bool is_outer_loop =
        words.size() == 2 && is_word(word, "outer") && is_word(words[1], "loop");
    if (state_ == State::outside && is_word(word, "solid")) {
      builder_.set_object(trim(text.substr(word.size())));
      return go(State::solid);
    }
    if (state_ == State::solid && is_word(word, "endsolid")) return go(State::outside);
    if (state_ == State::solid && is_word(word, "facet")) return go(State::facet);
    if (state_ == State::facet && is_outer_loop) {
      corner_.clear();
      facet_line_ = line_;
      return go(State::loop);
    }
    if (state_ == State::loop && is_word(word, "vertex")) return vertex(words);
    if (state_ == State::loop && is_word(word, "endloop")) return go(State::closed_loop);
    if (state_ == State::closed_loop && is_word(word, "endfacet")) return end_facet();
    return broken(fmt::format("unexpected '{}'", shorten_utf8(text, 40)));
  }

  bool vertex(const std::vector<std::string_view>& words) {
    glm::dvec3 position(0.0);
    if (words.size() != 4) return broken("a vertex needs three numbers");
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words[static_cast<std::size_t>(axis) + 1];
      const std::optional<double> value = parse_number(word);
      if (!value) return broken(fmt::format("'{}' is not a finite number", shorten_utf8(word, 40)));
      position[axis] = *value;
    }
    corner_.push_back(static_cast<std::uint32_t>(builder_.vertices()));
    return builder_.add_vertex(position, [&] { return fmt::format("line {}", line_); });
  }

  bool end_facet() {
    if (corner_.size() != 3) {
      return broken(fmt::format("a facet has {} corners; 3 are needed", corner_.size()));
    }
    return builder_.add_face(corner_, facet_line_) && go(State::solid);
  }

  bool go(State state) {
    state_ = state;
    return true;
  }

  bool broken(const std::string& what) {
    diagnostics_.report(DiagnosticId::mesh_broken, {name_, line_, 0}, "STL", what);
    return false;
  }

  const std::string& name_;
  Diagnostics& diagnostics_;
  MeshBuilder builder_;
  State state_ = State::outside;
  std::vector<std::uint32_t> corner_;
  int line_ = 0, facet_line_ = 0;
};

void report_not_stl(std::string_view bytes, const std::string& name, Diagnostics& diagnostics) {
  std::string what = "neither text that begins with 'solid' nor the 84 bytes of a binary header";
  if (bytes.size() >= kStlHeaderBytes) {
    const std::uint64_t count = binary_count(bytes);
    what = fmt::format("a binary file of {} triangles has {} bytes, this one has {}", count,
                       kStlHeaderBytes + kTriangleBytes * count, bytes.size());
  }
  diagnostics.report(DiagnosticId::mesh_broken, {name, 0, 0}, "STL", what);
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= kStlHeaderBytes &&
         bytes.size() == kStlHeaderBytes + kTriangleBytes * std::uint64_t{binary_count(bytes)};
}

bool is_text_stl(std::string_view bytes) {
  const std::string_view start = trim(bytes.substr(0, 200));
  return start.size() > 5 && is_word(start.substr(0, 5), "solid") &&
         std::string_view(" \t\r\n").find(start[5]) != std::string_view::npos &&
         bytes.find('\0') == std::string_view::npos;
}

std::optional<TriangleMesh> parse_stl(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics) {
  if (is_binary_stl(bytes)) return parse_binary(bytes, name, diagnostics);
  if (is_text_stl(bytes)) {
    StlText text(name, diagnostics);
    if (!text.read(bytes)) return std::nullopt;
    return text.finish();
  }
  report_not_stl(bytes, name, diagnostics);
  return std::nullopt;
}

}  // namespace calc
