#include "report/tools/submit/job_script.h"

#include "calc/base/file_hash.h"
#include "report/text/shell_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace cli {
namespace {

using report::shell_quoted;

constexpr double kShard_s = 180.0;
constexpr double kFirstLooksOfWork = 4.0;  // a guess: most planes take two or three looks
constexpr std::size_t kMostShards = 1000;  // Slurm's MaxArraySize is 1001 unless it is set

const char* engine_name(Engine engine) {
  switch (engine) {
    case Engine::slurm:
      return "slurm";
    case Engine::parallel:
      return "parallel";
    case Engine::local:
      return "local";
  }
  return "";
}

// A line each.
std::string list(std::string_view name, const std::vector<std::string>& quoted) {
  std::string text = fmt::format("{}=(\n", name);
  for (const std::string& words : quoted) text += "  " + words + "\n";
  return text + ")\n";
}

std::string head(const BatchJob& job) {
  std::string text = fmt::format(
      "#!/bin/bash\n"
      "# A batch of luxgate with the engine '{}': jobs: {}, shards: {}.\n"
      "# The prediction for the first sampling rounds is {:.3g} s of one core; all work takes a "
      "few times that.\n"
      "#   bash job.sh            starts the shards, then the closing job\n",
      engine_name(job.engine), job.units, job.shards, job.first_look_s);
  if (job.engine == Engine::slurm) {
    text += "#   bash job.sh wait       the same, and waits for the closing job\n";
  }
  return text +
         "#   bash job.sh shard 3    calculates shard 3 into the result cache\n"
         "#   bash job.sh close      reports from the result cache; its exit code is the batch's\n"
         "# The same command completes what was interrupted: light in the result cache is only "
         "read.\n";
}

std::string settings(const BatchJob& job) {
  std::string text = fmt::format(
      "set -u\n"
      "cd -- {} || exit 2\n"
      "luxgate={}\n"
      "store={}\n"
      "folder={}  # units.json, projects.txt, job.sh, logs\n"
      "shards={}\n"
      "jobs={}  # threads of a shard\n"
      "closing_jobs={}  # threads of the closing job\n",
      shell_quoted(job.working_folder), shell_quoted(job.program), shell_quoted(job.store),
      shell_quoted(job.job_folder), job.shards, job.jobs,
      job.closing_jobs > 0 ? std::to_string(job.closing_jobs) : "$(nproc)");
  if (!job.source_date_epoch.empty()) {
    text += fmt::format("export SOURCE_DATE_EPOCH={}\n", shell_quoted(job.source_date_epoch));
  }
  return text + "\n# Of shards and of the closing job alike.\n" + list("options", job.options) +
         "# Of the closing job alone.\n" + list("report_options", job.report_options);
}

// What a shard and the closing job are, whatever starts them.
std::string tasks() {
  return fmt::format(R"(
shard() {{
  exec "$luxgate" check "${{options[@]}}" --store "$store" --shard "$1/$shards" \
    --units "$folder/units.json" --jobs "$jobs" --files-from "$folder/projects.txt"
}}

close() {{
  "$luxgate" check "${{options[@]}}" "${{report_options[@]}}" --store "$store" --stored-only \
    --jobs "$closing_jobs" --files-from "$folder/projects.txt"
  local code=$?
  echo "$code" >"$folder/close-code"  # for who waits
  exit "$code"
}}
)");
}

// Partition, account, time limit and memory are Slurm's own variables: SBATCH_PARTITION, ...
std::string send_to_slurm(const BatchJob& job) {
  const std::string limit = job.at_once > 0 ? fmt::format("%{}", job.at_once) : "";
  return fmt::format(R"sh(
# Sends both, and says their numbers. SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT say the rest.
send() {{
  needs sbatch
  rm -f -- "$folder/close-code" "$folder/close.log" "$folder/close-messages.log"
  local logs=${{folder//%/%%}} common=(--parsable --requeue{})
  array=$(sbatch "${{common[@]}}" --cpus-per-task="$jobs" --job-name=luxgate --array="1-$shards{}" \
    --open-mode=append --output="$logs/shard-%a.log" "$folder/job.sh" shard) || exit 2
  echo "shards: job $array" >&2
  closing=$(sbatch "${{common[@]}}" --cpus-per-task="$closing_jobs" --job-name=luxgate-close \
    --dependency="afterany:${{array%%;*}}" --output="$logs/close.log" --error="$logs/close-messages.log" \
    "$folder/job.sh" close) || exit 2
  echo "closing job: job $closing; results in $folder/close.log" >&2
}}

# Until Slurm has ended the closing job, or knows it no more. Its exit code is what it wrote itself:
# where it was cancelled, or its node is gone, there is none.
await() {{
  trap 'echo "luxgate: jobs ${{array%%;*}} and ${{closing%%;*}} go on; scancel ends them" >&2; exit 130' INT TERM HUP
  local state
  while state=$(squeue --noheader --format=%T --jobs="${{closing%%;*}}" 2>&1) || [[ $state != *"Invalid job id"* ]]; do
    [ -n "$state" ] || break
    sleep 2
  done
  for _ in 1 2 3; do  # a file server may be late
    if [ -e "$folder/close-code" ]; then break; fi
    sleep 1
  done
  if [ -e "$folder/close-messages.log" ]; then cat -- "$folder/close-messages.log" >&2; fi
  if [ -e "$folder/close.log" ]; then cat -- "$folder/close.log"; fi
  if [ -e "$folder/close-code" ]; then exit "$(cat -- "$folder/close-code")"; fi
  echo "luxgate: error: the closing job did not finish" >&2
  exit 2
}}

case "${{1:-send}}" in
  send) send ;;
  wait) send; await ;;
  shard) shard "${{2:-${{SLURM_ARRAY_TASK_ID:-}}}}" ;;
  close) close ;;
  *) echo "luxgate: error: send, wait, shard N or close is needed" >&2; exit 2 ;;
