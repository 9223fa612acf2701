#include "rules/catalogue/aggregate.h"

namespace rules {

const char* rule_name(AggregateRule rule) {
  switch (rule) {
    case AggregateRule::all:
      return "all";
    case AggregateRule::any:
      return "any";
    case AggregateRule::at_least:
      return "at-least";
    case AggregateRule::share:
      return "share";
  }
  return "";
}

const char* over_name(AggregateOver over) {
  switch (over) {
    case AggregateOver::checks:
      return "checks";
    case AggregateOver::planes:
      return "planes";
    case AggregateOver::rooms:
      return "rooms";
  }
  return "";
}

const char* kind_name(AggregateKind kind) {
  return kind == AggregateKind::aggregate ? "aggregate" : "class";
}

}  // namespace rules
