#pragma once
// Strict typed access to the attributes of one XML element: whatever is missing, unknown, malformed
// or out of range is reported with its place and with what is allowed.

#include "calc/base/diagnostics.h"
#include "calc/base/element_table.h"
#include "calc/base/names.h"
#include "calc/base/xml_document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Returns whether c is one of A-Z, a-z, digits and _ . : -
bool is_id_character(char c);
// Returns true for a non-empty text of these.
bool is_id(std::string_view text);

// Getters report problems and then return a harmless value of the right size: check ok() before
// using values. The element and the diagnostics must outlive the reader.
class ElementReader {
 public:
  ElementReader(const XmlElement& element, Diagnostics& diagnostics);

  const XmlElement& element() const { return element_; }
  const SourceLocation& where() const { return element_.where; }
  // Returns the place of an attribute, or of the element if it has no such attribute.
  const SourceLocation& where(std::string_view name) const;
  Diagnostics& diagnostics() { return diagnostics_; }
  // Returns whether no error was reported, by any code, since this reader was made.
  bool ok() const { return diagnostics_.error_count() == errors_before_; }

  // Reports every attribute and child element that is not in the row or in `besides`.
  void allow(const ElementRow& row);
  void allow_attributes(const ElementRow& row, const Names& besides = {});
  void allow_children(const ElementRow& row);

  bool has(std::string_view name) const { return element_.find(name) != nullptr; }
  // Returns true if at most one of the two is there; else reports.
  bool exclude(std::string_view one, std::string_view other);
  // Returns true if both are there or none is; else reports.
  bool require_together(std::string_view one, std::string_view other);

  // Getters of required attributes report a missing attribute.
  std::string id(std::string_view name = "id");
  // Returns one to `most` ids, separated by blanks.
  std::vector<std::string> ids(std::string_view name, std::size_t most);
  std::string text(std::string_view name);
  double number(std::string_view name, const NumberRange& range);
  int integer(std::string_view name, int low);
  // Returns an index into `choices`.
  std::size_t choice(std::string_view name, const Names& choices);
  // Returns the enum value of the name in the attribute, see names.h.
  template <class Enum>
  Enum value(std::string_view name) {
    return EnumNames<Enum>::list[choice(name, names_of<Enum>())].value;
  }
  // Returns exactly `count` numbers; words name them: "3 numbers (x y z)".
  std::vector<double> numbers(std::string_view name, std::size_t count, std::string_view words,
                              const NumberRange& range = kCoordinate);
  // Returns exactly `count` whole numbers from `low`.
  std::vector<int> integers(std::string_view name, std::size_t count, std::string_view words,
                            int low);
  // Returns a multiple of `group` numbers, at least minimum * group and at most maximum * group;
  // empty on errors.
  std::vector<double> number_groups(std::string_view name, std::size_t group, std::size_t minimum,
                                    std::size_t maximum, std::string_view words,
                                    const NumberRange& range = kCoordinate);

  // Getters of optional attributes.
  std::string text_or(std::string_view name, std::string_view fallback);
  double number_or(std::string_view name, const NumberRange& range, double fallback);
  std::optional<double> optional_number(std::string_view name, const NumberRange& range);
  std::size_t choice_or(std::string_view name, const Names& choices, std::size_t fallback);
  template <class Enum>
  Enum value_or(std::string_view name, Enum fallback) {
    return has(name) ? value<Enum>(name) : fallback;
  }

  template <class... Args>
  void report(DiagnosticId what, const SourceLocation& place, const Args&... args) {
    diagnostics_.report(what, place, args...);
  }

 private:
  const XmlAttribute* require(std::string_view name);
  std::optional<double> parse(const XmlAttribute& attribute, std::string_view word,
                              const NumberRange& range);
  std::optional<int> parse(const XmlAttribute& attribute, std::string_view word, int low);

  const XmlElement& element_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
};

}  // namespace calc
