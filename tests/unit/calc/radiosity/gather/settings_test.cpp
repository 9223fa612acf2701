#include "calc/radiosity/gather/settings.h"

#include <gtest/gtest.h>

#include <limits>

namespace settings_test {
namespace {

TEST(RadiositySettings, DefaultsAreValid) {
  EXPECT_EQ(calc::validate(calc::RadiositySettings{}), "");
}

TEST(RadiositySettings, SaysWhatIsAllowed) {
  calc::RadiositySettings settings;
  settings.replicates = 3;
  EXPECT_EQ(calc::validate(settings), "replicates is 3; allowed: 4 to 64");
  settings = {};
  settings.max_paths = 1000;
  EXPECT_EQ(calc::validate(settings),
            "max paths is 1000; allowed: a power of two, 256 to 1073741824");
  settings = {};
  settings.max_paths = 128;
  EXPECT_EQ(calc::validate(settings),
            "max paths is 128; allowed: a power of two, 256 to 1073741824");
  settings = {};
  settings.first_paths = 0;
  EXPECT_EQ(calc::validate(settings), "first paths is 0; allowed: a power of two, 1 to 1073741824");
  settings = {};
  settings.first_paths = settings.max_paths = calc::kFewestPaths;
  EXPECT_EQ(calc::validate(settings), "");
  settings = {};
  settings.time_limit_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(calc::validate(settings), "");
  settings = {};
  settings.opening_error_factor = 0.0;
  EXPECT_EQ(calc::validate(settings), "opening error factor is 0; allowed: more than 0");
  settings = {};
  settings.jobs = -1;
  EXPECT_EQ(calc::validate(settings), "jobs is -1; allowed: 0 (one per core) to 4096");
}

}  // namespace
}  // namespace settings_test
