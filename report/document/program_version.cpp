#include "report/document/program_version.h"

namespace report {

std::string program_version() { return LUXGATE_VERSION; }  // from CMake

}  // namespace report
