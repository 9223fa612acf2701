#pragma once
// Messages in result files, see calc/base/message.h. Beside the English text of a key is a list of
// its parts: {"id": "undecided", "arguments": [[...], ...]} for a sentence, and for others one key,
// the kind of the part, with its text: {"number": "0.75 m"}.

#include "calc/base/message.h"
#include "report/result_file/json_cursor.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace report {

template <class T>
inline constexpr bool kIsMessage = std::is_same_v<std::remove_cv_t<T>, calc::Message>;
template <class T>
inline constexpr bool kIsMessageList =
    std::is_same_v<std::remove_cv_t<T>, std::vector<calc::Message>>;

// Returns "reason_message" for "reason".
inline std::string message_key(const char* key) { return std::string(key) + "_message"; }

// Returns whether it has parts beside its text.
bool has_parts(const calc::Message& message);
bool has_parts(const std::vector<calc::Message>& messages);

nlohmann::ordered_json message_json(const calc::Message& message);
nlohmann::ordered_json message_json(const std::vector<calc::Message>& messages);

// Reads a message. at: of the text; parts: the list beside it. Without parts (results of earlier
// versions), or if the parts do not make the text in this version, it is the exact text. Throws
// BadJson.
calc::Message read_message(const JsonCursor& at, const std::optional<JsonCursor>& parts);
std::vector<calc::Message> read_messages(const JsonCursor& at,
                                         const std::optional<JsonCursor>& parts);

// Returns the schema of a part, for "#/definitions/message_part".
nlohmann::ordered_json message_part_schema();

}  // namespace report
