#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/files/synthetic_files.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/ping_file.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch_command_test {

namespace fs = std::filesystem;
using test::bytes_of;
using test::lines_of;
using test::run_percuss;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Records a … d: a valid record, a record without a pulse, an invalid file, another valid record.
class BatchCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    fs::create_directory(records().file("recs"));
    test::write_small_test(records().file("recs/a.h5"), R"("hits": 2, "seed": 1)");
    test::write_small_test(records().file("recs/b.csv"), R"("hits": 1, "faults": [{"hit": 0, "kind": "missing"}])");
    test::write_bytes(records().file("recs/c.csv"), "no,record\n");
    test::write_small_test(records().file("recs/d.mat"), R"("hits": 2, "seed": 2)");
  }
  static test::ScratchFolder& records() {
    static test::ScratchFolder folder;
    return folder;
  }
  void SetUp() override { fs::create_symlink(records().file("recs"), folder_.file("recs")); }

  test::ProcessOutcome percuss(const std::vector<std::string>& words, std::vector<std::string> environment = {}) {
    return run_percuss(words, {.folder = folder_.path(), .environment = std::move(environment)});
  }
  test::ProcessOutcome batch(std::vector<std::string> words, std::vector<std::string> environment = {}) {
    words.insert(words.begin(), "batch");
    return percuss(words, std::move(environment));
  }
  void plan(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"plan", "recs/a.h5", "recs/b.csv", "recs/c.csv", "recs/d.mat",
                                   "-o",   "m.jsonl",   "--effort",   "quick",      "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = batch(words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  test::ProcessOutcome run(std::vector<std::string> more = {}, std::vector<std::string> environment = {}) {
    std::vector<std::string> words{"run", "--manifest", "m.jsonl", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return batch(words, std::move(environment));
  }
  /// Merges all rows into the file `name`; returns its bytes.
  std::string merged(const std::string& name, const std::string& folder = "out") {
    const auto outcome = batch({"merge", "--manifest", "m.jsonl", folder, "-o", name});
    EXPECT_EQ(outcome.code, 6) << outcome.err;
    return bytes_of(folder_.file(name));
  }
  test::ScratchFolder folder_;
};

void expect_lines_of(const std::string& text, const std::string& schema) {
  for (const std::string& line : lines_of(text))
    EXPECT_THAT(test::schema_violations(test::parse_json(line), test::schema_named(schema)), IsEmpty()) << line;
}

TEST_F(BatchCommand, WritesRowsThatFitTheirSchemas) {
  plan();
  expect_lines_of(bytes_of(folder_.file("m.jsonl")), "batch-manifest");
  EXPECT_EQ(run().code, 6);
  expect_lines_of(bytes_of(folder_.file("out/part-0.ok")), "batch-part");
  const auto rows = lines_of(merged("r.jsonl"));
  for (const std::string& row : rows) expect_lines_of(row, "batch");
  ASSERT_EQ(rows.size(), 1U + 4U + 4U);  // header, four records, two modes of each valid record
  const auto first = test::parse_json(rows[1]), mode = test::parse_json(rows[2]);
  EXPECT_EQ(first["id"], "a");
  EXPECT_EQ(first["hits_accepted"], 2);
  EXPECT_EQ(first["modes"], 2);
  EXPECT_NEAR(mode["frequency_hz"].get<double>(), 200, 0.1);
  EXPECT_EQ(mode["family"], "bending");
}

TEST_F(BatchCommand, AgreesWithAnalyze) {
  plan();
  ASSERT_EQ(run().code, 6);
  const auto mode = test::parse_json(lines_of(merged("r.jsonl")).at(3));
  const auto analysis = test::parse_json(percuss({"analyze", "recs/a.h5", "--effort", "quick", "--json"}).out);
  for (const char* key : {"index", "frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std", "family",
                          "order", "confidence", "alternative"})
    EXPECT_EQ(mode[key], analysis["modes"][1][key]) << key;
  EXPECT_EQ(mode["overlay_difference_db"], analysis["modes"][1]["overlay"]["difference_db"]);
  EXPECT_EQ(mode["ratio_re"], analysis["modes"][1]["ratio"]["re"]);
}