esac
)sh",
                     job.needs_gpu ? " --gres=gpu:1" : "", limit);
}

// All jobs end with the script, however it is ended.
constexpr std::string_view kEndTogether = R"(
end() {
  trap '' INT TERM HUP
  kill $(jobs -p) 2>/dev/null
  sleep 0.2
  kill $(jobs -p) 2>/dev/null  # GNU parallel waits for its jobs unless it is told twice
  wait
  exit 130
}
)";

std::string send_to_parallel(const BatchJob& job) {
  std::string slots;
  if (job.at_once > 0) {
    slots = fmt::format(" --jobs {}", job.at_once);
  } else if (job.jobs > 1) {
    slots = R"( --jobs "$((jobs < 100 ? 100 / jobs : 1))%")";
  }
  return std::string(kEndTogether) + fmt::format(R"(
# Run again it does the shards again that failed; or all, if the closing job misses something that
# they say they have done. PARALLEL='--sshlogin a,b' takes other machines, too.
send() {{
  needs parallel
  trap end INT TERM HUP
  parallel --quote --joblog "$folder/joblog" --resume-failed{} \
    bash "$folder/job.sh" shard {{}} < <(seq "$shards") &
  wait $! && local done=all
  (close) &
  wait $!
  local code=$?
  if [ "$code" = 2 ] && [ "${{done:-}}" = all ]; then rm -f -- "$folder/joblog"; fi
  exit "$code"
}}
)",
                                                 slots);
}

std::string send_here(const BatchJob& job) {
  const std::string at_once =
      job.at_once > 0 ? std::to_string(job.at_once) : "$((($(nproc) + jobs - 1) / jobs))";
  return std::string(kEndTogether) + fmt::format(R"(
send() {{
  local at_once={} i
  trap end INT TERM HUP
  for ((i = 1; i <= shards; ++i)); do
    while (($(jobs -pr | wc -l) >= at_once)); do wait -n; done
    shard "$i" &
  done
  wait
  (close) &
  wait $!
  exit $?
}}
)",
                                                 at_once);
}

constexpr std::string_view kNeeds = R"(
needs() {
  command -v "$1" >/dev/null && return
  echo "luxgate: error: '$1' is not installed" >&2
  exit 2
}
)";

constexpr std::string_view kDispatch = R"(
case "${1:-send}" in
  send) send ;;
  shard) if [ -n "${2:-}" ]; then shard "$2"; fi ;;
  close) close ;;
esac
echo "luxgate: error: send, shard N or close is needed" >&2
exit 2
)";

}  // namespace

std::string job_file(const BatchJob& job) { return job.job_folder + "/job.sh"; }
std::string units_file(const BatchJob& job) { return job.job_folder + "/units.json"; }
std::string projects_file(const BatchJob& job) { return job.job_folder + "/projects.txt"; }
std::string job_log(const BatchJob& job) { return job.job_folder + "/joblog"; }

std::string batch_id(const BatchJob& job, const std::string& units, const std::string& projects) {
  constexpr std::size_t kDigits = 12;
  return calc::sha256_hex(render_job_script(job) + '\0' + units + '\0' + projects)
      .substr(0, kDigits);
}

std::size_t shards_for(std::size_t units, double first_look_s) {
  const double wanted = std::ceil(first_look_s * kFirstLooksOfWork / kShard_s);
  const auto most = static_cast<double>(std::clamp<std::size_t>(units, 1, kMostShards));
  return static_cast<std::size_t>(std::clamp(wanted, 1.0, most));
}

std::string render_job_script(const BatchJob& job) {
  const std::string common = head(job) + settings(job) + tasks();
  switch (job.engine) {
    case Engine::slurm:
      return common + std::string(kNeeds) + send_to_slurm(job);
    case Engine::parallel:
      return common + std::string(kNeeds) + send_to_parallel(job) + std::string(kDispatch);
    case Engine::local:
      return common + send_here(job) + std::string(kDispatch);
  }
  return common;
}

}  // namespace cli
