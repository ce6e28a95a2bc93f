#include "identify/classify/type_posterior.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/units.hpp"

namespace percuss::identify::type_posterior_test {

using std::numbers::pi;

TypeEvidence mode_at(double freq_Hz, double chi_deg, double size = 1) {
  return {.freq_Hz = freq_Hz, .size = size, .ratio = RatioAngle{.chi_rad = chi_deg * kDegree_rad, .std_rad = 0.001}};
}

std::vector<TypeEvidence> paired(TypeEvidence one, TypeEvidence two) {
  one.partner = 1;
  two.partner = 0;
  return {one, two};
}

std::vector<TypePosterior> posteriors(const std::vector<TypeEvidence>& modes) {
  return type_posteriors(modes, RatioLikelihood(0, pi / 2, {}));
}

TEST(TypePosterior, IsAProbability) {
  for (const auto& modes : {std::vector<TypeEvidence>{mode_at(169, 25), mode_at(1900, -45), {.freq_Hz = 2500}},
                            paired(mode_at(169, 25), mode_at(171, 115))}) {
    for (const TypePosterior& posterior : posteriors(modes)) {
      EXPECT_NEAR(posterior[0] + posterior[1] + posterior[2], 1, 1e-12);
      EXPECT_GE(*std::min_element(posterior.begin(), posterior.end()), 0);
    }
  }
  EXPECT_TRUE(posteriors({}).empty());
}

TEST(TypePosterior, IsThePriorForAnUnobservedMode) {
  const auto found = posteriors({mode_at(169, 25), {.freq_Hz = 2500}});
  for (const double p : found[1]) EXPECT_NEAR(p, 1.0 / 3, 1e-12);
}

TEST(TypePosterior, StaysUncertainWhereTheLowestModeHasTheHoopRatio) {
  // A bat that bends at −45° shows the hoop ratio in every mode; with bending at 25°, only hoop modes have it.
  const auto all = posteriors({mode_at(169, -45), mode_at(575, -45), mode_at(1150, -45), mode_at(1900, -45)});
  const auto one = posteriors({mode_at(169, 25), mode_at(575, 25), mode_at(1150, 25), mode_at(1900, -45)});
  EXPECT_GT(all[0][0], 0.5);
  for (const TypePosterior& posterior : all) EXPECT_GT(posterior[0], 0.05);
  EXPECT_GT(one[3][1], 0.95);
  EXPECT_LT(one[3][0], 0.5 * all[3][0]);
}

TEST(TypePosterior, AssumesThatTheLowestModeBendsOnlyBelowTheHoopFrequencies) {
  EXPECT_GT(posteriors({mode_at(169, -45)})[0][0], 0.5);
  EXPECT_GT(posteriors({mode_at(1900, -45)})[0][1], 0.9);
}

TEST(TypePosterior, FindsTheTwoPlanesOfAModeByTheirRightAngle) {
  const auto across = posteriors(paired(mode_at(1900, -45), mode_at(1912, 45)));
  EXPECT_GT(across[0][0], 0.8);
  EXPECT_GT(across[1][0], 0.8);
}

TEST(TypePosterior, UsesTheAmplitudeOfAHoopModeNearItsNodes) {
  // A mode of a pair may have any ratio if misplaced sensors lie near its nodes. Its amplitude is then about a tenth of
  // the amplitude of the other mode.
  const auto as_large = posteriors(paired(mode_at(1895, 0, 1), mode_at(1912, -45, 1)));
  const auto smaller = posteriors(paired(mode_at(1895, 0, 0.07), mode_at(1912, -45, 1)));
  EXPECT_GT(as_large[0][0], as_large[0][1]);
  EXPECT_GT(smaller[0][1], smaller[0][0]);
}

TEST(TypePosterior, IsFiniteForManyModes) {
  std::vector<TypeEvidence> modes(600);
  for (std::size_t i = 0; i < modes.size(); ++i) modes[i] = mode_at(169 + 20 * static_cast<double>(i), 25);
  const auto found = posteriors(modes);
  EXPECT_TRUE(
      std::all_of(found.begin(), found.end(), [](const TypePosterior& posterior) { return posterior[0] > 0.95; }));
}

}  // namespace percuss::identify::type_posterior_test
