#include "report/tools/import/step_text.h"

#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kLinesBlock = 65536;
constexpr std::size_t kMostNames = 10000;  // of classes; IFC has less than 1500
constexpr std::size_t kMostDigits = 18;    // of the number of an instance: it fits 64 bits

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool is_name_part(char c) { return is_letter(c) || calc::is_digit(c) || c == '-'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

// "'abc'" of what stands in a file, short and harmless.
std::string in_quotes(std::string_view text) {
  return "'" + calc::shorten_utf8(calc::printable(text.substr(0, 200)), 40) + "'";
}

}  // namespace

// Where a reader is in the text. Every function leaves a reason in problem() when it returns false
// or nothing; what was read before is then of no use.
class StepCursor {
 public:
  explicit StepCursor(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  std::size_t problem_at() const { return problem_at_; }
  const std::string& problem() const { return problem_; }
  std::string_view from(std::size_t begin) const { return text_.substr(begin, at_ - begin); }
  bool is_end() const { return at_ >= text_.size(); }
  char front() const { return is_end() ? '\0' : text_[at_]; }

  bool fail(std::size_t at, std::string what) {
    problem_at_ = at;
    problem_ = std::move(what);
    return false;
  }

  // Blanks and comments.
  bool skip() {
    for (;;) {
      while (!is_end() && is_blank(text_[at_])) ++at_;
      if (text_.substr(at_, 2) != "/*") return true;
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) return fail(at_, "a comment that is never closed");
      at_ = end + 2;
    }
  }

  bool take(char c) {
    if (!skip()) return false;
    if (!is_end() && text_[at_] == c) {
      ++at_;
      return true;
    }
    return fail(at_, fmt::format("'{}' is expected, but {} found", c, here()));
  }

  // As far as it goes; "" if none is there.
  std::string_view name() {
    const std::size_t begin = at_;
    if (!is_end() && (is_letter(text_[at_]) || text_[at_] == '!')) {
      ++at_;
      while (!is_end() && is_name_part(text_[at_])) ++at_;
    }
    return from(begin);
  }

  // #12 as 12.
  std::optional<std::uint64_t> reference() {
    const std::size_t begin = at_++;
    std::uint64_t number = 0;
    while (!is_end() && calc::is_digit(text_[at_])) {
      if (at_ - begin > kMostDigits) {
        fail(begin, fmt::format("the number of an instance has more than {} digits", kMostDigits));
        return std::nullopt;
      }
      number = 10 * number + static_cast<std::uint64_t>(text_[at_++] - '0');
    }
    if (at_ == begin + 1) {
      fail(begin, "'#' without a number");
      return std::nullopt;
    }
    return number;
  }

  // Of any kind. The slice of lists and typed values includes their brackets.
  std::optional<StepValue> value(int depth) {
    if (!skip()) return std::nullopt;
    const std::size_t begin = at_;
    const auto result = [&](StepValue::Kind kind) {
      return std::optional(StepValue(kind, from(begin)));
    };
    const char c = front();
    if (c == '$' || c == '*') {
      ++at_;
      return result(c == '$' ? StepValue::Kind::null : StepValue::Kind::derived);
    }
    if (c == '\'') return string() ? result(StepValue::Kind::text) : std::nullopt;
    if (c == '#') return reference() ? result(StepValue::Kind::reference) : std::nullopt;
    if (c == '.') return enumeration() ? result(StepValue::Kind::enumeration) : std::nullopt;
    if (c == '"') return binary() ? result(StepValue::Kind::binary) : std::nullopt;
    if (c == '(') return list(depth) ? result(StepValue::Kind::list) : std::nullopt;
    if (calc::is_digit(c) || c == '+' || c == '-') {
      return number() ? result(StepValue::Kind::number) : std::nullopt;
    }
    if (is_letter(c)) {
      name();
      if (!skip()) return std::nullopt;
      if (front() != '(') {
        fail(begin, fmt::format("a value is expected, but {} found", in_quotes(from(begin))));
        return std::nullopt;
      }
      return list(depth) ? result(StepValue::Kind::typed) : std::nullopt;
    }
    fail(at_, is_end() ? std::string("the file ends within an instance: it is cut off")
                       : fmt::format("a value is expected, but {} found", here()));
    return std::nullopt;
  }