// The modes at 200 and 700 Hz lie outside the band.
TEST_F(BatchCommand, FlagsARecordWithoutModes) {
  plan({"--band", "1000:1300"});
  run();
  const auto record = test::parse_json(lines_of(merged("r.jsonl")).at(1));
  EXPECT_EQ(record["id"], "a");
  EXPECT_EQ(record["code"], 0) << "it is a result";
  EXPECT_EQ(record["modes"], 0);
  EXPECT_THAT(record["warnings"], testing::Contains("no_modes"));
}

// A WAV file per part: modes from free decays, as analyze finds them.
TEST_F(BatchCommand, AnalysesRecordsWithoutAForceAsAnalyzeDoes) {
  fs::create_directories(folder_.file("pings"));
  test::write_bytes(folder_.file("pings/a.wav"), test::wav_of(test::ping(1e-3)));
  test::write_bytes(folder_.file("pings/b.wav"), test::wav_of(std::vector<double>(44100, 0.5)));
  for (const std::vector<std::string>& unit : {std::vector<std::string>{}, {"--unit", "Pa"}}) {
    std::vector<std::string> words{"plan", "pings", "--band", "500:6000", "--frf", "-o", "m.jsonl", "--force"};
    words.insert(words.end(), unit.begin(), unit.end());
    const auto planned = batch(words);
    ASSERT_EQ(planned.code, 0) << planned.err;
    ASSERT_EQ(run({"--force"}).code, 6);
    const auto merging = batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.jsonl", "--force"});
    EXPECT_EQ(merging.code, 6);
    const auto rows = lines_of(bytes_of(folder_.file("r.jsonl")));
    for (const std::string& row : rows) expect_lines_of(row, "batch");
    ASSERT_EQ(rows.size(), 1U + 2U + test::kPing.size());
    const auto record = test::parse_json(rows[1]), dead = test::parse_json(rows.back());
    std::vector<std::string> analyze{"analyze", "pings/a.wav", "--band", "500:6000", "--json"};
    analyze.insert(analyze.end(), unit.begin(), unit.end());
    const auto document = test::parse_json(percuss(analyze).out);
    EXPECT_EQ(record["id"], "a");
    EXPECT_EQ(record["code"], 0);
    EXPECT_EQ(record["hits_accepted"], 1);
    EXPECT_EQ(record["band_high_hz"], 6000);
    EXPECT_THAT(record["warnings"], testing::Contains("no_force"));
    ASSERT_EQ(document["modes"].size(), test::kPing.size());
    for (std::size_t m = 0; m < test::kPing.size(); ++m) {
      const auto row = test::parse_json(rows[2 + m]);
      for (const char* key :
           {"index", "frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std", "family"})
        EXPECT_EQ(row[key], document["modes"][m][key]) << key;
    }
    EXPECT_EQ(dead["id"], "b");
    EXPECT_EQ(dead["code"], 4);
    EXPECT_EQ(percuss({"analyze", "pings/b.wav"}).code, 4);
    EXPECT_THAT(dead["reason"].get<std::string>(), HasSubstr("channel 1 is constant"));
    EXPECT_THAT(dead["warnings"], testing::Contains("dead_channel"));
  }
}

TEST_F(BatchCommand, RefusesOptionsThatNeedAForceAsAnalyzeDoes) {
  test::write_bytes(folder_.file("a.wav"), test::wav_of(test::ping(1e-3)));
  ASSERT_EQ(batch({"plan", "a.wav", "--estimator", "h2", "-o", "m.jsonl"}).code, 0);
  ASSERT_EQ(run().code, 6);
  const auto record = test::parse_json(lines_of(merged("r.jsonl")).at(1));
  const auto analysis = percuss({"analyze", "a.wav", "--estimator", "h2"});
  EXPECT_EQ(record["code"], analysis.code);
  EXPECT_EQ("percuss: " + record["reason"].get<std::string>() + "\n", analysis.err);
}

