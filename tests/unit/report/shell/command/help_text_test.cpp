#include "report/shell/command/help_text.h"

#include "calc/base/text.h"
#include "report/cli/commands.h"
#include "report/shell/process/environment_variables.h"
#include "report/tools/help/completions.h"
#include "report/tools/help/man_page.h"
#include "report/tools/help/option_table.h"
#include "tests/support/command_lines.h"
#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace help_text_test {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Help, ShortHelpIsOneScreen) {
  constexpr std::size_t kScreenLines = 24;
  const std::vector<cli::Command> commands = cli::all_commands();
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    const std::vector<std::string> lines = lines_of(cli::short_help(topic));
    EXPECT_LE(lines.size(), kScreenLines) << topic.line;
    for (const std::string& line : lines) {
      EXPECT_LE(line.size(), cli::kHelpColumns) << topic.line << ": " << line;
    }
  }
}

TEST(Help, LongHelpHasAllOfACommand) {
  const std::vector<cli::Command> commands = cli::all_commands();
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    const std::string help = cli::long_help(topic);
    for (const cli::Option& option : topic.about->options) {
      EXPECT_THAT(help, HasSubstr("  " + cli::option_words(option) + "\n")) << topic.line;
    }
    // Where one changes something.
    if (topic.line == "luxgate check" || topic.line == "luxgate devices") {
      EXPECT_THAT(help, HasSubstr("Environment variables:\n  ")) << topic.line;
    } else if (topic.line == "luxgate init") {
      EXPECT_THAT(help, Not(HasSubstr("Environment variables:"))) << topic.line;
    }
    if (!topic.parts.empty() && topic.part_name == "ACTION") continue;
    EXPECT_THAT(help, HasSubstr("\nExamples:\n")) << topic.line;
    EXPECT_THAT(help, HasSubstr("\nExit codes:\n  0")) << topic.line;
    EXPECT_THAT(help, HasSubstr("\n  2 ")) << topic.line;
  }
}

TEST(Help, MostUsedOptionsAreThere) {
  const std::vector<cli::Command> commands = cli::all_commands();
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    std::set<std::string> names;
    for (const cli::Option& option : topic.about->options) names.insert(option.long_name());
    for (const cli::Command& part : topic.parts) names.insert(part.name);
    for (const std::string& name : topic.about->most_used) {
      EXPECT_TRUE(names.contains(name)) << topic.line << " " << name;
    }
  }
}

// Whatever help shows as an example is taken; what comes behind a pipe is the shell's.
TEST(Help, ExamplesAreGoodLines) {
  // What lies in the current folder by chance is nothing that an example means.
  const test_support::ScratchFolder scratch;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(scratch.path());
  const std::vector<cli::Command> commands = cli::all_commands();
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    for (const cli::Example& example : topic.about->examples) {
      const std::string line = example.line.substr(0, example.line.find_first_of("|>"));
      const std::vector<std::string_view> split = calc::split_words(line);
      ASSERT_GE(split.size(), 2u);
      EXPECT_EQ(split.front(), "luxgate");
      const std::vector<std::string> words(split.begin() + 1, split.end());
      std::vector<const char*> typed;
      for (const std::string& word : words) typed.push_back(word.c_str());
      const cli::TestLine result = cli::parse_words(typed);
      const bool lacks_file = result.err.find("there is no folder") != std::string::npos;
      EXPECT_TRUE(result.is_good || lacks_file) << line << "\n" << result.err;
    }
  }
  std::filesystem::current_path(before);
}

TEST(Help, EveryVariableThatIsReadIsInTheTable) {
  const std::filesystem::path root = LUXGATE_SOURCE_DIR;
  const std::regex read(R"re((?:getenv|variable)\("([A-Za-z_0-9]+)"\))re");
  std::size_t found = 0;
  for (const char* part : {"calc", "rules", "gpu", "report"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / part)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".cpp" && ending != ".h") continue;
      const std::string text = contents(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), read), end; at != end; ++at) {
        ++found;
        EXPECT_TRUE(cli::is_environment_variable((*at)[1].str())) << entry.path() << (*at)[1].str();
      }
      // All other reading is of names that compile from the table alone.
      const bool is_other = std::regex_search(text, std::regex(R"re(getenv\([^"])re"));
      EXPECT_EQ(is_other, entry.path().filename() == "environment.cpp") << entry.path();
    }
  }
  EXPECT_GT(found, 8u);
}