  // (a,b,...): into `items` if there is somewhere to put them.
  bool list(int depth, std::vector<StepValue>* items = nullptr) {
    if (depth >= kDeepestStepList) {
      return fail(at_, fmt::format("lists are nested more than {} deep", kDeepestStepList));
    }
    ++at_;  // the bracket
    if (!skip()) return false;
    if (front() == ')') {
      ++at_;
      return true;
    }
    for (;;) {
      const std::optional<StepValue> item = value(depth + 1);
      if (!item || !skip()) return false;
      if (items != nullptr) items->push_back(*item);
      const char c = front();
      if (c != ',' && c != ')') {
        return fail(at_, is_end() ? std::string("the file ends within an instance: it is cut off")
                                  : fmt::format("',' or ')' is expected, but {} found", here()));
      }
      ++at_;
      if (c == ')') return true;
    }
  }

  std::string here() const {
    return is_end() ? std::string("the end of the file") : in_quotes(text_.substr(at_, 1));
  }

 private:
  bool string() {
    const std::size_t begin = at_++;
    while (!is_end()) {
      const char c = text_[at_];
      if (c == '\\') {
        // In \S\' the quote belongs to the escape. A doubled backslash begins none.
        const std::string_view rest = text_.substr(at_, 3);
        at_ += rest == "\\S\\" ? 4u : rest.starts_with("\\\\") ? 2u : 1u;
      } else if (c != '\'') {
        ++at_;
      } else if (text_.substr(at_, 2) == "''") {
        at_ += 2;
      } else {
        ++at_;
        return true;
      }
    }
    at_ = text_.size();
    return fail(begin, "a string that is never closed");
  }

  bool enumeration() {
    const std::size_t begin = at_++;
    while (!is_end() && is_name_part(text_[at_])) ++at_;
    if (front() != '.' || at_ == begin + 1) {
      return fail(begin, fmt::format("{} is not an enumeration such as .METRE.",
                                     in_quotes(text_.substr(begin, at_ - begin + 1))));
    }
    ++at_;
    return true;
  }

  bool binary() {
    const std::size_t begin = at_;
    const std::size_t end = text_.find('"', at_ + 1);
    if (end == std::string_view::npos) return fail(begin, "a binary value that is never closed");
    at_ = end + 1;
    return true;
  }

  bool number() {
    const std::size_t begin = at_;
    while (!is_end() && (is_name_part(text_[at_]) || text_[at_] == '+' || text_[at_] == '.')) {
      ++at_;
    }
    if (calc::parse_number(from(begin))) return true;
    return fail(begin, fmt::format("{} is not a finite number", in_quotes(from(begin))));
  }

  std::string_view text_;
  std::size_t at_ = 0, problem_at_ = 0;
  std::string problem_;
};

std::optional<double> StepValue::number() const {
  if (kind_ != Kind::number) return std::nullopt;
  return calc::parse_number(slice_);
}

std::optional<std::uint64_t> StepValue::reference() const {
  if (kind_ != Kind::reference) return std::nullopt;
  return StepCursor(slice_).reference();
}

std::optional<std::string> StepValue::text(bool* is_sure) const {
  if (kind_ != Kind::text) return std::nullopt;
  return step_string(slice_.substr(1, slice_.size() - 2), is_sure);
}

std::string StepValue::enumeration() const {
  if (kind_ != Kind::enumeration) return {};
  return upper(slice_.substr(1, slice_.size() - 2));
}

std::string StepValue::type_name() const {
  if (kind_ != Kind::typed) return {};
  return upper(StepCursor(slice_).name());
}

std::vector<StepValue> StepValue::items() const {
  std::vector<StepValue> items;
  if (kind_ != Kind::list && kind_ != Kind::typed) return items;
  StepCursor cursor(slice_);
  cursor.name();
  cursor.skip();
  cursor.list(0, &items);  // cannot fail: the text was gone through when it was opened
  return items;
}

StepValue StepValue::untyped() const {
  if (kind_ != Kind::typed) return *this;
  const std::vector<StepValue> inside = items();
  return inside.size() == 1 ? inside[0].untyped() : StepValue();
}

// Goes through the whole text once.
class StepText::Opener {
 public:
  Opener(std::string_view bytes, StepText& text) : bytes_(bytes), text_(text), cursor_(bytes) {}

  bool read() {
    count_lines();
    const bool is_read = sections();
    return is_read && sort();
  }
  StepProblem problem() const {
    return {text_.line_at(std::min(cursor_.problem_at(), bytes_.size())), cursor_.problem()};
  }

