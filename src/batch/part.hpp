#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "batch/manifest.hpp"

namespace percuss::batch {

// The files of a shard in the folder of results:
//   part-3.partial   the journal of a running shard (journal.hpp)
//   part-3.jsonl     the rows of a finished shard, ordered by id
//   part-3.ok        the label, size and digest of part-3.jsonl; written last
std::string part_path(const std::string& folder, std::size_t shard, const char* extension);

/// Identifies a shard, its batch and the way of analysing.
struct ShardLabel {
  std::string version;          // of percuss at the time of the analysis
  std::string manifest_sha256;  // of the plan
  std::string options_sha256;
  std::size_t shard = 0, shards = 1;

  bool operator==(const ShardLabel&) const = default;
};

ShardLabel label_of(const Manifest& manifest, std::size_t shard, std::size_t shards);

/// A finished shard: part-i.ok.
struct FinishedShard {
  ShardLabel label;
  std::size_t records = 0, failed = 0;
  std::uint64_t bytes = 0;  // of part-i.jsonl
  std::string sha256;       // of part-i.jsonl
};

/// The first line of part-i.partial and of part-i.jsonl, without its line end.
std::string label_line(const ShardLabel& label);
/// The content of part-i.ok, without a line end.
std::string finished_line(const FinishedShard& part);

/// Nothing when part-i.ok is absent. errors  InputError: the file is invalid
std::optional<FinishedShard> finished_part(const std::string& folder, std::size_t shard);
ShardLabel parse_label(std::string_view line, const std::string& where);
FinishedShard parse_finished(std::string_view text, const std::string& where);

/// The number of shards of the results in a folder; nothing for a folder without results.
std::optional<std::size_t> shard_count_in(const std::string& folder);

/// errors  InputError: `found` is of another shard, plan or version of percuss than `wanted`, or of other options
void require_same_shard(const ShardLabel& found, const ShardLabel& wanted, const std::string& path);

}  // namespace percuss::batch
