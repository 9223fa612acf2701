#pragma once
// Command lines as the program reads them.

#include "report/cli/commands.h"
#include "report/shell/command/command_line.h"

#include <string>
#include <vector>

namespace cli {

struct TestLine {
  bool is_good = false;
  int exit_code = 0;
  std::string out, err;
};

inline TestLine parse_words(const std::vector<Command>& commands, std::vector<const char*> words,
                            const std::string& source_date_epoch = "") {
  words.insert(words.begin(), "/somewhere/luxgate");
  Environment environment;
  environment.source_date_epoch = source_date_epoch;
  const ParsedLine line =
      parse_command_line(commands, static_cast<int>(words.size()), words.data(), environment);
  return {line.command != nullptr, line.exit_code, line.out, line.err};
}

// As the program does.
inline TestLine parse_words(std::vector<const char*> words,
                            const std::string& source_date_epoch = "") {
  return parse_words(all_commands(), std::move(words), source_date_epoch);
}

// Into the options of one command.
template <class Options>
TestLine parse_words(Command (*syntax)(Options&), Options& options, std::vector<const char*> words,
                     const std::string& source_date_epoch = "") {
  return parse_words(std::vector<Command>{syntax(options)}, std::move(words), source_date_epoch);
}

}  // namespace cli
