#include "report/formats/kept_rows.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <variant>

namespace report {
namespace {

template <class T>
void put(const T& value, std::string& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

template <class T>
T take(const std::string& bytes, std::size_t& at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  at += sizeof(T);
  return value;
}

static_assert(std::is_same_v<std::variant_alternative_t<1, TableCell>, std::string> &&
              std::is_same_v<std::variant_alternative_t<2, TableCell>, TableNumber> &&
              std::is_same_v<std::variant_alternative_t<3, TableCell>, std::int64_t>);

void put_cell(const TableCell& cell, std::string& bytes) {
  bytes.push_back(static_cast<char>(cell.index()));
  if (const auto* text = std::get_if<std::string>(&cell)) {
    put(text->size(), bytes);
    bytes += *text;
  } else if (const auto* number = std::get_if<TableNumber>(&cell)) {
    put(number->value, bytes);
    put(number->decimals, bytes);
    put(number->is_percent, bytes);
  } else if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    put(*count, bytes);
  }
}

TableCell take_cell(const std::string& bytes, std::size_t& at) {
  switch (bytes[at++]) {
    case 1: {
      const auto size = take<std::size_t>(bytes, at);
      at += size;
      return bytes.substr(at - size, size);
    }
    case 2: {
      TableNumber number;
      number.value = take<double>(bytes, at);
      number.decimals = take<int>(bytes, at);
      number.is_percent = take<bool>(bytes, at);
      return number;
    }
    case 3:
      return take<std::int64_t>(bytes, at);
    default:
      return {};
  }
}

}  // namespace

void KeptRows::add(std::span<const TableCell> row) {
  if (is_used_.empty()) is_used_.resize(row.size());
  for (std::size_t c = 0; c < row.size(); ++c) {
    put_cell(row[c], bytes_);
    if (!std::holds_alternative<std::monostate>(row[c])) is_used_[c] = true;
  }
}

void KeptRows::for_each(const std::function<void(std::vector<TableCell>)>& visit) const {
  for (std::size_t at = 0; at < bytes_.size();) {
    std::vector<TableCell> row;
    row.reserve(is_used_.size());
    for (std::size_t c = 0; c < is_used_.size(); ++c) row.push_back(take_cell(bytes_, at));
    visit(std::move(row));
  }
}

}  // namespace report
