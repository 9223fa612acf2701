#include "report/tools/compare/compare.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "report/result_file/read_json.h"
#include "report/revision/matching.h"
#include "report/revision/revise.h"
#include "report/shell/options/recording_reader.h"
#include "report/tools/compare/compare_pairs.h"
#include "report/tools/compare/comparison.h"
#include "report/tools/compare/value_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace cli {
namespace {

using calc::DiagnosticId;

bool is_anything_judged(const report::Document& document) {
  return std::any_of(document.projects.begin(), document.projects.end(),
                     [](const report::ProjectPart& project) { return project.is_judged; });
}

// B's values are rows of a table, whether they came from one or from a result.
class Comparer {
 public:
  Comparer(const CompareOptions& options, const calc::FileReader& files,
           calc::Diagnostics& diagnostics)
      : options_(options), files_(files), diagnostics_(diagnostics) {}

  std::optional<report::Comparison> compare() {
    std::optional<report::Document> a = read_result(options_.a);
    if (!a) return std::nullopt;
    if (options_.b.size() > 5 && options_.b.ends_with(".json")) {
      b_ = read_result(options_.b);
      if (!b_) return std::nullopt;
    }
    // Two results of nothing are not alike: nobody knows.
    if (b_ && !is_anything_judged(*a) && !is_anything_judged(*b_)) {
      fail("no project could be judged in either result: there is nothing to compare");
      return std::nullopt;
    }
    comparison_.name_a = options_.a;
    comparison_.name_b = options_.b;
    comparison_.confidence = a->provenance.confidence;
    comparison_.replicates = a->provenance.replicates;
    comparison_.tolerance = options_.tolerance;
    // Of different parts nobody can tell what is asked otherwise.
    if (b_ && !options_.is_partial && a->provenance.selection != b_->provenance.selection) {
      const auto part = [](const std::string& selection) {
        return selection.empty() ? std::string("all") : "the part of " + selection;
      };
      fail(fmt::format("A is a result of {}, B of {} (--partial compares values that both have)",
                       part(a->provenance.selection), part(b_->provenance.selection)));
      return std::nullopt;
    }
    has_projects_ = a->projects.size() > 1 || (b_ && b_->projects.size() > 1);
    if (b_ && !options_.is_partial) {
      a->revision = report::revise(*b_, *a, options_.b, {});
      if (!options_.planes.empty()) keep_chosen(*a, *a->revision);
      comparison_.revised = a;
    }
    for (const auto& pair : report::match_projects(b_ ? *b_ : report::Document(), *a)) {
      if (pair.before != nullptr && pair.after != nullptr)
        path_in_a_[pair.before] = pair.after->path;
    }
    add_planes(*a);
    if (b_ && b_->provenance.confidence != comparison_.confidence) {
      const std::string words =
          fmt::format("A's intervals are at {}, B's at {}: values are compared at one level only",
                      comparison_.confidence, b_->provenance.confidence);
      if (!comparison_.revised) {
        fail(words);
        return std::nullopt;
      }
      comparison_.notes.push_back(words);
      comparison_.planes.clear();
      return std::move(comparison_);
    }
    if (!read_b() || !keep_chosen()) return std::nullopt;
    if (!are_of_one_quantity()) return std::nullopt;
    pair_points();
    if (diagnostics_.has_errors()) return std::nullopt;
    know_averages();
    report::compare_points(comparison_);
    return std::move(comparison_);
  }

 private:
  void fail(const std::string& problem) {
    diagnostics_.report(DiagnosticId::reference_unreadable, {options_.b, 0, 0}, problem);
  }
  // What one side lacks: an error, with --partial a note, and of results a difference.
  void lack(const std::string& what) {
    if (options_.is_partial) {
      comparison_.notes.push_back(what);
    } else if (comparison_.revised) {
      comparison_.notes.push_back(what);
      ++comparison_.lacks;
    } else {
      fail(what + " (--partial compares the rest)");
    }
  }

