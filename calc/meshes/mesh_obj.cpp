#include "calc/meshes/mesh_obj.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/meshes/mesh_builder.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <istream>
#include <streambuf>
#include <utility>

namespace calc {
namespace {

constexpr std::size_t kMaxErrors = 10;
constexpr std::string_view kObjBlanks = " \t";

// Reads from memory and knows which line was read last.
class LineBuffer : public std::streambuf {
 public:
  explicit LineBuffer(std::string_view text) : text_(text) {
    // A streambuf wants mutable memory, but never writes to a get area that was set like this.
    char* begin = const_cast<char*>(text.data());
    setg(begin, begin, begin + text.size());
  }

  // Number of the last line read, from 1, and its text without the line end.
  int line_number() {
    advance();
    return line_;
  }
  std::string_view line() {
    advance();
    return text_.substr(begin_, end_ - begin_);
  }

 private:
  // The line ends are those of tinyobjloader: LF, CR LF or CR.
  void advance() {
    const auto consumed = static_cast<std::size_t>(gptr() - eback());
    while (next_ < consumed) {
      begin_ = next_;
      end_ = std::min(text_.find_first_of("\r\n", begin_), text_.size());
      next_ = text_.substr(end_).starts_with("\r\n") ? end_ + 2 : end_ + 1;
      ++line_;
    }
  }

  std::string_view text_;
  std::size_t begin_ = 0, end_ = 0, next_ = 0;
  int line_ = 0;
};

struct Face {
  std::size_t first = 0, corners = 0;      // in ObjFile::corner
  std::uint32_t material = 0, object = 0;  // in ObjFile::names
  int line = 0;
};

// What the file says, before anything is triangulated.
struct ObjFile {
  std::vector<glm::dvec3> vertex;
  std::vector<std::int64_t> corner;  // from 0
  std::vector<Face> face;
  NameList names;
};

// Takes tinyobjloader's callbacks. What it cannot read it takes for 0, and long numbers wrap
// around, so that the text of the statement is looked at as well.
class ObjCollector {
 public:
  ObjCollector(LineBuffer& lines, std::string name, Diagnostics& diagnostics)
      : lines_(lines), name_(std::move(name)), diagnostics_(diagnostics) {}

  void add_vertex() {
    const std::vector<std::string_view> words = split_words(lines_.line());
    glm::dvec3 position(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t word = static_cast<std::size_t>(axis) + 1;
      const std::optional<double> value =
          word < words.size() ? parse_number(words[word]) : std::nullopt;
      if (value && std::abs(*value) <= kMaxMeshCoordinate) {
        position[axis] = *value;
      } else {
        report(DiagnosticId::mesh_bad_vertex, lines_.line_number(), file_.vertex.size() + 1,
               shortened(arguments()), kMaxMeshCoordinate);
        break;
      }
    }
    file_.vertex.push_back(position);
  }

  void add_face(const tinyobj::index_t* index, std::size_t count) {
    const int line = lines_.line_number();
    const bool readable = is_index_list(arguments());
    file_.face.push_back({file_.corner.size(), readable ? count : 0, material_, object_, line});
    const std::size_t number = file_.face.size();
    if (!readable) {
      report(DiagnosticId::mesh_bad_face, line, number, shortened(arguments()));
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t written = index[i].vertex_index;
      const auto vertices = static_cast<std::int64_t>(file_.vertex.size());
      if (written == 0 || written < -vertices) {
        report(DiagnosticId::mesh_bad_index, line, number, written,
               fmt::format("numbers from 1, or -1 to -{} for those before the face", vertices));
      }
      file_.corner.push_back(written < 0 ? vertices + written : written - 1);
    }
  }

  void set_material(std::string_view name) { material_ = file_.names.index_of(trim(name)); }
  // Of an o or g statement; the last one counts. tinyobjloader may cut the name at a blank.
  void set_object() { object_ = file_.names.index_of(arguments()); }

  // A face may name vertices that come after it, so the upper limit is known at the end.
  void check_upper_limits() {
    const auto vertices = static_cast<std::int64_t>(file_.vertex.size());
    for (std::size_t f = 0; f < file_.face.size(); ++f) {
      const Face& face = file_.face[f];
      for (std::size_t i = 0; i < face.corners; ++i) {
        const std::int64_t corner = file_.corner[face.first + i];
        if (corner < vertices) continue;
        report(DiagnosticId::mesh_bad_index, face.line, f + 1, corner + 1,
               fmt::format("1 to {}", vertices));
      }
    }
  }

  bool failed() const { return errors_ > 0; }
  ObjFile take_file() { return std::move(file_); }

 private:
  // The text after the keyword.
  std::string_view arguments() {
    const std::string_view line = trim(lines_.line());
    return trim(line.substr(std::min(line.find_first_of(kObjBlanks), line.size())));
  }

