#include "report/tools/photometry/photometry_options.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace cli {
namespace {

bool ends_with_one_of(std::string text, const std::vector<std::string_view>& endings) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return std::string_view(text).ends_with(ending);
  });
}

}  // namespace

std::string photometry_contradiction(const PhotometryOptions& photometry) {
  const std::size_t files = photometry.files.size();
  const auto one_file = [&](const char* name, const std::string& value,
                            const std::vector<std::string_view>& endings) -> std::string {
    if (value.empty()) return "";
    if (files != 1) return fmt::format("{} is for one FILE; found {}", name, files);
    if (ends_with_one_of(value, endings)) return "";
    return fmt::format("{}: '{}' must end with {}", name, value, calc::join_choices(endings));
  };
  std::string problem = one_file("--polar", photometry.polar_file, {".svg", ".png"});
  if (problem.empty()) problem = one_file("--convert", photometry.convert_file, {".ies", ".ldt"});
  if (!problem.empty()) return problem;
  if (!photometry.compare) return "";
  if (files != 2) return fmt::format("--compare needs two FILEs; found {}", files);
  return photometry.format == PhotometryFormat::csv ? "--compare has no CSV form; use --json" : "";
}

}  // namespace cli
