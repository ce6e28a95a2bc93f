#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "batch/manifest.hpp"

namespace percuss::batch {

// A shard's files in the folder of results:
//   part-3.partial   its finished records so far, while it runs (journal.hpp)
//   part-3.jsonl     its rows, ordered by id, once all of its records are finished
//   part-3.ok        what part-3.jsonl must be: written last
std::string part_path(const std::string& folder, std::size_t shard, const char* extension);

/// Which part of which batch, made how.
struct ShardLabel {
  std::string version;          // of the percuss that analyses
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
  std::uint64_t bytes = 0;  // of part-i.jsonl …
  std::string sha256;       // … and their digest
};

/// The label as the first line of part-i.partial and, with counts, as all of part-i.ok; without a line's end.
std::string label_line(const ShardLabel& label);
std::string finished_line(const FinishedShard& part);

/// Nothing when there is no part-i.ok. errors  InputError: it is not one.
std::optional<FinishedShard> finished_part(const std::string& folder, std::size_t shard);
ShardLabel parse_label(std::string_view line, const std::string& where);
FinishedShard parse_finished(std::string_view text, const std::string& where);

/// Into how many shards the results in a folder are divided; nothing where there are none.
std::optional<std::size_t> shard_count_in(const std::string& folder);

/// InputError when a part in `folder` is of another plan, of other options, or of another version of percuss.
void require_same_shard(const ShardLabel& found, const ShardLabel& wanted, const std::string& path);

}  // namespace percuss::batch
