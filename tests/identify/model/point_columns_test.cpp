#include "identify/model/point_columns.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::point_columns_test {

using test::largest;
using test::vector_of;

TEST(TruncatedDecay, IsTheDifferenceOfUntruncatedAndTruncatedColumns) {
  constexpr double kTolerance = 1e-12;  // rounding, of the largest line
  const synth::SyntheticTest made = synth::synthesise(test::truncated_bat_spec());
  for (const double decay_per_s : {0.0, 3.0}) {
    const FrfDataset set = test::frf_set_of(made.record, 40, 2000, decay_per_s);
    const Pole pole{.freq_Hz = 120, .damping_ratio = 0.004};
    const PointForce& force = set.points[0];
    const Eigen::VectorXcd whole = untruncated_column(pole, decay_per_s, set.lines, 5, 200, ColumnContent::value).value;
    const Eigen::VectorXcd cut = mode_column(pole, force, set.lines, 5, 200, ColumnContent::derivatives).value;
    ASSERT_GT((whole - cut).norm(), 1e-6 * whole.norm());
    const std::vector<Complex> decay = TruncatedDecay(pole, decay_per_s, set.lines, 5, 200).at(force);
    ASSERT_EQ(decay.size(), 200u);
    for (std::size_t k = 0; k < decay.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      EXPECT_LE(std::abs(decay[k] - (whole(i) - cut(i))), kTolerance * whole.cwiseAbs().maxCoeff());
    }
  }
}

// Points with three and with four hits, with and without an exponential window; one mode ends within the records.
TEST(PointColumns, EqualTheColumnsOfEachPoint) {
  constexpr double kTolerance = 1e-12;  // rounding, of the largest line
  const synth::SyntheticTest made = synth::synthesise(test::truncated_bat_spec());
  for (const double decay_per_s : {0.0, 3.0}) {
    FrfDataset set = test::frf_set_of(made.record, 40, 2000, decay_per_s);
    PointForce more_hits = set.points[0];
    more_hits.blocks.push_back(more_hits.blocks[0]);
    more_hits.blocks.back().offset += 7;
    for (double& force : more_hits.blocks.back().force_N) force *= 1.5;
    more_hits.spectra.push_back(test::make_spectrum(frf::force_spectrum(more_hits.blocks.back(), set.lines)));
    set.points.push_back(point_force(more_hits.blocks, more_hits.spectra, set.lines, 0));
    for (const Pole& pole : {Pole{120, 0.004}, Pole{800, 0.05}}) {
      const PointColumns columns(pole, set, 5, 200);
      const PointValues values(pole, set, 5, 200);
      for (const PointForce& force : set.points) {
        const ModeColumn expected = mode_column(pole, force, set.lines, 5, 200);
        const ModeColumn column = columns.at(force);
        EXPECT_LE(largest(column.value - expected.value), kTolerance * largest(expected.value));
        EXPECT_LE(largest(column.by_freq - expected.by_freq), kTolerance * largest(expected.by_freq));
        EXPECT_LE(largest(column.by_damping - expected.by_damping), kTolerance * largest(expected.by_damping));
        std::vector<Complex> work;
        const auto value = values.at(force, work);
        ASSERT_EQ(value.size(), 200u);
        EXPECT_LE(largest(vector_of({value.begin(), value.end()}) - expected.value),
                  kTolerance * largest(expected.value));
      }
    }
  }
}

}  // namespace percuss::identify::point_columns_test
