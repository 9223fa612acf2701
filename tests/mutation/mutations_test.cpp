// The list of mutations fits the sources: run.py takes hours and is no test of the suite.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace mutations_test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(LUXGATE_SOURCE_DIR) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> parts_of(const std::string& line) {
  const std::string between = " | ";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = line.find(between, begin)) != std::string::npos;) {
    parts.push_back(line.substr(begin, end - begin));
    begin = end + between.size();
  }
  parts.push_back(line.substr(begin));
  return parts;
}

TEST(Mutations, EveryTextStandsOnceInItsFile) {
  std::istringstream lines(text_of("tests/mutation/mutations.txt"));
  std::set<std::string> names;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    ++count;
    const std::vector<std::string> parts = parts_of(line);
    ASSERT_EQ(parts.size(), 5u) << line;
    EXPECT_TRUE(names.insert(parts[0]).second) << parts[0];
    EXPECT_NE(parts[2], parts[3]) << parts[0];
    const std::string text = text_of(parts[1]);
    const std::size_t first = text.find(parts[2]);
    ASSERT_NE(first, std::string::npos) << parts[0] << ": not in " << parts[1];
    EXPECT_EQ(text.find(parts[2], first + 1), std::string::npos) << parts[0] << ": twice";
  }
  EXPECT_GE(count, 30u);
}

}  // namespace
}  // namespace mutations_test
