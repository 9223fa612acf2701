#include "report/tools/import/project_merge.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace cli {
namespace {

struct Attribute {
  std::string name, value;         // as written
  std::size_t begin = 0, end = 0;  // of the value, without its quotes
  std::size_t from = 0, to = 0;    // with the blank before its name, and its quotes
};
struct Element {
  std::string name, path;
  std::vector<Attribute> attribute;
  std::vector<std::size_t> child;  // those of the list
  std::size_t parent = 0;
  std::size_t begin = 0, end = 0;  // of all of it
  std::size_t head_end = 0;        // behind the last attribute
  std::size_t content_end = 0;     // where its closing tag begins
  bool is_empty = false;           // <a/>

  const Attribute* find(std::string_view wanted) const {
    for (const Attribute& one : attribute) {
      if (one.name == wanted) return &one;
    }
    return nullptr;
  }
  std::string value(std::string_view wanted) const {
    const Attribute* found = find(wanted);
    return found == nullptr ? "" : found->value;
  }
};

// Elements of a well-formed text with their places, the root first.
class Places {
 public:
  // text must outlive it.
  explicit Places(std::string_view text) : text_(text) { scan(); }

  const std::vector<Element>& all() const { return element_; }
  const Element* find(const std::string& path) const {
    const auto found = by_path_.find(path);
    return found == by_path_.end() ? nullptr : &element_[found->second];
  }
  std::string_view text() const { return text_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  void skip_to(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == text_.npos ? text_.size() : found + end.size();
  }

  void scan() {
    std::vector<std::size_t> open;
    while ((at_ = text_.find('<', at_)) != text_.npos) {
      const std::string_view rest = text_.substr(at_);
      if (rest.substr(0, 4) == "<!--") {
        skip_to("-->");
      } else if (rest.substr(0, 2) == "<?") {
        skip_to("?>");
      } else if (rest.substr(0, 9) == "<![CDATA[") {
        skip_to("]]>");
      } else if (rest.substr(0, 2) == "</") {
        if (open.empty()) return;
        Element& element = element_[open.back()];
        element.content_end = at_;
        skip_to(">");
        element.end = at_;
        open.pop_back();
      } else {
        scan_element(open);
      }
    }
  }

  void scan_element(std::vector<std::size_t>& open) {
    Element element;
    element.begin = at_++;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '>' && text_[at_] != '/') {
      element.name += text_[at_++];
    }
    element.head_end = at_;
    while (at_ < text_.size()) {
      const std::size_t from = at_;
      while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
      if (at_ >= text_.size() || text_[at_] == '>' || text_[at_] == '/') break;
      Attribute attribute;
      attribute.from = from;
      while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '=') {
        attribute.name += text_[at_++];
      }
      at_ = std::min(text_.find_first_of("\"'", at_), text_.size());
      if (at_ >= text_.size()) return;
      attribute.begin = at_ + 1;
      attribute.end = std::min(text_.find(text_[at_], at_ + 1), text_.size());
      attribute.value = text_.substr(attribute.begin, attribute.end - attribute.begin);
      at_ = attribute.to = std::min(attribute.end + 1, text_.size());
      element.head_end = at_;
      element.attribute.push_back(std::move(attribute));
    }
    element.is_empty = at_ < text_.size() && text_[at_] == '/';
    skip_to(">");
    element.end = element.content_end = at_;
    const std::size_t index = element_.size();
    if (!open.empty()) {
      element.parent = open.back();
      element_[open.back()].child.push_back(index);
      // Without an id it is nobody's but the user's.
      if (element.find("id") != nullptr) {
        element.path =
            fmt::format("{}/{} {}", element_[open.back()].path, element.name, element.value("id"));
      }
    }
    if (open.empty() || !element.path.empty()) by_path_.try_emplace(element.path, index);
    if (!element.is_empty) open.push_back(index);
    element_.push_back(std::move(element));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Element> element_;
  std::map<std::string, std::size_t> by_path_;  // "" = the root
};

// "luminaire L-2A"
std::string words_of(const Element& element) {
  if (element.path.empty()) return element.name;
  return fmt::format("{} {}", element.name, element.value("id"));
}

class Merger {
 public:
  Merger(const Places& base, const Places& mine, const Places& next)
      : base_(base), mine_(mine), next_(next) {}

