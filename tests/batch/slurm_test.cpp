#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "batch/slurm.hpp"

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

TEST(BatchSlurm, FindsTheLargestArray) {
  EXPECT_EQ(largest_array_index("MaxDBDMsgs = 20004\nMaxArraySize            = 5001\nMaxJobCount = 1"), 5000U);
  EXPECT_EQ(largest_array_index(""), 1000U);
  EXPECT_EQ(largest_array_index("MaxArraySize = "), 1000U);
}

}  // namespace percuss::batch::slurm_test
