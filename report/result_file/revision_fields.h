#pragma once
// The result file, changes from a baseline: worse results, weaker requirements, changed inputs. See
// result_fields.h.

#include "report/document/revision.h"
#include "report/result_file/describe.h"

namespace report {

void describe(auto& v, Is<RevisionPlace> auto& place) {
  v.is("revision_place",
       "Where in the design. '' where something is about all of what stands before it.");
  v.field("project", place.project,
          {.words = "Its path; of what is gone, in the baseline.", .holds = Holds::file});
  v.field("space", place.space);
  v.field("plane", place.plane);
  v.field("item", place.item,
          {.words = "Id of a requirement, aggregate, role, luminaire type or material."});
  v.field("words", place.words, {.words = "Names, for people.", .holds = Holds::prose});
  v.field("where", place.where);
}

void describe(auto& v, Is<ChangedResult> auto& result) {
  v.is("changed_result");
  v.field(
      "change", result.change,
      {.words = "broken: did not fail, and fails. new-failing: was not asked, and fails. unsure: "
                "was decided and is not, or cannot be compared. worse, better: beyond the "
                "interval of the difference. gone: no longer asked. fixed: did not pass, and "
                "passes. new: was not asked, and does not fail."});
  v.field("place", result.place);
  v.field("is_aggregate", result.is_aggregate, {.words = "Else it is a requirement."});
  v.field("quantity", result.metric,
          {.words = "Of a requirement.", .presence = only_if(result.metric.has_value())});
  v.field(
      "quantity_words", result.quantity,
      {.words = "For people: with its scene, or the kind of an aggregate.", .holds = Holds::prose});
  v.field("unit", result.unit);
  v.field("counts", result.counts, {.words = "For the exit code."});
  v.field("verdict_before", result.verdict_before,
          {.presence = only_if(result.verdict_before.has_value())});
  v.field("verdict_after", result.verdict_after,
          {.presence = only_if(result.verdict_after.has_value())});
  v.field("is_waived_before", result.is_waived_before);
  v.field("is_waived_after", result.is_waived_after);
  v.field("before", result.before);
  v.field("after", result.after);
  v.field("difference", result.difference, {.words = "after - before."});
  v.field("gain", result.gain,
          {.words = "difference / |before|, turned so that positive is good."});
  v.field("is_paired", result.is_paired,
          {.words = "The interval is that of the differences of single replicates, which share "
                    "random numbers; else the two are taken for independent."});
  v.field("excused_by", result.excused_by,
          {.words = "Worse, and passes: what is lost, a stricter question takes. "
                    "maintenance-factor: no more than the lower factor of all luminaires takes. "
                    "grid: it is finer, and nothing else in the room has changed. A gate of "
                    "regressions does not stop at it.",
           .presence = only_if(result.excused_by.has_value())});
}

void describe(auto& v, Is<ChangedQuestion> auto& question) {
  v.is("changed_question");
  v.field("change", question.change,
          {.words = "exchanged: neither is proved to ask for less. A gate of regressions stops at "
                    "weaker and at exchanged, unless they are accepted."});
  v.field("part", question.part);
  v.field("place", question.place);
  v.field("before", question.before, {.words = "'': there was none.", .holds = Holds::prose});
  v.field("after", question.after, {.words = "'': there is none.", .holds = Holds::prose});
}

void describe(auto& v, Is<ChangedInput> auto& input) {
  v.is("changed_input");
  v.field("what", input.what);
  v.field("place", input.place);
  v.field("before", input.before, {.holds = Holds::prose});
  v.field("after", input.after, {.holds = Holds::prose});
}

void describe(auto& v, Is<ChangedPlane> auto& plane) {
  v.is("changed_plane");
  v.field("place", plane.place);
  v.field("before_lx", plane.before_lx,
          {.words = "Of each point of that plane, in the order of its points."});
}

void describe(auto& v, Is<KnownWarnings> auto& known) {
  v.is("known_warnings");
  v.field("project", known.project, {.words = "Its path.", .holds = Holds::file});
  v.field("diagnostics", known.diagnostics, {.words = "Which of its diagnostics, counted from 0."});
}

void describe(auto& v, Is<AllowedLoss> auto& loss) {
  v.is("allowed_loss");
  v.field("quantity", loss.metric);
  v.field("share", loss.share, {.least = 0.0, .below = 1.0});
}

void describe(auto& v, Is<Gate> auto& gate) {
  v.is("gate");
  v.field("mode", gate.mode,
          {.words = "regression: the exit code tells of what became worse and of weaker questions, "
                    "not of failures that were there before."});
  v.field("allowed_worse", gate.allowed_worse,
          {.words = "Share of a value that may be lost.", .least = 0.0, .below = 1.0});
  v.field("allowed_worse_of", gate.allowed_worse_of,
          {.words = "Of quantities that may lose another share.",
           .presence = only_if(!gate.allowed_worse_of.empty())});
  v.field(
      "weaker_accepted_by", gate.weaker_accepted_by,
      {.words = "The reason given; '': weaker questions are not accepted.", .holds = Holds::prose});
}

void describe(auto& v, Is<Revision> auto& revision) {
  v.is("revision", "Against a baseline: only with --baseline or --against.");
  v.field("baseline", revision.baseline,
          {.words = "The file, or the git revision as it was given: then it has commits.",
           .holds = revision.commits.empty() ? Holds::file : Holds::text});
  v.field("commits", revision.commits,
          {.words = "Full ids of a git revision, one for each repository.",
           .presence = only_if(!revision.commits.empty())});
  v.field("baseline_version", revision.baseline_version, {.words = "Of the program that made it."});
  v.field("gate", revision.gate);
  v.field("results", revision.results, {.words = "Those that changed, gravest first."});
  v.field("same", revision.same, {.words = "How many did not."});
  v.field("untold", revision.untold,
          {.words = "Of them: a loss of more than allowed_worse is not excluded.",
           .presence = kSinceLater});
  v.field(
      "is_of_itself", revision.is_of_itself,
      {.words = "The git revision is HEAD, and no file that was read differs from it: a gate of "
                "regressions has judged nothing.",
       .presence = only_if(revision.is_of_itself)});
  v.field("known_failures", revision.known_failures,
          {.words = "That count, and failed in the baseline, too."});
  v.field("questions", revision.questions, {.words = "What is asked otherwise, weaker first."});
  v.field("inputs", revision.inputs);
  v.field("planes", revision.planes,
          {.words = "Illuminances that are others than before at the same points.",
           .presence = kSinceLater});
  v.field("known_warnings", revision.known_warnings,
          {.words = "Warnings that were there before, word for word; none that counts like an "
                    "error.",
           .presence = only_if(!revision.known_warnings.empty())});
  v.field("notes", revision.notes);
}

}  // namespace report