  std::optional<report::Document> read_result(const std::string& path) {
    const calc::FileContent content = files_.read(path);
    if (!content.ok()) {
      diagnostics_.report(DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
      return std::nullopt;
    }
    std::string problem;
    std::optional<report::Document> document = report::read_json(content.bytes, problem, path);
    if (!document) diagnostics_.report(DiagnosticId::result_not_readable, {}, path, problem);
    return document;
  }

  // Ratings and ratios are no illuminances: said, not compared.
  void leave_out(const std::string& id, const report::PlanePart& plane, std::string_view side) {
    const std::string quantity(calc::quantity_name(plane.kernel, plane.derived));
    comparison_.notes.push_back(fmt::format(
        "plane '{}' of {} has the quantity '{}', which is not an illuminance: not compared", id,
        side, quantity));
    (side == "A" ? ratings_a_ : ratings_b_)[id] = quantity;
  }

  void leave_out_of_both(const std::string& id) {
    std::erase_if(comparison_.planes, [&](const auto& plane) { return plane.id == id; });
    std::erase_if(rows_, [&](const TableRow& row) { return row.plane == id; });
  }

  // Of --plane A=B; what is not chosen keeps its name.
  std::string name_in_a(const std::string& in_b) const {
    for (const std::string& item : options_.planes) {
      const std::size_t equals = item.find('=');
      if (equals != std::string::npos && item.substr(equals + 1) == in_b) {
        return item.substr(0, equals);
      }
    }
    return in_b;
  }

  bool is_chosen(const std::string& in_a) const {
    return options_.planes.empty() ||
           std::any_of(options_.planes.begin(), options_.planes.end(),
                       [&](const auto& item) { return item.substr(0, item.find('=')) == in_a; });
  }

  // What is asked and judged otherwise on the chosen planes, in their rooms and in all of the run.
  void keep_chosen(const report::Document& a, report::Revision& revision) {
    std::set<std::string> names, rooms;
    for (const std::string& item : options_.planes) {
      if (item.find('=') == std::string::npos) {
        names.insert(item);
      } else {
        comparison_.notes.push_back(fmt::format(
            "--plane {}: with two names only values are compared, not requirements", item));
      }
    }
    std::size_t findings = 0;
    for (const report::ProjectPart& project : a.projects) {
      const std::string path = has_projects_ ? project.path + ":" : "";
      for (const report::SpacePart& space : project.spaces) {
        for (const report::PlanePart& plane : space.planes) {
          if (!names.contains(path + plane.id)) continue;
          rooms.insert(project.path + ":" + space.id);
          findings += plane.findings.size();
        }
      }
    }
    const auto is_elsewhere = [&](const auto& changed) {
      const report::RevisionPlace& at = changed.place;
      if (!at.plane.empty()) {
        return !names.contains((has_projects_ ? at.project + ":" : "") + at.plane);
      }
      return !at.space.empty() && !rooms.contains(at.project + ":" + at.space);
    };
    std::erase_if(revision.results, is_elsewhere);
    std::erase_if(revision.questions, is_elsewhere);
    std::erase_if(revision.planes, is_elsewhere);
    const auto changed = static_cast<std::size_t>(
        std::count_if(revision.results.begin(), revision.results.end(), [](const auto& result) {
          return !result.place.plane.empty() && result.verdict_after.has_value();
        }));
    revision.same = findings - std::min(findings, changed);
    revision.known_failures = revision.untold = 0;
  }

  // The same quantity on both sides, plane by plane.
  bool are_of_one_quantity() {
    std::map<std::string, std::string> in_b;
    for (const auto& [id, quantity] : ratings_b_) in_b[name_in_a(id)] = quantity;
    for (const TableRow& row : rows_) {  // by A's names already
      if (row.plane && !row.quantity.empty()) in_b[*row.plane] = row.quantity;
    }
    bool is_good = true;
    for (const auto& [id, quantity] : in_b) {
      const auto plane = quantity_.find(id);
      const auto rating = ratings_a_.find(id);
      const std::string in_a = plane != quantity_.end()     ? plane->second
                               : rating != ratings_a_.end() ? rating->second
                                                            : quantity;
      if (in_a == quantity || !is_chosen(id)) continue;
      const std::string words = fmt::format(
          "plane '{}' has the quantity '{}' in A and '{}' in B: they are not comparable", id, in_a,
          quantity);
      // Whoever has chosen the plane has asked for what there is not.
      if (comparison_.revised && options_.planes.empty()) {
        lack(words);
        leave_out_of_both(id);
      } else {
        fail(words);
        is_good = false;
      }
    }
    return is_good;
  }

  // Averages are judged where their own intervals are known: of a result, and of all its points; of
  // a table at worst, as if its errors went together.
  void know_averages() {
    for (std::size_t p = 0; p < comparison_.planes.size(); ++p) {
      report::ComparedPlane& plane = comparison_.planes[p];
      double sum_a = 0.0, sum_b = 0.0, errors_b = 0.0;
      for (const report::ComparedPoint& point : plane.points) {
        sum_a += point.a.lx;
        sum_b += point.b.lx;
        errors_b += point.b.half_width_lx;
      }
      const auto count = static_cast<double>(plane.points.size());
      const auto half_width = [&](const std::map<std::string, calc::Estimate>& averages,
                                  double average_lx) -> std::optional<double> {
        const auto found = averages.find(plane.id);
        if (found == averages.end()) return std::nullopt;
        const calc::Estimate& e = found->second;
        const bool is_of_these_points = std::abs(e.value - average_lx) <= 1e-6 * std::abs(e.value);
        return is_of_these_points ? std::optional(e.half_width()) : std::nullopt;
      };
      plane.average_half_width_a_lx = half_width(average_a_, sum_a / count);
      plane.average_half_width_b_lx =
          is_table_ ? std::optional(errors_b / count) : half_width(average_b_, sum_b / count);
    }
  }

  // The path, and of B that of A's project which it is: a design may lie in another folder.
  std::string name_of(const report::ProjectPart& project) const {
    const auto found = path_in_a_.find(&project);
    return found == path_in_a_.end() ? project.path : found->second;
  }

  template <class Visit>
  void for_each_plane(const report::Document& document, Visit visit) {
    for (const report::ProjectPart& project : document.projects) {
      for (const report::SpacePart& space : project.spaces) {
        for (const report::PlanePart& plane : space.planes) {
          visit((has_projects_ ? name_of(project) + ":" : "") + plane.id, plane);
        }
      }
    }
  }

  void add_planes(const report::Document& document) {
    for_each_plane(document, [&](const std::string& id, const report::PlanePart& plane) {
      if (!plane.is_computed) {
        if (is_chosen(id))
          lack(fmt::format("plane '{}' was not computed in A: {}", id, plane.reason.english()));
        return;
      }
      if (calc::is_plain_number(plane.derived)) return leave_out(id, plane, "A");
      report::ComparedPlane compared;
      compared.id = id;
      quantity_[id] = calc::quantity_name(plane.kernel, plane.derived);
      average_a_[id] = plane.average;
      for (const report::PointRow& point : plane.points) {
        const calc::Estimate& e = point.measured;
        report::ComparedPoint p{point.position_m, point.column, point.row, {}, {}};
        p.a = {e.value, e.half_width()};
        compared.points.push_back(p);
      }
      comparison_.planes.push_back(std::move(compared));
    });
  }

  bool read_b() {
    if (b_) {
      for_each_plane(*b_, [&](const std::string& id, const report::PlanePart& plane) {
        if (!plane.is_computed) {
          if (is_chosen(name_in_a(id))) {
            lack(fmt::format("plane '{}' was not computed in B: {}", id, plane.reason.english()));
          }
          return;
        }
        if (calc::is_plain_number(plane.derived)) return leave_out(id, plane, "B");
        average_b_[name_in_a(id)] = plane.average;
        for (const report::PointRow& point : plane.points) {
          const calc::Estimate& e = point.measured;
          rows_.push_back({id,
                           point.position_m,
                           std::nullopt,
                           std::string(calc::quantity_name(plane.kernel, plane.derived)),
                           {e.value, e.half_width()},
                           0});
        }
      });
      return true;
    }
    const calc::FileContent content = files_.read(options_.b);
    if (!content.ok()) {
      diagnostics_.report(DiagnosticId::file_not_readable, {options_.b, 0, 0}, options_.b,
                          content.error);
      return false;
    }
    std::optional<ValueTable> table =
        read_value_table(content.bytes, options_.b, comparison_.confidence, diagnostics_);
    if (!table) return false;
    is_table_ = true;
    rows_ = std::move(table->rows);
    if (table->ratings > 0) {
      comparison_.notes.push_back(fmt::format(
          "{} values of B are ratings or ratios, not illuminances: not compared", table->ratings));
    }
    if (!table->unused_columns.empty()) {
      comparison_.notes.push_back(fmt::format("columns of B that were not used: {}",
                                              fmt::join(table->unused_columns, ", ")));
    }
    return true;
  }

  // --plane A=B: only these, and B's rows by A's names.
  bool keep_chosen() {
    if (options_.planes.empty()) return true;
    std::vector<report::ComparedPlane> kept;
    std::vector<TableRow> rows;
    for (const std::string& item : options_.planes) {
      const std::size_t equals = item.find('=');
      const std::string in_a = item.substr(0, equals);
      const std::string in_b = equals == std::string::npos ? in_a : item.substr(equals + 1);
      const auto found = std::find_if(comparison_.planes.begin(), comparison_.planes.end(),
                                      [&](const auto& plane) { return plane.id == in_a; });
      if (const auto rating = ratings_a_.find(in_a); rating != ratings_a_.end()) {
        fail(fmt::format("plane '{}' of A has the quantity '{}'; only illuminances are compared",
                         in_a, rating->second));
        return false;
      }
      if (found == comparison_.planes.end()) {
        std::vector<std::string_view> ids;
        for (const auto& plane : comparison_.planes) ids.push_back(plane.id);
        diagnostics_.report(DiagnosticId::choose_plane, {options_.a, 0, 0}, in_a,
                            calc::join_choices(ids));
        return false;
      }
      kept.push_back(*found);
      for (TableRow row : rows_) {
        if (!row.plane || *row.plane != in_b) continue;
        row.plane = in_a;
        rows.push_back(std::move(row));
      }
    }
    for (const TableRow& row : rows_) {
      if (!row.plane) rows.push_back(row);
    }
    comparison_.planes = std::move(kept);
    rows_ = std::move(rows);
    return true;
  }

  // B's values at A's points, and what either side lacks.
  void pair_points() {
    PointPairs pairs(comparison_.planes, quantity_, options_.distance_m);
    for (const TableRow& row : rows_) {
      if (const std::string problem = pairs.place(row); !problem.empty()) fail(problem);
    }
    for (const std::string& what : pairs.drop_unpaired(rows_.size())) lack(what);
    if (comparison_.planes.empty() && !comparison_.revised) {
      fail("A and B have no common point");
    }
  }

  const CompareOptions& options_;
  const calc::FileReader& files_;
  calc::Diagnostics& diagnostics_;
  report::Comparison comparison_;
  std::optional<report::Document> b_;  // if it is a result
  std::map<const report::ProjectPart*, std::string> path_in_a_;
  bool has_projects_ = false;  // several: planes are named with theirs
  std::map<std::string, std::string> quantity_, ratings_a_, ratings_b_;  // by plane
  std::map<std::string, calc::Estimate> average_a_, average_b_;          // by A's plane
  bool is_table_ = false;                                                // B
  std::vector<TableRow> rows_;
};

std::string render(DataFormat kind, const report::Comparison& comparison,
                   const CompareOptions& options) {
  const auto worst = static_cast<std::size_t>(options.worst);
  switch (kind) {
    case DataFormat::csv:
      return report::render_comparison_csv(comparison);
    case DataFormat::json:
      return report::render_comparison_json(comparison);
    case DataFormat::html:
      return report::render_comparison_html(comparison, worst, options.page.texts(),
                                            options.page.paper);
    case DataFormat::markdown:
      return report::render_comparison_markdown(comparison, worst);
    case DataFormat::text:
      break;
  }
  return report::render_comparison_text(comparison, worst);
}

}  // namespace

CommandOutcome run_compare(const CompareOptions& options, const calc::FileReader& disk) {
  calc::Diagnostics diagnostics;
  CommandOutcome outcome;
  outcome.code = kNotJudged;
  std::optional<report::Comparison> comparison;
  check_data_outputs(options.outputs, {options.a, options.b}, diagnostics);
  if (!diagnostics.has_errors()) {
    comparison = Comparer(options, disk, diagnostics).compare();
  }
  if (comparison) {
    const auto render_as = [&](DataFormat kind) { return render(kind, *comparison, options); };
    outcome.text = write_data_outputs(options.outputs, render_as, options.quiet, diagnostics);
    if (!diagnostics.has_errors()) outcome.code = comparison->is_alike() ? kAllMet : kNotMet;
  }
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

Command compare_command() {
  const auto options = std::make_shared<CompareOptions>();
  Command command = compare_syntax(*options);
  command.run = [options](const RunContext&) {
    return print_outcome(run_compare(*options, calc::DiskFileReader()), options->quiet);
  };
  return command;
}

}  // namespace cli
