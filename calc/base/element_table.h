#pragma once
// What an XML file format allows, as rows: its elements with their attributes and children. The
// readers take the names from here and xml_schema.h writes the schema from here, so that neither
// knows a name that the other does not. What attributes mean together is the readers' own.

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

// Beyond 1e9 nothing is meant seriously, and squares or differences would lose their meaning.
inline constexpr NumberRange kCoordinate{-1.0e9, 1.0e9, false, "a number from -1e9 to 1e9"};
inline constexpr NumberRange kPositive{0.0, 1.0e9, true, "a number above 0, up to 1e9"};
inline constexpr NumberRange kNonNegative{0.0, 1.0e9, false, "a number from 0 to 1e9"};
inline constexpr NumberRange kFraction{0.0, 1.0, false, "a number from 0 to 1"};
inline constexpr NumberRange kPositiveFraction{0.0, 1.0, true, "a number above 0, up to 1"};

// Texts of all rows go into the schema as they are: what XML reserves is written as an entity.

// What an attribute may hold, whatever the others say: a simple type of the schema.
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

// Of the schema itself.
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

// Children that stand in several elements.
struct ElementGroup {
  std::string_view name;
  std::vector<ChildRow> children;
};

// What elements of one type hold, in the order in which messages name it. Elements of several names
// may have one type.
struct ElementRow {
  std::string_view type;
  std::string_view meaning{};
  std::vector<AttributeRow> attributes{};
  std::vector<ChildRow> children{};  // any number of each, in any order
  bool needs_child = false;
};

Names attribute_names(const ElementRow& row);
Names child_names(const ElementRow& row);

// What either allows, required only where it is in `one`: for an element with two forms.
ElementRow either_of(const ElementRow& one, const ElementRow& other);

}  // namespace calc
