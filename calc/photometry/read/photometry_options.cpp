#include "calc/photometry/read/photometry_options.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/text_encoding.h"

#include <cstddef>

namespace calc {

std::string list_choices(const std::vector<PhotometryChoice>& choices) {
  constexpr std::size_t kLongest = 10;
  if (choices.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < choices.size() && i < kLongest; ++i) {
    if (i > 0) text += ", ";
    text += quotable(choices[i].id);
    if (!choices[i].label.empty()) text += " (" + quotable(choices[i].label) + ")";
  }
  if (choices.size() > kLongest) text += fmt::format(", ... ({} in all)", choices.size());
  return text;
}

SourceLocation place_of_choice(const PhotometryOptions& options, const std::string& name) {
  return options.where.file.empty() ? SourceLocation{name, 0, 0} : options.where;
}

bool check_options(const PhotometryOptions& options, const KnownOptions& known,
                   std::string_view format, const std::string& name, Diagnostics& diagnostics) {
  bool ok = true;
  const auto refuse = [&](bool is_given, bool is_known, std::string_view things,
                          std::string_view option) {
    if (!is_given || is_known) return;
    diagnostics.report(DiagnosticId::photometry_option_unused, place_of_choice(options, name), name,
                       format, things, option);
    ok = false;
  };
  refuse(options.lamp_set != 0, known.lamp_set, "lamp sets", "lamp-set");
  refuse(!options.variant.empty(), known.variant, "variants", "variant");
  refuse(!options.emitter.empty(), known.emitter, "emitters", "emitter");
  return ok;
}

}  // namespace calc
