#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "batch/journal.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch::journal_test {

class BatchJournal : public testing::Test {
 protected:
  Journal open(bool anew = false) { return {path_, label_, {.first = 10, .end = 20}, anew}; }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("part-0.partial");
  ShardLabel label_{.version = "1", .manifest_sha256 = "m", .options_sha256 = "o", .shard = 0, .shards = 2};
};

TEST_F(BatchJournal, KeepsFinishedRecords) {
  {
    Journal journal = open();
    journal.begin(12);
    journal.finish(12, false, {R"({"a":1})", R"({"b":2})"});
    journal.begin(11);
    journal.finish(11, true, {R"({"c":3})"});
    journal.begin(15);
  }
  const Journal journal = open();
  EXPECT_EQ(journal.finished(), 2U);
  EXPECT_EQ(journal.failed(), 1U);
  EXPECT_TRUE(journal.has(11));
  EXPECT_TRUE(journal.has(12));
  EXPECT_FALSE(journal.has(15));
  EXPECT_EQ(journal.rows(12), "{\"a\":1}\n{\"b\":2}\n");
  EXPECT_EQ(journal.rows(11), "{\"c\":3}\n");
}

TEST_F(BatchJournal, ForgetsTheRowsOfARecordThatIsOpenedAgain) {
  {
    Journal journal = open();
    journal.finish(12, true, {R"({"a":1})"});
    journal.finish(13, false, {R"({"c":3})"});
    journal.reopen(12);
    EXPECT_FALSE(journal.has(12));
    EXPECT_EQ(journal.finished(), 1U);
    EXPECT_EQ(journal.failed(), 0U);
  }
  EXPECT_EQ(journal_state(path_).finished, 1U);
  {
    Journal journal = open();
    EXPECT_FALSE(journal.has(12));
    EXPECT_EQ(journal.failed(), 0U);
    journal.begin(12);
    journal.finish(12, false, {R"({"a":2})"});
  }
  EXPECT_EQ(journal_state(path_).finished, 2U);
  EXPECT_EQ(open().rows(12), "{\"a\":2}\n");
}

// A killed writer may leave the file cut off at any byte.
TEST_F(BatchJournal, LosesAtMostTheLastLineWhenCutOff) {
  std::vector<std::size_t> ends;
  {
    Journal journal = open();
    for (std::size_t i = 10; i < 14; ++i) {
      ends.push_back(test::bytes_of(path_).size());
      journal.finish(i, false, {R"({"row":"record"})"});
    }
  }
  const std::string whole = test::bytes_of(path_);
  ends.push_back(whole.size());
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    test::write_bytes(path_, whole.substr(0, cut));
    std::size_t complete = 0;
    while (complete < 4 && ends[complete + 1] <= cut) ++complete;
    Journal journal = open();
    ASSERT_EQ(journal.finished(), complete) << cut;
    journal.finish(19, false, {R"({"row":"record"})"});
    EXPECT_EQ(journal.rows(19), R"({"row":"record"})"
                                "\n");
  }
}

TEST_F(BatchJournal, IgnoresDamagedLines) {
  {
    Journal journal = open();
    journal.finish(10, false, {R"({"x":1111})"});
    journal.finish(11, false, {R"({"x":2222})"});
  }
  std::string bytes = test::bytes_of(path_);
  bytes[bytes.find("1111")] = '3';
  bytes.insert(bytes.find("done 11"), "done 99999999999999999999 0\ndone 17 0 \ndone 5 0 x x\nnonsense\n");
  test::write_bytes(path_, bytes);
  const Journal journal = open();
  EXPECT_FALSE(journal.has(10));
  EXPECT_TRUE(journal.has(11));
  EXPECT_EQ(journal.finished(), 1U);
}

TEST_F(BatchJournal, BelongsToOnePlanAndVersion) {
  { const Journal journal = open(); }
  label_.version = "2";
  EXPECT_THROW(open(), InputError);
  label_.version = "1";
  label_.options_sha256 = "p";
  EXPECT_THROW(open(), InputError);
  EXPECT_EQ(open(true).finished(), 0U);
}

TEST_F(BatchJournal, AcceptsLinesOfSeveralThreads) {
  Journal journal = open();
  parallel_for(10, 2, [&](std::size_t i) {
    journal.begin(10 + i);
    journal.finish(10 + i, i % 2 == 0, {std::string(100 * i + 1, 'x')});
  });
  EXPECT_EQ(journal.failed(), 5U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(journal.rows(10 + i), std::string(100 * i + 1, 'x') + "\n");
}

// Needs a second process: a lock does not exclude its owner.
TEST_F(BatchJournal, BelongsToOneProcessAtATime) {
  const auto refused_elsewhere = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        const Journal journal = open();
        ::_exit(0);
      } catch (const InputError&) {
        ::_exit(1);
      }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 1;
  };
  {
    const Journal journal = open();
    EXPECT_TRUE(refused_elsewhere());
  }
  EXPECT_FALSE(refused_elsewhere());
}

TEST_F(BatchJournal, ListsRecordsBegunTwiceAndNeverFinished) {
  {
    Journal journal = open();
    journal.begin(10);
    journal.finish(10, false, {"{}"});
    journal.begin(11);
    journal.begin(12);
  }
  {
    Journal journal = open();
    journal.begin(12);
  }
  const JournalState state = journal_state(path_);
  EXPECT_EQ(state.finished, 1U);
  EXPECT_THAT(state.stuck, testing::ElementsAre(12));
}

}  // namespace percuss::batch::journal_test
