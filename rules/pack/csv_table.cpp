#include "rules/pack/csv_table.h"

#include <utility>

namespace rules {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<std::vector<CsvRecord>> read() {
    for (; position_ < text_.size(); ++position_) {
      const char c = text_[position_];
      if (is_quoted_) {
        take_quoted(c);
      } else if (c == '"') {
        is_quoted_ = true;
      } else if (c == ',') {
        end_field();
      } else if (c == '\n') {
        end_record();
      } else if (c != '\r') {
        field_ += c;
      }
    }
    if (is_quoted_) return std::nullopt;
    end_record();
    return std::move(records_);
  }

 private:
  void take_quoted(char c) {
    const bool is_doubled = c == '"' && position_ + 1 < text_.size() && text_[position_ + 1] == '"';
    if (c == '"' && !is_doubled) {
      is_quoted_ = false;
      return;
    }
    if (is_doubled) ++position_;
    if (c == '\n') ++line_;
    if (c != '\r') field_ += c == '\n' ? ' ' : c;
  }

  void end_field() { record_.fields.push_back(std::exchange(field_, {})); }

  void end_record() {
    end_field();
    const bool is_empty = record_.fields.size() == 1 && record_.fields[0].empty();
    if (!is_empty) records_.push_back(record_);
    ++line_;
    record_ = {line_, {}};
  }

  std::string_view text_;
  std::size_t position_ = 0;
  bool is_quoted_ = false;
  int line_ = 1;
  std::string field_;
  CsvRecord record_{1, {}};
  std::vector<CsvRecord> records_;
};

}  // namespace

std::optional<std::vector<CsvRecord>> read_csv(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return Reader(text).read();
}

}  // namespace rules
