#include "synth/simulated_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"
#include "synth/read_spec.hpp"

namespace percuss::synth::simulated_session_test {

// The band of the preset ends at 3200 Hz.
TEST(SimulatedSession, EndsItsBandAtHalfALowSamplingRate) {
  EXPECT_EQ(parse_simulated_session("wood-bat,fs=2000").spec.band_high_Hz, 1000);
  EXPECT_EQ(parse_simulated_session("wood-bat", {.fs_Hz = 2000}).spec.fs_Hz, 2000);
  EXPECT_EQ(parse_simulated_session("wood-bat,fs=51200").spec.band_high_Hz, 3200);
  const SynthSpec changed_back = parse_simulated_session("wood-bat,fs=2000", {.fs_Hz = 51200}).spec;
  EXPECT_EQ(changed_back.fs_Hz, 51200);
  EXPECT_EQ(changed_back.band_high_Hz, 3200);
}

TEST(SimulatedSession, RefusesARateOutOfRange) {
  EXPECT_THROW(parse_simulated_session("wood-bat,fs=50"), InputError);
  EXPECT_THROW(parse_simulated_session("wood-bat,fs=2e6"), InputError);
}

TEST(SimulatedSession, RefusesATooLongSpecAsTheReaderOfSpecsDoes) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("spec.json"), text(kMaxSpec_bytes + 1, ' ');
  test::write_bytes(path, text);
  const std::string message = test::input_error_of([&] { parse_simulated_session(path); });
  EXPECT_THAT(message, testing::HasSubstr("longer than 4 MiB"));
  EXPECT_EQ(message, test::input_error_of([&] { parse_synth_spec(text, path); }));
}

}  // namespace percuss::synth::simulated_session_test