 private:
  void count_lines() {
    std::uint32_t lines = 0;
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      if (i % kLinesBlock == 0) text_.lines_before_.push_back(lines);
      if (bytes_[i] == '\n') ++lines;
    }
  }

  // A word and its semicolon.
  bool statement(std::string_view word) {
    if (!cursor_.skip()) return false;
    const std::size_t begin = cursor_.at();
    const std::string found = upper(cursor_.name());
    if (found != word) {
      return cursor_.fail(begin, fmt::format("{} is expected, but {} found", word,
                                             found.empty() ? cursor_.here() : in_quotes(found)));
    }
    return cursor_.take(';');
  }

  bool sections() {
    if (!statement("ISO-10303-21") || !statement("HEADER")) return false;
    for (;;) {
      if (!cursor_.skip()) return false;
      const std::size_t begin = cursor_.at();
      const std::string name = upper(cursor_.name());
      if (name == "ENDSEC") break;
      if (name.empty()) return cursor_.fail(begin, "ENDSEC of the header is expected");
      const std::optional<StepValue> arguments = list_here();
      if (!arguments || !cursor_.take(';')) return false;
      header(name, *arguments);
    }
    if (!cursor_.take(';')) return false;
    for (;;) {
      if (!cursor_.skip()) return false;
      const std::size_t begin = cursor_.at();
      const std::string name = upper(cursor_.name());
      if (name == "END-ISO-10303-21") return cursor_.take(';');
      if (name != "DATA") {
        return cursor_.fail(
            begin,
            name.empty()
                ? fmt::format("DATA or END-ISO-10303-21 is expected, but {} found", cursor_.here())
                : fmt::format("the section {} is not read; only HEADER and DATA are",
                              in_quotes(name)));
      }
      if (!cursor_.skip()) return false;
      if (cursor_.front() == '(' && !list_here()) return false;
      if (!cursor_.take(';') || !data()) return false;
    }
  }

  std::optional<StepValue> list_here() {
    if (!cursor_.skip()) return std::nullopt;
    if (cursor_.front() != '(') {
      cursor_.fail(cursor_.at(), fmt::format("'(' is expected, but {} found", cursor_.here()));
      return std::nullopt;
    }
    return cursor_.value(0);
  }

  void header(const std::string& name, const StepValue& arguments) {
    const std::vector<StepValue> argument = arguments.items();
    if (name == "FILE_SCHEMA" && !argument.empty()) {
      for (const StepValue& schema : argument[0].items()) {
        if (const auto text = schema.text()) text_.schema_.push_back(upper(*text));
      }
    }
  }

  bool data() {
    for (;;) {
      if (!cursor_.skip()) return false;
      const std::size_t begin = cursor_.at();
      if (cursor_.front() == '#') {
        if (!instance()) return false;
        continue;
      }
      const std::string name = upper(cursor_.name());
      if (name == "ENDSEC") {
        text_.data_end_ = begin;
        return cursor_.take(';');
      }
      return cursor_.fail(
          begin, cursor_.is_end()
                     ? std::string("the file ends before ENDSEC of its data: it is cut off")
                     : fmt::format("an instance (#12=...) or ENDSEC is expected, but {} found",
                                   name.empty() ? cursor_.here() : in_quotes(name)));
    }
  }

  bool instance() {
    const std::optional<std::uint64_t> number = cursor_.reference();
    if (!number || !cursor_.take('=') || !cursor_.skip()) return false;
    const std::size_t named = cursor_.at();
    const std::string_view name = cursor_.name();
    if (!cursor_.skip()) return false;
    const std::size_t begin = cursor_.at();
    if (name.empty()) {
      if (!several()) return false;
    } else if (!list_here()) {
      return false;
    }
    const std::size_t end = cursor_.at();
    if (name.empty() && end == begin) {
      return cursor_.fail(named, "the name of an instance is expected");
    }
    if (!cursor_.take(';')) return false;
    if (text_.instance_.size() >= std::numeric_limits<std::uint32_t>::max()) {
      return cursor_.fail(named, "too many instances");
    }
    const std::uint32_t name_number = number_of(name);
    if (text_.name_.size() > kMostNames) {
      return cursor_.fail(
          named, fmt::format("more than {} different names of instances; this is not an IFC file",
                             kMostNames));
    }
    text_.instance_.push_back({*number, name_number, static_cast<std::uint32_t>(begin),
                               static_cast<std::uint32_t>(end - begin)});
    return true;
  }

  // (A(...)B(...))
  bool several() {
    if (!cursor_.take('(')) return false;
    for (;;) {
      if (!cursor_.skip()) return false;
      if (cursor_.front() == ')') return cursor_.take(')');
      if (cursor_.name().empty()) {
        return cursor_.fail(
            cursor_.at(),
            fmt::format("the name of an instance is expected, but {} found", cursor_.here()));
      }
      if (!list_here()) return false;
    }
  }

  std::uint32_t number_of(std::string_view name) {
    key_.assign(name);
    for (char& c : key_) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    const auto [found, is_new] =
        text_.name_number_.try_emplace(key_, static_cast<std::uint32_t>(text_.name_.size()));
    if (is_new) text_.name_.push_back(&found->first);
    return found->second;
  }

  bool sort() {
    std::vector<Instance>& all = text_.instance_;
    const auto by_number = [](const Instance& a, const Instance& b) {
      return a.number != b.number ? a.number < b.number : a.begin < b.begin;
    };
    if (!std::is_sorted(all.begin(), all.end(), by_number)) {
      std::sort(all.begin(), all.end(), by_number);
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i].number != all[i - 1].number) continue;
      return cursor_.fail(all[i].begin,
                          fmt::format("#{} is given twice, first in line {}", all[i].number,
                                      text_.line_at(all[i - 1].begin)));
    }
    text_.name_at_.assign(text_.name_.size() + 1, 0);
    for (const Instance& one : all) ++text_.name_at_[one.name + 1];
    for (std::size_t i = 1; i < text_.name_at_.size(); ++i) {
      text_.name_at_[i] += text_.name_at_[i - 1];
    }
    text_.by_name_.resize(all.size());
    std::vector<std::uint32_t> next(text_.name_at_.begin(), text_.name_at_.end() - 1);
    for (std::uint32_t i = 0; i < all.size(); ++i) text_.by_name_[next[all[i].name]++] = i;
    return true;
  }

  std::string_view bytes_;
  StepText& text_;
  StepCursor cursor_;
  std::string key_;
};

