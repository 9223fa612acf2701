#include "tests/support/prefix.h"
