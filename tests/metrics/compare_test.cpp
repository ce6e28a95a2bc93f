#include "metrics/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::metrics::compare_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kRounding = 1e-12;  // of a few operations on values of about 1

ComparedDocument document_with(const std::vector<double>& freq_Hz, const std::string& family = "") {
  ComparedDocument document;
  for (const double f : freq_Hz) document.modes.push_back({.freq_Hz = f, .family = family, .shape = {}});
  return document;
}

std::vector<std::pair<std::size_t, std::size_t>> indices(const PairedModes& paired) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (const ModePair& pair : paired.pairs) out.emplace_back(pair.a, pair.b);
  return out;
}

TEST(PairModes, PairsTheNearestInOrder) {
  const PairedModes paired =
      pair_modes(document_with({165, 568, 1177, 1851}), document_with({170, 560, 900, 1200, 1800}));
  EXPECT_THAT(indices(paired),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 3), testing::Pair(3, 4)));
  EXPECT_THAT(paired.unpaired_a, IsEmpty());
  EXPECT_THAT(paired.unpaired_b, ElementsAre(2));
  EXPECT_NEAR(paired.pairs[0].difference_percent, 100 * 5 / 165.0, kRounding);
}

TEST(PairModes, MaximisesTheNumberOfPairs) {
  // 108 is nearest to 110, but then 100 has no partner.
  EXPECT_THAT(indices(pair_modes(document_with({100, 108}), document_with({110, 125}))),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1)));
}

TEST(PairModes, SkipsDistantModesAndOtherTypes) {
  EXPECT_THAT(indices(pair_modes(document_with({100}), document_with({200}))), IsEmpty());
  EXPECT_THAT(indices(pair_modes(document_with({1900}, "hoop"), document_with({1905}, "bending"))), IsEmpty());
  EXPECT_THAT(indices(pair_modes(document_with({1900}, "hoop"), document_with({1905}, "unknown"))),
              ElementsAre(testing::Pair(0, 0)));
}

// The first peak represents a split mode. The second never pairs with a classified single mode, even where it is
// nearer.
TEST(PairModes, PairsTheFirstPeakOfASplitMode) {
  ComparedDocument doublet = document_with({1900, 1912}, "hoop");
  doublet.modes[1].second = true;
  EXPECT_THAT(indices(pair_modes(doublet, document_with({2100}, "hoop"))), ElementsAre(testing::Pair(0, 0)));
  EXPECT_THAT(indices(pair_modes(doublet, document_with({2100}, "hoop"), {.furthest = 0.1})), IsEmpty())
      << "9.8 % from the second, too far from the first";
  EXPECT_THAT(indices(pair_modes(doublet, document_with({1911}, "hoop"))), ElementsAre(testing::Pair(0, 0)));
  EXPECT_THAT(indices(pair_modes(doublet, doublet)), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1)));
}

TEST(PairModes, SkipsRigidBodyModes) {
  const PairedModes paired = pair_modes(document_with({0, 0, 100}), document_with({101}));
  EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(2, 0)));
  EXPECT_THAT(paired.unpaired_a, IsEmpty());
}

/// A real shape at three points.
std::map<std::pair<int, int>, ComparedMode::Component> shape(double x, double y, double z) {
  return {{{0, 0}, {{x, 0}, 0}}, {{1, 0}, {{y, 0}, 0}}, {{2, 0}, {{z, 0}, 0}}};
}

TEST(PairModes, PairsByShapeWherePossible) {
  ComparedDocument a = document_with({100, 104}), b = document_with({101, 103});
  a.modes[0].shape = b.modes[1].shape = shape(1, 1, 1);
  a.modes[1].shape = b.modes[0].shape = shape(1, 0, -1);
  const PairedModes paired = pair_modes(a, b);
  EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(0, 1), testing::Pair(1, 0)));
  EXPECT_NEAR(paired.pairs[0].mac->value, 1, kRounding);
}

