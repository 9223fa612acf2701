#include "calc/meshes/mesh_ply.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace calc {
namespace {

enum class Encoding { ascii, little, big };

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
constexpr std::array<std::size_t, 8> kTypeBytes{1, 1, 2, 2, 4, 4, 4, 8};

struct Property {
  std::string name;
  Type type = Type::int8;
  std::optional<Type> count_type;  // given: a list of `type`
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> property;
};

struct Header {
  std::optional<Encoding> encoding;
  std::vector<Element> element;
  std::size_t bytes = 0;  // up to the data
  int lines = 0;
};

std::optional<Type> type_of_name(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Type>, 16> kNames{
      {{"char", Type::int8},
       {"int8", Type::int8},
       {"uchar", Type::uint8},
       {"uint8", Type::uint8},
       {"short", Type::int16},
       {"int16", Type::int16},
       {"ushort", Type::uint16},
       {"uint16", Type::uint16},
       {"int", Type::int32},
       {"int32", Type::int32},
       {"uint", Type::uint32},
       {"uint32", Type::uint32},
       {"float", Type::float32},
       {"float32", Type::float32},
       {"double", Type::float64},
       {"float64", Type::float64}}};
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  return std::nullopt;
}

bool is_whole(Type type) { return type != Type::float32 && type != Type::float64; }

template <class T>
double number_from(const char* data, bool swap) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), data, sizeof(T));
  if (swap) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<T>(bytes));
}