std::optional<StepText> StepText::open(std::string_view bytes, StepProblem& problem) {
  const std::string_view begun = calc::without_byte_order_mark(bytes);
  const std::string_view start = calc::trim(begun.substr(0, 4096));
  const calc::FileKind* kind = calc::kind_by_content(bytes);
  const bool is_drawing = kind != nullptr && kind->use == calc::FileUse::drawing;
  if (kind != nullptr && !kind->is_vague && !is_drawing && !start.starts_with("ISO-10303")) {
    problem = {0, fmt::format("it is {}; an IFC model (STEP text) is needed here", kind->words)};
  } else if (start.starts_with("PK\x03\x04")) {
    problem = {0, "this is a ZIP file; unpack it and give the IFC file within it"};
  } else if (start.starts_with("<")) {
    problem = {0, "this is XML; IFC is read as STEP text, which begins with ISO-10303-21"};
  } else if (calc::has_utf16_mark(bytes)) {
    problem = {0, "this is UTF-16; STEP text must be single bytes"};
  } else if (begun.size() >= std::numeric_limits<std::uint32_t>::max()) {
    problem = {0, "the file has more than 4 GiB"};
  } else {
    StepText text;
    text.bytes_ = begun;
    text.is_utf8_ = !calc::first_invalid_utf8(begun);
    Opener opener(begun, text);
    if (opener.read()) {
      if (text.data_end_ != 0) text.data_end_ += bytes.size() - begun.size();
      return text;
    }
    problem = opener.problem();
  }
  return std::nullopt;
}

std::optional<std::uint32_t> StepText::find(std::uint64_t number) const {
  const auto found = std::lower_bound(
      instance_.begin(), instance_.end(), number,
      [](const Instance& one, std::uint64_t wanted) { return one.number < wanted; });
  if (found == instance_.end() || found->number != number) return std::nullopt;
  return static_cast<std::uint32_t>(found - instance_.begin());
}

std::optional<std::uint32_t> StepText::find(const StepValue& reference) const {
  const std::optional<std::uint64_t> number = reference.reference();
  return number ? find(*number) : std::nullopt;
}

std::size_t StepText::line(std::uint32_t instance) const {
  return line_at(instance_[instance].begin);
}

std::size_t StepText::line_at(std::size_t offset) const {
  if (lines_before_.empty()) return 1;
  const std::size_t block = std::min(offset / kLinesBlock, lines_before_.size() - 1);
  const std::string_view before = bytes_.substr(block * kLinesBlock, offset - block * kLinesBlock);
  return 1 + lines_before_[block] +
         static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::span<const std::uint32_t> StepText::of_name(std::string_view name) const {
  const auto found = name_number_.find(name);
  if (found == name_number_.end()) return {};
  const std::uint32_t begin = name_at_[found->second], end = name_at_[found->second + 1];
  return std::span(by_name_).subspan(begin, end - begin);
}

std::vector<StepValue> StepText::arguments(std::uint32_t instance) const {
  const Instance& one = instance_[instance];
  if (name(instance).empty()) return {};
  return StepValue(StepValue::Kind::list, bytes_.substr(one.begin, one.size)).items();
}

}  // namespace cli
