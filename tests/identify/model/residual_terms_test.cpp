#include "identify/model/residual_terms.hpp"

#include <gtest/gtest.h>

#include "core/math/linear_algebra.hpp"

namespace percuss::identify::residual_terms_test {

const acquire::LineRange kLines{.fs_Hz = 8192, .samples = 8192, .first = 60, .count = 3200};

// The part of an undamped out-of-band mode's accelerance that the terms cannot follow.
double missed(double freq_Hz) {
  const Eigen::MatrixXd terms = out_of_band_terms(kLines);
  Eigen::VectorXd tail(terms.rows());
  for (Eigen::Index k = 0; k < tail.size(); ++k) {
    const double f = kLines.freq_Hz(static_cast<std::size_t>(k));
    tail(k) = f * f / (f * f - freq_Hz * freq_Hz);
  }
  return (tail - terms * least_squares(terms, tail)).norm() / tail.norm();
}

TEST(OutOfBandTerms, FollowTheTailsOfModesBeyondTheLines) {
  constexpr double kMaxMissed = 0.002;  // of the tail; below the noise of a good measurement
  for (const double freq_Hz : {3600.0, 4200.0, 6000.0, 1e4, 1e5}) EXPECT_LE(missed(freq_Hz), kMaxMissed) << freq_Hz;
  for (const double freq_Hz : {0.5, 5.0, 30.0}) EXPECT_LE(missed(freq_Hz), kMaxMissed) << freq_Hz;
}

TEST(OutOfBandTerms, BeginWithTheMassLine) {
  const Eigen::MatrixXd terms = out_of_band_terms(kLines);
  EXPECT_EQ(terms.col(0).minCoeff(), 1);
  EXPECT_EQ(terms.col(0).maxCoeff(), 1);
}

TEST(OutOfBandTerms, AreFiniteFromZeroHertz) {
  EXPECT_TRUE(out_of_band_terms({.fs_Hz = 1000, .samples = 1000, .first = 0, .count = 400}).allFinite());
}

}  // namespace percuss::identify::residual_terms_test
