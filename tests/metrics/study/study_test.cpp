#include "metrics/study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "metrics/study/study_files.hpp"
#include "support/input_error.hpp"
#include "synth/population.hpp"
#include "synth/random_stream.hpp"

namespace percuss::metrics::study_test {

using test::input_error_of;
using testing::HasSubstr;

const StudyStatement& statement_of(const Study& study, StudyFamily family, StudyQuantity y, StudyQuantity x) {
  return *std::find_if(study.statements.begin(), study.statements.end(),
                       [&](const auto& s) { return s.family == family && s.y == y && s.x == x; });
}

TEST(Study, FindsKnownRelations) {
  using enum StudyQuantity;
  int false_relations = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Study study = study_of(synth::synthetic_population({.seed = seed}));
    for (const StudyQuantity y : {besr, bbs, bbcor}) {
      const auto& hoop = statement_of(study, StudyFamily::nonwood, y, hoop1);
      EXPECT_EQ(hoop.verdict, StatementVerdict::supported) << seed;
      EXPECT_LT(hoop.association->spearman.high, 0);
    }
    EXPECT_EQ(statement_of(study, StudyFamily::wood, besr, moi).verdict, StatementVerdict::supported);
    const auto& unrelated = statement_of(study, StudyFamily::wood, bbcor, moi);
    false_relations += unrelated.association->spearman.low > 0 || unrelated.association->spearman.high < 0 ? 1 : 0;
  }
  EXPECT_LE(false_relations, 4);  // 5 % of 20 by chance: more than 4 once in 400 times
}

// The correlation of a hollow bat's BBCOR with its hoop frequency follows from gain g, range and noise σ:
// r = −g σ_h/√(g² σ_h² + σ²), with σ_h the standard deviation of the uniformly distributed hoop frequencies.
TEST(Study, HasIntervalsThatCoverTheCorrelation) {
  int covered = 0;
  const int populations = 200;
  for (int seed = 0; seed < populations; ++seed) {
    const synth::PopulationSpec spec{.seed = static_cast<std::uint64_t>(seed),
                                     .wood = 0,
                                     .aluminum = 0,
                                     .composite = 80,
                                     .hoop_gain = 1e-5,
                                     .noise = 0.006,
                                     .break_in = false};
    const Study study = study_of(synth::synthetic_population(spec));
    // Uniform from 1300 to 2800 Hz.
    const double hoop_std = 1500 / std::sqrt(12.0), part = spec.hoop_gain * hoop_std;
    const double true_r = -part / std::hypot(part, spec.noise);
    const auto& a = statement_of(study, StudyFamily::nonwood, StudyQuantity::bbcor, StudyQuantity::hoop1).association;
    covered += a->pearson.low <= true_r && true_r <= a->pearson.high ? 1 : 0;
  }
  // 95 % of 200: 190 ± 3.1. The limit is four standard deviations below. A uniform x makes the interval a little too
  // wide, if anything.
  EXPECT_GE(covered, 178);
}

bool finds_a_relation(const Study& study) {
  return std::any_of(study.statements.begin(), study.statements.end(),
                     [](const StudyStatement& s) { return s.verdict != StatementVerdict::not_supported; });
}

TEST(Study, FindsNoRelationInUnrelatedBats) {
  int false_studies = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto bats = synth::synthetic_population({.seed = seed, .related = false, .break_in = false});
    false_studies += finds_a_relation(study_of(bats)) ? 1 : 0;
  }
  // At most 5 % of 200 studies have a false statement: 10, with a standard deviation of 3.1. Three standard deviations
  // are added.
  EXPECT_LE(false_studies, 19);
}

// Bats of `lengths` different lengths, whose quantities are independent of each other.
std::vector<StudyBat> unrelated_bats(std::uint64_t seed, std::size_t count, BarrelMaterial material, int lengths) {
  synth::RandomStream random{23, seed};
  std::vector<double> draws(count * kStudyQuantities, 0);
  random.add_normal(1, draws);
  std::vector<StudyBat> bats;
  for (std::size_t b = 0; b < count; ++b) {
    StudyBat bat{.id = "b" + std::to_string(b),
                 .length_in = 31.0 + static_cast<double>(b % static_cast<std::size_t>(lengths)),
                 .material = material};
    for (std::size_t q = 0; q < kStudyQuantities; ++q) bat.values.at(q) = 100 + draws[b * kStudyQuantities + q];
    bats.push_back(bat);
  }
  return bats;
}

// The number of 200 studies of unrelated bats that find a relation.
int false_studies(std::size_t bats, BarrelMaterial material, int lengths) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    count += finds_a_relation(study_of(unrelated_bats(seed, bats, material, lengths))) ? 1 : 0;
  return count;
}

// 5 % of 200 and three standard deviations, as above. Four bats can support nothing: their least p is 1/12.
TEST(Study, FindsNoRelationInAFewUnrelatedBats) {
  EXPECT_EQ(false_studies(4, BarrelMaterial::composite, 1), 0);
  for (const std::size_t bats : {5U, 6U, 8U, 10U, 12U, 13U, 16U, 24U}) {
    EXPECT_LE(false_studies(bats, BarrelMaterial::composite, 1), 19) << bats;
    if (bats % 4 == 0) {
      EXPECT_LE(false_studies(bats, BarrelMaterial::wood, 3), 19) << bats;
    }
  }
}

