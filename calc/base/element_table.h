#pragma once
// An XML file format as rows: its elements with their attributes and children. The readers take the
// names from here and xml_schema.h writes the schema from here, so that both know the same names.
// Rules between attributes belong to the readers.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace calc {

using Names = std::vector<std::string_view>;

// Numbers from low (left out if is_open) to high; words complete "expected ...".
struct NumberRange {
  double low;
  double high;
  bool is_open;
  std::string_view words;

  constexpr bool contains(double value) const {
    return (is_open ? value > low : value >= low) && value <= high;
  }
};

// Limits of coordinates: beyond 1e9, squares and differences would lose their accuracy.
inline constexpr NumberRange kCoordinate{-1.0e9, 1.0e9, false, "a number from -1e9 to 1e9"};
inline constexpr NumberRange kPositive{0.0, 1.0e9, true, "a number above 0, up to 1e9"};
inline constexpr NumberRange kNonNegative{0.0, 1.0e9, false, "a number from 0 to 1e9"};
inline constexpr NumberRange kFraction{0.0, 1.0, false, "a number from 0 to 1"};
inline constexpr NumberRange kPositiveFraction{0.0, 1.0, true, "a number above 0, up to 1"};

// All texts of the rows go into the schema unchanged: characters reserved in XML are entities.

// The values that an attribute may have on its own: a simple type of the schema.
struct ValueType {
  std::string_view name;            // in the schema; xs:... are its own and need nothing else
  const ValueType* base = nullptr;  // what it narrows
  std::string_view meaning{};
  Names words{};                       // one of these
  std::optional<NumberRange> range{};  // an infinite end is none
  std::string_view pattern{};
  const ValueType* item = nullptr;  // of a list, separated by blanks; instead of a base
  std::size_t least = 0, most = 0;  // items of a list or characters of a text, 0: any number
  std::string_view verbatim{};      // instead of all these: the contents of xs:simpleType
};

// Types of the schema language itself.
inline const ValueType kAnyText{"xs:string"};
inline const ValueType kAnyDouble{"xs:double"};
inline const ValueType kAnyInt{"xs:int"};
inline const ValueType kAnyDate{"xs:date"};

enum class Presence { optional, required };

struct AttributeRow {
  std::string_view name;
  const ValueType* type;
  Presence presence = Presence::optional;
  std::string_view meaning{};
  std::string_view otherwise{};  // what counts without it, if the schema says so
};

struct ElementRow;
struct ElementGroup;

// One child element, or all of a group.
struct ChildRow {
  std::string_view name{};
  const ElementRow* row = nullptr;
  std::string_view constraints{};  // xs:unique, xs:key and xs:keyref, verbatim
  const ElementGroup* group = nullptr;
};

// Children that several elements have.
struct ElementGroup {
  std::string_view name;
  std::vector<ChildRow> children;
};

// The content of elements of one type, in the order in which messages name it. Elements of several
// names may share a type.
struct ElementRow {
  std::string_view type;
  std::string_view meaning{};
  std::vector<AttributeRow> attributes{};
  std::vector<ChildRow> children{};  // any number of each, in any order
  bool needs_child = false;
};

Names attribute_names(const ElementRow& row);
Names child_names(const ElementRow& row);

// Returns a row for an element with two forms: it allows what either allows, requires what `one`
// does.
ElementRow either_of(const ElementRow& one, const ElementRow& other);

}  // namespace calc
