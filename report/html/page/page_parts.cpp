#include "report/html/page/page_parts.h"

#include "report/html/page/html_markup.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>

namespace report {
namespace {

std::string region_start() {
  const std::string box = scroll_box_start("");  // up to the quote at the end of its label
  return box.substr(box.find("role="), box.rfind('"') - box.find("role="));
}

std::string page_number(const ContentsEntry& entry, const PageNumbers* numbers) {
  if (numbers == nullptr) return {};
  const auto page = numbers->find(entry.address.substr(1));  // without '#'
  if (page == numbers->end()) return {};
  return fmt::format("<span class=\"page-number\">{}</span>", page->second);
}

}  // namespace

std::string RegionNames::unique(const std::string& label) {
  if (!is_taken(label)) return *plain_.insert(label).first;
  for (int& k = next_.try_emplace(label, 2).first->second;;) {
    std::string name = fmt::format("{} ({})", label, k++);
    if (!plain_.contains(name)) return name;
  }
}

std::string RegionNames::with_unique_regions(std::string_view html) {
  const std::string start = region_start();
  std::string unique_html;
  unique_html.reserve(html.size());
  for (std::size_t at = html.find(start); at != std::string_view::npos; at = html.find(start)) {
    const std::size_t begin = at + start.size();
    const std::string label(html.substr(begin, html.find('"', begin) - begin));
    unique_html += html.substr(0, begin);
    unique_html += unique(label);
    html.remove_prefix(begin + label.size());
  }
  unique_html += html;
  return unique_html;
}

bool RegionNames::is_taken(const std::string& name) const {
  if (plain_.contains(name)) return true;
  const std::size_t at = name.rfind(" (");
  if (at == std::string::npos) return false;
  const auto found = next_.find(name.substr(0, at));
  if (found == next_.end()) return false;
  int k = 0;
  std::from_chars(name.data() + at + 2, name.data() + name.size(), k);
  return k >= 2 && k < found->second && name.substr(at) == fmt::format(" ({})", k);
}

std::string html_contents(const Texts& t, const std::vector<ContentsEntry>& entries,
                          const PageNumbers* numbers) {
  std::string html =
      fmt::format("<nav aria-label=\"{0}\"><h2 class=\"on-paper\">{0}</h2><ul class=\"contents\">",
                  t[Text::contents]);
  for (const ContentsEntry& entry : entries)
    html += fmt::format("<li{}><a href=\"{}\">{}</a>{}</li>",
                        entry.is_on_paper ? " class=\"on-paper\"" : "", entry.address, entry.words,
                        page_number(entry, numbers));
  return html + "</ul></nav>\n";
}

}  // namespace report
