#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace percuss::batch {

/// A record of a batch at the time of planning.
struct BatchRecord {
  std::string id;    // orders the rows
  std::string path;  // absolute, or relative to the folder of the manifest
  std::uint64_t bytes = 0;
  std::string sha256{};  // of its bytes; empty: only `bytes` is checked
};

/// The data of a whole batch: the first line of its manifest.
struct BatchHeader {
  std::string version;               // of percuss at the time of planning
  std::vector<std::string> options;  // arguments of the command `analyze`: "--band", "60:3200"
  std::string setup;                 // text of a channel set-up; empty: none
  bool frf = false;                  // also keep FRFs
  std::size_t shards = 1;            // default number of shards
};

/// Identifies the way of analysing: the SHA-256 of options, set-up and frf.
std::string options_sha256(const BatchHeader& head);

/// Writes a manifest: the head, then a line of JSON per record (docs/schema/batch-manifest.schema.json). `records` have
/// distinct ids in ascending order. The file is whole or absent. errors  InputError as AtomicFile
void write_manifest(const std::string& path, const BatchHeader& head, const std::vector<BatchRecord>& records,
                    bool force);

/// Records first … end − 1 of a manifest.
struct ShardRange {
  std::size_t first = 0, end = 0;
  std::size_t size() const { return end - first; }
};

/// A valid manifest. Its records stay in the file until they are read: 16 bytes of memory for each.
class Manifest {
 public:
  /// errors  InputError naming the line: not a manifest, records out of order or named twice, lines too long, a number
  /// of records that differs from the head
  explicit Manifest(std::string path);
  ~Manifest();
  Manifest(const Manifest&) = delete;
  Manifest& operator=(const Manifest&) = delete;

  const std::string& path() const { return path_; }
  const BatchHeader& head() const { return head_; }
  const std::string& sha256() const { return sha256_; }  // of its lines
  std::size_t size() const { return ends_.size(); }
  std::uint64_t bytes() const { return bytes_.empty() ? 0 : bytes_.back(); }

  /// Several threads may call at the same time.
  BatchRecord record(std::size_t index) const;

  /// Shard `i` of `shards`. Shards have about the same number of bytes, follow one another and together hold all
  /// records. A shard may be empty.
  ShardRange shard(std::size_t i, std::size_t shards) const;

 private:
  void require_next(const BatchRecord& record, const std::string& id_before) const;
  std::size_t records_before(std::size_t i, std::size_t shards) const;

  std::string path_, sha256_;
  BatchHeader head_;
  std::uint64_t head_end_ = 0;
  std::vector<std::uint64_t> ends_;   // end of the line of each record in the file
  std::vector<std::uint64_t> bytes_;  // total size up to and including each record
  int descriptor_ = -1;
};

inline constexpr std::size_t kMaxShards = 100000;

}  // namespace percuss::batch
