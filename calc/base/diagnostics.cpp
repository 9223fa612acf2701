#include "calc/base/diagnostics.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/message.h"
#include "calc/base/utf8.h"

#include <algorithm>
#include <array>
#include <utility>

namespace calc {
namespace {

struct Entry {
  std::string_view name;
  Severity severity;
  std::string_view text;
};

// No std::array{...}: Clang 14 deduces the type of no more than 256 elements.
constexpr auto kEntries = std::to_array<Entry>({
#define LUXGATE_DIAGNOSTIC(id, severity, text) Entry{#id, Severity::severity, text},
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC
});

const Entry& entry(DiagnosticId id) { return kEntries[static_cast<std::size_t>(id)]; }

}  // namespace

std::string diagnostic_name(DiagnosticId id) {
  std::string name(entry(id).name);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::optional<DiagnosticId> diagnostic_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    const auto id = static_cast<DiagnosticId>(i);
    if (diagnostic_name(id) == name) return id;
  }
  return std::nullopt;
}

Severity diagnostic_severity(DiagnosticId id) { return entry(id).severity; }

std::string_view diagnostic_template(DiagnosticId id) { return entry(id).text; }

std::string format_diagnostic(const Diagnostic& diagnostic) {
  std::string text = printable_path(diagnostic.where.file);
  if (diagnostic.where.line > 0) text += fmt::format(":{}", diagnostic.where.line);
  if (diagnostic.where.column > 0) text += fmt::format(":{}", diagnostic.where.column);
  if (!text.empty()) text += ": ";
  text += name_of(diagnostic.severity());
  return text + "[" + diagnostic_name(diagnostic.id) + "]: " + diagnostic.message;
}

void Diagnostics::sort_by_line(std::string_view file, std::size_t first) {
  std::vector<std::size_t> places;
  std::vector<Diagnostic> sorted;
  for (std::size_t i = first; i < all_.size(); ++i) {
    if (all_[i].where.file != file || all_[i].id == DiagnosticId::messages_left_out) continue;
    places.push_back(i);
    sorted.push_back(all_[i]);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.where.line < b.where.line;
  });
  for (std::size_t i = 0; i < places.size(); ++i) all_[places[i]] = std::move(sorted[i]);
}

void Diagnostics::add(const Diagnostics& others) {
  for (const Diagnostic& other : others.all_) {
    if (other.id == DiagnosticId::messages_left_out) continue;
    if (take(other.id, 1, other.where.file)) all_.push_back(other);
  }
  for (const auto& [id, found] : others.of_id_) {
    if (found.left_out == 0) continue;
    take(id, found.count - kMostMessagesOfAnId, others.all_[found.left_out].where.file);
  }
}

void Diagnostics::add(DiagnosticId id, const SourceLocation& where, std::string message) {
  // Messages quote files, which may hold anything.
  all_.push_back(Diagnostic{id, where, printable(shorten_utf8(message, kLongestMessage))});
}

std::string Diagnostics::shown(const Message& message) { return message.english(); }

bool Diagnostics::take(DiagnosticId id, std::size_t count, const std::string& file) {
  if (diagnostic_severity(id) == Severity::error) error_count_ += count;
  OfAnId& found = of_id_[id];
  found.count += count;
  if (found.count <= kMostMessagesOfAnId) return true;
  if (found.left_out == 0) {
    found.left_out = all_.size();
    Diagnostic words{DiagnosticId::messages_left_out, {}, {}};  // found below
    words.where.file = file;
    all_.push_back(std::move(words));
  }
  all_[found.left_out].message =
      fmt::format(fmt::runtime(diagnostic_template(DiagnosticId::messages_left_out)),
                  found.count - kMostMessagesOfAnId, diagnostic_name(id), kMostMessagesOfAnId);
  return false;
}

}  // namespace calc
