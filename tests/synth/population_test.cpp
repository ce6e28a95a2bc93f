#include "synth/population.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::synth::population_test {

using metrics::BarrelMaterial;
using metrics::StudyBat;
using metrics::StudyQuantity;

TEST(Population, FollowsTheDescriptionOfTheSource) {
  double sum = 0, wood = 0;
  for (const StudyBat& bat : synthetic_population({.wood = 400})) {
    const auto hoop = bat.value(StudyQuantity::hoop1);
    if (bat.material == BarrelMaterial::wood) {
      EXPECT_FALSE(hoop);
      sum += *bat.value(StudyQuantity::bbcor);
      ++wood;
    } else if (bat.material == BarrelMaterial::aluminum) {
      EXPECT_GE(*hoop, 1800);
      EXPECT_LE(*hoop, 2400);
    } else {
      EXPECT_GE(*hoop, 1300);
      EXPECT_LE(*hoop, 2800);
    }
  }
  EXPECT_NEAR(sum / wood, 0.480, 4 * 0.004 / std::sqrt(wood));
}

}  // namespace percuss::synth::population_test
