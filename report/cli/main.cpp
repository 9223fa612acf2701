// The program luxgate. Where to read on: run.cpp, then check_project.cpp.

#include "report/cli/run.h"

int main(int argc, char** argv) { return cli::run_program(argc, argv); }