TEST(Help, VariablesOfTheTableNameCommandsAndOptionsThatAreThere) {
  const std::vector<cli::Command> commands = cli::all_commands();
  std::set<std::string> known = {""};
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    known.insert(topic.line.substr(std::min(topic.line.size(), topic.line.find(' ') + 1)));
    for (const cli::Option& option : topic.about->options) known.insert(option.long_name());
  }
  for (const cli::EnvironmentVariable& variable : cli::kEnvironmentVariables) {
    for (const std::string_view list : {variable.options, variable.commands}) {
      std::istringstream in{std::string(list)};
      for (std::string name; std::getline(in, name, ',');) {
        EXPECT_TRUE(known.contains(name)) << variable.name << " " << name;
      }
    }
  }
}

// The same option is written in the same way in all commands, or stands here with the reason.
TEST(Help, OptionsAreSpeltTheSameEverywhere) {
  const std::set<std::string> differ = {
      "--format",  // [=FILE] where files can be written
      "--output",  // of one file, of one of a kind, or of a folder
      "--clamp",   // of a method of converge, in another unit's letter
      "--plane",   // of compare: two ids
      "--strict",  // with ids where warnings of projects have ids to choose from
      "--space",   // of check: patterns
      "--units",   // a file, a list, or what lengths are in
  };
  const std::vector<cli::Command> commands = cli::all_commands();
  std::map<std::string, std::string> values, one_letters;
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    for (const cli::Option& option : topic.about->options) {
      const std::string name = option.long_name();
      EXPECT_EQ(one_letters.try_emplace(name, option.short_name()).first->second,
                option.short_name())
          << topic.line << " " << name;
      if (differ.contains(name)) continue;
      EXPECT_EQ(values.try_emplace(name, option.value_name).first->second, option.value_name)
          << topic.line << " " << name;
    }
  }
  EXPECT_EQ(one_letters.at("--output"), "-o");
  EXPECT_EQ(one_letters.at("--jobs"), "-j");
  EXPECT_EQ(one_letters.at("--quiet"), "-q");
}

// The first sentence is what the short help and shells show.
TEST(Help, OptionsBeginWithAShortSentenceInTheImperative) {
  constexpr std::size_t kLongest = 100;
  const std::vector<cli::Command> commands = cli::all_commands();
  for (const cli::Topic& topic : cli::all_topics(commands)) {
    for (const cli::Option& option : topic.about->options) {
      const std::string where = topic.line + " " + option.long_name() + ": " + option.help;
      EXPECT_LE(std::min(option.help.find(". "), option.help.size()), kLongest) << where;
      EXPECT_FALSE(option.help.ends_with('.')) << where;
      for (const char* word : {"may be repeated", "an be repeated", " asked", "look", "hangs on"}) {
        EXPECT_EQ(option.help.find(word), std::string::npos) << where;
      }
      const std::string first = option.help.substr(0, option.help.find(' '));
      constexpr std::array kNone{"As", "Of", "The", "What", "Which", "Where", "Only", "Also"};
      EXPECT_EQ(std::find(kNone.begin(), kNone.end(), first), kNone.end()) << where;
    }
  }
}

TEST(Help, TableHasALineForEveryOption) {
  const std::vector<cli::Command> commands = cli::all_commands();
  std::size_t options = 0;
  for (const cli::Topic& topic : cli::all_topics(commands)) options += topic.about->options.size();
  const std::vector<std::string> lines = lines_of(cli::option_table(commands));
  EXPECT_EQ(lines.size(), options + 1);
  EXPECT_GT(options, 100u);
}

TEST(Help, FirstClauseEndsAtASignOrIsCut) {
  EXPECT_EQ(cli::first_clause("Threads; default one per core", 40), "Threads");
  EXPECT_EQ(cli::first_clause("As 1.5 m: no\nmore", 40), "As 1.5 m: no more");
  EXPECT_EQ(cli::first_clause("As 1.5 m: no\nmore", 12), "As 1.5 m");
  EXPECT_EQ(cli::first_clause("one two three", 10), "one two...");
}