TEST_F(BatchCommand, ReportsABadRecordAsAnalyzeDoes) {
  plan();
  ASSERT_EQ(run().code, 6);
  const auto rows = lines_of(merged("r.jsonl"));
  const auto no_hit = test::parse_json(rows.at(4)), invalid = test::parse_json(rows.at(5));
  EXPECT_EQ(no_hit["code"], 4);
  const auto analysis = percuss({"analyze", "recs/b.csv"});
  EXPECT_EQ(analysis.code, 4);
  const std::string unwrapped = std::regex_replace(analysis.out, std::regex("\n  "), " ");
  EXPECT_THAT(unwrapped, HasSubstr(no_hit["reason"].get<std::string>()));
  EXPECT_THAT(no_hit["findings"], ElementsAre("no_pulse"));
  EXPECT_EQ(invalid["code"], 3);
  EXPECT_EQ("percuss: " + invalid["reason"].get<std::string>() + "\n", percuss({"analyze", "recs/c.csv"}).err);
}

TEST_F(BatchCommand, NamesFailedRecordsAndTheirReasons) {
  plan();
  const std::string reason = percuss({"analyze", "recs/c.csv"}).err.substr(std::string("percuss: ").size());
  const auto names_both = AllOf(HasSubstr("percuss: b failed: "), HasSubstr("percuss: c failed: " + reason));
  EXPECT_THAT(run().err, names_both);
  EXPECT_THAT(run().err, IsEmpty()) << "nothing was analysed in this run";
  EXPECT_THAT(run({"--force", "--quiet"}).err, IsEmpty());
  EXPECT_THAT(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.csv"}).err, names_both);
  EXPECT_THAT(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "q.csv", "--quiet"}).err, IsEmpty());
}

TEST_F(BatchCommand, GivesTheSameBytesForAnyNumberOfShards) {
  plan({"--frf"});
  ASSERT_EQ(run({"--threads", "1"}).code, 6);
  ASSERT_EQ(
      batch({"merge", "--manifest", "m.jsonl", "out", "-o", "1.jsonl", "-o", "1.csv", "-o", "1.h5", "-o", "1.HDF5"})
          .code,
      6);
  for (const std::string shard : {"2/3", "0/3", "1/3"})
    EXPECT_NE(batch({"run", "--manifest", "m.jsonl", "-o", "three", "--threads", "2", "--shard", shard}).code, 3);
  ASSERT_EQ(batch({"merge", "--manifest", "m.jsonl", "three", "-o", "3.jsonl", "-o", "3.csv", "-o", "3.h5"}).code, 6);
  EXPECT_EQ(bytes_of(folder_.file("1.HDF5")), bytes_of(folder_.file("1.h5")));
  for (const char* kind : {".jsonl", ".csv", ".h5"})
    EXPECT_EQ(bytes_of(folder_.file("1" + std::string(kind))), bytes_of(folder_.file("3" + std::string(kind)))) << kind;
}

TEST_F(BatchCommand, StoresTheFrfsThatFrfWrites) {
  plan({"--frf"});
  ASSERT_EQ(run().code, 6);
  ASSERT_EQ(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.h5"}).code, 6);
  ASSERT_EQ(percuss({"frf", "recs/a.h5", "-o", "a.h5"}).code, 0);
  // Both files store the numbers contiguously.
  const std::string alone = bytes_of(folder_.file("a.h5")), all = bytes_of(folder_.file("r.h5"));
  ASSERT_GT(alone.size(), 20000U);
  EXPECT_THAT(all, HasSubstr(alone.substr(alone.size() / 2, 4096)));
}

TEST_F(BatchCommand, SkipsFinishedRecords) {
  plan({"--shards", "2"});
  const auto first = run({"--json"}), second = run({"--json"});
  EXPECT_EQ(first.code, 6);
  EXPECT_EQ(second.code, 6);
  const auto document = test::parse_json(second.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("batch-run")), IsEmpty());
  EXPECT_EQ(test::parse_json(first.out)["shards"][0]["analysed"], test::parse_json(first.out)["shards"][0]["records"]);
  EXPECT_EQ(document["shards"][0]["analysed"], 0);
  EXPECT_EQ(document["shards"][1]["analysed"], 0);
}

