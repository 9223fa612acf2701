#pragma once
// Messages in result files, see calc/base/message.h. Beside the English text of a key stands what
// it is made of, as a list of parts: {"id": "undecided", "arguments": [[...], ...]} for a sentence,
// and for others one key, the kind of the part, with its text: {"number": "0.75 m"}.

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

// "reason_message" of "reason".
inline std::string message_key(const char* key) { return std::string(key) + "_message"; }

// Whether there is more to it than its text.
bool has_parts(const calc::Message& message);
bool has_parts(const std::vector<calc::Message>& messages);

nlohmann::ordered_json message_json(const calc::Message& message);
nlohmann::ordered_json message_json(const std::vector<calc::Message>& messages);

// at: of the text; parts: what stands beside it. Of results of earlier versions, which have no
// parts, and of parts that do not make the text in this version, it is the text to the letter.
// Throws BadJson.
calc::Message read_message(const JsonCursor& at, const std::optional<JsonCursor>& parts);
std::vector<calc::Message> read_messages(const JsonCursor& at,
                                         const std::optional<JsonCursor>& parts);

// Of one part, for "#/definitions/message_part".
nlohmann::ordered_json message_part_schema();

}  // namespace report
