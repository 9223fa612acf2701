#pragma once
// Requirements and verdicts as HTML: the verdict at the top, open points, the summary, and the
// table of a plane.

#include "report/document/document.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/stream/spill.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace report {

// Returns the verdict. If options selected a part of the requirements it says so first and is never
// green.
std::string html_verdict_banner(const Texts& t, const DocumentFrame& frame, const DocumentEnd& end,
                                const std::string& link = {});

// Returns remarks to be read with a finding's quantity: clause, state, scene, notes; "" if there
// are none.
std::string html_finding_notes(const Texts& t, const rules::Finding& finding,
                               const Footnotes& footnotes);
// Returns the badge; if the finding does not count, with words that say so; if advice is not
// followed, with the recommended range. plane: has this finding.
std::string html_verdict(const Texts& t, const PlanePart& plane, const rules::Finding& finding);

// The list of everything that does not pass, gravest first.
class HtmlAttention {
 public:
  // folder: of the planes' pages, see plane_href().
  HtmlAttention(const Texts& t, std::string folder, const SpillPlace& place)
      : t_(t), folder_(std::move(folder)), items_(place) {}

  // index: of the project.
  void add(const ProjectPart& project, std::size_t index, const Footnotes& footnotes);
  bool is_empty() const { return items_.is_empty(); }  // all is well
  void copy_to(Sink& sink) const;                      // nothing when it is empty

 private:
  struct Item {
    double margin = 0.0;  // the order of findings; 0 where there is none
    std::uint64_t begin = 0;
    std::size_t length = 0;
  };
  struct Items {  // of one verdict, in their order
    std::vector<Item> findings, aggregates, projects;
  };

  Item kept(const std::string& html, double margin = 0.0);
  void add_findings(const ProjectPart& project, std::size_t index, rules::Verdict verdict,
                    const Footnotes& footnotes, Items& items);

  Texts t_;
  std::string folder_;
  Spill items_;
  std::map<rules::Verdict, Items> by_verdict_;
};

// Returns parts of the table by building, room and plane, which the page's script sorts and
// filters: before, between and after the rows of projects. is_folded: behind a line of words.
std::string html_summary_title(const Texts& t, bool is_folded);
std::string html_summary_start(const Texts& t, const std::string& region, double confidence);
std::string html_summary_rows(const Texts& t, const ProjectPart& project, std::size_t index,
                              bool is_only, const std::string& folder, const Footnotes& footnotes);
std::string html_summary_end(bool is_folded);
// Returns the requirements of a plane; "" if it has none.
std::string html_plane_findings(const Texts& t, const SpacePart& space, const PlanePart& plane,
                                const Footnotes& footnotes);

}  // namespace report