  MergedProject merge() {
    for (const Element& element : next_.all()) {
      if (element.path.empty() && &element != &next_.all().front()) continue;
      take(element);
    }
    for (const Element& element : base_.all()) {
      if (!element.path.empty() && next_.find(element.path) == nullptr) drop(element);
    }
    place_new();
    result_.xml = edited();
    return std::move(result_);
  }

 private:
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };

  void take(const Element& next) {
    const Element* base = base_.find(next.path);
    const Element* mine = mine_.find(next.path);
    if (base != nullptr && mine != nullptr) return take_attributes(*base, *mine, next);
    if (mine != nullptr) {
      if (!same_attributes(*mine, next)) {
        conflict(next, "it is new in the drawing, and was there by hand before");
      }
      return;
    }
    const Element& parent = next_.all()[next.parent];
    if (base != nullptr) {
      if (mine_.find(parent.path) != nullptr && !same_attributes(*base, next)) {
        conflict(next, "it was removed by hand, and changed in the drawing: it stays removed");
      }
      return;
    }
    const Element* home = mine_.find(parent.path);
    if (home != nullptr) {
      new_[home->begin].push_back(&next);
      result_.changes.push_back(fmt::format("came: {}", words_of(next)));
    } else if (base_.find(parent.path) != nullptr) {
      conflict(next, fmt::format("it is new, but {} was removed by hand", words_of(parent)));
    }  // else it comes with its parent
  }

  static bool same_attributes(const Element& a, const Element& b) {
    return a.attribute.size() == b.attribute.size() &&
           std::all_of(a.attribute.begin(), a.attribute.end(), [&](const Attribute& one) {
             const Attribute* other = b.find(one.name);
             return other != nullptr && other->value == one.value;
           });
  }

  void take_attributes(const Element& base, const Element& mine, const Element& next) {
    std::vector<std::string> names;
    for (const Element* element : {&base, &next}) {
      for (const Attribute& one : element->attribute) {
        if (std::find(names.begin(), names.end(), one.name) == names.end()) {
          names.push_back(one.name);
        }
      }
    }
    for (const std::string& name : names) {
      const Attribute* b = base.find(name);
      const Attribute* m = mine.find(name);
      const Attribute* n = next.find(name);
      const auto same = [](const Attribute* one, const Attribute* other) {
        return one == nullptr || other == nullptr ? one == other : one->value == other->value;
      };
      if (same(b, n) || same(m, n)) continue;
      const std::string change = fmt::format("{}: {} -> {}", name, b == nullptr ? "none" : b->value,
                                             n == nullptr ? "none" : n->value);
      if (!same(m, b)) {
        conflict(mine, fmt::format("{} in the drawing, {} by hand", change,
                                   m == nullptr ? "taken out" : m->value));
        continue;
      }
      result_.changes.push_back(fmt::format("{}, {}", words_of(mine), change));
      if (n == nullptr) {
        edits_.push_back({m->from, m->to, ""});
      } else if (m == nullptr) {
        edits_.push_back({mine.head_end, mine.head_end, fmt::format(" {}=\"{}\"", name, n->value)});
      } else {
        edits_.push_back({m->begin, m->end, within(n->value, mine_.text()[m->end])});
      }
    }
  }

  // A value as it stands between quotes of this kind.
  static std::string within(const std::string& value, char quote) {
    std::string text;
    for (const char c : value) {
      if (c == quote) {
        text += quote == '"' ? "&quot;" : "&apos;";
      } else {
        text += c;
      }
    }
    return text;
  }

  // Nothing of it was changed or added by hand.
  bool is_as_imported(const Element& mine) const {
    const Element* base = mine.path.empty() ? nullptr : base_.find(mine.path);
    if (base == nullptr || !same_attributes(*base, mine)) return false;
    return std::all_of(mine.child.begin(), mine.child.end(),
                       [&](std::size_t child) { return is_as_imported(mine_.all()[child]); });
  }

