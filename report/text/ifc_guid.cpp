#include "report/text/ifc_guid.h"

#include "calc/base/file_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace report {
namespace {

constexpr std::string_view kIfcLetters =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";

}  // namespace

std::string key_of_id(std::string_view id, std::string_view prefix) {
  if (!id.starts_with(prefix)) return {};
  std::string key(id.substr(prefix.size()));
  std::replace(key.begin(), key.end(), kDollarInId, '$');
  return key;
}

Guid guid_of_names(const std::vector<std::string>& names) {
  std::string text;  // lengths keep one list of names from looking like another
  for (const std::string& name : names) text += fmt::format("{}:{}", name.size(), name);
  const std::string hash = calc::sha256(text);
  Guid guid{};
  for (std::size_t i = 0; i < guid.size(); ++i) guid[i] = static_cast<std::uint8_t>(hash[i]);
  // As UUIDs have it that are made by a rule of their own: version 8.  [RFC 9562, section 5.8]
  guid[6] = static_cast<std::uint8_t>((guid[6] & 0x0Fu) | 0x80u);
  guid[8] = static_cast<std::uint8_t>((guid[8] & 0x3Fu) | 0x80u);
  return guid;
}

std::string ifc_letters(const Guid& guid) {
  std::string text;
  std::uint32_t bits = 0;  // that no letter has taken yet
  int count = 4;           // of them; the first letter begins with four that are 0
  for (const std::uint8_t byte : guid) {
    bits = (bits << 8u) | byte;
    for (count += 8; count >= 6; count -= 6) {
      const std::uint32_t letter = bits >> static_cast<unsigned int>(count - 6);
      text += kIfcLetters[letter & 63u];
    }
    bits &= 63u;
  }
  return text;
}

}  // namespace report
