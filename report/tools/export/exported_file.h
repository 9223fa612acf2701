#pragma once
// What an export writes.

#include <string>

namespace cli {

struct ExportedFile {
  std::string name, text;  // in the folder of -o; bytes
};

}  // namespace cli
