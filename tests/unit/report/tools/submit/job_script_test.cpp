#include "report/tools/submit/job_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace job_script_test {
namespace {

using testing::HasSubstr;
using testing::Not;

cli::BatchJob small_job(cli::Engine engine) {
  cli::BatchJob job;
  job.engine = engine;
  job.program = "/usr/bin/luxgate";
  job.working_folder = "/campus of 2026";
  job.job_folder = "/campus of 2026/looks-job";
  job.store = "looks";
  job.options = {"--seed 7"};
  job.report_options = {"--format csv=out.csv"};
  job.units = 5;
  job.shards = 3;
  job.first_look_s = 12.0;
  return job;
}

TEST(JobScript, QuotesEveryPath) {
  for (const auto engine : {cli::Engine::slurm, cli::Engine::parallel, cli::Engine::local}) {
    const std::string script = cli::render_job_script(small_job(engine));
    EXPECT_THAT(script, HasSubstr("cd -- '/campus of 2026' || exit 2\n"));
    EXPECT_THAT(script, HasSubstr("folder='/campus of 2026/looks-job'"));
    EXPECT_THAT(script, HasSubstr("--files-from \"$folder/projects.txt\""));
  }
}

TEST(JobScript, GivesReportOptionsToTheClosingJobAlone) {
  const std::string script = cli::render_job_script(small_job(cli::Engine::local));
  EXPECT_THAT(script, HasSubstr("\noptions=(\n  --seed 7\n)\n"));
  EXPECT_THAT(script, HasSubstr("\nreport_options=(\n  --format csv=out.csv\n)\n"));
  EXPECT_THAT(script, HasSubstr("check \"${options[@]}\" --store \"$store\" --shard"));
  EXPECT_THAT(script, HasSubstr("check \"${options[@]}\" \"${report_options[@]}\" --store"));
}

TEST(JobScript, GivesTheClosingJobItsOwnThreads) {
  cli::BatchJob job = small_job(cli::Engine::slurm);
  job.jobs = 2;
  job.closing_jobs = 16;
  const std::string script = cli::render_job_script(job);
  EXPECT_THAT(script, HasSubstr("\njobs=2  #"));
  EXPECT_THAT(script, HasSubstr("\nclosing_jobs=16  #"));
  EXPECT_THAT(script, HasSubstr("--cpus-per-task=\"$jobs\" --job-name=luxgate --array"));
  EXPECT_THAT(script, HasSubstr("--cpus-per-task=\"$closing_jobs\" --job-name=luxgate-close"));
  EXPECT_THAT(cli::render_job_script(small_job(cli::Engine::local)),
              HasSubstr("\nclosing_jobs=$(nproc)  #"));
}

TEST(JobScript, ClosesAfterTheArrayHoweverItEnded) {
  cli::BatchJob job = small_job(cli::Engine::slurm);
  std::string script = cli::render_job_script(job);
  EXPECT_THAT(script, HasSubstr("--array=\"1-$shards\""));
  EXPECT_THAT(script, HasSubstr("--dependency=\"afterany:${array%%;*}\""));
  EXPECT_THAT(script, Not(HasSubstr("--gres")));
  job.needs_gpu = true;
  job.at_once = 4;
  script = cli::render_job_script(job);
  EXPECT_THAT(script, HasSubstr("--gres=gpu:1"));
  EXPECT_THAT(script, HasSubstr("--array=\"1-$shards%4\""));
}

TEST(JobScript, ParallelGoesOnWhereItStopped) {
  const std::string script = cli::render_job_script(small_job(cli::Engine::parallel));
  EXPECT_THAT(script, HasSubstr("--joblog \"$folder/joblog\" --resume-failed"));
  EXPECT_THAT(script, Not(HasSubstr("sbatch")));
}

// Slurm ends with 0 or 1 where the closing job never ran: what it says of it is no verdict.
TEST(JobScript, TakesNoVerdictFromSlurm) {
  const std::string script = cli::render_job_script(small_job(cli::Engine::slurm));
  EXPECT_THAT(script, Not(HasSubstr("--wait")));
  EXPECT_THAT(script, HasSubstr("rm -f -- \"$folder/close-code\" \"$folder/close.log\""));
  EXPECT_THAT(script, HasSubstr("exit \"$(cat -- \"$folder/close-code\")\""));
}

TEST(JobScript, HasAFolderOfItsOwn) {
  const cli::BatchJob job = small_job(cli::Engine::local);
  const std::string id = cli::batch_id(job, "units", "a.xml\n");
  EXPECT_EQ(id.size(), 12u);
  EXPECT_EQ(cli::batch_id(job, "units", "a.xml\n"), id);
  EXPECT_NE(cli::batch_id(job, "units", "b.xml\n"), id);
  EXPECT_NE(cli::batch_id(job, "unit", "sa.xml\n"), id);
  EXPECT_NE(cli::batch_id(small_job(cli::Engine::slurm), "units", "a.xml\n"), id);
}

TEST(JobScript, SaysADateOnlyIfThereIsOne) {
  cli::BatchJob job = small_job(cli::Engine::local);
  EXPECT_THAT(cli::render_job_script(job), Not(HasSubstr("SOURCE_DATE_EPOCH")));
  job.source_date_epoch = "1700000000";
  EXPECT_THAT(cli::render_job_script(job), HasSubstr("export SOURCE_DATE_EPOCH=1700000000\n"));
}

TEST(ShardsFor, TakesThreeMinutesEach) {
  EXPECT_EQ(cli::shards_for(0, 0.0), 1u);
  EXPECT_EQ(cli::shards_for(200, 10.0), 1u);
  EXPECT_EQ(cli::shards_for(200, 45.0 * 12), 12u);
  EXPECT_EQ(cli::shards_for(5, 45.0 * 12), 5u);
  EXPECT_EQ(cli::shards_for(1'000'000, 1e9), 1000u);
}

}  // namespace
}  // namespace job_script_test