TEST_F(BatchCommand, ListsMissingShards) {
  plan({"--shards", "3"});
  ASSERT_NE(run({"--shard", "1"}).code, 3);
  EXPECT_EQ(batch({"status", "--manifest", "m.jsonl", "out", "--missing"}).out, "0,2\n");
  const auto status = test::parse_json(batch({"status", "--manifest", "m.jsonl", "out", "--json"}).out);
  EXPECT_THAT(test::schema_violations(status, test::schema_named("batch-status")), IsEmpty());
  EXPECT_EQ(status["missing"], nlohmann::json({0, 2}));
  test::rejection_of({"batch", "merge", "--manifest", folder_.file("m.jsonl"), folder_.file("out")}, {".jsonl"},
                     "2 of 3 shards are not finished: 0,2");
  ASSERT_NE(run({"--shard", "all"}).code, 3);
  EXPECT_EQ(batch({"status", "--manifest", "m.jsonl", "out", "--missing"}).out, "");
}

TEST_F(BatchCommand, TakesItsShardFromTheScheduler) {
  plan({"--shards", "3"});
  EXPECT_THAT(run({}, {"SLURM_ARRAY_TASK_ID=2"}).out, HasSubstr("in shard 2 of 3"));
  EXPECT_THAT(run({}, {"JOB_COMPLETION_INDEX=0"}).out, HasSubstr("in shard 0 of 3"));
  EXPECT_THAT(run({}, {"PARALLEL_SEQ=2"}).out, HasSubstr("in shard 1 of 3"));
  EXPECT_EQ(run({}, {"SLURM_ARRAY_TASK_ID=3"}).code, 2);
  EXPECT_EQ(run({}, {"PARALLEL_SEQ=0"}).code, 2);
  EXPECT_THAT(run({"--shard", "0"}, {"SLURM_ARRAY_TASK_ID=3"}).out, HasSubstr("in shard 0 of 3"));
}

TEST_F(BatchCommand, DetectsAChangedRecord) {
  test::write_small_test(folder_.file("x.csv"), R"("hits": 1)");
  ASSERT_EQ(batch({"plan", "x.csv", "--hash", "-o", "m.jsonl"}).code, 0);
  std::string bytes = bytes_of(folder_.file("x.csv"));
  bytes[bytes.size() - 2] = bytes[bytes.size() - 2] == '1' ? '2' : '1';
  test::write_bytes(folder_.file("x.csv"), bytes);
  ASSERT_EQ(run().code, 6);
  EXPECT_THAT(merged("r.jsonl"), HasSubstr("the file changed after the batch was planned"));
  test::write_bytes(folder_.file("x.csv"), bytes + "\n");
  ASSERT_EQ(run({"--force"}).code, 6);
  EXPECT_THAT(merged("s.jsonl"), HasSubstr("bytes; it had"));
  fs::remove(folder_.file("x.csv"));
  ASSERT_EQ(run({"--force"}).code, 6);
  EXPECT_THAT(merged("t.jsonl"), HasSubstr("the file is missing; it existed when the batch was planned (x.csv)"));
}

TEST_F(BatchCommand, FindsRecordsRelativeToItsManifest) {
  fs::create_directories(folder_.file("here/recs"));
  fs::copy(folder_.file("recs/a.h5"), folder_.file("here/recs/a.h5"));
  ASSERT_EQ(batch({"plan", "here/recs", "-o", "here/m.jsonl"}).code, 0);
  EXPECT_THAT(bytes_of(folder_.file("here/m.jsonl")), HasSubstr(R"("path":"recs/a.h5")"));
  fs::rename(folder_.file("here"), folder_.file("there"));
  EXPECT_EQ(batch({"run", "--manifest", "there/m.jsonl", "-o", "out"}).code, 0);
}

