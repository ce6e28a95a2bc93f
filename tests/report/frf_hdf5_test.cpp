#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/write_record.hpp"
#include "report/frf_files.hpp"
#include "support/input_error.hpp"
#include "support/modal_frfs.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::frf_hdf5_test {

using acquire::hdf5::InputDataSet;
using acquire::hdf5::InputHdf5;
using testing::ElementsAre;
using testing::HasSubstr;

class FrfHdf5 : public testing::Test {
 protected:
  /// Points 0 and 1, two channels.
  static pipeline::Analysis analysis_of(std::size_t hits) {
    synth::SynthSpec spec =
        test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 0.5);
    spec.hits = hits;
    spec.points.resize(2, spec.points.front());
    spec.points[1].position_m += 0.05;
    spec.noise = {.force = 1e-4, .accel = 1e-3};
    return {synth::synthesise(spec).record, {.band_Hz = std::pair{100.0, 400.0}, .threads = 1}};
  }
  std::vector<double> numbers(const std::string& name) const { return InputDataSet(InputHdf5(path_), name).read_all(); }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.file("frf.h5");
};

/// The elements {r, i} of /frf, read with the HDF5 library alone.
std::vector<Complex> complex_numbers(const std::string& path, std::size_t count) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, "frf", H5P_DEFAULT);
  const hid_t type = H5Tcreate(H5T_COMPOUND, 2 * sizeof(double));
  H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "i", sizeof(double), H5T_NATIVE_DOUBLE);
  std::vector<Complex> out(count);
  const hid_t space = H5Dget_space(set);
  EXPECT_EQ(H5Sget_simple_extent_npoints(space), static_cast<hssize_t>(count));
  EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()), 0);
  H5Tclose(type);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return out;
}

TEST_F(FrfHdf5, ContainsLinesPointsAndFrfsToTheLastDigit) {
  const pipeline::Analysis analysis = analysis_of(3);
  acquire::write_frfs(path_, frf_record_of(analysis), acquire::FrfKind::accelerance, false);
  const auto freq_Hz = numbers("frequency_hz");
  ASSERT_GT(freq_Hz.size(), 100U);
  EXPECT_GE(freq_Hz.front(), 100 - 1e-6);
  EXPECT_LE(freq_Hz.back(), 400 + 1e-6);
  EXPECT_THAT(numbers("point"), ElementsAre(0, 1));
  const std::size_t lines = freq_Hz.size();
  const auto std = numbers("frf_std"), coherence = numbers("coherence");
  const std::size_t frfs = 4;  // two points, two channels
  ASSERT_EQ(std.size(), frfs * lines);
  const auto value = complex_numbers(path_, frfs * lines);
  std::size_t first = 0;
  while (analysis.lines().freq_Hz(first) < freq_Hz.front()) ++first;
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    const std::size_t at = (static_cast<std::size_t>(frf.point) * 2 + frf.channel) * lines;
    for (std::size_t k = 0; k < lines; ++k) {
      ASSERT_EQ(value[at + k], frf.frf.value[first + k]);
      ASSERT_EQ(std[at + k], frf.frf.std[first + k]);
      ASSERT_EQ(coherence[at + k], frf.frf.coherence[first + k]);
    }
  }
}

TEST_F(FrfHdf5, StatesKindUnitAndEstimator) {
  acquire::write_frfs(path_, frf_record_of(analysis_of(3)), acquire::FrfKind::receptance, false);
  const InputHdf5 file(path_);
  EXPECT_EQ(acquire::hdf5::text_attribute(file.id(), "kind", path_), "receptance");
  EXPECT_EQ(acquire::hdf5::text_attribute(file.id(), "unit", path_), "m/N");
  EXPECT_EQ(acquire::hdf5::text_attribute(file.id(), "estimator", path_), "H1");
  EXPECT_THAT(acquire::hdf5::number_attribute(file.id(), "averages", path_, 1).value(), ElementsAre(3));
}

TEST_F(FrfHdf5, HasNoStdForSingleHits) {
  acquire::write_frfs(path_, frf_record_of(analysis_of(1)), acquire::FrfKind::accelerance, false);
  const InputHdf5 file(path_);
  EXPECT_TRUE(file.has("frf"));
  EXPECT_FALSE(file.has("frf_std"));
  EXPECT_FALSE(file.has("coherence"));
}

TEST_F(FrfHdf5, ReplacesAFileOnlyWhenForced) {
  test::write_bytes(path_, "mine");
  const pipeline::Analysis analysis = analysis_of(2);
  EXPECT_THAT(test::input_error_of(
                  [&] { acquire::write_frfs(path_, frf_record_of(analysis), acquire::FrfKind::accelerance, false); }),
              HasSubstr("frf.h5"));
  EXPECT_EQ(test::bytes_of(path_), "mine");
  acquire::write_frfs(path_, frf_record_of(analysis), acquire::FrfKind::accelerance, true);
  EXPECT_GT(numbers("frequency_hz").size(), 0U);
}

}  // namespace percuss::report::frf_hdf5_test
