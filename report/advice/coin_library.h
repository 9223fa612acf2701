#pragma once
// Loads COIN-OR's solvers CLP and CBC when they are needed: otherwise every other command would
// take half as long again to start, and few machines need them.

#include <coin/Cbc_C_Interface.h>
#include <coin/Clp_C_Interface.h>

#include <string>

namespace cli {

// Functions of their C interfaces under their own names.
struct CoinLibrary {
#define COIN_FUNCTIONS(FUNCTION)        \
  FUNCTION(Clp_newModel)                \
  FUNCTION(Clp_deleteModel)             \
  FUNCTION(Clp_setLogLevel)             \
  FUNCTION(Clp_loadProblem)             \
  FUNCTION(Clp_dual)                    \
  FUNCTION(Clp_primal)                  \
  FUNCTION(Clp_status)                  \
  FUNCTION(Clp_getColSolution)          \
  FUNCTION(Clp_getRowPrice)             \
  FUNCTION(Cbc_newModel)                \
  FUNCTION(Cbc_deleteModel)             \
  FUNCTION(Cbc_setLogLevel)             \
  FUNCTION(Cbc_loadProblem)             \
  FUNCTION(Cbc_setInteger)              \
  FUNCTION(Cbc_setMaximumNodes)         \
  FUNCTION(Cbc_setParameter)            \
  FUNCTION(Cbc_solve)                   \
  FUNCTION(Cbc_isProvenOptimal)         \
  FUNCTION(Cbc_isProvenInfeasible)      \
  FUNCTION(Cbc_numberSavedSolutions)    \
  FUNCTION(Cbc_getBestPossibleObjValue) \
  FUNCTION(Cbc_getColSolution)
#define COIN_POINTER(name) decltype(&::name) name = nullptr;
  COIN_FUNCTIONS(COIN_POINTER)
#undef COIN_POINTER
  std::string problem;  // why they cannot be used, and what to install; "" = they can
};

// Opens the library at the first call, and never closes it.
const CoinLibrary& coin_library();

}  // namespace cli
