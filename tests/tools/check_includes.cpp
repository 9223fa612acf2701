// Every source and header includes what it uses of the precompiled headers, itself or by a header
// of ours: so it compiles without them, too.
//   check_includes ROOT HEADER...      e.g. check_includes . "<string>" "<vector>"
// Exit code 1 if a name is used without its header, or if this table lacks one of the HEADERs.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Names with their namespace; "glm" and "std::filesystem" stand for all in them. A name that
// several headers may bring (std::swap) is left out, as is what <string_view> shares with <string>.
const std::map<std::string, std::vector<std::string_view>> kNames = {
    {"<algorithm>", {"std::sort",         "std::stable_sort",
                     "std::find",         "std::find_if",
                     "std::any_of",       "std::all_of",
                     "std::none_of",      "std::count",
                     "std::count_if",     "std::min",
                     "std::max",          "std::min_element",
                     "std::max_element",  "std::minmax_element",
                     "std::clamp",        "std::lower_bound",
                     "std::upper_bound",  "std::copy",
                     "std::copy_if",      "std::fill",
                     "std::fill_n",       "std::transform",
                     "std::reverse",      "std::unique",
                     "std::remove_if",    "std::replace",
                     "std::nth_element",  "std::partition",
                     "std::rotate",       "std::is_sorted",
                     "std::for_each",     "std::binary_search",
                     "std::equal_range",  "std::mismatch",
                     "std::adjacent_find"}},
    {"<array>", {"std::array"}},
    {"<bit>",
     {"std::bit_cast", "std::countr_zero", "std::countl_zero", "std::popcount", "std::bit_ceil",
      "std::bit_floor", "std::bit_width", "std::has_single_bit", "std::endian"}},
    {"<cmath>",
     {"std::sqrt", "std::floor", "std::ceil", "std::round", "std::llround", "std::lround",
      "std::isfinite", "std::isnan", "std::isinf", "std::fmod", "std::ldexp", "std::frexp",
      "std::nextafter", "std::signbit", "std::copysign", "std::trunc"}},
    {"<cstddef>", {"std::size_t", "std::ptrdiff_t", "std::byte"}},
    {"<cstdint>",
     {"std::uint8_t", "std::uint16_t", "std::uint32_t", "std::uint64_t", "std::int8_t",
      "std::int16_t", "std::int32_t", "std::int64_t", "std::uintptr_t"}},
    {"<filesystem>", {"std::filesystem"}},
    {"<functional>", {"std::function", "std::hash", "std::greater", "std::less", "std::ref"}},
    {"<limits>", {"std::numeric_limits"}},
    {"<map>", {"std::map", "std::multimap"}},
    {"<memory>",
     {"std::unique_ptr", "std::shared_ptr", "std::weak_ptr", "std::make_unique",
      "std::make_shared"}},
    {"<optional>", {"std::optional", "std::nullopt"}},
    {"<set>", {"std::set", "std::multiset"}},
    {"<span>", {"std::span"}},
    {"<stdexcept>",
     {"std::runtime_error", "std::invalid_argument", "std::logic_error", "std::out_of_range"}},
    {"<string>", {"std::string", "std::to_string"}},
    {"<string_view>", {"std::string_view"}},
    {"<utility>", {"std::move", "std::pair", "std::exchange", "std::forward", "std::as_const"}},
    {"<variant>",
     {"std::variant", "std::visit", "std::get_if", "std::monostate", "std::holds_alternative"}},
    {"<vector>", {"std::vector"}},
    {"<fmt/format.h>", {"fmt::format", "fmt::print", "fmt::join"}},
    {"<glm/glm.hpp>", {"glm"}}};

std::string file_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Blanks where comments and literals were; lines stay.
std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0) {
      end = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "R\"") == 0 && (i == 0 || !is_word(text[i - 1]))) {
      const std::size_t open = text.find('(', i);
      const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
      end = std::min(text.find(close, open), text.size() - close.size()) + close.size();
    } else if (text[i] == '"' || (text[i] == '\'' && (i == 0 || !is_word(text[i - 1])))) {
      while (end < text.size() && text[end] != text[i]) end += text[end] == '\\' ? 2 : 1;
      ++end;
    } else {
      code += text[i++];
      continue;
    }
    i = end;
    code += ' ';
  }
  return code;
}

struct Source {
  std::set<std::string> headers;      // "<vector>"
  std::vector<std::string> includes;  // ours, from the root
  std::string code;
};

Source read_source(const fs::path& path) {
  Source source;
  const std::string text = file_text(path);
  for (std::size_t line = 0; line < text.size();) {
    const std::size_t end = std::min(text.find('\n', line), text.size());
    const std::string_view row = std::string_view(text).substr(line, end - line);
    constexpr std::string_view kInclude = "#include ";
    if (row.starts_with(kInclude)) {
      const std::string name(
          row.substr(kInclude.size(), row.find_last_of(">\"") + 1 - kInclude.size()));
      if (name.starts_with('<')) source.headers.insert(name);
      if (name.starts_with('"')) source.includes.push_back(name.substr(1, name.size() - 2));
    }
    line = end + 1;
  }
  source.code = code_of(text);
  return source;
}

using Sources = std::map<std::string, Source>;

void collect_headers(const Sources& all, const std::string& name, std::set<std::string>& seen,
                     std::set<std::string>& headers) {
  const auto found = all.find(name);
  if (found == all.end() || !seen.insert(name).second) return;
  headers.insert(found->second.headers.begin(), found->second.headers.end());
  for (const std::string& other : found->second.includes)
    collect_headers(all, other, seen, headers);
}

bool uses(const std::string& code, std::string_view name) {
  for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || (!is_word(code[at - 1]) && code[at - 1] != ':');
    const bool ends = end < code.size() && !is_word(code[end]);
    if (begins && ends && (name != "glm" || code.compare(end, 2, "::") == 0)) return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  int problems = 0;
  for (int i = 2; i < argc; ++i) {
    if (kNames.contains(argv[i])) continue;
    fmt::print("{} is precompiled, but check_includes knows no name of it\n", argv[i]);
    ++problems;
  }
  const fs::path root = argc > 1 ? argv[1] : ".";
  Sources all;
  for (const char* folder : {"calc", "rules", "report", "gpu"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      all.emplace(fs::relative(entry.path(), root).generic_string(), read_source(entry.path()));
    }
  }
  for (const auto& [name, source] : all) {
    if (name == "calc/base/shader_words.h") continue;  // text for those who include it
    std::set<std::string> seen, headers;
    collect_headers(all, name, seen, headers);
    for (int i = 2; i < argc; ++i) {
      const auto row = kNames.find(argv[i]);
      if (row == kNames.end() || headers.contains(argv[i])) continue;
      for (const std::string_view used : row->second) {
        if (!uses(source.code, used)) continue;
        fmt::print("{} uses {} without {}\n", name, used, argv[i]);
        ++problems;
        break;
      }
    }
  }
  fmt::print("{} files, {} problems\n", all.size(), problems);
  return problems == 0 && !all.empty() ? 0 : 1;
}