TEST_F(BatchCommand, SaysWhereAllFailedRecordsStand) {
  std::vector<std::string> words{"plan", "-o", "m.jsonl", "--quiet"};
  for (int i = 0; i < 12; ++i) {
    words.push_back("bad" + std::to_string(i) + ".csv");
    test::write_bytes(folder_.file(words.back()), "no,record\n");
  }
  ASSERT_EQ(batch(words).code, 0);
  const auto ran = run();
  EXPECT_THAT(ran.err, HasSubstr("percuss: and 2 more; all of them, with their reasons, are the rows of "
                                 "out/part-*.jsonl whose code is not 0\n"));
  const auto merging = batch({"merge", "--manifest", "m.jsonl", "out", "-o", "all.csv"});
  EXPECT_THAT(merging.err, HasSubstr("are the rows of all.csv whose code is not 0\n"));
  EXPECT_EQ(lines_of(bytes_of(folder_.file("all.csv"))).size(), 13U) << "a heading and a row for each record";
}

TEST_F(BatchCommand, LeavesOutTextsOfAFolderThatHoldNoNumbers) {
  fs::create_directories(folder_.file("bats"));
  test::write_small_test(folder_.file("bats/x.csv"), R"("hits": 1)");
  test::write_bytes(folder_.file("bats/README.txt"), "Bats of June.\nHit at the barrel, 3 times each.\n");
  const auto planned = batch({"plan", "bats", "-o", "m.jsonl"});
  ASSERT_EQ(planned.code, 0) << planned.err;
  EXPECT_THAT(planned.err, HasSubstr("skipped 1 file of other kinds"));
  EXPECT_THAT(bytes_of(folder_.file("m.jsonl")), AllOf(HasSubstr("x.csv"), Not(HasSubstr("README"))));
  ASSERT_EQ(batch({"plan", "bats/README.txt", "-o", "n.jsonl"}).code, 0);
  EXPECT_THAT(bytes_of(folder_.file("n.jsonl")), HasSubstr("README")) << "a file that is named is planned";
}

// Files called hit1, hit2 … could also be parts that were hit once each. So the plan only proposes to join them.
TEST_F(BatchCommand, ProposesToJoinFilesThatAreCalledHits) {
  for (const std::string part : {"A", "B", "C"}) {
    fs::create_directories(folder_.file("parts/" + part));
    for (const std::string hit : {"hit1", "hit2"})
      test::write_small_test(folder_.file("parts/" + part + "/" + hit + ".csv"), R"("hits": 1)");
  }
  const auto planned = batch({"plan", "parts", "-o", "m.jsonl", "--json"});
  ASSERT_EQ(planned.code, 0) << planned.err;
  EXPECT_THAT(planned.err,
              HasSubstr("parts/A/hit1.csv to parts/A/hit2.csv are 2 hits of one part, A, by their names, but "
                        "each file is a test of its own, as is each file of 2 other such parts; if they are "
                        "hits, join the files of each part to one record"));
  const auto document = test::parse_json(planned.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("batch-plan")), testing::IsEmpty());
  EXPECT_EQ(document["records"], 6) << "each file is a record";
  ASSERT_EQ(document["hits_of_one_part"].size(), 3U);
  EXPECT_EQ(document["hits_of_one_part"][1]["part"], "B");
  EXPECT_EQ(document["hits_of_one_part"][1]["paths"].size(), 2U);
  ASSERT_EQ(run_percuss({"convert", "parts/A", "--files", "hits", "-o", "A.h5"}, {.folder = folder_.path()}).code, 0);
  const auto joined = batch({"plan", "A.h5", "-o", "n.jsonl", "--json"});
  EXPECT_EQ(joined.err, "");
  EXPECT_FALSE(test::parse_json(joined.out).contains("hits_of_one_part"));
}

