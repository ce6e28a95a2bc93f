#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Names and texts of files with characters that control a terminal, reorder a line or are invisible; and formulas in
// tables.
namespace percuss::hidden_characters_test {

namespace fs = std::filesystem;
using test::bytes_of;
using test::ProcessOutcome;
using test::run_percuss;
using test::write_bytes;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kHidden{"\u202e", "\x1b",   "\r",     "\x07",   "\x7f",   "\u0085", "\u009b", "\u200b",
                                       "\u200e", "\u200f", "\u061c", "\u202a", "\u202b", "\u202c", "\u202d", "\u2066",
                                       "\u2067", "\u2068", "\u2069", "\u2028", "\u2029", "\ufeff"};

std::string all_hidden() {
  std::string text = "a";
  for (const std::string& one : kHidden) text += one;
  return text + "z";
}

void expect_visible(const std::string& text) {
  for (const std::string& one : kHidden) EXPECT_EQ(text.find(one), std::string::npos) << text;
  for (const char byte : {'\xff', '\xfe'}) EXPECT_EQ(text.find(byte), std::string::npos) << text;
}

void expect_visible(const ProcessOutcome& outcome) {
  EXPECT_EQ(outcome.signal, 0);
  expect_visible(outcome.out);
  expect_visible(outcome.err);
}

TEST(HiddenCharacters, AreEscapesInErrorsAboutPathsAndWords) {
  const std::string name = all_hidden() + "\xff\xfe";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"info", name + ".csv"},
                                             {"analyze", name + ".h5"},
                                             {"analyze", "x.h5", "--effort", name},
                                             {name},
                                             {"--" + name},
                                             {"analyze", "x.h5", "--" + name},
                                             {"convert", "x.h5", name}}) {
    const ProcessOutcome outcome = run_percuss(words);
    EXPECT_NE(outcome.code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("\\u202e")) << testing::PrintToString(words);
    expect_visible(outcome);
  }
}

TEST(HiddenCharacters, AreEscapesInTablesOfChannelsAndPaths) {
  const test::ScratchFolder folder;
  std::string channel;
  for (const std::string& one : kHidden) channel += one == "\r" ? "" : one;  // a carriage return would end the line
  std::string rows;
  for (int i = 0; i < 600; ++i)
    rows += std::to_string(i * 0.001) + (i == 20 ? ",50" : i == 21 ? ",80" : i == 22 ? ",40" : ",0") + ",0.1\n";
  const std::string path = folder.file(all_hidden() + "\xff.csv");
  write_bytes(path, "t,force_N,acc" + channel + " (m/s^2)\n" + rows);
  for (const char* command : {"info", "analyze"}) {
    const ProcessOutcome text = run_percuss({command, path});
    EXPECT_THAT(text.out + text.err, HasSubstr("\\u202e"));
    expect_visible(text);
  }
}

