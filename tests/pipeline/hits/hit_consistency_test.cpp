#include "pipeline/hits/hit_consistency.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace percuss::pipeline::hit_consistency_test {

constexpr std::size_t kLines = 200;

/// Hits of one point whose spectra follow one FRF with noise; tests change some of them.
class HitAgreement : public testing::Test {
 protected:
  void make(std::size_t count, double noise) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0, noise);
    for (std::size_t h = 0; h < count; ++h) {
      force_.emplace_back(kLines, Complex(1 + 0.1 * static_cast<double>(h), 0));
      accel_.emplace_back(kLines);
      for (std::size_t k = 0; k < kLines; ++k)
        accel_[h][k] = force_[h][k] * frf(k) + Complex(normal(random), normal(random));
      hits_.push_back({.hit = {.peak_N = 100}, .point = 0, .accepted = true});
    }
  }
  static Complex frf(std::size_t k) { return std::polar(2.0, 0.1 * static_cast<double>(k)); }
  void grade() {
    std::vector<ComparedHit> spectra;
    for (std::size_t h = 0; h < hits_.size(); ++h) spectra.push_back({.force = force_[h], .accel = {accel_[h]}});
    grade_agreement(hits_, spectra);
  }
  const acquire::Finding* found(std::size_t hit, acquire::FindingCode code) const {
    const auto& findings = hits_[hit].hit.findings;
    const auto at =
        std::find_if(findings.begin(), findings.end(), [&](const acquire::Finding& f) { return f.code == code; });
    return at == findings.end() ? nullptr : &*at;
  }
  std::vector<AnalysedHit> hits_;
  std::vector<std::vector<Complex>> force_, accel_;
};

TEST_F(HitAgreement, FindsNothingAmongHitsThatAgree) {
  for (const std::size_t count : {1U, 2U, 3U, 6U}) {
    hits_.clear(), force_.clear(), accel_.clear();
    make(count, 0.01);
    grade();
    for (const AnalysedHit& hit : hits_) {
      EXPECT_TRUE(hit.accepted);
      EXPECT_TRUE(hit.hit.findings.empty());
    }
  }
}

TEST_F(HitAgreement, RejectsOneOutlier) {
  for (const std::size_t count : {4U, 5U, 12U}) {
    hits_.clear(), force_.clear(), accel_.clear();
    make(count, 0.01);
    for (Complex& line : accel_[2]) line *= -1;
    grade();
    ASSERT_NE(found(2, acquire::FindingCode::outlier), nullptr) << count;
    EXPECT_EQ(found(2, acquire::FindingCode::outlier)->severity, acquire::Severity::reject);
    EXPECT_GE(found(2, acquire::FindingCode::outlier)->value, 0.9);
    for (std::size_t h = 0; h < count; ++h) {
      EXPECT_EQ(hits_[h].accepted, h != 2) << h;
      EXPECT_EQ(hits_[h].hit.findings.size(), h == 2 ? 1U : 0U) << h;
    }
  }
}

// Each hit is compared with the FRFs of the other hits. A strong hit at another place dominates these FRFs, so the good
// hits agree with them badly, too.
TEST_F(HitAgreement, RejectsTheOddHitThoughItIsNotTheWorst) {
  for (const std::size_t odd : {0U, 1U, 3U}) {
    hits_.clear(), force_.clear(), accel_.clear();
    make(4, 0.001);
    for (std::size_t k = 0; k < kLines; ++k) {
      force_[odd][k] *= 3;
      accel_[odd][k] = force_[odd][k] * Complex(1.5, 1) * frf(k);
    }
    grade();
    for (std::size_t h = 0; h < hits_.size(); ++h) EXPECT_EQ(hits_[h].accepted, h != odd) << odd << ", hit " << h;
  }
}

TEST_F(HitAgreement, RejectsSeveralOutliers) {
  make(7, 0.01);
  for (const std::size_t h : {1U, 4U}) {
    for (Complex& line : accel_[h]) line *= Complex(0, 1);
  }
  grade();
  for (std::size_t h = 0; h < hits_.size(); ++h) EXPECT_EQ(hits_[h].accepted, h != 1 && h != 4) << h;
}

TEST_F(HitAgreement, AcceptsHitsThatDifferAsMuchAsTheOthers) {
  make(6, 0.8);
  grade();
  for (const AnalysedHit& hit : hits_) EXPECT_TRUE(hit.accepted);
}

TEST_F(HitAgreement, AcceptsAnOutlierThatTheUserAccepts) {
  make(5, 0.01);
  for (Complex& line : accel_[2]) line *= -1;
  hits_[2].by_user = true;
  grade();
  EXPECT_NE(found(2, acquire::FindingCode::outlier), nullptr);
  EXPECT_TRUE(hits_[2].accepted);
}

TEST_F(HitAgreement, OnlyWarnsOfAnOutlierAmongThreeHits) {
  make(3, 0.01);
  for (Complex& line : accel_[2]) line *= -1;
  grade();
  for (std::size_t h = 0; h < 3; ++h) {
    EXPECT_EQ(found(h, acquire::FindingCode::outlier), nullptr);
    EXPECT_TRUE(hits_[h].accepted);
  }
  ASSERT_NE(found(2, acquire::FindingCode::low_coherence), nullptr);
  EXPECT_LE(found(2, acquire::FindingCode::low_coherence)->value, 0.9);
}

