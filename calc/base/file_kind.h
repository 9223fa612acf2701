#pragma once
// Recognises the kind of a file, so that a reader given another kind can say what it is and what to
// do instead.

#include "calc/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// What luxgate does with files. other: nothing, it does not read them.
enum class FileUse {
  mesh,
  photometry,
  project,
  gbxml,
  rule_pack,
  result,
  table,
  drawing,  // DXF and IFC: 'luxgate import' reads them
  policy,
  settings,  // TOML
  other
};

struct FileKind {
  std::string_view words;  // "a PDF document"
  FileUse use = FileUse::other;
  std::string_view advice;  // what to do with it, a sentence without its full stop; "" = none
  bool is_vague = false;    // a container: its name tells more
};

// Returns "a mesh (OBJ, STL, PLY or glTF)"; not for FileUse::other.
std::string_view words_of(FileUse use);

// Returns the kind by the contents; null where they do not tell. A binary STL may begin with
// anything: check for that first.
const FileKind* kind_by_content(std::string_view bytes);
// Returns the kind by the end of the name, in any case; null where it is not known.
const FileKind* kind_by_name(std::string_view name);

// What a file is where something else is needed.
struct OtherKind {
  std::string words;   // "it is a PDF document", "by its name it is an STL mesh"
  std::string advice;  // ". Use it as <room file=\"hall.obj\">", "" = none
};

// Empty if nothing speaks against `wanted`. The contents count; the name only if they say nothing
// and `is_recognised` is false, which is for readers that found nothing of theirs in the file.
std::optional<OtherKind> other_kind(std::string_view bytes, std::string_view name, FileUse wanted,
                                    bool is_recognised = true);

// The same as text: "it is a PDF document; a mesh (...) is needed here. ...", or "".
std::string other_kind_problem(std::string_view bytes, std::string_view name, FileUse wanted,
                               bool is_recognised = true);

// Reports the same as an error; returns false if it was reported.
bool check_file_kind(std::string_view bytes, const std::string& name, FileUse wanted,
                     Diagnostics& diagnostics, bool is_recognised = true);

}  // namespace calc
