#include "acquire/channels/channel_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/units.hpp"
#include "support/input_error.hpp"
#include "support/json_schema.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::channel_setup_test {

using test::input_error_of;
using testing::HasSubstr;

std::string rejection_of(const std::string& json) {
  return input_error_of([&] { parse_channel_setup(json, "s.json"); });
}

TEST(ChannelSetup, ExampleReadsBack) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.json"), channel_setup_example());
  const auto setup = read_channel_setup(folder.file("s.json"));
  ASSERT_EQ(setup.size(), 3U);
  EXPECT_EQ(setup[0].role, "force");
  EXPECT_DOUBLE_EQ(setup[0].sensitivity_V_per_SI.value(), 2.25e-3);
  EXPECT_EQ(setup[1].sign, 1);
  EXPECT_EQ(setup[2].sign, -1);
  EXPECT_DOUBLE_EQ(setup[2].angle_rad.value(), std::numbers::pi / 2);
  EXPECT_EQ(setup[2].position_m, 0.15);
  EXPECT_DOUBLE_EQ(setup[1].sensitivity_V_per_SI.value(), 10.2e-3 / kStandardGravity_mps2);
  EXPECT_EQ(setup[1].unit, "V");
}

TEST(ChannelSetup, ExampleFollowsTheSchema) {
  const auto example = test::parse_json(channel_setup_example());
  EXPECT_THAT(test::schema_violations(example, test::schema_named("channel-setup")), testing::IsEmpty());
}

TEST(ChannelSetup, LeavesMissingKeysEmpty) {
  const auto setup = parse_channel_setup(R"([{"name": "2"}])", "s.json");
  EXPECT_EQ(setup.at(0).role, "");
  EXPECT_EQ(setup.at(0).sign, 1);
  EXPECT_FALSE(setup.at(0).angle_rad || setup.at(0).position_m || setup.at(0).sensitivity_V_per_SI || setup.at(0).unit);
}

TEST(ChannelSetup, TakesNumbersForNames) {
  EXPECT_EQ(parse_channel_setup(R"([{"name": 2}])", "s.json").at(0).name, "2");
  EXPECT_EQ(rejection_of(R"([{"name": 2}, {"name": "2"}])").find("two entries"), 0U);
}

TEST(ChannelSetup, TurnsADirectionIntoASignAndAnAxis) {
  EXPECT_EQ(parse_channel_setup(R"([{"name": "a", "direction": "-z"}])", "s").at(0).sign, -1);
  EXPECT_EQ(parse_channel_setup(R"([{"name": "a", "direction": "-z"}])", "s").at(0).axis, (Direction{0, 0, 1}));
  EXPECT_FALSE(parse_channel_setup(R"([{"name": "a", "sign": -1}])", "s").at(0).axis);
  EXPECT_EQ(parse_channel_setup(R"([{"name": "a", "direction": "+x"}])", "s").at(0).sign, 1);
  EXPECT_THAT(rejection_of(R"([{"name": "a", "direction": "up"}])"), HasSubstr("s.json: [0].direction"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "direction": "-x", "sign": -1}])"), HasSubstr("both given"));
}

struct SensitivityCase {
  const char* unit;
  double volts_per_SI;
};

TEST(ChannelSetup, KnowsSensitivitiesOfForceAccelerationAndPressure) {
  for (const auto& c :
       {SensitivityCase{"mV/N", 1e-3}, SensitivityCase{"V/N", 1}, SensitivityCase{"mV/lbf", 1e-3 / kPoundForce_N},
        SensitivityCase{"mV/g", 1e-3 / kStandardGravity_mps2}, SensitivityCase{"V/(m/s^2)", 1},
        SensitivityCase{"mV/m/s2", 1e-3}, SensitivityCase{"mV/Pa", 1e-3}, SensitivityCase{"mV/kPa", 1e-6}}) {
    const auto setup = parse_channel_setup(
        std::string(R"([{"name": "a", "sensitivity": 2, "sensitivity_unit": ")") + c.unit + "\"}]", "s");
    EXPECT_DOUBLE_EQ(setup.at(0).sensitivity_V_per_SI.value(), 2 * c.volts_per_SI) << c.unit;
    EXPECT_EQ(setup.at(0).sensitivity_to == Quantity::pressure, std::string(c.unit).ends_with("Pa")) << c.unit;
  }
}