  static std::string shortened(std::string_view text) {
    constexpr std::size_t kShown = 60;
    return text.size() <= kShown ? std::string(text) : std::string(text.substr(0, kShown)) + "...";
  }

  // Groups of up to 9 digits, signs and slashes.
  static bool is_index_list(std::string_view text) {
    std::size_t digits = 0;
    for (const char c : text) {
      digits = c >= '0' && c <= '9' ? digits + 1 : 0;
      if (digits > 9) return false;
      if (digits == 0 && std::string_view("-/ \t").find(c) == std::string_view::npos) return false;
    }
    return true;
  }

  template <class... Args>
  void report(DiagnosticId id, int line, const Args&... args) {
    ++errors_;
    if (errors_ <= kMaxErrors) {
      diagnostics_.report(id, {name_, line, 0}, args...);
    } else if (errors_ == kMaxErrors + 1) {
      diagnostics_.report(DiagnosticId::mesh_too_many_errors, {name_, line, 0});
    }
  }

  LineBuffer& lines_;
  std::string name_;
  Diagnostics& diagnostics_;
  ObjFile file_;
  std::uint32_t material_ = file_.names.index_of("");
  std::uint32_t object_ = material_;
  std::size_t errors_ = 0;
};

// A backslash at the end of a line goes on with the next one, comments do not. The lines that this
// takes away come back, empty, behind the statement: all keep their numbers.
std::string with_joined_lines(std::string_view text) {
  std::string joined;
  joined.reserve(text.size());
  std::string owed;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::size_t length = text.substr(end).starts_with("\r\n") ? 2 : 1;
    const std::string_view line = text.substr(0, end);
    const std::string_view line_end = text.substr(end, length);
    const bool is_comment = owed.empty() && trim(line).starts_with('#');
    if (line.ends_with('\\') && !line_end.empty() && !is_comment) {
      joined += line.substr(0, line.size() - 1);
      joined += ' ';
      owed += '\n';
    } else {
      joined += line;
      joined += line_end;
      joined += owed;
      owed.clear();
    }
    text.remove_prefix(end + line_end.size());
  }
  return joined;
}

bool read_statements(LineBuffer& lines, ObjCollector& collector, std::string& problem) {
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* self, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t,
                          tinyobj::real_t) { static_cast<ObjCollector*>(self)->add_vertex(); };
  callback.index_cb = [](void* self, tinyobj::index_t* index, int count) {
    static_cast<ObjCollector*>(self)->add_face(index, static_cast<std::size_t>(count));
  };
  callback.usemtl_cb = [](void* self, const char* name, int) {
    static_cast<ObjCollector*>(self)->set_material(name);
  };
  callback.group_cb = [](void* self, const char**, int) {
    static_cast<ObjCollector*>(self)->set_object();
  };
  callback.object_cb = [](void* self, const char*) {
    static_cast<ObjCollector*>(self)->set_object();
  };
  try {
    std::istream stream(&lines);
    return tinyobj::LoadObjWithCallback(stream, callback, &collector, nullptr, nullptr, &problem);
  } catch (const std::exception& exception) {
    problem = exception.what();
    return false;
  }
}

std::optional<TriangleMesh> split_faces(ObjFile file, const std::string& name,
                                        Diagnostics& diagnostics) {
  MeshBuilder builder(MeshFormat::obj, name, diagnostics);
  builder.set_vertices(std::move(file.vertex));
  std::vector<std::uint32_t> corners;
  for (const Face& face : file.face) {
    corners.clear();
    for (std::size_t i = 0; i < face.corners; ++i) {
      corners.push_back(static_cast<std::uint32_t>(file.corner[face.first + i]));
    }
    builder.set_material(file.names.names()[face.material]);
    builder.set_object(file.names.names()[face.object]);
    if (!builder.add_face(corners, face.line)) return std::nullopt;
  }
  return builder.finish();
}

}  // namespace

std::optional<TriangleMesh> parse_obj(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics) {
  if (bytes.find('\0') != std::string_view::npos) {
    diagnostics.report(DiagnosticId::mesh_not_text, {name, 0, 0}, "it has bytes that are not text");
    return std::nullopt;
  }
  const bool is_continued = bytes.find("\\\n") != bytes.npos || bytes.find("\\\r") != bytes.npos;
  const std::string joined = is_continued ? with_joined_lines(bytes) : std::string();
  LineBuffer lines(is_continued ? std::string_view(joined) : bytes);
  ObjCollector collector(lines, name, diagnostics);
  std::string problem;
  if (!read_statements(lines, collector, problem)) {
    diagnostics.report(DiagnosticId::mesh_not_text, {name, 0, 0}, problem);
    return std::nullopt;
  }
  collector.check_upper_limits();
  if (collector.failed()) return std::nullopt;
  return split_faces(collector.take_file(), name, diagnostics);
}

}  // namespace calc
