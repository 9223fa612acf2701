#include "report/shell/process/environment.h"

#include <gtest/gtest.h>

namespace environment_test {
namespace {

cli::Environment terminal() {
  cli::Environment environment;
  environment.stdout_is_terminal = true;
  environment.term = "xterm-256color";
  return environment;
}

TEST(UseColor, FollowsTheTerminal) {
  EXPECT_TRUE(cli::use_color(cli::ColorChoice::automatic, terminal()));
  EXPECT_FALSE(cli::use_color(cli::ColorChoice::automatic, cli::Environment{}));
}

TEST(UseColor, DumbTerminalsGetNone) {
  cli::Environment environment = terminal();
  environment.term = "dumb";
  EXPECT_FALSE(cli::use_color(cli::ColorChoice::automatic, environment));
}

TEST(UseColor, ForceWorksWithoutATerminalButZeroIsNotForce) {
  cli::Environment environment;
  environment.clicolor_force = "1";
  EXPECT_TRUE(cli::use_color(cli::ColorChoice::automatic, environment));
  environment.clicolor_force = "0";
  EXPECT_FALSE(cli::use_color(cli::ColorChoice::automatic, environment));
}

TEST(UseColor, NoColorWinsOverForceAndTheOptionOverBoth) {
  cli::Environment environment = terminal();
  environment.no_color = "1";
  environment.clicolor_force = "1";
  EXPECT_FALSE(cli::use_color(cli::ColorChoice::automatic, environment));
  EXPECT_TRUE(cli::use_color(cli::ColorChoice::always, environment));
  EXPECT_FALSE(cli::use_color(cli::ColorChoice::never, terminal()));
}

}  // namespace
}  // namespace environment_test
