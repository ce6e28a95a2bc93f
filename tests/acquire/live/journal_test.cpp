#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "acquire/live/journal_format.hpp"
#include "acquire/live/journal_reader.hpp"
#include "acquire/live/journal_writer.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::journal_test {

using test::bytes_of;
using test::input_error_of;
using test::ScratchFolder;
using test::write_bytes;
using testing::ElementsAre;
using testing::HasSubstr;

const StreamFormat kFormat{.device = "test", .fs_Hz = 1000, .channels = 2, .names = {"a", "b"}, .units = {"N", "V"}};

SampleBlock samples(std::uint64_t first, std::size_t frames, double offset = 0) {
  SampleBlock block{.first_frame = first, .frames = frames};
  for (std::size_t i = 0; i < frames; ++i) {
    const auto number = static_cast<double>(first + i);
    block.values.insert(block.values.end(), {number + offset, -number});
  }
  return block;
}

std::string sample_bytes(const SampleBlock& block) {
  std::string out;
  make_sample_block(block, 2, out);
  return out;
}

/// A journal of 3 blocks of 10 frames with an event after each.
std::string example(const ScratchFolder& folder) {
  std::string path = folder.file("test.h5.journal");
  JournalWriter writer(path, kFormat, true);
  for (std::uint64_t i = 0; i < 3; ++i) {
    writer.append(sample_bytes(samples(10 * i, 10)));
    writer.append(journal_block(JournalBlockType::event, "{\"blow\":" + std::to_string(i) + "}"));
  }
  return path;
}

TEST(Journal, ReturnsWhatWasWritten) {
  const ScratchFolder folder;
  const JournalReader reader(example(folder));
  EXPECT_EQ(reader.format().device, "test");
  EXPECT_EQ(reader.format().fs_Hz, 1000);
  EXPECT_THAT(reader.format().units, ElementsAre("N", "V"));
  ASSERT_EQ(reader.events().size(), 3U);
  EXPECT_EQ(reader.events()[1].json, "{\"blow\":1}");
  EXPECT_EQ(reader.events()[1].frame, 20U);
  EXPECT_THAT(reader.ranges(), ElementsAre(FrameRange{0, 30}));
  EXPECT_EQ(reader.torn_bytes(), 0U);
  EXPECT_THAT(reader.read(8, 4), ElementsAre(8, -8, 9, -9, 10, -10, 11, -11));
  EXPECT_EQ(reader.read(0, 30), samples(0, 30).values);
}

TEST(Journal, StoresFloatsOf4BytesOnlyWhereTheyAreExact) {
  const std::string narrow = sample_bytes(samples(0, 10)), wide = sample_bytes(samples(0, 10, 0.1));
  EXPECT_EQ(narrow.size(), kBlockHeader_bytes + 80);
  EXPECT_EQ(wide.size(), kBlockHeader_bytes + 160);
  const auto header = parse_block_header(wide);
  ASSERT_TRUE(header);
  EXPECT_EQ(block_values(*header, std::string_view(wide).substr(kBlockHeader_bytes)), samples(0, 10, 0.1).values);
}

TEST(Journal, KeepsNanAndInfinity) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const std::string bytes = sample_bytes({.first_frame = 0, .frames = 1, .values = {kNaN, -kInf}});
  const auto values = block_values(*parse_block_header(bytes), std::string_view(bytes).substr(kBlockHeader_bytes));
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], -kInf);
}

TEST(Journal, SeparatesRangesAtGapsAndOverruns) {
  const ScratchFolder folder;
  const std::string path = folder.file("gaps.journal");
  {
    JournalWriter writer(path, kFormat, false);
    writer.append(sample_bytes(samples(0, 10)));
    writer.append(sample_bytes(samples(15, 10)));
    SampleBlock overrun = samples(25, 10);
    overrun.overrun = true;
    writer.append(sample_bytes(overrun));
  }
  const JournalReader reader(path);
  EXPECT_THAT(reader.ranges(), ElementsAre(FrameRange{0, 10}, FrameRange{15, 10}, FrameRange{25, 10}));
  EXPECT_EQ(reader.frames(), 30U);
  EXPECT_TRUE(reader.has(15, 10));
  EXPECT_FALSE(reader.has(20, 10));
  EXPECT_FALSE(reader.has(12, 1));
  EXPECT_THAT(input_error_of([&] { reader.read(5, 10); }), HasSubstr("frames are missing"));
}