TEST(ChannelSetup, RefusesImpossibleSensitivities) {
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sensitivity": 2}])"), HasSubstr("give both"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sensitivity_unit": "mV/N"}])"), HasSubstr("give both"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sensitivity": 0, "sensitivity_unit": "mV/N"}])"), HasSubstr("zero"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sensitivity": 2, "sensitivity_unit": "pC/N"}])"), HasSubstr("charge"));
  for (const char* unit : {"N/mV", "mV", "mV/", "/N", "mV/s", "furlong"}) {
    EXPECT_THAT(rejection_of(std::string(R"([{"name": "a", "sensitivity": 2, "sensitivity_unit": ")") + unit + "\"}]"),
                HasSubstr("unknown sensitivity unit"))
        << unit;
  }
  EXPECT_THAT(rejection_of(R"([{"name": "a", "role": "force", "sensitivity": 2, "sensitivity_unit": "mV/g"}])"),
              HasSubstr("does not fit the role force"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "role": "force", "sensitivity": 50, "sensitivity_unit": "mV/Pa"}])"),
              HasSubstr("does not fit the role force"));
}

TEST(ChannelSetup, NamesTheWrongKey) {
  EXPECT_THAT(rejection_of(R"([{"name": "a"}, {"name": "b", "angel_deg": 3}])"),
              HasSubstr("unknown key (s.json: [1].angel_deg); use one of name,"));
  EXPECT_THAT(rejection_of(R"([{"role": "force"}])"), HasSubstr("no name (s.json: [0])"));
  EXPECT_THAT(rejection_of(R"([{"name": 3.5}])"), HasSubstr("no text (s.json: [0].name)"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "angle_deg": "90"}])"), HasSubstr("not a number (s.json: [0].angle_deg)"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "angle_deg": 4000}])"), HasSubstr("out of range"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "position_m": 1e300}])"), HasSubstr("out of range"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sign": 0.5}])"), HasSubstr("is not a sign"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "role": "hammer"}])"), HasSubstr("unknown role"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "unit": "furlong"}])"), HasSubstr("unknown unit"));
  EXPECT_THAT(rejection_of(R"([{"name": "a"}, {"name": "A"}])"), HasSubstr("two entries"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "role": "force"}, {"name": "b", "role": "force"}])"),
              HasSubstr("second force"));
  EXPECT_THAT(rejection_of(R"([{"name": "a", "sign": 1, "sign": -1}])"), HasSubstr("\"sign\" is given twice"));
}

TEST(ChannelSetup, RefusesOtherDocuments) {
  for (const char* json :
       {"", "[", "[]", "{}", "3", "[3]", "[[]]", "nul", R"([{"name": "a"}] x)", "[{\"name\": \"\xFF\"}]"}) {
    EXPECT_THAT(rejection_of(json), HasSubstr("s.json")) << json;
  }
  EXPECT_THAT(rejection_of(std::string(100000, '[')), HasSubstr("deeper than 16"));
  EXPECT_THAT(rejection_of(std::string((std::size_t{1} << 20U) + 1, ' ')), HasSubstr("1 MiB"));
  const test::ScratchFolder folder;
  EXPECT_THAT(input_error_of([&] { read_channel_setup(folder.path()); }), HasSubstr("folder"));
  EXPECT_THAT(input_error_of([&] { read_channel_setup(folder.file("none")); }), HasSubstr("no such file"));
}

}  // namespace percuss::acquire::channel_setup_test
