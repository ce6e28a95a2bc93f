#include "metrics/protocol/sweet_spot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "synth/random_stream.hpp"

namespace percuss::metrics::sweet_spot_test {

using testing::ElementsAre;
using Barrel = std::function<double(HalfInches)>;

struct Search {
  SearchStep end;
  std::vector<HalfInches> order;
};

// Runs the search on a barrel, and checks that it asks only for permitted locations, each once.
Search search_on(const Barrel& barrel, const SearchRules& rules = {}) {
  Search out;
  std::map<HalfInches, double> tested;
  for (out.end = next_location(tested, rules); out.end.state == SearchState::shoot;
       out.end = next_location(tested, rules)) {
    EXPECT_FALSE(tested.contains(out.end.at)) << "asked twice";
    EXPECT_GE(out.end.at, rules.low);
    EXPECT_LE(out.end.at, rules.high);
    if (tested.size() > 100) break;
    tested[out.end.at] = barrel(out.end.at);
    out.order.push_back(out.end.at);
  }
  return out;
}

Barrel peak_at(double centre, double fall = 0.005) {
  return [=](HalfInches at) { return 0.72 - fall * std::abs(at - centre); };
}

TEST(SweetSpot, StartsAtSixFiveAndSevenInches) {
  EXPECT_THAT(search_on(peak_at(12)).order, ElementsAre(12, 10, 14, 13, 11));
}

TEST(SweetSpot, LooksFirstOnTheBetterSideOfSixInches) {
  EXPECT_THAT(search_on(peak_at(11.9)).order, ElementsAre(12, 10, 14, 11, 13));
  EXPECT_THAT(search_on(peak_at(12.1)).order, ElementsAre(12, 10, 14, 13, 11));
}

TEST(SweetSpot, TestsTheNeighbourTowardsSixInchesFirst) {
  EXPECT_THAT(search_on(peak_at(10)).order, ElementsAre(12, 10, 14, 11, 9));
  EXPECT_THAT(search_on(peak_at(8)).order, ElementsAre(12, 10, 14, 11, 9, 8, 7));
  EXPECT_THAT(search_on(peak_at(14)).order, ElementsAre(12, 10, 14, 13, 15));
  EXPECT_THAT(search_on(peak_at(17)).order, ElementsAre(12, 10, 14, 13, 15, 16, 17, 18));
  for (const int at : {8, 10, 12, 14, 17}) {
    const auto end = search_on(peak_at(at)).end;
    EXPECT_EQ(end.state, SearchState::found);
    EXPECT_EQ(end.at, at);
    EXPECT_THAT(end.plateau, ElementsAre(at));
  }
}

TEST(SweetSpot, NeedsTheMarginOnBothSides) {
  std::map<HalfInches, double> tested{{12, 0.731}, {10, 0.71}, {14, 0.71}, {11, 0.728}, {13, 0.728}};
  EXPECT_EQ(next_location(tested).state, SearchState::found);  // 0.731 − 0.728 counts as 0.003 despite rounding
  tested[11] = 0.7281;
  const auto end = next_location(tested);
  EXPECT_EQ(end.state, SearchState::plateau);
  EXPECT_EQ(end.at, 12);
  EXPECT_THAT(end.plateau, ElementsAre(11, 12));
}

TEST(SweetSpot, TestsBothSidesOfAPlateau) {
  const auto flat = search_on([](HalfInches at) { return at >= 9 && at <= 12 ? 0.72 : 0.70; });
  EXPECT_EQ(flat.end.state, SearchState::plateau);
  EXPECT_EQ(flat.end.at, 12);  // among equals, the location nearest 6 in
  EXPECT_THAT(flat.end.plateau, ElementsAre(9, 10, 11, 12));
  EXPECT_THAT(flat.order, testing::Contains(8));
}

TEST(SweetSpot, StatesThatTheBestLiesAtAnEdge) {
  EXPECT_EQ(search_on(peak_at(0)).end.state, SearchState::edge);
  EXPECT_EQ(search_on(peak_at(0)).end.at, 6);
  EXPECT_EQ(search_on(peak_at(30)).end.state, SearchState::edge);
  EXPECT_EQ(search_on([](HalfInches) { return 0.7; }).end.state, SearchState::edge);
}

// On random barrels the search ends and asks only for permitted locations, each once (search_on checks this). A sweet
// spot exceeds both neighbours by the margin, and no tested location is better.
TEST(SweetSpot, EndsOnEveryBarrelWithoutFalseSweetSpots) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    synth::RandomStream random{11, seed};
    std::vector<double> values(40);
    for (double& value : values) value = 0.7 + 0.02 * random.uniform();
    if (seed % 3 == 0)
      for (double& value : values) value = std::round(500 * value) / 500;  // ties
    const SearchRules rules{.low = 2 + static_cast<int>(8 * random.uniform()),
                            .high = 14 + static_cast<int>(12 * random.uniform())};
    const auto at = [&](HalfInches h) { return values.at(static_cast<std::size_t>(h)); };
    const auto search = search_on(at, rules);
    EXPECT_LE(search.order.size(), static_cast<std::size_t>(rules.high - rules.low + 1));
    for (const HalfInches h : search.order) EXPECT_LE(at(h), at(search.end.at));
    if (search.end.state != SearchState::found) continue;
    ++found;
    constexpr double kSlack = 1e-9;
    EXPECT_GE(at(search.end.at) - at(search.end.at - 1), rules.margin - kSlack);
    EXPECT_GE(at(search.end.at) - at(search.end.at + 1), rules.margin - kSlack);
  }
  EXPECT_GT(found, 300);
}

}  // namespace percuss::metrics::sweet_spot_test
