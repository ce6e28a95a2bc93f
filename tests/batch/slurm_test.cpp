#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "batch/slurm.hpp"
#include "core/error.hpp"

namespace percuss::batch::slurm_test {

TEST(BatchSlurm, WritesAScriptThatAShellParsesCorrectly) {
  EXPECT_EQ(slurm_script({.program = "/usr/bin/percuss",
                          .manifest = "/data/it's mine.jsonl",
                          .folder = "/data/out",
                          .shards = 9,
                          .tasks = {0, 3, 8},
                          .threads = 2,
                          .directives = {"--time=5"}}),
            "#!/bin/sh\n"
            "#SBATCH --job-name=percuss-batch\n"
            "#SBATCH --array=0,3,8\n"
            "#SBATCH --cpus-per-task=2\n"
            "#SBATCH --output=/data/out/slurm-%A-%a.log\n"
            "#SBATCH --time=5\n"
            "exec /usr/bin/percuss batch run --manifest '/data/it'\\''s mine.jsonl' --shard "
            "\"$SLURM_ARRAY_TASK_ID/9\" --threads 2 -o /data/out\n");
}

TEST(BatchSlurm, RefusesPathsThatAreNotPrintable) {
  const SlurmJob good{.program = "/usr/bin/percuss", .manifest = "/data/m.jsonl", .folder = "/data/out", .tasks = {0}};
  for (const char* name :
       {"/a\n#SBATCH --wrap=id", "/a\r", "/a\x1b[2K", "/a\u0085", "/a\u202e", "/a\u2028b", "/a\xff"}) {
    for (std::string SlurmJob::*path : {&SlurmJob::program, &SlurmJob::manifest, &SlurmJob::folder}) {
      SlurmJob job = good;
      job.*path = name;
      EXPECT_THROW(slurm_script(job), InputError) << one_line(name);
    }
  }
  EXPECT_NO_THROW(slurm_script(good));
}

TEST(BatchSlurm, EscapesThePatternsOfLogNames) {
  EXPECT_THAT(slurm_script({.program = "/p", .manifest = "/m", .folder = "/50%A $(id)", .tasks = {0}}),
              testing::AllOf(testing::HasSubstr("--output='/50%%A $(id)/slurm-%A-%a.log'\n"),
                             testing::HasSubstr("-o '/50%A $(id)'\n")));
}

TEST(BatchSlurm, FindsTheLargestArray) {
  EXPECT_EQ(largest_array_index("MaxDBDMsgs = 20004\nMaxArraySize            = 5001\nMaxJobCount = 1"), 5000U);
  EXPECT_EQ(largest_array_index(""), 1000U);
  EXPECT_EQ(largest_array_index("MaxArraySize = "), 1000U);
}

}  // namespace percuss::batch::slurm_test