TEST(Help, ParagraphsKeepLinesThatBeginWithABlank) {
  const auto parts = cli::paragraphs_of("a\nb\n  c\n  d\n\ne");
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].text, "a b");
  EXPECT_EQ(parts[1].text, "  c\n  d\n");
  EXPECT_TRUE(parts[1].is_verbatim);
  EXPECT_EQ(parts[2].text, "e");
}

TEST(Help, NearNamesAreSuggestedAndFarOnesAreNot) {
  const auto problem = [](std::vector<const char*> words) {
    const cli::TestLine line = cli::parse_words(std::move(words));
    EXPECT_EQ(line.exit_code, 2);
    return line.err;
  };
  EXPECT_EQ(problem({"chek"}),
            "luxgate: error: unknown command 'chek'; did you mean 'check'?\n"
            "try 'luxgate --help'\n");
  EXPECT_EQ(problem({"zzzzzzzz"}),
            "luxgate: error: unknown command 'zzzzzzzz'\ntry 'luxgate --help'\n");
  EXPECT_THAT(problem({"a/room.xml"}), HasSubstr("did you mean 'luxgate check a/room.xml'?\n"));
  EXPECT_THAT(problem({"rules", "lst"}),
              HasSubstr("unknown action 'lst'; did you mean 'list'?\ntry 'luxgate rules --help'"));
  EXPECT_THAT(problem({"rules", "zzzzzzzz"}),
              HasSubstr("unknown action 'zzzzzzzz'; 'luxgate rules' knows list, find, show"));
  EXPECT_THAT(problem({"rules"}),
              HasSubstr("no action given; 'luxgate rules' knows list, find, show"));
  EXPECT_THAT(problem({"check", "a.xml", "--frmat", "csv"}),
              HasSubstr("unknown option '--frmat'; did you mean '--format'?\n"));
  EXPECT_THAT(problem({"check", "a.xml", "--out=x"}), HasSubstr("did you mean '--output'?"));
  EXPECT_EQ(problem({"check", "a.xml", "--zzzzzzzz"}).find("did you mean"), std::string::npos);
  EXPECT_THAT(problem({"rules", "import", "--templte"}),
              HasSubstr("'luxgate rules import --help'"));
  EXPECT_THAT(problem({"completions", "fissh"}), HasSubstr("did you mean 'fish'?"));
  EXPECT_THAT(problem({"vpl", "a.xml", "b.xml", "-o", "c.ply"}),
              HasSubstr("unexpected argument 'b.xml'\ntry 'luxgate vpl --help'\n"));
}

TEST(Help, ShortAndLongHelpAndVersion) {
  for (const char* option : {"-h", "--help", "-V", "--version"}) {
    const cli::TestLine line = cli::parse_words({option});
    EXPECT_EQ(line.exit_code, 0) << option;
    EXPECT_THAT(line.out, HasSubstr(option[1] == 'V' || option[2] == 'v' ? "luxgate " : "Usage: "));
  }
  EXPECT_LT(cli::parse_words({"check", "-h"}).out.size(),
            cli::parse_words({"check", "--help"}).out.size() / 4);
}

TEST(Help, PagesAndScriptsHaveWhatTheTableHas) {
  const std::vector<cli::Command> commands = cli::all_commands();
  const cli::ManPage page = cli::man_page(commands, "rules");
  EXPECT_EQ(page.file, "luxgate-rules.1");
  EXPECT_THAT(page.text, HasSubstr(".SS \"import\"\n"));
  EXPECT_THAT(page.text, HasSubstr("\\fB\\-\\-template\\fR"));
  for (const cli::Shell shell : {cli::Shell::bash, cli::Shell::zsh, cli::Shell::fish}) {
    const std::string script = cli::completions(shell, commands);
    for (const cli::Command& command : commands) EXPECT_THAT(script, HasSubstr(command.name));
    EXPECT_THAT(script, HasSubstr("verdict accuracy"));
  }
}

}  // namespace
}  // namespace help_text_test
