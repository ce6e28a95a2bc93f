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

// The first peak represents a split mode. The second never pairs with a classified single mode, even if it is
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

// A stiffener raises the first mode by 34 %, beyond the limit. The third mode of b has its shape, too, but less
// exactly.
TEST(DistantPairs, AreUnpairedModesOfEqualShapes) {
  ComparedDocument a = document_with({128.4, 412.7}), b = document_with({171.9, 437.5, 180});
  a.modes[0].shape = b.modes[0].shape = shape(1, 1, 1);
  a.modes[1].shape = b.modes[1].shape = shape(1, 0, -1);
  b.modes[2].shape = shape(1, 1.1, 1);
  const PairedModes paired = pair_modes(a, b);
  ASSERT_THAT(indices(paired), ElementsAre(testing::Pair(1, 1)));
  const std::vector<DistantPair> distant = distant_pairs(a, b, paired);
  ASSERT_EQ(distant.size(), 1U);
  EXPECT_EQ(distant[0].a, 0U);
  EXPECT_EQ(distant[0].b, 0U);
  EXPECT_NEAR(distant[0].mac.value, 1, kRounding);
  EXPECT_NEAR(distant[0].difference, 171.9 / 128.4 - 1, kRounding);
  EXPECT_DOUBLE_EQ(distant[0].furthest, 0.4);
  const PairOptions wider{.furthest = distant[0].furthest};
  const PairedModes then = pair_modes(a, b, wider);
  EXPECT_THAT(indices(then), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1)));
  EXPECT_THAT(distant_pairs(a, b, then, wider), IsEmpty());
}

TEST(DistantPairs, NeedShapesThatAgreeAndFrequenciesWithinAFactorOfTwo) {
  const auto count = [](double a_Hz, double b_Hz, double last_of_b) {
    ComparedDocument a = document_with({a_Hz}), b = document_with({b_Hz});
    a.modes[0].shape = shape(1, 1, 1);
    b.modes[0].shape = shape(1, 1, last_of_b);
    return distant_pairs(a, b, pair_modes(a, b)).size();
  };
  EXPECT_EQ(count(100, 140, 1), 1U);
  EXPECT_EQ(count(140, 100, 1), 1U);
  EXPECT_EQ(count(100, 140, 0), 0U) << "a MAC of 0.67";
  EXPECT_EQ(count(100, 201, 1), 0U);
  EXPECT_EQ(count(201, 100, 1), 0U);
  const ComparedDocument a = document_with({100}), b = document_with({140});
  EXPECT_THAT(distant_pairs(a, b, pair_modes(a, b)), IsEmpty()) << "without shapes";
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

struct Order {
  const char* family;
  int order;
  double freq_Hz;
  double confidence = 0.99;
  bool second = false;
};

ComparedDocument document_of_orders(const std::vector<Order>& orders) {
  ComparedDocument document;
  for (const Order& one : orders) {
    document.modes.push_back({.freq_Hz = one.freq_Hz,
                              .family = one.family,
                              .second = one.second,
                              .order = one.order,
                              .confidence = one.confidence,
                              .shape = {}});
  }
  return document;
}

std::vector<PairedBy> rules(const PairedModes& paired) {
  std::vector<PairedBy> out;
  for (const ModePair& pair : paired.pairs) out.push_back(pair.by);
  return out;
}

// An aluminium and a wooden bat: by frequency alone, bending 4 of the first bat (lower peak) pairs with bending 5 of
// the second, and bending 3 (lower peak) with the upper peak of bending 3.
TEST(PairModes, PairsByFamilyAndOrder) {
  const ComparedDocument aluminium = document_of_orders({{"bending", 1, 175.2},
                                                         {"bending", 1, 175.9, 0.99, true},
                                                         {"bending", 2, 660.7},
                                                         {"bending", 2, 663.9, 0.99, true},
                                                         {"bending", 3, 1321.9},
                                                         {"bending", 3, 1329.3, 0.99, true},
                                                         {"hoop", 1, 1985},
                                                         {"bending", 4, 2217.5},
                                                         {"bending", 4, 2231.7, 0.99, true}});
  const ComparedDocument wood = document_of_orders({{"bending", 1, 168.2},
                                                    {"bending", 1, 172.4, 0.99, true},
                                                    {"bending", 2, 523.8},
                                                    {"bending", 2, 539.5, 0.99, true},
                                                    {"bending", 3, 1009.8},
                                                    {"bending", 3, 1045.2},
                                                    {"bending", 4, 1675.2},
                                                    {"bending", 4, 1742.2},
                                                    {"bending", 5, 2511.7},
                                                    {"bending", 6, 2624.8, 0.86}});
  const PairedModes paired = pair_modes(aluminium, wood);
  EXPECT_THAT(indices(paired),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 2), testing::Pair(3, 3),
                          testing::Pair(4, 4), testing::Pair(5, 5), testing::Pair(7, 6), testing::Pair(8, 7)));
  EXPECT_THAT(rules(paired), testing::Each(PairedBy::order));
  EXPECT_THAT(paired.unpaired_a, ElementsAre(6));
  EXPECT_THAT(paired.unpaired_b, ElementsAre(8, 9));
  EXPECT_THAT(paired.doubted_orders, IsEmpty());
  // The differences relative to the other bat are up to 32 %.
  EXPECT_EQ(pair_modes(wood, aluminium).pairs.size(), 8U);
  // A stated limit holds for them, too. Modes of other orders do not pair in their place.
  const PairedModes limited = pair_modes(wood, aluminium, {.furthest = 0.25, .furthest_of_orders = 0.25});
  EXPECT_THAT(indices(limited), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(3, 3)));
}

