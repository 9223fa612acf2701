#include "rules/pack/expression.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace rules {
namespace {

constexpr std::size_t kLongestText = 1000;
constexpr int kDeepest = 32;
constexpr double kLargestNumber = 1.0e9;
constexpr int kMostSteps = 100;

struct Function {
  const char* name;
  ExpressionKind kind;
};
constexpr std::array kFunctions{
    Function{"row", ExpressionKind::row_value},  Function{"table", ExpressionKind::table},
    Function{"limit", ExpressionKind::limit_of}, Function{"result", ExpressionKind::result_of},
    Function{"fact", ExpressionKind::fact},      Function{"step", ExpressionKind::step},
    Function{"min", ExpressionKind::minimum},    Function{"max", ExpressionKind::maximum},
};

calc::Names function_names() {
  calc::Names names;
  for (const Function& function : kFunctions) names.emplace_back(function.name);
  return names;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_name_part(char c) {
  return is_letter(c) || calc::is_digit(c) || c == '_' || c == '.' || c == ':' || c == '-';
}

struct SyntaxError {
  std::string text;
  std::size_t position;
};

// Recursive descent; throws SyntaxError, which does not leave this file.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Expression parse() {
    Expression result = sum();
    if (!at_end()) fail("expected '+', '*', '/' or the end");
    return result;
  }

 private:
  // Counts the depth of nested brackets, which is the depth of calls.
  class Depth {
   public:
    explicit Depth(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepest) {
        parser_.fail(fmt::format("brackets are nested more than {} deep", kDeepest));
      }
    }
    ~Depth() { --parser_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    Parser& parser_;
  };

  [[noreturn]] void fail(std::string text) const { throw SyntaxError{std::move(text), position_}; }

  void skip_blanks() {
    while (position_ < text_.size() && text_[position_] == ' ') ++position_;
  }
  bool at_end() {
    skip_blanks();
    return position_ == text_.size();
  }
  bool take(char wanted) {
    if (at_end() || text_[position_] != wanted) return false;
    ++position_;
    return true;
  }
  void expect(char wanted) {
    if (!take(wanted)) fail(fmt::format("expected '{}'", wanted));
  }

  static Expression joined(ExpressionKind kind, Expression left, Expression right) {
    Expression result;
    result.kind = kind;
    result.operands.push_back(std::move(left));
    result.operands.push_back(std::move(right));
    return result;
  }

  Expression sum() {
    const Depth depth(*this);
    Expression result = product();
    while (take('+')) result = joined(ExpressionKind::add, std::move(result), product());
    return result;
  }

  Expression product() {
    Expression result = factor();
    for (;;) {
      if (take('*')) {
        result = joined(ExpressionKind::multiply, std::move(result), factor());
      } else if (take('/')) {
        result = joined(ExpressionKind::divide, std::move(result), factor());
      } else {
        return result;
      }
    }
  }

  Expression factor() {
    if (at_end()) fail("expected a number, a function or '('");
    if (take('(')) {
      Expression inner = sum();
      expect(')');
      return inner;
    }
    if (calc::is_digit(text_[position_])) return number();
    if (is_letter(text_[position_])) return function();
    fail("expected a number, a function or '('");
  }

  Expression number() {
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (calc::is_digit(text_[position_]) || text_[position_] == '.')) {
      ++position_;
    }
    const std::optional<double> value = calc::parse_number(text_.substr(begin, position_ - begin));
    if (!value || *value > kLargestNumber) {
      position_ = begin;
      fail("expected a decimal number from 0 to 1e9");
    }
    Expression result;
    result.number = *value;
    skip_blanks();
    if (const std::optional<Unit> unit = unit_at_start(text_.substr(position_))) {
      position_ += unit->name.size();
      result.number *= unit->factor;
      result.dimension = unit->dimension;
    }
    return result;
  }

  std::string name() {
    skip_blanks();
    const std::size_t begin = position_;
    while (position_ < text_.size() && is_name_part(text_[position_])) ++position_;
    if (begin == position_) fail("expected a name");
    return std::string(text_.substr(begin, position_ - begin));
  }

  int signed_steps() {
    const bool is_down = !take('+') && take('-');
    skip_blanks();
    int steps = 0;
    const std::size_t begin = position_;
    while (position_ < text_.size() && calc::is_digit(text_[position_]) && steps <= kMostSteps) {
      steps = 10 * steps + (text_[position_++] - '0');
    }
    if (begin == position_ || steps > kMostSteps) {
      position_ = begin;
      fail(fmt::format("expected a number of steps such as +1 or -1, at most {}", kMostSteps));
    }
    return is_down ? -steps : steps;
  }

  ExpressionKind function_kind() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
    const std::string_view found = text_.substr(begin, position_ - begin);
    for (const Function& function : kFunctions) {
      if (found == function.name) return function.kind;
    }
    position_ = begin;
    fail(fmt::format("unknown function '{}'; allowed: {}{}", found,
                     calc::join_choices(function_names()),
                     calc::suggestion(found, function_names())));
  }

  Expression function() {
    Expression result;
    result.kind = function_kind();
    expect('(');
    switch (result.kind) {
      case ExpressionKind::minimum:
      case ExpressionKind::maximum:
        do {
          result.operands.push_back(sum());
        } while (take(','));
        break;
      case ExpressionKind::table:
        result.name = name();
        expect(',');
        result.operands.push_back(sum());
        break;
      case ExpressionKind::step:
        result.operands.push_back(sum());
        expect(',');
        result.steps = signed_steps();
        expect(',');
        result.name = name();
        break;
      default:
        result.name = name();
    }
    expect(')');
    return result;
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

ParsedExpression parse_expression(std::string_view text) {
  ParsedExpression result;
  if (text.size() > kLongestText) {
    result.error = fmt::format("the formula has more than {} characters", kLongestText);
    return result;
  }
  try {
    result.expression = Parser(text).parse();
  } catch (const SyntaxError& error) {
    result.error = error.text;
    result.position = error.position;
  }
  return result;
}

}  // namespace rules