// A kill leaves any part of the last block.
TEST(Journal, IsRecoveredFromEveryTornTail) {
  const ScratchFolder folder;
  const std::string path = example(folder), whole = bytes_of(path);
  const std::uint64_t first_block = kJournalHeader_bytes + kBlockHeader_bytes + format_json(kFormat).size();
  for (std::size_t size = first_block; size < whole.size(); size += 3) {
    write_bytes(path, whole.substr(0, size));
    const JournalReader reader(path);
    EXPECT_EQ(reader.whole_bytes() + reader.torn_bytes(), size);
    EXPECT_LE(reader.torn_bytes(), kBlockHeader_bytes + 80);
    EXPECT_EQ(reader.frames() % 10, 0U);
    EXPECT_GE(reader.frames() / 10, reader.events().size());
    EXPECT_EQ(reader.read(0, reader.frames()), samples(0, reader.frames()).values);
  }
  for (std::size_t size = 0; size < first_block; size += 7) {
    write_bytes(path, whole.substr(0, size));
    input_error_of([&] { JournalReader reader(path); });
  }
}

// A changed bit is found by the checksum: the journal ends before it, or is refused.
TEST(Journal, NeverReturnsChangedSamples) {
  const ScratchFolder folder;
  const std::string path = example(folder), whole = bytes_of(path);
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    write_bytes(path, changed);
    try {
      const JournalReader reader(path);
      EXPECT_TRUE(reader.torn_bytes() > 0 || at < kJournalHeader_bytes) << at;
      EXPECT_EQ(reader.read(0, reader.frames()), samples(0, reader.frames()).values);
    } catch (const InputError&) {
      EXPECT_LT(at, kJournalHeader_bytes + kBlockHeader_bytes + format_json(kFormat).size());
    }
  }
}

// Blocks with right checksums may still contradict each other.
TEST(Journal, RefusesContradictions) {
  const ScratchFolder folder;
  const std::string path = folder.file("hostile.journal");
  const auto refusal = [&](const std::string& blocks) {
    write_bytes(path, journal_header() + blocks);
    return input_error_of([&] { JournalReader reader(path); });
  };
  const auto format = [](const std::string& json) { return journal_block(JournalBlockType::format, json); };
  const std::string good = format(format_json(kFormat));
  EXPECT_THAT(refusal(""), HasSubstr("ends before its first block"));
  EXPECT_THAT(refusal(sample_bytes(samples(0, 1))), HasSubstr("before their description"));
  EXPECT_THAT(refusal(format("[]")), HasSubstr("damaged description"));
  EXPECT_THAT(refusal(format("[[[[[")), HasSubstr("nested deeper"));
  EXPECT_THAT(refusal(format("{\"device\":\"x\",\"fs_hz\":1,\"channels\":1e9,\"names\":[],\"units\":[],"
                             "\"full_scale\":0,\"full_scales\":[]}")),
              HasSubstr("contradicts itself"));
  EXPECT_THAT(refusal(good + sample_bytes(samples(5, 5)) + sample_bytes(samples(9, 5))), HasSubstr("back in time"));
  std::string three;
  make_sample_block({.frames = 1, .values = {1, 2, 3}}, 3, three);
  EXPECT_THAT(refusal(good + three), HasSubstr("another length"));
  StreamFormat other = kFormat;
  other.fs_Hz = 2000;
  EXPECT_THAT(refusal(good + format(format_json(other))), HasSubstr("changes its channels"));
  EXPECT_THAT(refusal(good + journal_block(JournalBlockType::finding, "{}")), HasSubstr("damaged finding"));
  EXPECT_THAT(refusal(good + journal_block(JournalBlockType::finding, "{\"fault\":\"x\"}")), HasSubstr("unknown"));
  write_bytes(path, "RIFF0000WAVE00000000000000");
  EXPECT_THAT(input_error_of([&] { JournalReader reader(path); }), HasSubstr("not a journal"));
  std::string newer = journal_header() + good;
  newer[8] = 2;
  write_bytes(path, newer);
  EXPECT_THAT(input_error_of([&] { JournalReader reader(path); }), HasSubstr("another version"));
}