// Each pair of modes decides by itself whether it pairs by shape. Here the first modes have no shape.
TEST(PairModes, PairsByShapeAlthoughTheFirstModesHaveNone) {
  ComparedDocument a = document_with({50, 100, 104}), b = document_with({52, 101, 103});
  a.modes[1].shape = b.modes[2].shape = shape(1, 1, 1);
  a.modes[2].shape = b.modes[1].shape = shape(1, 0, -1);
  const PairedModes paired = pair_modes(a, b);
  EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 2), testing::Pair(2, 1)));
  EXPECT_FALSE(paired.pairs[0].mac.has_value());
  EXPECT_THAT(paired.unpaired_a, IsEmpty());
  // Modes whose shapes differ do not pair by frequency.
  a.modes[1].shape = b.modes[1].shape = shape(1, 1, 1);
  a.modes[2].shape = b.modes[2].shape = {};
  b.modes[1].shape = shape(1, 0, -1);
  EXPECT_THAT(indices(pair_modes(a, b)), ElementsAre(testing::Pair(0, 0), testing::Pair(2, 2)));
  a.modes[2].shape = b.modes[2].shape = shape(0, 1, 0);
  EXPECT_THAT(indices(pair_modes(a, b)), ElementsAre(testing::Pair(0, 0), testing::Pair(2, 2)));
}

TEST(PairModes, NamesModesThatMayHaveCrossed) {
  const auto exchangeable = [](const PairedModes& paired) {
    std::vector<std::vector<std::size_t>> out;
    for (const ModePair& pair : paired.pairs) out.push_back(pair.exchangeable_a);
    return out;
  };
  // In truth, 412 Hz moved to 431 Hz and 418.5 Hz to 421.3 Hz.
  ComparedDocument a = document_with({296.4, 412, 418.5, 574}), b = document_with({310.2, 421.3, 431, 560});
  const PairedModes paired = pair_modes(a, b);
  EXPECT_THAT(indices(paired),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 2), testing::Pair(3, 3)));
  EXPECT_THAT(exchangeable(paired), ElementsAre(IsEmpty(), ElementsAre(2), ElementsAre(1), IsEmpty()));
  // Small shifts of the same modes leave no doubt.
  EXPECT_THAT(exchangeable(pair_modes(a, document_with({297, 413, 419, 575}))), testing::Each(IsEmpty()));
  // Modes of different types do not cross.
  a.modes[1].family = b.modes[1].family = "hoop";
  a.modes[2].family = b.modes[2].family = "bending";
  EXPECT_THAT(exchangeable(pair_modes(a, b)), testing::Each(IsEmpty()));
  // Nor do modes that are paired by shape.
  a.modes[1].shape = b.modes[2].shape = shape(1, 1, 1);
  a.modes[2].shape = b.modes[1].shape = shape(1, 0, -1);
  for (const std::size_t m : {1U, 2U}) a.modes[m].family = b.modes[m].family = "";
  EXPECT_THAT(exchangeable(pair_modes(a, b)), testing::Each(IsEmpty()));
}

ComparedDocument deflected(bool model, const std::vector<std::pair<double, double>>& at) {
  ComparedDocument document{.model = model, .modes = {}, .deflections = {}};
  for (const auto& [position_m, peak_m] : at)
    document.deflections.push_back({.position_m = position_m, .peak_m = peak_m, .std_m = model ? 0 : 0.01 * peak_m});
  return document;
}

TEST(PairDeflections, InterpolatesAModelBetweenItsPositions) {
  const auto test = deflected(false, {{0.1, 0.002}, {0.25, 0.005}, {0.5, 0.01}});
  const auto model = deflected(true, {{0.1, 0.0022}, {0.3, 0.0066}});
  for (const auto& pairs : {pair_deflections(test, model), pair_deflections(model, test)}) {
    ASSERT_EQ(pairs.size(), 2U);  // none beyond the model's positions
    EXPECT_NEAR(pairs[0].ratio, 1.1, kRounding);
    EXPECT_NEAR(pairs[1].ratio, 1.1, kRounding);
    EXPECT_NEAR(pairs[0].ratio_std, 0.011, kRounding);
  }
  EXPECT_EQ(pair_deflections(model, test)[0].a_m, 0.0022);
}

TEST(PairDeflections, DoesNotInterpolateATest) {
  EXPECT_THAT(pair_deflections(deflected(false, {{0.2, 0.001}}), deflected(false, {{0.1, 0.001}, {0.3, 0.001}})),
              IsEmpty());
}

}  // namespace percuss::metrics::compare_test
