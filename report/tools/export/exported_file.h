#pragma once
// A file written by an export.

#include <string>

namespace cli {

struct ExportedFile {
  std::string name, text;  // in the folder of -o; bytes
};

}  // namespace cli