// A block that claims 4 GB is not read.
TEST(Journal, IgnoresABlockLargerThanAllowed) {
  const ScratchFolder folder;
  const std::string path = example(folder), whole = bytes_of(path);
  std::string head = journal_block(JournalBlockType::event, "");
  for (std::size_t i = 4; i < 8; ++i) head[i] = '\xff';
  write_bytes(path, whole + head);
  EXPECT_EQ(JournalReader(path).torn_bytes(), head.size());
}

TEST(Journal, SkipsBlocksOfOtherTypes) {
  const ScratchFolder folder;
  const std::string path = example(folder);
  write_bytes(path,
              bytes_of(path) + journal_block(static_cast<JournalBlockType>(7), "later") + sample_bytes(samples(30, 1)));
  EXPECT_EQ(JournalReader(path).frames(), 31U);
}

TEST(Journal, IsResumedAfterItsLastWholeBlock) {
  const ScratchFolder folder;
  const std::string path = example(folder);
  write_bytes(path, bytes_of(path) + sample_bytes(samples(30, 10)).substr(0, 50));
  {
    JournalWriter writer = JournalWriter::resumed(path, kFormat);
    EXPECT_EQ(writer.next_frame(), 30U + 1000U);
    EXPECT_EQ(writer.append(sample_bytes(samples(1030, 10))).error, 0);
  }
  const JournalReader reader(path);
  EXPECT_EQ(reader.torn_bytes(), 0U);
  EXPECT_THAT(reader.ranges(), ElementsAre(FrameRange{0, 30}, FrameRange{1030, 10}));
  ASSERT_EQ(reader.findings().size(), 1U);
  EXPECT_EQ(reader.findings()[0].fault, CaptureFault::resumed);
  EXPECT_EQ(reader.events().size(), 3U);
}

TEST(Journal, IsNotOverwrittenSharedOrResumedByAnotherDevice) {
  const ScratchFolder folder;
  const std::string path = example(folder);
  EXPECT_THAT(input_error_of([&] { JournalWriter(path, kFormat, false); }), HasSubstr("a journal exists"));
  StreamFormat other = kFormat;
  other.channels = 3;
  other.names = other.units = {};
  EXPECT_THAT(input_error_of([&] { JournalWriter::resumed(path, other); }), HasSubstr("other channels"));
  EXPECT_EQ(JournalReader(path).frames(), 30U);
  const JournalWriter writer = JournalWriter::resumed(path, kFormat);
  EXPECT_THAT(input_error_of([&] { JournalWriter::resumed(path, kFormat); }), HasSubstr("another process"));
  EXPECT_THAT(input_error_of([&] { JournalWriter(folder.file("no/folder"), kFormat, false); }), HasSubstr("no/folder"));
}

TEST(CaptureFinding, SurvivesItsText) {
  const CaptureFinding finding{.fault = CaptureFault::overload,
                               .frame = 5000000000,
                               .count = 7,
                               .channel = 3,
                               .value = -1.5e-4,
                               .text = "\"x\""};
  EXPECT_EQ(parse_finding(finding_json(finding), "test"), finding);
  EXPECT_EQ(parse_finding(finding_json({}), "test"), CaptureFinding{});
  EXPECT_EQ(finding_text(finding), "channel 4 has 7 samples at full scale");
}

}  // namespace percuss::acquire::journal_test