double number_from(Type type, const char* data, bool swap) {
  switch (type) {
    case Type::int8:
      return number_from<std::int8_t>(data, swap);
    case Type::uint8:
      return number_from<std::uint8_t>(data, swap);
    case Type::int16:
      return number_from<std::int16_t>(data, swap);
    case Type::uint16:
      return number_from<std::uint16_t>(data, swap);
    case Type::int32:
      return number_from<std::int32_t>(data, swap);
    case Type::uint32:
      return number_from<std::uint32_t>(data, swap);
    case Type::float32:
      return number_from<float>(data, swap);
    case Type::float64:
      break;
  }
  return number_from<double>(data, swap);
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, Diagnostics& diagnostics)
      : bytes_(bytes),
        name_(name),
        diagnostics_(diagnostics),
        builder_(MeshFormat::ply, name, diagnostics) {
    builder_.set_material(kDefaultMeshMaterial);
  }

  std::optional<TriangleMesh> run() {
    if (!read_header()) return std::nullopt;
    at_ = header_.bytes;
    line_ = header_.lines + 1;
    for (const Element& element : header_.element) {
      if (!read_element(element)) return std::nullopt;
    }
    return builder_.finish();
  }

 private:
  bool read_header() {
    LineCursor lines(bytes_);
    lines.next();  // "ply"
    while (const std::optional<std::string_view> text = lines.next()) {
      line_ = lines.line();
      const std::vector<std::string_view> words = split_words(*text);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        header_.bytes = bytes_.size() - lines.rest().size();
        header_.lines = line_;
        return check_header();
      }
      if (!read_header_line(*text, words)) return false;
    }
    return broken("its header has no end");
  }

  bool read_header_line(std::string_view text, const std::vector<std::string_view>& words) {
    if (words[0] == "format" && words.size() == 3 && words[2] == "1.0") {
      if (words[1] == "ascii") header_.encoding = Encoding::ascii;
      if (words[1] == "binary_little_endian") header_.encoding = Encoding::little;
      if (words[1] == "binary_big_endian") header_.encoding = Encoding::big;
      if (header_.encoding) return true;
    }
    if (words[0] == "element" && words.size() == 3) {
      const std::optional<double> count = parse_number(words[2]);
      constexpr double kMost = 1.0e15;
      if (count && *count >= 0.0 && *count <= kMost && *count == std::floor(*count)) {
        header_.element.push_back({std::string(words[1]), static_cast<std::uint64_t>(*count), {}});
        return true;
      }
    }
    if (words[0] == "property" && !header_.element.empty()) {
      if (const std::optional<Property> property = read_property(words)) {
        header_.element.back().property.push_back(*property);
        return true;
      }
    }
    return broken(fmt::format("unknown header line '{}'", shorten_utf8(text, 60)));
  }

  static std::optional<Property> read_property(const std::vector<std::string_view>& words) {
    if (words.size() == 3) {
      if (const std::optional<Type> type = type_of_name(words[1])) {
        return Property{std::string(words[2]), *type, std::nullopt};
      }
    } else if (words.size() == 5 && words[1] == "list") {
      const std::optional<Type> count = type_of_name(words[2]);
      const std::optional<Type> type = type_of_name(words[3]);
      if (count && type && is_whole(*count)) return Property{std::string(words[4]), *type, count};
    }
    return std::nullopt;
  }

  bool check_header() {
    if (!header_.encoding) return broken("its header has no format line");
    bool has_vertices = false;
    for (const Element& element : header_.element) {
      if (element.name == "tristrips" && element.count > 0) {
        return broken("triangle strips are not read; export the mesh with faces");
      }
      if (element.name == "face" && !has_vertices) {
        return broken("its faces come before its vertices");
      }
      has_vertices = has_vertices || element.name == "vertex";
    }
    return true;
  }

  // At least this many bytes belong to each of the element.
  std::size_t least_bytes(const Element& element) const {
    std::size_t bytes = 0;
    for (const Property& property : element.property) {
      const Type first = property.count_type.value_or(property.type);
      bytes +=
          header_.encoding == Encoding::ascii ? 1 : kTypeBytes[static_cast<std::size_t>(first)];
    }
    return bytes;
  }

  bool read_element(const Element& element) {
    const std::size_t least = least_bytes(element);
    if (element.count == 0) return true;
    if (least == 0) return broken(fmt::format("element '{}' has no properties", element.name));
    if (element.count > (bytes_.size() - at_) / least) {
      return broken(fmt::format("its header states {} of '{}', but only {} bytes follow",
                                element.count, element.name, bytes_.size() - at_));
    }
    if (element.name == "vertex") return read_vertices(element);
    if (element.name == "face") return read_faces(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.property) {
        if (!skip(property)) return false;
      }
    }
    return true;
  }

  bool read_vertices(const Element& element) {
    std::array<std::size_t, 3> column{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view name = std::string_view("xyz").substr(axis, 1);
      const auto found =
          std::find_if(element.property.begin(), element.property.end(),
                       [&](const Property& p) { return p.name == name && !p.count_type; });
      if (found == element.property.end()) {
        return broken(fmt::format("its vertices have no property '{}'", name));
      }
      column[axis] = static_cast<std::size_t>(found - element.property.begin());
    }
    if (!builder_.has_room_for_vertices(element.count)) return false;
    for (std::uint64_t v = 0; v < element.count; ++v) {
      glm::dvec3 position(0.0);
      for (std::size_t p = 0; p < element.property.size(); ++p) {
        double value = 0.0;
        if (element.property[p].count_type) {
          if (!skip(element.property[p])) return false;
        } else if (!read(element.property[p].type, value)) {
          return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
          if (column[static_cast<std::size_t>(axis)] == p) position[axis] = value;
        }
      }
      if (!builder_.add_vertex(position, [&] { return fmt::format("vertex {}", v + 1); })) {
        return false;
      }
    }
    return true;
  }

  bool read_faces(const Element& element) {
    const auto corners =
        std::find_if(element.property.begin(), element.property.end(), [](const Property& p) {
          return (p.name == "vertex_indices" || p.name == "vertex_index") && p.count_type &&
                 is_whole(p.type);
        });
    if (corners == element.property.end()) {
      return broken("its faces have no list of whole numbers 'vertex_indices'");
    }
    for (std::uint64_t f = 0; f < element.count; ++f) {
      const int line = header_.encoding == Encoding::ascii ? line_ : 0;
      for (auto p = element.property.begin(); p != element.property.end(); ++p) {
        if (p == corners ? !read_corners(*p, f) : !skip(*p)) return false;
      }
      if (!builder_.add_face(corner_, line)) return false;
    }
    return true;
  }

  bool read_corners(const Property& property, std::uint64_t face) {
    std::size_t count = 0;
    if (!read_count(property, count)) return false;
    corner_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      double index = 0.0;
      if (!read(property.type, index)) return false;
      if (!(index >= 0.0 && index < static_cast<double>(builder_.vertices()))) {
        diagnostics_.report(DiagnosticId::mesh_bad_index, place(), face + 1, index,
                            builder_.vertices() > 0
                                ? fmt::format("0 to {}", builder_.vertices() - 1)
                                : std::string("none, there are no vertices"));
        return false;
      }
      corner_.push_back(static_cast<std::uint32_t>(index));
    }
    return true;
  }

  // Of a list: no more than what is there.
  bool read_count(const Property& property, std::size_t& count) {
    double number = 0.0;
    if (!read(*property.count_type, number)) return false;
    const std::size_t least = header_.encoding == Encoding::ascii
                                  ? 1
                                  : kTypeBytes[static_cast<std::size_t>(property.type)];
    if (!(number >= 0.0 && number <= static_cast<double>((bytes_.size() - at_) / least))) {
      return broken(fmt::format("a list '{}' of {} numbers does not fit into the {} bytes left",
                                property.name, number, bytes_.size() - at_));
    }
    count = static_cast<std::size_t>(number);
    return true;
  }

  bool skip(const Property& property) {
    double ignored = 0.0;
    if (!property.count_type) return read(property.type, ignored);
    std::size_t count = 0;
    if (!read_count(property, count)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (!read(property.type, ignored)) return false;
    }
    return true;
  }

  bool read(Type type, double& value) {
    return header_.encoding == Encoding::ascii ? read_text(type, value) : read_binary(type, value);
  }

  bool read_binary(Type type, double& value) {
    const std::size_t size = kTypeBytes[static_cast<std::size_t>(type)];
    if (size > bytes_.size() - at_) return broken("it ends within its data");
    const bool swap =
        (header_.encoding == Encoding::big) != (std::endian::native == std::endian::big);
    value = number_from(type, bytes_.data() + at_, swap);
    at_ += size;
    return true;
  }

  bool read_text(Type type, double& value) {
    constexpr std::string_view kPlyBlanks = " \t\r\n\v\f";
    while (at_ < bytes_.size() && kPlyBlanks.find(bytes_[at_]) != std::string_view::npos) {
      if (bytes_[at_] == '\n') ++line_;
      ++at_;
    }
    if (at_ == bytes_.size()) return broken("it ends within its data");
    const std::size_t end = std::min(bytes_.find_first_of(kPlyBlanks, at_), bytes_.size());
    const std::string_view word = bytes_.substr(at_, end - at_);
    const std::optional<double> number = parse_number(word);
    if (!number || (is_whole(type) && *number != std::floor(*number))) {
      return broken(fmt::format("'{}' is not a finite {}number", shorten_utf8(word, 40),
                                is_whole(type) ? "whole " : ""));
    }
    value = *number;
    at_ = end;
    return true;
  }

  SourceLocation place() const {
    const bool is_text = header_.bytes == 0 || header_.encoding == Encoding::ascii;
    return {name_, is_text ? line_ : 0, 0};
  }

  bool broken(const std::string& what) {
    diagnostics_.report(DiagnosticId::mesh_broken, place(), "PLY", what);
    return false;
  }

  std::string_view bytes_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  MeshBuilder builder_;
  Header header_;
  std::vector<std::uint32_t> corner_;
  std::size_t at_ = 0;
  int line_ = 0;
};

}  // namespace

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

std::optional<TriangleMesh> parse_ply(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics) {
  if (!is_ply(bytes)) {
    diagnostics.report(DiagnosticId::mesh_broken, SourceLocation{name, 0, 0}, "PLY",
                       "its first line is not 'ply'");
    return std::nullopt;
  }
  return PlyReader(bytes, name, diagnostics).run();
}

}  // namespace calc
