#include "metrics/protocol/abi.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/input_error.hpp"
#include "synth/random_stream.hpp"

namespace percuss::metrics::abi_test {

using test::input_error_of;
using testing::HasSubstr;

AbiEntry compression(double mean_lbf) {
  return {.place = "log", .what = AbiCompression{{mean_lbf + 6, mean_lbf - 6, mean_lbf + 2, mean_lbf - 2}}};
}
AbiEntry roll(double depth_in) { return {.place = "log", .what = AbiRoll{depth_in}}; }
AbiEntry performance(double value) { return {.place = "log", .what = AbiPerformance{.value = value}}; }

AbiLog log_of(std::vector<AbiEntry> entries) {
  return {.bat = "b", .material = "composite", .limit = 0.728, .entries = std::move(entries)};
}
AbiRun run_of(std::vector<AbiEntry> entries) { return evaluate_abi(log_of(std::move(entries))); }

// The first cycle, up to the compression after its test.
std::vector<AbiEntry> start(double after_lbf) { return {compression(600), performance(0.715), compression(after_lbf)}; }

std::vector<AbiEntry> with(std::vector<AbiEntry> entries, const std::vector<AbiEntry>& more) {
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

TEST(Abi, StartsWithTheCompressionAndATest) {
  EXPECT_EQ(run_of({}).next, AbiStep::initial_compression);
  EXPECT_EQ(run_of({compression(600)}).next, AbiStep::first_performance);
  EXPECT_EQ(run_of({compression(600), performance(0.7)}).next, AbiStep::compression_after_first);
}

TEST(Abi, AveragesTheFourOrientations) {
  AbiCompression forces{{600, 610, 590, 620}};
  EXPECT_EQ(forces.mean_lbf(), 605);
  EXPECT_EQ(run_of({compression(600)}).compressions.at(0).mean_lbf, 600);
}

TEST(Abi, SkipsRollingAboveFifteenPercent) {
  EXPECT_EQ(run_of(start(600)).next, AbiStep::roll);
  EXPECT_EQ(run_of(start(510)).next, AbiStep::roll);  // 15 % is not more than 15 %
  EXPECT_EQ(run_of(start(509)).next, AbiStep::performance);
  EXPECT_NEAR(*run_of(start(509)).compressions.back().reduction, 91.0 / 600, 1e-12);
}

TEST(Abi, RollsDeeperUntilFivePercentOfTheStateBeforeRolling) {
  AbiRun run = run_of(start(590));
  EXPECT_EQ(next_depth_in(run), 0.10);
  run = run_of(with(start(590), {roll(0.1)}));
  EXPECT_EQ(run.next, AbiStep::compression_after_roll);
  run = run_of(with(start(590), {roll(0.1), compression(561)}));  // 4.9 % of 590; 6.5 % of BC_0
  EXPECT_EQ(run.next, AbiStep::roll);
  EXPECT_EQ(next_depth_in(run), 0.1125);
  EXPECT_NEAR(*run.compressions.back().reduction, 29.0 / 590, 1e-12);
  run = run_of(with(start(590), {roll(0.1), compression(560.5)}));  // 5 % exactly
  EXPECT_EQ(run.next, AbiStep::performance);
}

TEST(Abi, ComparesTheCompressionAfterATestWithTheLastBeforeIt) {
  // Step 9 as printed would be (BC_2,0 − BC_1,1)/BC_2,0, below zero for a barrel that softens.
  const auto cycle = with(start(600), {roll(0.1), compression(560), performance(0.72)});
  EXPECT_EQ(run_of(cycle).next, AbiStep::compression_after_performance);
  AbiRun run = run_of(with(cycle, {compression(500)}));
  EXPECT_NEAR(*run.compressions.back().reduction, 60.0 / 560, 1e-12);
  EXPECT_EQ(run.next, AbiStep::roll);
  EXPECT_EQ(run.roll, 0);
  EXPECT_EQ(next_depth_in(run), 0.1125);  // deeper than the last rolling, also in a new cycle
  run = run_of(with(cycle, {compression(470)}));
  EXPECT_EQ(run.next, AbiStep::performance);  // 16 %
  run = run_of(with(cycle, {compression(470), performance(0.721)}));
  EXPECT_EQ(run.next, AbiStep::compression_after_performance);
  run = run_of(with(cycle, {compression(470), performance(0.721), compression(469)}));
  EXPECT_NEAR(*run.compressions.back().reduction, 1.0 / 470, 1e-12);
}

TEST(Abi, FailsOnTheLimitInAnyTestAndOnDamageInTheFirst) {
  EXPECT_EQ(run_of({compression(600), performance(0.728)}).verdict, AbiVerdict::in_progress);
  const AbiRun first = run_of({compression(600), performance(0.7281)});
  EXPECT_EQ(first.verdict, AbiVerdict::fail);
  EXPECT_EQ(first.next, AbiStep::done);
  EXPECT_EQ(run_of(with(start(500), {performance(0.73)})).verdict, AbiVerdict::fail);
  AbiEntry damaged = performance(0.7);
  std::get<AbiPerformance>(damaged.what).damage = true;
  EXPECT_EQ(run_of({compression(600), damaged}).verdict, AbiVerdict::fail);
  EXPECT_EQ(run_of(with(start(500), {damaged})).verdict,
            AbiVerdict::pass);  // 0.015 below the best; damage counts only in the first test
}

TEST(Abi, PassesWhenThePerformanceFellEnough) {
  EXPECT_EQ(run_of(with(start(500), {performance(0.701)})).verdict, AbiVerdict::pass);  // 0.014 exactly
  EXPECT_EQ(run_of(with(start(500), {performance(0.7011)})).verdict, AbiVerdict::in_progress);
  AbiLog bbcor = log_of(with(start(500), {performance(0.698)}));
  bbcor.bbcor = true;
  EXPECT_EQ(evaluate_abi(bbcor).verdict, AbiVerdict::in_progress);  // 0.017
  bbcor.entries.back() = performance(0.697);
  EXPECT_EQ(evaluate_abi(bbcor).verdict, AbiVerdict::pass);
  // The best value of all earlier tests counts.
  const auto risen = with(start(500), {performance(0.725), compression(400), performance(0.711)});
  EXPECT_EQ(run_of(risen).verdict, AbiVerdict::pass);
  EXPECT_EQ(run_of(risen).cycles.back().best, 0.725);
}

TEST(Abi, PassesNothingWithoutALimit) {
  AbiLog log = log_of(with(start(500), {performance(0.65)}));
  log.limit.reset();
  EXPECT_EQ(evaluate_abi(log).verdict, AbiVerdict::undecided);
}

TEST(Abi, GivesNoVerdictOnABrokenBat) {
  AbiEntry broken = performance(0.71);
  std::get<AbiPerformance>(broken.what).broken = true;
  EXPECT_EQ(run_of(with(start(500), {broken})).verdict, AbiVerdict::undecided);
  EXPECT_EQ(run_of({compression(600), broken}).verdict, AbiVerdict::fail);
}

TEST(Abi, ContinuesAfterAFailureWithTheSameVerdict) {
  AbiLog log = log_of(with(start(500), {performance(0.74), compression(400), performance(0.72)}));
  EXPECT_THAT(input_error_of([&] { evaluate_abi(log); }), HasSubstr("after the procedure's end"));
  log.continued = true;
  const AbiRun run = evaluate_abi(log);
  EXPECT_EQ(run.verdict, AbiVerdict::fail);
  EXPECT_EQ(run.next, AbiStep::done);
  log.entries.back() = performance(0.76);
  EXPECT_THAT(evaluate_abi(log).why, HasSubstr("cycle 2"));  // the first reason stays
}

TEST(Abi, EndsAfterManyCycles) {
  const auto entries = with(start(500), {performance(0.72)});
  AbiRules rules;
  rules.max_cycles = 2;
  const AbiRun run = evaluate_abi(log_of(entries), rules);
  EXPECT_EQ(run.verdict, AbiVerdict::undecided);
  EXPECT_THAT(run.why, HasSubstr("does not fall"));
}

TEST(Abi, RefusesStepsOutOfOrderAndNamesTheStep) {
  const auto message = [](std::vector<AbiEntry> entries) {
    return input_error_of([&] { run_of(std::move(entries)); });
  };
  EXPECT_THAT(message({performance(0.7)}), HasSubstr("step 1 comes next (measure the barrel's compression), not a "));
  EXPECT_THAT(message({compression(600), compression(600)}), HasSubstr("step 2"));
  EXPECT_THAT(message({compression(600), performance(0.7), roll(0.1)}), HasSubstr("step 3"));
  EXPECT_THAT(message(with(start(600), {performance(0.7)})), HasSubstr("step 4"));
  EXPECT_THAT(message(with(start(600), {roll(0.1), roll(0.11)})), HasSubstr("step 5"));
  EXPECT_THAT(message(with(start(500), {roll(0.1)})), HasSubstr("step 7"));
  EXPECT_THAT(message(with(start(500), {performance(0.71), performance(0.71)})), HasSubstr("step 9"));
  EXPECT_THAT(message(with(start(600), {roll(0.1), compression(590), roll(0.1)})), HasSubstr("step 4: rolled 0.1 in"));
  EXPECT_THAT(message({compression(600), performance(0.8), compression(600)}), HasSubstr("after the procedure's end"));
}

TEST(Abi, RemarksOnDepthsOvershootAndMaterial) {
  AbiRun run = run_of(with(start(600), {roll(0.12), compression(520)}));
  ASSERT_EQ(run.remarks.size(), 2U);
  EXPECT_EQ(run.remarks[0].code, "roll_depth");
  EXPECT_EQ(run.remarks[1].code, "overshoot");
  AbiLog aluminium = log_of({});
  aluminium.material = "aluminum";
  EXPECT_EQ(evaluate_abi(aluminium).remarks.at(0).code, "material");
  aluminium.material.clear();
  EXPECT_TRUE(evaluate_abi(aluminium).remarks.empty());
}

TEST(Abi, StatesTheNextStep) {
  EXPECT_EQ(next_step_text(run_of({})), "step 1: measure the barrel's compression");
  EXPECT_THAT(next_step_text(run_of(start(600))), HasSubstr("roll the barrel, rollers about 0.1 in deep"));
  EXPECT_THAT(next_step_text(run_of(start(509))), HasSubstr("test the performance"));
  EXPECT_EQ(next_step_text(run_of({compression(600), performance(0.8)})).substr(0, 6), "fail: ");
  AbiRun broken{.next = AbiStep::done, .verdict = AbiVerdict::undecided, .why = "broken"};
  EXPECT_EQ(next_step_text(broken), "no verdict: broken");
}

TEST(Abi, NamesItsVerdicts) {
  EXPECT_STREQ(name_of(AbiVerdict::pass), "pass");
  EXPECT_STREQ(name_of(AbiVerdict::fail), "fail");
  EXPECT_STREQ(name_of(AbiVerdict::undecided), "undecided");
  EXPECT_STREQ(name_of(AbiVerdict::in_progress), "in_progress");
}

TEST(Abi, EndsForABarrelThatDoesNotSoften) {
  auto entries = start(600);
  AbiRun run = run_of(entries);
  for (int i = 0; run.next == AbiStep::roll; ++i) {
    ASSERT_LT(i, 100);
    entries.push_back(roll(next_depth_in(run)));
    entries.push_back(compression(600));
    run = run_of(entries);
  }
  EXPECT_EQ(run.verdict, AbiVerdict::undecided);
  EXPECT_THAT(run.why, HasSubstr("deeper than"));
}

// Bats whose compression and performance change at random. The procedure always ends, never asks for a depth beyond
// the rollers, and never passes a bat that exceeded the limit.
TEST(Abi, EndsOnEveryBatAndNeverPassesOneThatFails) {
  std::array<int, 4> verdicts{};
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    synth::RandomStream random{3, seed};
    AbiLog log = log_of({});
    log.limit = 0.735;
    double stiff_lbf = random.uniform(300, 900), value = random.uniform(0.70, 0.73), highest = 0;
    const double softening = random.uniform(0, 0.06), gain = random.uniform(0, 0.004),
                 falls_below = random.uniform(0.2, 0.9);
    const double fresh_lbf = stiff_lbf;
    AbiRun run = evaluate_abi(log);
    for (int done = 0; run.next != AbiStep::done; ++done) {
      ASSERT_LT(done, 1000) << "does not end";
      if (run.next == AbiStep::roll) {
        ASSERT_LE(next_depth_in(run), 0.5);
        log.entries.push_back(roll(next_depth_in(run)));
        stiff_lbf *= 1 - softening;
      } else if (run.next == AbiStep::first_performance || run.next == AbiStep::performance) {
        value += stiff_lbf > falls_below * fresh_lbf ? gain * random.uniform() : -0.006;
        highest = std::max(highest, value);
        log.entries.push_back(performance(value));
        stiff_lbf *= 1 - 0.2 * random.uniform() * random.uniform();
      } else {
        log.entries.push_back(compression(std::max(stiff_lbf, 10.0)));
      }
      run = evaluate_abi(log);
    }
    ++verdicts.at(static_cast<std::size_t>(run.verdict));
    if (run.verdict == AbiVerdict::pass) {
      EXPECT_LE(highest, *log.limit);
    }
    if (highest > *log.limit) {
      EXPECT_EQ(run.verdict, AbiVerdict::fail);
    }
  }
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(AbiVerdict::pass)), 20);
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(AbiVerdict::fail)), 20);
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(AbiVerdict::undecided)), 5);
}

