#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::devices_command_test {

using test::ProcessOutcome;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::IsEmpty;

// The null device asks for buffers of a gigabyte. Marking each byte of them takes the address sanitizer minutes.
constexpr const char* kNoHeapPoisoning = "ASAN_OPTIONS=poison_heap=0";

/// Runs percuss devices with a configuration of ALSA, or with the machine's.
ProcessOutcome devices(const std::string& configuration, const std::vector<std::string>& arguments = {}) {
  const ScratchFolder folder;
  std::vector<std::string> words{"devices"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  if (configuration.empty()) return test::run_percuss(words);
  test::write_bytes(folder.file("asound.conf"), configuration);
  return test::run_percuss(words,
                           {.environment = {kNoHeapPoisoning, "ALSA_CONFIG_PATH=" + folder.file("asound.conf")}});
}

TEST(DevicesCommand, ListsInputs) {
  const ProcessOutcome outcome = devices("pcm.default { type null }\npcm.bench { type null }\n");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("portaudio:bench"));
  EXPECT_THAT(outcome.out, HasSubstr("8000 to 192000"));
}

TEST(DevicesCommand, PrintsADocument) {
  const ProcessOutcome outcome = devices("pcm.default { type null }\npcm.bench { type null }\n", {"--json"});
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("devices")), IsEmpty());
  ASSERT_FALSE(document["devices"].empty());
  EXPECT_EQ(document["devices"][0]["device"], "portaudio:bench");
  EXPECT_TRUE(document["advice"].is_null());
}

// PortAudio would abort.
TEST(DevicesCommand, RefusesAConfigurationWithoutADefault) {
  const ProcessOutcome outcome = devices("pcm.bench { type null }\n");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("it needs a device called default"));
  EXPECT_EQ(test::lines_of(outcome.err).size(), 1U);
}

// The machines that usually run the tests have no sound card. Other machines list theirs.
TEST(DevicesCommand, SaysWhatToDoWhereNothingCanRecord) {
  const ProcessOutcome text = devices(""), json = devices("", {"--json"});
  const auto document = test::parse_json(json.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("devices")), IsEmpty());
  EXPECT_EQ(text.code, 0);
  EXPECT_EQ(text.err, "");
  const bool can_record = document["advice"].is_null();
  EXPECT_THAT(text.out, HasSubstr(can_record ? document["devices"][0]["name"].get<std::string>()
                                             : document["advice"].get<std::string>()));
}

}  // namespace percuss::devices_command_test
