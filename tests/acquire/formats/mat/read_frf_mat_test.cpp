#include "acquire/formats/mat/read_frf_mat.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/formats/mat/read_mat.hpp"
#include "acquire/open_measurement.hpp"
#include "core/units.hpp"
#include "support/files/mat_variables.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"

// FRFs of MAT files: variables of another class or shape than expected, and the numbers of the points.
namespace percuss::acquire::read_frf_mat_test {

using test::input_error_of;
using test::mat_file_of;
using test::mat_numbers;
using test::mat_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

MatVariable complex(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<double>& real) {
  return {.name = name, .shape = shape, .real = real, .imaginary = std::vector<double>(real.size(), 0.5)};
}

// Two points, one channel, three lines.
MatFile two_points(const std::vector<MatVariable>& more) {
  std::vector<MatVariable> variables{mat_numbers("frequency_hz", {1, 3}, {0, 1, 2}),
                                     complex("frf", {2, 1, 3}, {1, 2, 3, 4, 5, 6})};
  variables.insert(variables.end(), more.begin(), more.end());
  return mat_file_of(variables);
}

// One point, one channel, three lines.
MatFile one_point(const MatVariable& more) {
  return mat_file_of({mat_numbers("frequency_hz", {1, 3}, {0, 1, 2}), complex("frf", {1, 3}, {1, 2, 3}), more});
}

std::vector<int> points_of(const MatFile& file) {
  std::vector<int> points;
  const StoredFrfs frfs = read_frf_mat(file, {}).value();
  for (const StoredFrf& frf : frfs.frfs) points.push_back(frf.point);
  return points;
}

TEST(ReadFrfMat, UsesCoherenceAndStandardDeviationOnlyIfTheyAreReal) {
  const StoredFrfs good = read_frf_mat(one_point(mat_numbers("coherence", {1, 3}, {0.5, 0.6, 0.7})), {}).value();
  EXPECT_THAT(good.frfs[0].coherence, ElementsAre(0.5, 0.6, 0.7));
  EXPECT_THAT(good.record.notes, IsEmpty());
  const StoredFrfs upright = read_frf_mat(one_point(mat_numbers("coherence", {3, 1}, {0.5, 0.6, 0.7})), {}).value();
  EXPECT_THAT(upright.frfs[0].coherence, ElementsAre(0.5, 0.6, 0.7)) << "vectors of equal length";
  for (const std::string name : {"coherence", "frf_std"}) {
    for (const MatVariable& other :
         {mat_text(name, "abc"), complex(name, {1, 3}, {1, 1, 1}), mat_numbers(name, {1, 2}, {1, 1})}) {
      const StoredFrfs frfs = read_frf_mat(one_point(other), {}).value();
      EXPECT_THAT(frfs.frfs[0].coherence, IsEmpty());
      EXPECT_THAT(frfs.frfs[0].std, IsEmpty());
      EXPECT_THAT(test::texts(frfs.record.notes),
                  ElementsAre(name + " is not used: it is not an array of 1x3 real numbers"));
    }
  }
}

// The tolerances of converted frequencies, from 1e-9 to 1e-6 Hz, allow for rounding.
TEST(ReadFrfMat, ReadsTheUnitOfTheFrequencies) {
  const StoredFrfs kilo = read_frf_mat(one_point(mat_text("frequency_hz_unit", "kHz")), {}).value();
  EXPECT_NEAR(kilo.record.lines.df_Hz(), 1000, 1e-9);
  EXPECT_THAT(input_error_of([] { read_frf_mat(one_point(mat_text("frequency_hz_unit", "orders")), {}); }),
              HasSubstr("the unit of the frequencies, orders, is not known (x.mat: frequency_hz)"));
}

TEST(ReadFrfMat, FindsFrequenciesWithOtherNames) {
  const MatVariable frf = complex("H", {1, 3}, {1, 2, 3});
  const StoredFrfs found =
      read_frf_mat(mat_file_of({mat_numbers("freq_axis", {1, 3}, {20, 20.5, 21}), frf}), {}).value();
  EXPECT_EQ(found.record.lines.first, 40U);
}

TEST(ReadFrfMat, ReadsTheUnitInTheNameOfTheFrequencies) {
  const MatVariable frf = complex("H", {1, 3}, {1, 2, 3});
  const auto first_Hz = [&](const std::string& name) {
    return read_frf_mat(mat_file_of({mat_numbers(name, {1, 3}, {20, 20.5, 21}), frf}), {})
        .value()
        .record.lines.freq_Hz(0);
  };
  EXPECT_NEAR(first_Hz("freq_kHz"), 20000, 1e-6);
  EXPECT_NEAR(first_Hz("frequency_rad_s"), 20 / kTwoPi, 1e-9);
  EXPECT_NEAR(first_Hz("freq_hz"), 20, 1e-9);
  const StoredFrfs angular = read_frf_mat(mat_file_of({mat_numbers("w", {1, 3}, {20, 20.5, 21}), frf}), {}).value();
  EXPECT_NEAR(angular.record.lines.freq_Hz(0), 20 / kTwoPi, 1e-9);
  EXPECT_THAT(test::texts(angular.record.notes), ElementsAre("w is taken as the frequencies in rad/s"));
}

TEST(ReadFrfMat, ReadsKindAndUnitBesideTheFrfs) {
  const MatVariable freq = mat_numbers("freq", {1, 3}, {0, 1, 2});
  const StoredFrfs stated =
      read_frf_mat(mat_file_of({freq, complex("H", {1, 3}, {1, 2, 3}), mat_text("H_unit", "g/N")}), {}).value();
  EXPECT_EQ(stated.unit.value().response_to_SI, kStandardGravity_mps2);
  const StoredFrfs named = read_frf_mat(mat_file_of({freq, complex("mobility", {1, 3}, {1, 2, 3})}), {}).value();
  EXPECT_EQ(named.kind, FrfKind::mobility);
}

TEST(ReadFrfMat, NumbersPointsByWholeNumbersFromZero) {
  EXPECT_THAT(points_of(two_points({})), ElementsAre(0, 1));
  EXPECT_THAT(points_of(two_points({mat_numbers("point", {1, 2}, {7, 3})})), ElementsAre(7, 3));
  EXPECT_THAT(points_of(two_points({mat_text("point", "73")})), ElementsAre(0, 1));
  const auto refusal = [](const MatVariable& point) {
    return input_error_of([&] { read_frf_mat(two_points({point}), {}); });
  };
  for (const double number : {1.5, 2e9, -0.5}) {
    EXPECT_EQ(refusal(mat_numbers("point", {1, 2}, {0, number})), "not a whole number (x.mat: point); store 0, 1, …");
  }
  EXPECT_EQ(refusal(complex("point", {1, 2}, {0, 1})), "not a whole number (x.mat: point); store 0, 1, …");
  EXPECT_EQ(refusal(mat_numbers("point", {1, 2}, {0, -5})),
            "-5 is not a point number (x.mat: point); number points from 0 to 1000000000");
  EXPECT_EQ(refusal(mat_numbers("point", {1, 2}, {4, 4})),
            "a point occurs twice (x.mat: point); give each point its own number");
}

TEST(ReadFrfMat, IgnoresAnglesThatAreNotReal) {
  const StoredFrfs frfs = read_frf_mat(one_point(complex("angle_deg", {1, 1}, {90})), {}).value();
  EXPECT_FALSE(frfs.record.accel.at(0).angle_rad.has_value());
}

// A real array longer than the complex one may be a record. The name `frf`, in any letter case, decides for FRFs.
TEST(ReadFrfMat, KnowsTheNameFrfInAnyLetterCase) {
  for (const std::string name : {"frf", "FRF", "test.Frf"}) {
    const MatFile file = mat_file_of({mat_numbers("frequency_hz", {1, 3}, {0, 1, 2}), complex(name, {1, 3}, {1, 2, 3}),
                                      mat_numbers("other", {1, 6}, {0, 0, 0, 0, 0, 0})});
    EXPECT_TRUE(read_frf_mat(file, {}).has_value()) << name;
  }
  const MatFile other = mat_file_of({mat_numbers("frequency_hz", {1, 3}, {0, 1, 2}), complex("h", {1, 3}, {1, 2, 3}),
                                     mat_numbers("other", {1, 6}, {0, 0, 0, 0, 0, 0})});
  EXPECT_FALSE(read_frf_mat(other, {}).has_value());
}

TEST(ReadFrfMat, ReadsAnArrayOfOneDimension) {
  const StoredFrfs frfs =
      read_frf_mat(mat_file_of({mat_numbers("frequency_hz", {3}, {0, 1, 2}), complex("frf", {3}, {1, 2, 3})}), {})
          .value();
  ASSERT_EQ(frfs.frfs.size(), 1U);
  EXPECT_THAT(frfs.frfs[0].value, ElementsAre(Complex(1, 0.5), Complex(2, 0.5), Complex(3, 0.5)));
}

// The reader once read beyond the end of this coherence.
TEST(ReadFrfMat, ReadsTheFileWhoseCoherenceIsText) {
  const std::string path = std::string(PERCUSS_SOURCE_DIR "/fuzz/corpus/foreign/text_coherence.mat");
  const auto record = std::get<FrfRecord>(open_measurement(path, {.read = {.sandboxed = false}}));
  ASSERT_EQ(record.frfs.size(), 1U);
  EXPECT_THAT(record.frfs[0].frf.coherence, IsEmpty());
  EXPECT_THAT(test::texts(record.notes), testing::Contains(HasSubstr("coherence is not used")));
}

}  // namespace percuss::acquire::read_frf_mat_test