TEST(HiddenCharacters, AreEscapesOfJsonInDocuments) {
  const test::ScratchFolder folder;
  const std::string name = all_hidden() + ".h5", path = folder.file(name);
  test::write_small_test(path);
  const ProcessOutcome outcome = run_percuss({"info", path, "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_visible(outcome);
  EXPECT_EQ(test::parse_json(outcome.out)["files"][0]["path"], path);
}

// A long document is written in several pieces, and a character may be divided between two of them.
TEST(HiddenCharacters, DoNotChangeOtherCharacters) {
  const test::ScratchFolder folder;
  const std::string first = folder.file("r.csv");
  test::write_small_test(first, R"("hits": 1)");
  std::vector<std::string> words{"info", "--json"};
  for (int i = 0; i < 300; ++i) {
    std::string name = std::to_string(i);
    for (int n = 0; n < 70; ++n) name += "°";
    words.push_back(folder.file(name + ".csv"));
    fs::create_hard_link(first, words.back());
  }
  const ProcessOutcome outcome = run_percuss(words);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(outcome.out.size(), 150'000U);
  const auto files = test::parse_json(outcome.out)["files"];
  ASSERT_EQ(files.size(), 300U);
  for (std::size_t i = 0; i < files.size(); ++i) EXPECT_EQ(files[i]["path"], words[i + 2]);
}

TEST(Formulas, AreEscapedInTablesOfBatsAndRestored) {
  const test::ScratchFolder folder;
  const std::string head = "id,bat,maker,model,length_in,material,condition,program,besr\n";
  write_bytes(folder.file("bats.csv"), head + "=1+1,@b,+c,-d,33,wood,new,=x,0.7\n-1.5,b,c,d,33,wood,new,x,0.71\n");
  const auto table = [&](const std::string& in, const std::string& out, std::vector<std::string> more) {
    more.insert(more.begin(), {"study", folder.file(in), "--table", folder.file(out), "--quiet"});
    const ProcessOutcome outcome = run_percuss(more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return bytes_of(folder.file(out));
  };
  const std::string safe = table("bats.csv", "safe.csv", {});
  EXPECT_THAT(safe, HasSubstr("\n'=1+1,'@b,'+c,'-d,33,wood,new,'=x,"));
  EXPECT_THAT(safe, HasSubstr("\n-1.5,b,c,d,33,"));
  const std::string plain = table("safe.csv", "plain.csv", {"--keep-formulas"});
  EXPECT_THAT(plain, HasSubstr("\n=1+1,@b,+c,-d,33,wood,new,=x,"));
  EXPECT_EQ(table("plain.csv", "again.csv", {}), safe);
}

TEST(Formulas, AreEscapedInTheKeyAndInTheTablesOfFigures) {
  const test::ScratchFolder folder;
  std::string bats = run_percuss({"study", "--example"}).out;
  for (std::size_t at = bats.find("\nS"); at != std::string::npos; at = bats.find("\nS", at))
    bats.replace(at, 2, "\n=S");
  write_bytes(folder.file("bats.csv"), bats);
  const ProcessOutcome outcome = run_percuss(
      {"study", folder.file("bats.csv"), "--figures", folder.file("figures"), "-o", folder.file("s.csv"), "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(run_percuss({"study", folder.file("bats.csv"), "--blind", folder.file("key.csv"), "--quiet"}).code, 0);
  EXPECT_THAT(bytes_of(folder.file("key.csv")), HasSubstr(",'=S001,"));
  std::size_t tables = 0;
  for (const auto& entry : fs::directory_iterator(folder.file("figures"))) {
    if (entry.path().extension() != ".csv") continue;
    ++tables;
    EXPECT_THAT(bytes_of(entry.path()), Not(HasSubstr("\n=S"))) << entry.path();
  }
  EXPECT_GT(tables, 5U);
  EXPECT_THAT(bytes_of(folder.file("s.csv")), Not(HasSubstr(",=S")));
}

TEST(Formulas, AreEscapedInMergedRows) {
  const test::ScratchFolder folder;
  fs::create_directory(folder.file("recs"));
  test::write_small_test(folder.file("recs/=cmd.h5"), R"("hits": 1, "seed": 1)");
  const auto batch = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "batch");
    const ProcessOutcome outcome = run_percuss(words, {.folder = folder.path()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  };
  batch({"plan", "recs", "-o", "m.jsonl", "--effort", "quick", "--quiet"});
  batch({"run", "--manifest", "m.jsonl", "-o", "out", "--quiet"});
  batch({"merge", "--manifest", "m.jsonl", "out", "-o", "safe.csv", "--quiet"});
  batch({"merge", "--manifest", "m.jsonl", "out", "-o", "plain.csv", "--keep-formulas", "--quiet"});
  EXPECT_THAT(bytes_of(folder.file("safe.csv")), HasSubstr("\nrecord,'=cmd,recs/=cmd.h5,"));
  EXPECT_THAT(bytes_of(folder.file("plain.csv")), HasSubstr("\nrecord,=cmd,recs/=cmd.h5,"));
  write_bytes(folder.file("bats.csv"), "id,length_in,material,besr\n'=cmd,33,wood,0.7\n");
  for (const char* rows : {"safe.csv", "plain.csv"}) {
    const ProcessOutcome study = run_percuss(
        {"study", folder.file("bats.csv"), folder.file(rows), "--table", folder.file("t.csv"), "--force", "--quiet"});
    ASSERT_EQ(study.code, 0) << study.err;
    EXPECT_THAT(bytes_of(folder.file("t.csv")), HasSubstr("\n'=cmd,,,,33,wood,"));
    EXPECT_THAT(bytes_of(folder.file("t.csv")), HasSubstr(",199.99"));  // the mode at 200 Hz, from the rows
  }
}

}  // namespace percuss::hidden_characters_test
