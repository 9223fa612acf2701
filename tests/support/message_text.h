#pragma once
// Messages against their English text, in expectations. The program itself compares no text.

#include "calc/base/message.h"

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

inline bool operator==(const Message& message, std::string_view english) {
  return message.english() == english;
}
inline std::ostream& operator<<(std::ostream& out, const Message& message) {
  return out << message.english();
}

inline std::vector<std::string> texts(const std::vector<Message>& messages) {
  std::vector<std::string> all;
  for (const Message& message : messages) all.push_back(message.english());
  return all;
}

}  // namespace calc