TEST(PairModes, UsesOrdersOnlyWhereBothDocumentsAreSureOfThem) {
  const ComparedDocument a = document_of_orders({{"bending", 1, 170}, {"bending", 2, 560}, {"bending", 3, 900}});
  const ComparedDocument sure = document_of_orders({{"bending", 1, 171}, {"bending", 2, 480}, {"bending", 3, 620}});
  EXPECT_THAT(indices(pair_modes(a, sure)), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 2)));
  ComparedDocument unsure = sure;
  unsure.modes[1].confidence = unsure.modes[2].confidence = 0.8;
  const PairedModes paired = pair_modes(a, unsure);
  EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1)));
  EXPECT_THAT(rules(paired), ElementsAre(PairedBy::order, PairedBy::frequency));
}

// The second document lacks bending 3, so that its bending 3 is the other's bending 4.
TEST(PairModes, DoubtsOrdersThatTheFrequenciesContradict) {
  const ComparedDocument all = document_of_orders(
      {{"bending", 1, 175}, {"bending", 2, 660}, {"bending", 3, 1322}, {"bending", 4, 2217}, {"bending", 5, 3200}});
  const ComparedDocument lacking =
      document_of_orders({{"bending", 1, 176}, {"bending", 2, 655}, {"bending", 3, 2200}, {"bending", 4, 3210}});
  const PairedModes paired = pair_modes(all, lacking);
  EXPECT_THAT(indices(paired),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(3, 2), testing::Pair(4, 3)));
  EXPECT_THAT(rules(paired), ElementsAre(PairedBy::order, PairedBy::order, PairedBy::frequency, PairedBy::frequency));
  ASSERT_EQ(paired.doubted_orders.size(), 1U);
  EXPECT_EQ(paired.doubted_orders[0].family, "bending");
  EXPECT_EQ(paired.doubted_orders[0].from, 3);
  EXPECT_THAT(indices(pair_modes(lacking, all)),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 3), testing::Pair(3, 4)));
  // The first mode is missing: all orders are one too low.
  const ComparedDocument without_first = document_of_orders({{"bending", 1, 640}, {"bending", 2, 1300}});
  EXPECT_THAT(indices(pair_modes(all, without_first)), ElementsAre(testing::Pair(1, 0), testing::Pair(2, 1)));
}

// The single peak of a tube splits. The lower peak shows how far the mode fell, however far apart the two are.
TEST(PairModes, PairsPeaksOfOneOrderFromBelow) {
  const ComparedDocument one = document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1740}});
  for (const double upper_Hz : {1695.0, 1721.6, 1739.0}) {
    for (const bool second : {false, true}) {
      const ComparedDocument both =
          document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1687.8}, {"hoop", 1, upper_Hz, 0.99, second}});
      const PairedModes paired = pair_modes(one, both);
      EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1))) << upper_Hz;
      EXPECT_THAT(paired.unpaired_b, ElementsAre(2)) << upper_Hz;
      EXPECT_THAT(indices(pair_modes(both, one)), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1))) << upper_Hz;
    }
  }
  const ComparedDocument three =
      document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1600}, {"hoop", 1, 1687}, {"hoop", 1, 1721}});
  const ComparedDocument two = document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1687}, {"hoop", 1, 1721}});
  EXPECT_THAT(indices(pair_modes(three, two)),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 2)));
  ComparedDocument split = two;
  split.modes[2].second = true;
  EXPECT_THAT(indices(pair_modes(three, split)),
              ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1), testing::Pair(2, 2)));
}

TEST(PairModes, PairsTheFirstPeakOfASplitModeThatLiesAboveTheSecond) {
  const ComparedDocument one = document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1740}});
  const ComparedDocument split =
      document_of_orders({{"bending", 1, 170}, {"hoop", 1, 1720, 0.99, true}, {"hoop", 1, 1738}});
  EXPECT_THAT(indices(pair_modes(one, split)), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 2)));
}

TEST(PairModes, PrefersShapesToOrders) {
  ComparedDocument a = document_of_orders({{"bending", 1, 170}, {"bending", 2, 500}, {"bending", 2, 520}}), b = a;
  a.modes[1].shape = b.modes[2].shape = shape(1, 1, 1);
  a.modes[2].shape = b.modes[1].shape = shape(1, 0, -1);
  const PairedModes paired = pair_modes(a, b);
  EXPECT_THAT(indices(paired), ElementsAre(testing::Pair(0, 0), testing::Pair(1, 2), testing::Pair(2, 1)));
  EXPECT_THAT(rules(paired), ElementsAre(PairedBy::order, PairedBy::shape, PairedBy::shape));
}

// The two planes of an order may cross; modes of other orders do not.
TEST(PairModes, NamesPeaksOfOneOrderThatMayHaveCrossed) {
  const ComparedDocument a = document_of_orders({{"bending", 2, 500}, {"bending", 2, 504}, {"bending", 3, 600}});
  const ComparedDocument b = document_of_orders({{"bending", 2, 560}, {"bending", 2, 566}, {"bending", 3, 660}});
  const PairedModes paired = pair_modes(a, b);
  ASSERT_EQ(paired.pairs.size(), 3U);
  EXPECT_THAT(paired.pairs[0].exchangeable_a, ElementsAre(1));
  EXPECT_THAT(paired.pairs[1].exchangeable_a, ElementsAre(0));
  EXPECT_THAT(paired.pairs[2].exchangeable_a, IsEmpty());
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
