#include "report/git/git_handles.h"

#include <fmt/format.h>

#include <iterator>

namespace git {

Library::Library() {
  git_libgit2_init();
  // What these ask of a program that only reads is kept: to ask nobody for missing objects, to
  // delete nothing; sparse checkouts keep their settings in a file of their own.
  const char* harmless[] = {"partialclone", "preciousobjects", "worktreeconfig"};
  git_libgit2_opts(GIT_OPT_SET_EXTENSIONS, harmless, std::size(harmless));
}

Library::~Library() { git_libgit2_shutdown(); }

std::string said() {
  const git_error* error = git_error_last();
  if (error == nullptr || error->message == nullptr) return "";
  return fmt::format(" ({})", error->message);
}

std::string hex_of(const git_oid& id) {
  std::string hex(GIT_OID_HEXSZ, '0');
  git_oid_fmt(hex.data(), &id);
  return hex;
}

}  // namespace git
