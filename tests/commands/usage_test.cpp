#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/help_pages.hpp"
#include "support/percuss_process.hpp"

// Errors of the command line: each message is one line that names the wrong word and what to type instead.
namespace percuss::usage_test {

using test::run_percuss;
using testing::HasSubstr;

std::vector<std::string> plus(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The message on standard error, without the name of the program and the newline.
std::string usage_error_of(const std::vector<std::string>& arguments) {
  SCOPED_TRACE(testing::PrintToString(arguments));
  const auto outcome = run_percuss(arguments);
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_THAT(outcome.err, testing::AllOf(testing::StartsWith("percuss: "), HasSubstr("; ")));
  return outcome.err.substr(9, outcome.err.size() - 10);
}

using Case = std::pair<std::vector<std::string>, std::string>;

void expect_lines(const std::vector<Case>& cases) {
  for (const auto& [arguments, line] : cases) EXPECT_EQ(usage_error_of(arguments), line);
}

TEST(Usage, NamesTheNearestCommand) {
  expect_lines({{{"anaylze"}, "there is no command 'anaylze'; did you mean analyze?"},
                {{"Calibrate"}, "there is no command 'Calibrate'; did you mean calibrate?"},
                {{"conv"}, "there is no command 'conv'; did you mean convert?"},
                {{"help", "anaylze"}, "there is no command 'anaylze'; did you mean analyze?"},
                {{"help", "analyze", "x"}, "help takes the name of one command; see percuss --help"},
                {{"fly"}, "there is no command 'fly'; percuss --help lists the commands"},
                {{""}, "there is no command ''; percuss --help lists the commands"},
                {{}, "no command is given; percuss --help lists the commands"},
                {{"model", "baem"}, "there is no command 'model baem'; did you mean model beam?"},
                {{"model", "moon"}, "there is no command 'model moon'; percuss model --help lists the commands"},
                {{"model"}, "no command after percuss model; percuss model --help lists the commands"}});
}

TEST(Usage, NamesTheNearestOption) {
  expect_lines({{{"analyze", "x.h5", "--bnad", "60:3200"}, "analyze has no option --bnad; did you mean --band?"},
                {{"analyze", "x.h5", "--bnad=60:3200"}, "analyze has no option --bnad; did you mean --band?"},
                {{"analyze", "-band", "60:3200"}, "analyze has no option -band; did you mean --band?"},
                {{"analyze", "x.h5", "--JSON"}, "analyze has no option --JSON; did you mean --json?"},
                {{"analyze", "x.h5", "--thr", "1"}, "analyze has no option --thr; did you mean --threads?"},
                {{"model", "beam", "--lenght", "1"}, "model beam has no option --lenght; did you mean --length?"},
                {{"synth", "x", "--sede", "1"}, "synth has no option --sede; did you mean --seed?"},
                {{"--verzion"}, "there is no option --verzion; did you mean --version?"}});
}

TEST(Usage, SuggestsNothingForADistantWord) {
  expect_lines(
      {{{"analyze", "x.h5", "--zebra"}, "analyze has no option --zebra; percuss analyze --help lists the options"},
       {{"analyze", "x.h5", "-z"}, "analyze has no option -z; percuss analyze --help lists the options"},
       {{"--zebra"}, "there is no option --zebra; percuss --help lists the options"},
       {{"analyze", "x.h5", "--" + std::string(500, 'b')},
        "analyze has no option --" + std::string(38, 'b') + "...; percuss analyze --help lists the options"}});
}

// A mistyped option often causes the other errors.
TEST(Usage, NamesTheUnknownOptionBeforeOtherErrors) {
  expect_lines(
      {{{"calibrate", "x.csv", "--mas", "1"}, "calibrate has no option --mas; did you mean --mass?"},
       {{"compare", "--foce"}, "compare has no option --foce; did you mean --force?"},
       {{"model", "beam", "--length", "-1", "--jsno"}, "model beam has no option --jsno; did you mean --json?"},
       {{"model", "beam", "--supprot", "free"}, "model beam has no option --supprot; did you mean --support?"}});
}

TEST(Usage, StatesWhereAnOptionBelongs) {
  expect_lines(
      {{{"--json", "analyze", "x.h5"}, "--json stands before the command; give it after: percuss analyze --json"},
       {{"model", "--length", "2", "beam"},
        "--length stands before the command; give it after: percuss model beam --length M"}});
}

TEST(Usage, NamesTheNearestValue) {
  expect_lines(
      {{{"analyze", "x.h5", "--effort", "bset"}, "--effort cannot be 'bset'; did you mean best?"},
       {{"analyze", "x.h5", "--effort", "9"}, "--effort cannot be '9'; give quick, standard or best"},
       {{"analyze", "x.h5", "--effort="}, "--effort has no value; give quick|standard|best"},
       {{"survey", "x.h5", "--roving", "hmmer"}, "--roving cannot be 'hmmer'; did you mean hammer?"},
       {{"analyze", "x.h5", "--files", "point"}, "--files cannot be 'point'; did you mean points?"},
       {{"analyze", "x.h5", "--frf-kind", "z"}, "--frf-kind cannot be 'z'; give accelerance, mobility or receptance"},
       {{"analyze", "x.h5", "--only", "hits,mods"}, "--only cannot be 'mods'; did you mean modes?"},
       {{"model", "beam", "--fit", "rhoa", "--measured", "1"}, "--fit cannot be 'rhoa'; did you mean rho-a?"},
       {{"completion", "fsh"}, "SHELL cannot be 'fsh'; did you mean fish?"},
       {{"completion", "csh"}, "SHELL cannot be 'csh'; did you mean zsh?"}});
}

TEST(Usage, StatesTheRuleForAValue) {
  expect_lines(
      {{{"analyze", "x.h5", "--threads", "x"}, "--threads cannot be 'x'; give a whole number from 0 to 1024"},
       {{"analyze", "x.h5", "--threads", "-1"}, "--threads cannot be '-1'; give a whole number from 0 to 1024"},
       {{"analyze", "x.h5", "--overlay-db", "0"}, "--overlay-db cannot be '0'; give a number above 0"},
       {{"analyze", "x.h5", "--angle", "0,x"}, "--angle cannot be 'x'; give a number"},
       {{"analyze", "x.h5", "--accept-hit", "1.5"},
        "--accept-hit cannot be '1.5'; give whole numbers from 1 up, ranges such as 1-5, or all"},
       {{"calibrate", "x.csv", "--mass", "1m"}, "--mass cannot be '1m'; give a number above 0"},
       {{"calibrate", "x.csv", "--mass", "nan"}, "--mass cannot be 'nan'; give a number above 0"},
       {{"model", "beam", "--length", ""}, "--length cannot be ''; give a number above 0"},
       {{"model", "beam", "--length", "1\n2"}, "--length cannot be '1\\u000a2'; give a number above 0"},
       {{"model", "beam", "--modes", "201"}, "--modes cannot be '201'; give a whole number from 1 to 200"},
       {{"metrics", "--period-s", "1.2,0"}, "--period-s cannot be '0'; give a number above 0"},
       {{"synth", "x", "--seed", "-4"}, "--seed cannot be '-4'; give a whole number from 0 up"},
       {{"synth", "x", "--seed", "18446744073709551616"},
        "--seed cannot be '18446744073709551616'; give a whole number below 2^64"}});
}

TEST(Usage, NamesTheMissingArgument) {
  expect_lines({{{"analyze", "x.h5", "--band"}, "--band has no value; give LO:HI"},
                {{"analyze", "x.h5", "--band", "--json"}, "--band has no value; give LO:HI"},
                {{"analyze", "x.h5", "-o", "--json"}, "--output has no value; give FILE"},
                {{"analyze", "x.h5", "-o"}, "--output has no value; give FILE"},
                {{"calibrate", "x.csv"}, "calibrate needs --mass; give percuss calibrate --mass KG"},
                {{"compare"}, "no FILE; give percuss compare FILE"},
                {{"completion"}, "no SHELL; give percuss completion SHELL: bash, zsh or fish"}});
}

TEST(Usage, NamesTheSuperfluousArgument) {
  expect_lines({{{"analyze", "x.h5", "--band", "1:2", "--band", "3:4"}, "--band is given twice; keep one"},
                {{"synth", "a", "b"}, "synth takes one SPEC, and 'b' is another; omit one"},
                {{"model", "beam", "x"},
                 "model beam takes options only, and 'x' is not one; percuss model beam --help lists the options"},
                {{"analyze", "x.h5", "--json=yes"}, "--json takes no value; give it alone, or omit it"}});
}

TEST(Usage, NamesTheOptionsOfTheRemedy) {
  expect_lines(
      {{{"model", "shell", "--wall", "1"},
        "--wall is half of the outer diameter or more; give the thickness of the wall in m (--outer-diameter)"},
       {{"metrics", "--period-s", "1", "--gate-times-s", "1,2"},
        "--period-s and --gate-times-s exclude each other; give one of them"},
       {{"nodes", "x.h5", "--positions", "3:0.3:9.1"},
        "--positions cannot be '3:0.3:9.1': the end is not a whole number of steps from the start; give START:STEP:END "
        "or a list, with a unit (in, m, mm, cm, ft), such as 3:0.25:9in or 3,3.5,5in; without a unit, inches"},
       {{"synth"}, "no spec is given; name a JSON file, a preset, or - for standard input (see percuss synth --list)"},
       {{"study"},
        "no table is given; name a table of bats, or documents of analyze, metrics, certify or abi that name their bat "
        "(see percuss analyze --bat-id)"}});
}

// "--" ends the options, so that the name of a file may look like one.
TEST(Usage, AcceptsAFileNamedLikeAnOption) {
  const auto outcome = run_percuss({"analyze", "--", "--bnad"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no such file (--bnad)"));
}

// Every option of at least four letters, with two of them swapped.
TEST(Usage, SuggestsEveryMistypedOption) {
  std::set<std::string> tried;
  for (const auto& command : test::commands()) {
    const auto names = test::option_names(command);
    const std::set<std::string> known(names.begin(), names.end());
    for (const std::string& name : names) {
      std::string typed = name;
      if (name.size() < 6 || tried.contains(name)) continue;
      std::swap(typed[3], typed[4]);
      if (known.contains(typed)) continue;
      EXPECT_THAT(usage_error_of(plus(command, {typed})),
                  HasSubstr(fmt::format("no option {}; did you mean {}?", typed, name)));
      tried.insert(name);
    }
  }
  EXPECT_GT(tried.size(), 100U);
}

TEST(Usage, SuggestsEveryMistypedCommand) {
  for (auto typed : test::commands()) {
    if (typed.empty() || typed.back().size() < 4) continue;
    const std::string meant = test::joined(typed);
    std::swap(typed.back()[1], typed.back()[2]);
    EXPECT_EQ(usage_error_of(typed), "there is no command '" + test::joined(typed) + "'; did you mean " + meant + "?");
  }
}

}  // namespace percuss::usage_test
