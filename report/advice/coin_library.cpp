#include "report/advice/coin_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <initializer_list>

namespace cli {
namespace {

CoinLibrary opened() {
  CoinLibrary coin;
  void* files[2] = {nullptr, nullptr};
  int count = 0;
  for (const char* file : {"libClp.so.1", "libCbcSolver.so.3"}) {
    files[count] = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (files[count] == nullptr) {
      coin.problem =
          fmt::format("the solver {} is not installed (Debian: apt install coinor-libcbc3)", file);
      return coin;
    }
    ++count;
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
