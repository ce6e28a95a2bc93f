#include "batch/part.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "batch/part_file.hpp"
#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"
#include "report/text/version.hpp"

namespace percuss::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kPartSchema = "percuss/batch-part/1";
constexpr std::size_t kLongestLabel_bytes = 4096;

Json label_json(const ShardLabel& label) {
  return {{"schema", kPartSchema},
          {"version", label.version},
          {"manifest_sha256", label.manifest_sha256},
          {"options_sha256", label.options_sha256},
          {"shard", label.shard},
          {"shards", label.shards}};
}

JsonText strict_text(std::string_view text, const std::string& where) {
  return {.text = text, .where = where, .remedy = "run the batch again"};
}

ShardLabel read_label(StrictObject& o) {
  ShardLabel label;
  for (const char* key : {"schema", "version", "manifest_sha256", "options_sha256", "shard", "shards"}) o.need(key);
  std::string schema;
  o.read("schema", schema);
  if (schema != kPartSchema) o.fail("not a part of a batch", "schema", "name another folder for the results");
  o.read("version", label.version);
  o.read("manifest_sha256", label.manifest_sha256);
  o.read("options_sha256", label.options_sha256);
  o.read("shard", label.shard);
  o.read("shards", label.shards);
  if (label.shards < 1 || label.shards > kMaxShards || label.shard >= label.shards)
    o.fail("out of range", "shards", "run the shard again", {"batch.run.force"});
  return label;
}

bool is_shard_name(const std::string& stem) {
  constexpr std::string_view kStart = "part-";
  return stem.starts_with(kStart) && stem.size() > kStart.size() &&
         stem.find_first_not_of("0123456789", kStart.size()) == std::string::npos;
}

// The number of shards in the label of a file; nothing for a file without a complete label.
std::optional<std::size_t> shards_of_label(const fs::path& path) {
  const std::string kind = path.extension().string();
  if (!is_shard_name(path.stem().string()) || (kind != ".ok" && kind != ".partial")) return std::nullopt;
  const PartFile file = PartFile::existing(path.string());
  if (!file.present()) return std::nullopt;  // another process removed it
  const std::string head = file.first_bytes(kLongestLabel_bytes);
  if (kind == ".ok") return parse_finished(head, path.string()).label.shards;
  const std::size_t end = head.find('\n');
  if (end == std::string::npos) return std::nullopt;
  return parse_label(std::string_view(head).substr(0, end), path.string()).shards;
}

}  // namespace

std::string part_path(const std::string& folder, std::size_t shard, const char* extension) {
  return fmt::format("{}/part-{}.{}", folder, shard, extension);
}

ShardLabel label_of(const Manifest& manifest, std::size_t shard, std::size_t shards) {
  return {.version = report::version(),
          .manifest_sha256 = manifest.sha256(),
          .options_sha256 = options_sha256(manifest.head()),
          .shard = shard,
          .shards = shards};
}

std::string label_line(const ShardLabel& label) { return label_json(label).dump(); }

std::string finished_line(const FinishedShard& part) {
  Json json = label_json(part.label);
  json["records"] = part.records;
  json["failed"] = part.failed;
  json["bytes"] = part.bytes;
  json["sha256"] = part.sha256;
  return json.dump();
}

ShardLabel parse_label(std::string_view line, const std::string& where) {
  ShardLabel label;
  read_strict_json(strict_text(line, where), [&](StrictObject& o) { label = read_label(o); });
  return label;
}

FinishedShard parse_finished(std::string_view text, const std::string& where) {
  FinishedShard part;
  read_strict_json(strict_text(text, where), [&](StrictObject& o) {
    part.label = read_label(o);
    for (const char* key : {"records", "failed", "bytes", "sha256"}) o.need(key);
    o.read("records", part.records);
    o.read("failed", part.failed);
    std::size_t bytes = 0;
    o.read("bytes", bytes);
    part.bytes = bytes;
    o.read("sha256", part.sha256);
  });
  return part;
}

std::optional<FinishedShard> finished_part(const std::string& folder, std::size_t shard) {
  const std::string path = part_path(folder, shard, "ok");
  const PartFile file = PartFile::existing(path);
  if (!file.present()) return std::nullopt;
  return parse_finished(file.first_bytes(kLongestLabel_bytes), path);
}

std::optional<std::size_t> shard_count_in(const std::string& folder) {
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) {
    if (const auto shards = shards_of_label(entry.path())) return shards;
  }
  return std::nullopt;
}

void require_same_shard(const ShardLabel& found, const ShardLabel& wanted, const std::string& path) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(problem, path, "name another folder for the results, or overwrite them", {"batch.run.force"});
  };
  if (found.shards != wanted.shards || found.shard != wanted.shard)
    refuse(fmt::format("shard {} of {}, not {} of {}", found.shard, found.shards, wanted.shard, wanted.shards));
  if (found.options_sha256 != wanted.options_sha256) refuse("made with options that differ from the manifest");
  if (found.manifest_sha256 != wanted.manifest_sha256) refuse("made from another manifest");
  if (found.version != wanted.version)
    refuse(fmt::format("made by percuss {}, not {}", one_line(found.version, 40), wanted.version));
}

}  // namespace percuss::batch