AbiEntry compression_by(double displacement_in, double mean_lbf) {
  AbiEntry entry = compression(mean_lbf);
  std::get<AbiCompression>(entry.what).displacement_in = displacement_in;
  return entry;
}

std::vector<std::string> remarks_of(const AbiRun& run) {
  std::vector<std::string> codes;
  for (const ProtocolFinding& remark : run.remarks) codes.push_back(remark.code);
  return codes;
}

TEST(Abi, KeepsOneDisplacementAndReportsAReducedOne) {
  EXPECT_EQ(run_of(start(590)).displacement_in, 0.03);
  EXPECT_THAT(remarks_of(run_of(start(590))), testing::IsEmpty());
  AbiLog log = log_of(start(590));
  log.displacement_in = 0.025;
  EXPECT_EQ(evaluate_abi(log).displacement_in, 0.025);
  EXPECT_THAT(remarks_of(evaluate_abi(log)), testing::ElementsAre("reduced_displacement"));
  EXPECT_THAT(evaluate_abi(log).remarks[0].message, HasSubstr("0.025 in, not 0.03 in"));
  log.displacement_in = 0.04;
  EXPECT_THAT(remarks_of(evaluate_abi(log)), testing::ElementsAre("displacement"));
  // Stated by the first compression alone, it holds for all.
  const AbiRun run = run_of({compression_by(0.02, 600), performance(0.7), compression(590)});
  EXPECT_EQ(run.displacement_in, 0.02);
  EXPECT_THAT(input_error_of([] {
                run_of({compression_by(0.02, 600), performance(0.7), compression_by(0.03, 590)});
              }),
              HasSubstr("compressed by 0.03 in, but the other compressions by 0.02 in"));
  log.displacement_in = 0.03;
  log.entries[0] = compression_by(0.025, 600);
  EXPECT_THAT(input_error_of([&] { evaluate_abi(log); }), HasSubstr("use one displacement"));
}

TEST(Abi, NamesTheStatesOfTheBat) {
  std::vector<AbiEntry> entries = with(start(500), {performance(0.72), compression(400), performance(0.71)});
  std::get<AbiPerformance>(entries.back().what).id = "B336";
  std::get<AbiPerformance>(entries.back().what).z_in = 5.5;
  const AbiRun run = run_of(entries);
  ASSERT_EQ(run.cycles.size(), 3U);
  EXPECT_EQ(run.cycles[0].id, "b");
  EXPECT_EQ(run.cycles[1].id, "b-2");
  EXPECT_EQ(run.cycles[2].id, "B336");
  EXPECT_EQ(run.cycles[2].z_in, 5.5);
}

}  // namespace percuss::metrics::abi_test