TEST(Study, LeavesOtherProgramsOutOfStatements) {
  auto bats = unrelated_bats(3, 20, BarrelMaterial::aluminum, 1);
  for (std::size_t b = 12; b < 20; ++b) bats[b].program = "bbcor";
  bats[0].program = "besr";
  using enum StudyQuantity;
  const auto points = [&](const Study& study) {
    return statement_of(study, StudyFamily::nonwood, besr, moi).association->points;
  };
  const Study study = study_of(bats);
  EXPECT_EQ(points(study), 12U);
  EXPECT_EQ(study.figures.back().classes.back().bats.size(), 20U);  // drawn
  ASSERT_EQ(study.programs.size(), 2U);
  EXPECT_FALSE(study.programs[0].counted);
  // The trend is that of the counted bats alone.
  const Study without = study_of({bats.begin(), bats.begin() + 12});
  EXPECT_EQ(study.figures[0].classes[0].trend->slope, without.figures[0].classes[0].trend->slope);
  EXPECT_EQ(study.figures[0].classes[0].outliers, without.figures[0].classes[0].outliers);
  EXPECT_EQ(points(study_of(bats, {.programs = {"all"}})), 20U);
  EXPECT_EQ(points(study_of(bats, {.programs = {"bbcor"}})), 8U);
  EXPECT_EQ(points(study_of(bats, {.programs = {"bbcor", "besr"}})), 20U);
  EXPECT_THAT(input_error_of([&] { study_of(bats, {.programs = {"usssa"}}); }), HasSubstr("usssa"));
  for (StudyBat& bat : bats) bat.program = "bbcor";
  EXPECT_EQ(points(study_of(bats)), 20U);  // the only program counts
}

TEST(StudyGroups, DescribeMaterialsAndKinds) {
  std::vector<StudyBat> bats{
      {.id = "a", .length_in = 33, .material = BarrelMaterial::wood},
      {.id = "b", .bat = "c", .length_in = 33, .material = BarrelMaterial::composite},
      {.id = "c", .bat = "c", .length_in = 33, .material = BarrelMaterial::composite, .broken_in = true},
      {.id = "d", .bat = "c", .length_in = 33, .material = BarrelMaterial::composite, .broken_in = true}};
  const auto at = static_cast<std::size_t>(StudyQuantity::hoop1);
  bats[1].values.at(at) = 2000;
  bats[2].values.at(at) = 1800;
  bats[3].values.at(at) = 1300;
  const auto groups = study_groups_of(bats);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].material, BarrelMaterial::wood);
  EXPECT_TRUE(groups[0].quantities.empty());
  EXPECT_EQ(groups[1].states, 3U);
  EXPECT_EQ(groups[1].bats, 1U);
  EXPECT_EQ(groups[1].quantities[0].mean, 1700);
  EXPECT_EQ(groups[1].quantities[0].low, 1300);
  EXPECT_EQ(groups[1].quantities[0].high, 2000);
  EXPECT_NEAR(groups[1].quantities[0].std, std::sqrt((300.0 * 300 + 100 * 100 + 400 * 400) / 2), 1e-9);
  EXPECT_EQ(groups[2].kind, "new");
  EXPECT_EQ(groups[3].kind, "broken in");
  EXPECT_EQ(groups[3].quantities[0].mean, 1550);
}

// Figures 13 to 66 and B1 to B5 of [8] in docs/theory/sources.md, except 52 to 54: those show a model of the collision.
TEST(Study, MakesTheFiguresOfTheSource) {
  const Study study = study_of(synth::synthetic_population());
  std::vector<std::string> sources;
  for (const StudyFigure& figure : study.figures) {
    if (!figure.source.empty()) sources.push_back(figure.source);
  }
  std::vector<std::string> expected;
  for (int n = 13; n <= 66; ++n) {
    if (n < 52 || n > 54) expected.push_back(std::to_string(n));
  }
  for (int n = 1; n <= 5; ++n) expected.push_back("B" + std::to_string(n));
  EXPECT_THAT(sources, testing::UnorderedElementsAreArray(expected));
  ASSERT_EQ(study.histories.size(), 1U);
  EXPECT_EQ(study.histories[0].states.size(), 9U);
  EXPECT_TRUE(study.histories[0].besr);
}

TEST(Study, CountsEachBatOnce) {
  const auto bats = synth::synthetic_population({.wood = 0, .aluminum = 0, .composite = 20});
  const Study study = study_of(bats);
  const auto& hoop = statement_of(study, StudyFamily::nonwood, StudyQuantity::besr, StudyQuantity::hoop1);
  EXPECT_LE(hoop.association->points, 21U);
  EXPECT_EQ(std::count(study.repeated.begin(), study.repeated.end(), true), 8);
}

TEST(Study, NamesOutliers) {
  auto bats = synth::synthetic_population({.wood = 60, .aluminum = 0, .composite = 0, .break_in = false});
  bats[7].values[static_cast<std::size_t>(StudyQuantity::bbcor)] = 0.60;
  const Study study = study_of(bats);
  const auto figure = std::find_if(study.figures.begin(), study.figures.end(),
                                   [](const StudyFigure& f) { return f.name == "bbcor-moi-wood-all"; });
  ASSERT_NE(figure, study.figures.end());
  std::vector<std::string> named;
  for (const StudyClass& one : figure->classes) {
    for (const std::size_t b : one.outliers) named.push_back(study.bats[b].id);
  }
  EXPECT_THAT(named, testing::Contains(bats[7].id));
}

}  // namespace percuss::metrics::study_test