// Files may be several tests if all hits are at one point, or if one of the files holds several points. Otherwise they
// are one survey, whose wrong hit is to be rejected.
TEST_F(HitAgreement, SuggestsToRejectAHitOrToSeparateFiles) {
  const auto option_for = [&](const std::vector<acquire::RowInfo>& rows) {
    hits_.clear(), force_.clear(), accel_.clear();
    make(3, 0.01);
    for (std::size_t h = 0; h < 3; ++h) hits_[h].hit.row = h;
    for (Complex& line : accel_[2]) line *= -1;
    std::vector<ComparedHit> spectra;
    for (std::size_t h = 0; h < hits_.size(); ++h) spectra.push_back({.force = force_[h], .accel = {accel_[h]}});
    grade_agreement(hits_, spectra, rows);
    return found(2, acquire::FindingCode::low_coherence)->options.at(0);
  };
  EXPECT_EQ(option_for({{.file = 0}, {.file = 0}, {.file = 0}}), "reject_hit");
  EXPECT_EQ(option_for({{.file = 0}, {.file = 1}, {.file = 2}}), "files");
  EXPECT_EQ(option_for({{.file = 0}, {.file = 1}, {.file = 2}, {.file = 3, .point = 1}}), "reject_hit");
  EXPECT_EQ(option_for({{.file = 0}, {.file = 1}, {.file = 2}, {.file = 0, .point = 1}}), "files");
}

// Each hit is compared with the FRF of the other two. A strong wrong hit dominates this FRF: the two good hits fit it
// badly, although they agree with each other.
TEST_F(HitAgreement, NamesTheOddOneOfThreeHits) {
  for (std::size_t odd = 0; odd < 3; ++odd) {
    hits_.clear(), force_.clear(), accel_.clear();
    make(3, 0.01);
    for (std::size_t k = 0; k < kLines; ++k) {
      force_[odd][k] *= 3;
      accel_[odd][k] *= -3;
    }
    grade();
    for (std::size_t h = 0; h < 3; ++h) {
      const acquire::Finding* finding = found(h, acquire::FindingCode::low_coherence);
      ASSERT_EQ(finding != nullptr, h == odd) << h;
      if (finding) {
        EXPECT_THAT(finding->message, testing::StartsWith("the other two hits agree with each other"));
      }
    }
  }
}

TEST_F(HitAgreement, ComparesHitsOfOnePointOnly) {
  make(4, 0.01);
  for (const std::size_t h : {2U, 3U}) {
    hits_[h].point = 1;
    for (Complex& line : accel_[h]) line *= -1;
  }
  grade();
  for (const AnalysedHit& hit : hits_) EXPECT_TRUE(hit.hit.findings.empty());
}

TEST_F(HitAgreement, AcceptsResponsesOfZero) {
  make(5, 0.01);
  std::fill(accel_[1].begin(), accel_[1].end(), Complex());
  grade();
  for (auto& spectrum : accel_) std::fill(spectrum.begin(), spectrum.end(), Complex());
  grade();
  ASSERT_EQ(hits_.size(), 5U);
  for (const AnalysedHit& hit : hits_) {
    EXPECT_TRUE(hit.accepted);
    EXPECT_TRUE(hit.hit.findings.empty());  // an error that is not a number would be a finding
  }
}

std::vector<AnalysedHit> hits_with_polarities(const std::vector<int>& polarities) {
  std::vector<AnalysedHit> hits;
  for (const int polarity : polarities) {
    AnalysedHit hit{.hit = {.peak_N = 100}, .accepted = true};
    hit.responses.push_back({.delay_s = 1e-3, .polarity = polarity});
    if (polarity == 0) hit.responses[0].delay_s.reset();
    hits.push_back(hit);
  }
  return hits;
}

std::vector<int> polarities_after_vote(std::vector<AnalysedHit> hits) {
  vote_first_motion(hits);
  std::vector<int> out;
  for (const AnalysedHit& hit : hits) {
    out.push_back(hit.responses[0].polarity);
    EXPECT_EQ(hit.responses[0].delay_s.has_value(), hit.responses[0].polarity != 0);
  }
  return out;
}

using Polarities = std::vector<int>;

TEST(VoteFirstMotion, KeepsADirectionThatAllHitsShow) {
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({1, 1, 0, 1})), (Polarities{1, 1, 0, 1}));
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({-1})), (Polarities{-1}));
}

TEST(VoteFirstMotion, IsUndecidedWhereMostHitsShowNoDirection) {
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({0, 1, 0, 0, 1})), (Polarities{0, 0, 0, 0, 0}));
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({0, 1, 0, 1})), (Polarities{0, 1, 0, 1}));
}

TEST(VoteFirstMotion, OverrulesOneAmongMany) {
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({1, 1, -1, 1, 1})), (Polarities{1, 1, 0, 1, 1}));
}

TEST(VoteFirstMotion, IsUndecidedWhenHitsDisagree) {
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({1, -1})), (Polarities{0, 0}));
  EXPECT_EQ(polarities_after_vote(hits_with_polarities({1, -1, -1, -1})), (Polarities{0, 0, 0, 0}));
}

TEST(VoteFirstMotion, IsRelativeToTheSignOfTheForce) {
  auto hits = hits_with_polarities({1, -1, 1});
  hits[1].hit.peak_N = -100;
  EXPECT_EQ(polarities_after_vote(hits), (Polarities{1, -1, 1}));
}

TEST(VoteFirstMotion, CountsTheAcceptedHitsOfOnePoint) {
  auto hits = hits_with_polarities({1, 1, -1, -1});
  hits[2].accepted = false;
  hits[3].point = 1;
  EXPECT_EQ(polarities_after_vote(hits), (Polarities{1, 1, -1, -1}));
}

}  // namespace percuss::pipeline::hit_consistency_test