  void drop(const Element& base) {
    const Element* mine = mine_.find(base.path);
    if (mine == nullptr) return;
    // What goes with its parent is said by that.
    const Element& parent = base_.all()[base.parent];
    if (!parent.path.empty() && next_.find(parent.path) == nullptr) return;
    if (!is_as_imported(*mine)) {
      conflict(*mine, "it is no longer in the drawing");
      return;
    }
    result_.changes.push_back(fmt::format("went: {}", words_of(*mine)));
    gone_.insert(mine->begin);
    const std::string_view text = mine_.text();
    std::size_t begin = mine->begin, end = mine->end;
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
    const bool is_own_line = begin == 0 || text[begin - 1] == '\n';
    if (is_own_line && end < text.size() && text[end] == '\r') ++end;
    if (is_own_line && end < text.size() && text[end] == '\n') {
      ++end;
    } else {
      begin = mine->begin;
    }
    edits_.push_back({begin, end, ""});
  }

  void place_new() {
    for (const auto& [begin, list] : new_) {
      const auto home =
          std::find_if(mine_.all().begin(), mine_.all().end(),
                       [&begin = begin](const Element& one) { return one.begin == begin; });
      const bool is_root = home->path.empty();
      if (home->is_empty) {
        std::string text = ">\n";
        for (const Element* element : list) text += lines_of(*element, is_root);
        text += fmt::format("{}</{}>", is_root ? "" : "  ", home->name);
        edits_.push_back({home->head_end, home->end, text});
        continue;
      }
      for (const Element* element : list) place(*element, *home);
    }
  }

  std::string lines_of(const Element& next, bool is_in_root) const {
    return fmt::format("{}{}\n", is_in_root ? "  " : "    ",
                       next_.text().substr(next.begin, next.end - next.begin));
  }

  // Behind the last one of its kind; materials and types come first.
  void place(const Element& next, const Element& home) {
    const std::string lines = lines_of(next, home.path.empty());
    std::size_t at = home.content_end;
    bool is_behind = false;
    for (const std::size_t child : home.child) {
      const Element& other = mine_.all()[child];
      if (other.name != next.name || gone_.count(other.begin) != 0) continue;
      at = mine_.all()[child].end;
      is_behind = true;
    }
    const std::string_view text = mine_.text();
    if (!is_behind && (next.name == "material" || next.name == "luminaire-type")) {
      at = text.find('>', home.head_end) + 1;
      is_behind = true;
    }
    if (is_behind) {
      edits_.push_back({at, at, "\n" + lines.substr(0, lines.size() - 1)});
      return;
    }
    // Before the closing tag, on lines of their own.
    std::size_t line = at;
    while (line > 0 && (text[line - 1] == ' ' || text[line - 1] == '\t')) --line;
    const bool is_own_line = line > 0 && text[line - 1] == '\n';
    edits_.push_back(is_own_line ? Edit{line, line, lines} : Edit{at, at, "\n" + lines});
  }

  void conflict(const Element& element, const std::string& why) {
    result_.conflicts.push_back(fmt::format("{}, {}", words_of(element), why));
  }

  std::string edited() {
    std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
      return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
    });
    std::string text;
    std::size_t at = 0;
    for (const Edit& edit : edits_) {
      // What stands behind an element that goes, or at its end, begins at the earliest there.
      const std::size_t begin = std::max(edit.begin, at);
      text += mine_.text().substr(at, begin - at);
      text += edit.text;
      at = std::max(edit.end, begin);
    }
    return text + std::string(mine_.text().substr(at));
  }

  const Places& base_;
  const Places& mine_;
  const Places& next_;
  MergedProject result_;
  std::vector<Edit> edits_;
  std::set<std::size_t> gone_;                              // places of elements that are taken out
  std::map<std::size_t, std::vector<const Element*>> new_;  // by the place of their parent
};

}  // namespace

std::optional<MergedProject> merge_projects(const ProjectSource& base, const ProjectSource& mine,
                                            const std::string& next,
                                            calc::Diagnostics& diagnostics) {
  for (const ProjectSource* source : {&base, &mine}) {
    const std::optional<std::string> text =
        calc::decoded_xml(source->xml, source->name, diagnostics);
    if (!text || !calc::parse_xml(*text, source->name, diagnostics)) return std::nullopt;
    if (*text == source->xml) continue;
    diagnostics.report(calc::DiagnosticId::output_not_possible, {source->name, 0, 0},
                       "an import only changes projects in UTF-8: save it in UTF-8");
    return std::nullopt;
  }
  const Places base_places(base.xml), mine_places(mine.xml), next_places(next);
  MergedProject merged = Merger(base_places, mine_places, next_places).merge();
  if (!calc::parse_xml(merged.xml, mine.name, diagnostics)) return std::nullopt;
  return merged;
}

}  // namespace cli
