#pragma once
// Texts of rules/packs/*.xml, embedded into the library when it is built (embed_packs.cmake).

#include <string_view>
#include <vector>

namespace rules {

std::vector<std::string_view> builtin_pack_texts();

}  // namespace rules
