#include "batch/manifest.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "batch/line_reader.hpp"
#include "batch/sha256_file.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kManifestSchema = "percuss/batch-manifest/1";
constexpr const char* kPlanAgain = "plan the batch again";
constexpr std::size_t kLongestEntry_bytes = std::size_t{4} << 20U;  // the first line may hold a channel set-up
constexpr std::size_t kLongestId_bytes = 4096;                      // the longest path
constexpr std::size_t kMaxRecords = 20'000'000;

Json head_json(const BatchHeader& head, std::size_t records, std::uint64_t bytes) {
  Json json{{"schema", kManifestSchema}, {"version", head.version}, {"records", records}, {"bytes", bytes}};
  json["shards"] = head.shards;
  json["frf"] = head.frf;
  json["options"] = head.options;
  if (!head.setup.empty()) json["setup"] = head.setup;
  json["options_sha256"] = options_sha256(head);
  return json;
}

Json record_json(const BatchRecord& record) {
  Json json{{"id", record.id}, {"path", record.path}, {"bytes", record.bytes}};
  if (!record.sha256.empty()) json["sha256"] = record.sha256;
  return json;
}

JsonText line_text(std::string_view line, const std::string& path, std::size_t number) {
  return {.text = line, .where = fmt::format("{}, line {}", path, number), .remedy = kPlanAgain};
}

void require_name(const StrictObject& o, const std::string& text, const char* key) {
  const bool fits = !text.empty() && text.size() <= kLongestId_bytes && text.find('\0') == std::string::npos;
  if (!fits) o.fail("empty, too long or not a name", key, kPlanAgain);
}

BatchHeader parse_head(const JsonText& text, std::size_t& records) {
  BatchHeader head;
  read_strict_json(text, [&](StrictObject& o) {
    std::string schema, digest;
    std::size_t bytes = 0;
    for (const char* key : {"schema", "version", "records", "shards", "options", "options_sha256"}) o.need(key);
    o.read("schema", schema);
    if (schema != kManifestSchema)
      o.fail("not the manifest of a batch", "schema", "give the manifest of a planned batch");
    o.read("version", head.version);
    o.read("records", records);
    o.read("bytes", bytes);
    o.read("shards", head.shards);
    if (head.shards < 1 || head.shards > kMaxShards)
      o.fail("out of range", "shards", fmt::format("give 1 to {}", kMaxShards));
    o.read("frf", head.frf);
    o.read("options", head.options);
    o.read("setup", head.setup);
    o.read("options_sha256", digest);
    if (digest != options_sha256(head)) o.fail("does not match the options", "options_sha256", kPlanAgain);
  });
  return head;
}

BatchRecord parse_record(const JsonText& text) {
  BatchRecord record;
  read_strict_json(text, [&](StrictObject& o) {
    for (const char* key : {"id", "path", "bytes"}) o.need(key);
    o.read("id", record.id);
    require_name(o, record.id, "id");
    o.read("path", record.path);
    require_name(o, record.path, "path");
    std::size_t bytes = 0;
    o.read("bytes", bytes);
    record.bytes = bytes;
    o.read("sha256", record.sha256);
  });
  return record;
}

}  // namespace

std::string options_sha256(const BatchHeader& head) {
  return report::hexadecimal(report::sha256(Json{head.options, head.setup, head.frf}.dump()));
}

void write_manifest(const std::string& path, const BatchHeader& head, const std::vector<BatchRecord>& records,
                    bool force) {
  std::uint64_t bytes = 0;
  for (const BatchRecord& record : records) bytes += record.bytes;
  Sha256File file(path, force);
  file.add(head_json(head, records.size(), bytes).dump() + "\n");
  for (const BatchRecord& record : records) file.add(record_json(record).dump() + "\n");
  file.commit();
}

Manifest::Manifest(std::string path) : path_(std::move(path)) {
  LineReader lines(path_, kLongestEntry_bytes);
  if (!lines.next()) throw InputError("the file is empty", path_, "give the manifest of a planned batch");
  std::size_t records = 0;
  head_ = parse_head(line_text(lines.line(), path_, 1), records);
  if (records > kMaxRecords) throw InputError("more than 20 million records", path_, "plan several batches");
  head_end_ = lines.end();
  report::Digest digest;
  digest.add(lines.line());
  std::string id;
  while (ends_.size() <= records && lines.next()) {
    const BatchRecord record = parse_record(line_text(lines.line(), path_, lines.number()));
    require_next(record, id);
    id = record.id;
    digest.add("\n");
    digest.add(lines.line());
    bytes_.push_back(bytes() + record.bytes);
    ends_.push_back(lines.end());
  }
  if (ends_.size() != records) {
    throw InputError(fmt::format("{} records where the first line says {}", ends_.size(), records), path_,
                     "the file is incomplete: copy it again, or plan the batch again");
  }
  sha256_ = report::hexadecimal(digest.result());
  std::uint64_t size_bytes = 0;
  descriptor_ = open_regular_file(path_, std::numeric_limits<std::uint64_t>::max(), size_bytes);
}

// Checks that the ids ascend and that the sum of the sizes cannot overflow.
void Manifest::require_next(const BatchRecord& record, const std::string& id_before) const {
  const std::string where = fmt::format("{}, line {}", path_, ends_.size() + 2);
  if (!id_before.empty() && record.id <= id_before) {
    throw InputError(fmt::format("record \"{}\" is out of order or named twice", one_line(record.id, 80)), where,
                     kPlanAgain);
  }
  if (record.bytes > std::numeric_limits<std::uint64_t>::max() / kMaxRecords)
    throw InputError("the size of a record is impossible", where, kPlanAgain);
}

Manifest::~Manifest() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

BatchRecord Manifest::record(std::size_t index) const {
  const std::uint64_t begin = index == 0 ? head_end_ : ends_[index - 1];
  const std::string line = bytes_at(descriptor_, begin, static_cast<std::size_t>(ends_[index] - begin), path_);
  return parse_record(line_text(line, path_, index + 2));
}

// Counts the records whose middle byte lies before the boundary. Boundaries rise with i, so the shards do not overlap.
std::size_t Manifest::records_before(std::size_t i, std::size_t shards) const {
  const double boundary = static_cast<double>(bytes()) / static_cast<double>(shards) * static_cast<double>(i);
  if (i == shards || bytes() == 0) return size() * i / shards;
  std::size_t low = 0, high = size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const std::uint64_t before = middle == 0 ? 0 : bytes_[middle - 1];
    const double centre = (static_cast<double>(before) + static_cast<double>(bytes_[middle])) / 2;
    if (centre < boundary) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

ShardRange Manifest::shard(std::size_t i, std::size_t shards) const {
  return {.first = records_before(i, shards), .end = records_before(i + 1, shards)};
}

}  // namespace percuss::batch
