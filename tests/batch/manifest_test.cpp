#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "batch/manifest.hpp"
#include "core/error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch::manifest_test {

class BatchManifest : public testing::Test {
 protected:
  /// Writes a manifest of records of these sizes, called r000, r001, …; returns its bytes.
  std::string write(const std::vector<std::uint64_t>& bytes) {
    std::vector<BatchRecord> records;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::string number = std::to_string(i);
      records.push_back({.id = "r" + std::string(3 - number.size(), '0') + number, .path = "p", .bytes = bytes[i]});
    }
    write_manifest(path_, {.version = "1.2.3", .options = {"--band=1:2"}, .setup = "[]", .frf = true, .shards = 4},
                   records, true);
    return test::bytes_of(path_);
  }
  /// The error of a manifest with these bytes; "" when it is accepted.
  std::string refusal(const std::string& bytes) {
    test::write_bytes(path_, bytes);
    try {
      const Manifest manifest(path_);
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("m.jsonl");
};

TEST_F(BatchManifest, IsReadAsItWasWritten) {
  write({5, 0, 7});
  const Manifest manifest(path_);
  EXPECT_EQ(manifest.size(), 3U);
  EXPECT_EQ(manifest.bytes(), 12U);
  EXPECT_EQ(manifest.record(2).id, "r002");
  EXPECT_EQ(manifest.record(2).bytes, 7U);
  EXPECT_EQ(manifest.head().version, "1.2.3");
  EXPECT_EQ(manifest.head().shards, 4U);
  EXPECT_TRUE(manifest.head().frf);
  EXPECT_EQ(manifest.head().setup, "[]");
  EXPECT_THAT(manifest.head().options, testing::ElementsAre("--band=1:2"));
}

TEST_F(BatchManifest, IsDividedWithoutGapOrOverlap) {
  std::vector<std::uint64_t> bytes;
  for (std::uint64_t i = 0; i < 100; ++i) bytes.push_back(i * 7919 % 1000);
  write(bytes);
  const Manifest manifest(path_);
  for (const std::size_t shards : {1U, 2U, 3U, 7U, 100U, 1000U}) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < shards; ++i) {
      EXPECT_EQ(manifest.shard(i, shards).first, next);
      next = manifest.shard(i, shards).end;
    }
    EXPECT_EQ(next, 100U);
  }
}

// A shard differs from its share by at most one record.
TEST_F(BatchManifest, IsDividedIntoAboutEqualBytes) {
  std::vector<std::uint64_t> bytes(100, 10);
  for (std::size_t i = 0; i < 10; ++i) bytes[i] = 500;
  write(bytes);
  const Manifest manifest(path_);
  for (std::size_t i = 0; i < 5; ++i) {
    std::uint64_t sum = 0;
    for (std::size_t r = manifest.shard(i, 5).first; r < manifest.shard(i, 5).end; ++r) sum += bytes[r];
    EXPECT_NEAR(static_cast<double>(sum), static_cast<double>(manifest.bytes()) / 5, 500);
  }
}

TEST_F(BatchManifest, OfEmptyFilesIsDividedByTheirNumber) {
  write(std::vector<std::uint64_t>(10, 0));
  const Manifest manifest(path_);
  EXPECT_EQ(manifest.shard(0, 2).size(), 5U);
  EXPECT_EQ(manifest.shard(1, 2).size(), 5U);
}

TEST_F(BatchManifest, IsRejectedWithThePlaceOfTheError) {
  const std::string good = write({5, 6, 7});
  EXPECT_EQ(refusal(good), "");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    bytes.replace(bytes.find(from), from.size(), to);
    return refusal(bytes);
  };
  EXPECT_THAT(changed("r001", "r000"), testing::HasSubstr("line 3"));
  EXPECT_THAT(changed("r001", "r002"), testing::HasSubstr("line 4"));
  EXPECT_THAT(changed("r001", ""), testing::HasSubstr("line 3"));
  EXPECT_THAT(changed("1:2", "1:3"), testing::HasSubstr("options_sha256"));
  EXPECT_THAT(changed("\"records\":3", "\"records\":4"), testing::HasSubstr("3 records where the first line says 4"));
  EXPECT_THAT(changed("\"records\":3", "\"records\":2"), testing::HasSubstr("3 records where the first line says 2"));
  EXPECT_THAT(changed("\"shards\":4", "\"shards\":0"), testing::HasSubstr("shards"));
  EXPECT_THAT(changed("\"bytes\":6}", "\"bytes\":1e30}"), testing::HasSubstr("line 3"));
  EXPECT_THAT(changed("\"path\":\"p\"", "\"path\":\"\\u0000\""), testing::HasSubstr("path"));
  EXPECT_THAT(changed("\"path\":\"p\"", "\"pfad\":\"p\""), testing::HasSubstr("path"));
  EXPECT_THAT(refusal(good.substr(0, good.size() - 20)), testing::HasSubstr("line 4"));
  EXPECT_THAT(refusal(good + std::string(8 << 20, ' ')), testing::HasSubstr("line 5 is longer"));
}

}  // namespace percuss::batch::manifest_test
