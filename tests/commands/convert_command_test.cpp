#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

namespace percuss::convert_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::HasSubstr;

class ConvertCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_small_test(file("bat.h5"));
    run_percuss({"frf", file("bat.h5"), "--band", "60:1000", "-o", file("frf.h5")});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static test::ProcessOutcome convert(const std::string& from, const std::string& to,
                                      std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"convert", file(from), file(to), "--force"});
    return run_percuss(more);
  }
  static json modes_of(const std::string& name) {
    const auto outcome = run_percuss({"analyze", file(name), "--band", "60:1000", "--angle", "0,90", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? test::parse_json(outcome.out)["modes"] : json();
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

constexpr std::array kKinds{"h5", "mat", "uff", "unv", "csv"};
constexpr std::array kSoundKinds{"wav", "rf64"};  // records only

TEST_F(ConvertCommand, GivesEqualModesThroughEveryFormat) {
  const json modes = modes_of("bat.h5");
  ASSERT_EQ(modes.size(), 2U);
  for (const std::string kind : kKinds) {
    ASSERT_EQ(convert("bat.h5", "a." + kind).code, 0) << kind;
    EXPECT_EQ(modes_of("a." + kind), modes) << kind;
  }
  for (const std::string kind : kSoundKinds) {
    ASSERT_EQ(convert("bat.h5", "a." + kind).code, 0) << kind;
    EXPECT_EQ(modes_of("a." + kind), modes) << kind;
  }
}

TEST_F(ConvertCommand, KeepsARecordWithoutAForce) {
  std::vector<double> time_s(4096), accel_mps2(4096);
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    time_s[i] = static_cast<double>(i) / 4096;
    if (i >= 400) accel_mps2[i] = std::exp(-5 * (time_s[i] - time_s[400])) * std::sin(600 * (time_s[i] - time_s[400]));
  }
  test::write_columns(file("ping.csv"), "time_s,accel_m_s2", {time_s, accel_mps2});
  ASSERT_EQ(convert("ping.csv", "ping.wav").code, 0);
  for (const std::string kind : {"h5", "mat", "uff", "csv"}) {
    const auto outcome = convert("ping.wav", "ping_back." + kind);
    ASSERT_EQ(outcome.code, 0) << kind << outcome.err;
    const auto analysed = run_percuss({"analyze", file("ping_back." + kind), "--band", "20:500", "--json"});
    ASSERT_EQ(analysed.code, 0) << kind << analysed.err;
    EXPECT_NEAR(test::parse_json(analysed.out)["modes"][0]["frequency_hz"].get<double>(), 95.5, 0.2) << kind;
  }
}

TEST_F(ConvertCommand, KeepsThatAResponseIsAPressure) {
  std::vector<double> time_s(4096), pressure_Pa(4096);
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    time_s[i] = static_cast<double>(i) / 4096;
    pressure_Pa[i] = std::exp(-5 * time_s[i]) * std::sin(600 * time_s[i]);
  }
  test::write_columns(file("mic.csv"), "time_s,mic_Pa", {time_s, pressure_Pa});
  for (const std::string kind : {"h5", "mat", "uff", "csv", "wav"}) {
    ASSERT_EQ(convert("mic.csv", "mic_back." + kind).code, 0) << kind;
    const auto shown = run_percuss({"info", file("mic_back." + kind), "--json"});
    ASSERT_EQ(shown.code, 0) << kind << shown.err;
    EXPECT_THAT(shown.out, testing::HasSubstr("pressure")) << kind;
  }
}

TEST_F(ConvertCommand, GivesEqualBytesAfterARoundTrip) {
  for (const std::string from : kKinds) {
    ASSERT_EQ(convert("bat.h5", "a." + from).code, 0);
    ASSERT_EQ(convert("frf.h5", "f." + from).code, 0);
    ASSERT_EQ(convert("a." + from, "b." + from).code, 0);
    ASSERT_EQ(convert("f." + from, "g." + from).code, 0);
    EXPECT_EQ(test::bytes_of(file("a." + from)), test::bytes_of(file("b." + from))) << from;
    EXPECT_EQ(test::bytes_of(file("f." + from)), test::bytes_of(file("g." + from))) << "FRFs, " << from;
  }
  for (const std::string from : kSoundKinds) {
    ASSERT_EQ(convert("bat.h5", "a." + from).code, 0);
    ASSERT_EQ(convert("a." + from, "b." + from).code, 0);
    EXPECT_EQ(test::bytes_of(file("a." + from)), test::bytes_of(file("b." + from))) << from;
  }
}

TEST_F(ConvertCommand, KeepsFrfsTheirStandardDeviationsAndSensors) {
  const json modes = modes_of("frf.h5");
  ASSERT_EQ(modes.size(), 2U);
  for (const std::string kind : kKinds) {
    ASSERT_EQ(convert("frf.h5", "x." + kind).code, 0);
    const json other = modes_of("x." + kind);
    ASSERT_EQ(other.size(), 2U) << kind;
    for (std::size_t m = 0; m < 2; ++m) {
      EXPECT_EQ(other[m]["family"], modes[m]["family"]) << kind;
      for (const char* key : {"frequency_hz", "damping_ratio", "frequency_std_hz"}) {
        const double is = other[m][key], was = modes[m][key];
        EXPECT_NEAR(is / was, 1, 1e-6) << kind << ' ' << key;
      }
    }
  }
}

TEST_F(ConvertCommand, ListsLostInformation) {
  EXPECT_EQ(convert("bat.h5", "k.uff").err, "");
  EXPECT_THAT(convert("bat.h5", "k.csv").err, HasSubstr("not kept: the sensors' angles"));
  EXPECT_EQ(convert("bat.h5", "k.csv", {"--quiet"}).err, "");
}

TEST_F(ConvertCommand, PrintsADocumentOfWhatWasWritten) {
  EXPECT_EQ(convert("bat.h5", "j.csv").out, "");
  const auto record = convert("bat.h5", "j.csv", {"--json"});
  ASSERT_EQ(record.code, 0) << record.err;
  EXPECT_THAT(record.err, HasSubstr("not kept: the sensors' angles"));
  const json document = test::parse_json(record.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("convert")), testing::IsEmpty());
  EXPECT_EQ(document["inputs"][0]["path"], file("bat.h5"));
  EXPECT_EQ(document["output"]["path"], file("j.csv"));
  EXPECT_EQ(document["output"]["bytes"], test::bytes_of(file("j.csv")).size());
  EXPECT_EQ(document["content"], "record");
  EXPECT_EQ(document["responses"], 2);
  EXPECT_EQ(document["force"], true);
  EXPECT_THAT(document["not_kept"].dump(), HasSubstr("the sensors' angles"));
  const json frfs = test::parse_json(convert("frf.h5", "j.mat", {"--json", "--frf-kind", "mobility"}).out);
  EXPECT_THAT(test::schema_violations(frfs, test::schema_named("convert")), testing::IsEmpty());
  EXPECT_EQ(frfs["content"], "frfs");
  EXPECT_EQ(frfs["frf_kind"], "mobility");
  EXPECT_EQ(frfs["points"], 1);
  EXPECT_EQ(frfs["responses"], 2);
}

TEST_F(ConvertCommand, RemovesTheLeftoversOfAKilledWriterOfAnyFormat) {
  for (const std::string kind : {"h5", "mat", "uff", "csv", "wav", "w64"}) {
    const std::string leftover = file(".left." + kind + ".percuss-99999999");
    for (const char* from : {"bat.h5", "frf.h5"}) {
      if (from == std::string("frf.h5") && kind.starts_with('w')) continue;  // sound files hold records only
      test::write_bytes(leftover, "");
      ASSERT_EQ(convert(from, "left." + kind).code, 0) << kind;
      EXPECT_FALSE(std::filesystem::exists(leftover)) << kind;
    }
  }
}

TEST_F(ConvertCommand, ExitsWithTheCodeOfTheError) {
  EXPECT_EQ(run_percuss({"convert", file("bat.h5")}).code, 2);
  EXPECT_EQ(run_percuss({"convert", file("bat.h5"), file("a.xls")}).code, 2);
  EXPECT_EQ(run_percuss({"convert", file("none.h5"), file("new.mat")}).code, 3);
  convert("bat.h5", "there.mat");
  EXPECT_EQ(run_percuss({"convert", file("bat.h5"), file("there.mat")}).code, 3);
}

}  // namespace percuss::convert_command_test
