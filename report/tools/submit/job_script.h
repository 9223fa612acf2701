#pragma once
// The script of a batch: shards that calculate into one store, then one job that reports from it.

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

enum class Engine { slurm, parallel, local };

struct BatchJob {
  Engine engine = Engine::local;
  std::string program;         // luxgate itself
  std::string working_folder;  // in which the names of files hold
  std::string job_folder;      // absolute: units.json, projects.txt, job.sh and logs
  std::string store;
  // Options, one each, quoted for a shell: "--seed 2". The first change results, the others
  // reports.
  std::vector<std::string> options, report_options;
  std::string source_date_epoch;  // "" = not set
  std::size_t units = 0, shards = 1;
  double first_look_s = 0.0;  // predicted, of all units, of one core
  int jobs = 1;               // threads of a shard
  int closing_jobs = 0;       // threads of the closing job; 0 = one for each core of its machine
  int at_once = 0;            // shards at a time; 0 = as many as there is room for
  bool needs_gpu = false;
};

// Returns the name of the batch's folder below --job-folder. It is made of all inputs of the batch,
// so two batches never share a folder, and the same batch finds its own again. job: with the latter
// as its folder.
std::string batch_id(const BatchJob& job, const std::string& units, const std::string& projects);

std::string job_file(const BatchJob& job);
std::string units_file(const BatchJob& job);
// Returns the name of a file for --files-from, which has no limit on its length, unlike command
// lines and scripts.
std::string projects_file(const BatchJob& job);
// Returns the name of GNU parallel's log.
std::string job_log(const BatchJob& job);

// Returns how many shards take about three minutes each. Only the first sampling round is
// predicted: it is taken as a quarter of the work. At most the number of units, and Slurm's limit
// for an array.
std::size_t shards_for(std::size_t units, double first_look_s);

std::string render_job_script(const BatchJob& job);

}  // namespace cli
