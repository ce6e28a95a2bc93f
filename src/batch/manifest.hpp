#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace percuss::batch {

/// One record of a batch, as it was when the batch was planned.
struct BatchRecord {
  std::string id;    // its rows are ordered by it
  std::string path;  // absolute, or from the manifest's folder
  std::uint64_t bytes = 0;
  std::string sha256{};  // of its bytes; empty: only their number is known
};

/// What holds for a whole batch: the first line of its manifest.
struct BatchHeader {
  std::string version;               // of the percuss that planned it
  std::vector<std::string> options;  // as percuss analyze takes them: "--band", "60:3200"
  std::string setup;                 // a channel set-up's text; empty: none
  bool frf = false;                  // FRFs are kept as well
  std::size_t shards = 1;            // as many as the batch is divided into unless somebody says otherwise
};

/// What tells one way of analysing from another: the SHA-256 of options, set-up and frf.
std::string options_sha256(const BatchHeader& head);

/// Writes a manifest: the head, then a line of JSON per record (docs/schema/batch-manifest.schema.json). `records` are
/// ordered by id, which are distinct. The file is whole or absent. errors  InputError as AtomicFile.
void write_manifest(const std::string& path, const BatchHeader& head, const std::vector<BatchRecord>& records,
                    bool force);

/// Records first … last − 1 of a manifest.
struct ShardRange {
  std::size_t first = 0, last = 0;
  std::size_t size() const { return last - first; }
};

/// A manifest that was read and found in order. Its records stay in the file until they are asked for: 16 bytes of
/// memory for each.
class Manifest {
 public:
  /// errors  InputError naming the line: not a manifest, records out of order or named twice, lines too long, another
  /// count of records than the head says.
  explicit Manifest(std::string path);
  ~Manifest();
  Manifest(const Manifest&) = delete;
  Manifest& operator=(const Manifest&) = delete;

  const std::string& path() const { return path_; }
  const BatchHeader& head() const { return head_; }
  const std::string& sha256() const { return sha256_; }  // of its lines
  std::size_t size() const { return ends_.size(); }
  std::uint64_t bytes() const { return bytes_.empty() ? 0 : bytes_.back(); }

  /// Several threads may call at once.
  BatchRecord record(std::size_t index) const;

  /// Shard `i` of `shards`, of about as many bytes as the others; all shards together are all records, in order. One
  /// may be empty.
  ShardRange shard(std::size_t i, std::size_t shards) const;

 private:
  void require_next(const BatchRecord& record, const std::string& id_before) const;
  std::size_t records_before(std::size_t i, std::size_t shards) const;

  std::string path_, sha256_;
  BatchHeader head_;
  std::uint64_t head_end_ = 0;
  std::vector<std::uint64_t> ends_;   // of each record's line in the file
  std::vector<std::uint64_t> bytes_;  // of all records up to and with each
  int descriptor_ = -1;
};

inline constexpr std::size_t kMaxShards = 100000;

}  // namespace percuss::batch