TEST_F(BatchCommand, PlansARecordOfAFolderWhoseExportFailed) {
  fs::create_directories(folder_.file("parts"));
  test::write_small_test(folder_.file("parts/x.csv"), R"("hits": 1)");
  test::write_bytes(folder_.file("parts/y.csv"), "time_s,force_N,accel_mps2\n");
  ASSERT_EQ(batch({"plan", "parts", "-o", "m.jsonl"}).code, 0);
  EXPECT_THAT(bytes_of(folder_.file("m.jsonl")), AllOf(HasSubstr("x.csv"), HasSubstr("y.csv")));
}

TEST_F(BatchCommand, RejectsOptionsAsAnalyzeDoes) {
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--band", "1"},
                                                                                       {"--effort", "bst"},
                                                                                       {"--trigger", "-1"},
                                                                                       {"--from", "2", "--to", "1"},
                                                                                       {"--unit", "furlong"},
                                                                                       {"--fs", "x"},
                                                                                       {"--force-scale", "1,2"},
                                                                                       {"--setup", "none.json"}}) {
    std::vector<std::string> analyze{"analyze", "recs/a.h5"}, plan{"batch", "plan", "recs/a.h5", "-o", "m.jsonl"};
    analyze.insert(analyze.end(), options.begin(), options.end());
    plan.insert(plan.end(), options.begin(), options.end());
    const auto analysed = percuss(analyze), planned = percuss(plan);
    EXPECT_NE(analysed.code, 0);
    EXPECT_EQ(planned.code, analysed.code);
    EXPECT_EQ(planned.err, analysed.err);
    EXPECT_FALSE(fs::exists(folder_.file("m.jsonl")));
  }
}

