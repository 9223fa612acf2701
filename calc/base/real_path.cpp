#include "calc/base/real_path.h"

#include <list>
#include <system_error>

namespace calc {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  fs::path done = whole.root_path();
  std::list<fs::path> rest(whole.begin(), whole.end());
  int links = 0;
  while (!rest.empty()) {
    const fs::path part = rest.front();
    rest.pop_front();
    if (part.empty() || part == "." || part == whole.root_path()) continue;
    if (part == "..") {
      done = done.parent_path();
      continue;
    }
    const fs::path next = done / part;
    if (links >= kMostLinks || !fs::is_symlink(fs::symlink_status(next, error))) {
      done = next;
      continue;
    }
    const fs::path target = fs::read_symlink(next, error);
    if (error) {
      done = next;
      continue;
    }
    ++links;
    if (target.is_absolute()) done = target.root_path();
    rest.insert(rest.begin(), target.begin(), target.end());
  }
  return done;
}

}  // namespace calc
