#include "report/advice/coin_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <initializer_list>

namespace cli {
namespace {

CoinLibrary opened() {
  CoinLibrary coin;
  const auto open = [](std::initializer_list<const char*> names) {
    void* file = nullptr;
    for (const char* name : names) {
      if (file == nullptr) file = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    }
    return file;
  };
  // CBC after 2.10.8 has another name, not other functions: Debian 13 and Ubuntu 24.04 have the
  // first, Debian 12 the second.
  void* const files[] = {open({"libClp.so.1"}), open({"libCbcSolver.so.3.1", "libCbcSolver.so.3"})};
  if (files[0] == nullptr || files[1] == nullptr) {
    coin.problem =
        "the solver CBC is not installed (apt install coinor-libcbc3.1; on Debian 12 "
        "coinor-libcbc3)";
    return coin;
  }
  const auto find = [&](const char* name) -> void* {
    void* found = dlsym(files[0], name);
    if (found == nullptr) found = dlsym(files[1], name);
    if (found == nullptr) coin.problem = fmt::format("the solvers CLP and CBC have no '{}'", name);
    return found;
  };
  const auto set = [&]<class Function>(Function*& target, const char* name) {
    target = reinterpret_cast<Function*>(find(name));
  };
#define COIN_FIND(name) set(coin.name, #name);
  COIN_FUNCTIONS(COIN_FIND)
#undef COIN_FIND
  return coin;
}

}  // namespace

const CoinLibrary& coin_library() {
  static const CoinLibrary coin = opened();
  return coin;
}

}  // namespace cli