TEST_F(BatchCommand, StoresOptionsAndTheSetUp) {
  test::write_bytes(folder_.file("setup.json"),
                    R"([{"name": "accel 1", "angle_deg": 10}, {"name": "accel 2", "angle_deg": 100}])");
  ASSERT_EQ(batch({"plan", "recs/a.h5", "--setup", "setup.json", "--start", "200,700", "--accel-scale", "-1,2", "-o",
                   "m.jsonl"})
                .code,
            0);
  EXPECT_THAT(bytes_of(folder_.file("m.jsonl")), AllOf(HasSubstr("angle_deg"), HasSubstr("--accel-scale=-1")));
  fs::remove(folder_.file("setup.json"));
  ASSERT_EQ(run().code, 0);
  EXPECT_EQ(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.jsonl"}).code, 0);
  test::write_bytes(folder_.file("setup.json"),
                    R"([{"name": "accel 1", "angle_deg": 10}, {"name": "accel 2", "angle_deg": 100}])");
  const auto analysis = test::parse_json(percuss({"analyze", "recs/a.h5", "--setup", "setup.json", "--start", "200,700",
                                                  "--accel-scale", "-1,2", "--json"})
                                             .out);
  const auto rows = lines_of(bytes_of(folder_.file("r.jsonl")));
  EXPECT_EQ(test::parse_json(rows.at(2))["ratio_re"], analysis["modes"][0]["ratio"]["re"]);
}

TEST_F(BatchCommand, RejectsAMixtureOfPlans) {
  plan();
  ASSERT_EQ(run().code, 6);
  plan({"--force", "--band", "100:900"});
  EXPECT_THAT(run().err, HasSubstr("made with options that differ from the manifest"));
  EXPECT_THAT(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.jsonl"}).err,
              HasSubstr("made with options that differ"));
  EXPECT_THAT(run({"--shard", "0/2"}).err, HasSubstr("the number of shards in this folder is 1, not 2"));
  EXPECT_EQ(run({"--force"}).code, 6);
  std::string ok = bytes_of(folder_.file("out/part-0.ok"));
  ok.replace(ok.find(R"("version":")"), 11, R"("version":"9.)");
  test::write_bytes(folder_.file("out/part-0.ok"), ok);
  EXPECT_THAT(run().err, HasSubstr("made by percuss 9."));
}

TEST_F(BatchCommand, DetectsAChangedPart) {
  plan();
  ASSERT_EQ(run().code, 6);
  std::string part = bytes_of(folder_.file("out/part-0.jsonl"));
  part[part.find("200.")] = '3';
  test::write_bytes(folder_.file("out/part-0.jsonl"), part);
  const auto outcome = batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.jsonl"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("the part changed after it was finished"));
  EXPECT_FALSE(fs::exists(folder_.file("r.jsonl")));
}

TEST_F(BatchCommand, WritesTablesThatStudyReads) {
  plan();
  ASSERT_EQ(run().code, 6);
  ASSERT_EQ(batch({"merge", "--manifest", "m.jsonl", "out", "-o", "r.jsonl", "-o", "r.csv"}).code, 6);
  test::write_bytes(folder_.file("bats.csv"), "id,length_in,material,besr\na,33,wood,0.7\nd,33,composite,0.71\n");
  for (const char* rows : {"r.csv", "r.jsonl"}) {
    const auto study = percuss({"study", "bats.csv", rows, "--table", "t.csv", "--force", "--json"});
    ASSERT_EQ(study.code, 0) << study.err;
    const auto table = lines_of(bytes_of(folder_.file("t.csv")));
    ASSERT_EQ(table.size(), 3U);
    EXPECT_THAT(table[0], HasSubstr("bending1_hz"));
    EXPECT_THAT(table[1], AllOf(HasSubstr("a,"), HasSubstr(",199.99"), HasSubstr(",699.99")));
  }
}

TEST_F(BatchCommand, PrintsAJobArrayOfMissingShards) {
  plan({"--shards", "3"});
  ASSERT_NE(run({"--shard", "1"}).code, 3);
  const auto script = batch({"submit", "slurm", "--manifest", "m.jsonl", "-o", "out", "--sbatch=--time=5"});
  ASSERT_EQ(script.code, 0) << script.err;
  EXPECT_THAT(script.out, AllOf(HasSubstr("#!/bin/sh\n"), HasSubstr("#SBATCH --array=0,2\n"),
                                HasSubstr("#SBATCH --time=5\n"), HasSubstr("--shard \"$SLURM_ARRAY_TASK_ID/3\"")));
  EXPECT_EQ(batch({"submit", "slurm", "--manifest", "m.jsonl", "-o", "out", "--sbatch=x"}).code, 2);
  EXPECT_EQ(batch({"submit", "pbs", "--manifest", "m.jsonl", "-o", "out"}).code, 2);
}

TEST_F(BatchCommand, RefusesAJobArrayInAFolderWhoseNameHoldsALineEnd) {
  plan();
  const std::string folder = folder_.file("x\n#SBATCH --wrap=id");
  fs::create_directory(folder);
  fs::copy_file(folder_.file("m.jsonl"), folder + "/m.jsonl");
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--go"}}) {
    std::vector<std::string> words{"batch", "submit", "slurm", "--manifest", "m.jsonl", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = run_percuss(words, {.folder = folder});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, HasSubstr("cannot be seen"));
  }
  for (const char* option : {"--sbatch=--a\r--b", "--sbatch=--a\nid", "--sbatch=--a\u202e"})
    EXPECT_EQ(batch({"submit", "slurm", "--manifest", "m.jsonl", "-o", "out", option}).code, 2);
}

TEST_F(BatchCommand, RejectsAnInvalidManifest) {
  const std::string good = R"({"schema":"percuss/batch-manifest/1","version":"1","records":0,"bytes":0,"shards":1,)"
                           R"("frf":false,"options":[],"options_sha256":")";
  for (const std::string& text : std::vector<std::string>{"", "x\n", "{}\n", "[]\n", std::string(1000, '[') + "\n",
                                                          good + "00\"}\n", std::string("\0\0\n", 3)}) {
    test::write_bytes(folder_.file("bad.jsonl"), text);
    test::rejection_of({"batch", "run", "--manifest", folder_.file("bad.jsonl"), "--folder", folder_.file("o")}, {},
                       "bad.jsonl");
  }
}

}  // namespace percuss::batch_command_test
