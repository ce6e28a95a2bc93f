#include "metrics/protocol/abi_log.hpp"

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/strict_json.hpp"
#include "metrics/protocol/averages.hpp"
#include "metrics/protocol/performance.hpp"

namespace percuss::metrics {
namespace {

constexpr std::uint64_t kMaxLog_bytes = std::uint64_t{1} << 20U;
constexpr std::size_t kMaxEntries = 10'000;
constexpr double kLoadFrame_lbf = 1000;

constexpr double kMinDisplacement_in = 0.001, kMaxDisplacement_in = 0.1;

AbiEntry read_abi_entry(StrictObject& o) {
  AbiEntry entry{.place = o.place(), .what = AbiCompression{}};
  std::string kind;
  o.need("do");
  o.read("do", kind);
  if (kind == "compression") {
    AbiCompression compression;
    o.need("force_lbf");
    o.read("force_lbf", compression.force_lbf);
    if (compression.force_lbf.size() != 4)
      o.fail("not four forces", "force_lbf", "give the forces at 0, 90, 45 and -45 degrees");
    for (const double force : compression.force_lbf) {
      if (!(force > 0 && force <= kLoadFrame_lbf))
        o.fail("a force outside the range of the load frame", "force_lbf", "give more than 0 lbf, at most 1000 lbf");
    }
    o.read_within("displacement_in", kMinDisplacement_in, kMaxDisplacement_in, compression.displacement_in);
    entry.what = compression;
  } else if (kind == "roll") {
    AbiRoll roll;
    o.need("depth_in");
    o.read_within("depth_in", 0, 10, roll.depth_in);
    entry.what = roll;
  } else if (kind == "performance") {
    AbiPerformance test;
    o.need("value");
    o.read_within("value", 0, 2, test.value);
    o.read("damage", test.damage);
    o.read("broken", test.broken);
    o.read_within("hoop_hz", 1, 1e6, test.hoop_Hz);
    o.read_within("z_in", 0, 20, test.z_in);
    o.read("id", test.id);
    if (test.id.size() > 80) o.fail("an id of more than 80 characters", "id", "give a shorter one");
    entry.what = test;
  } else {
    o.fail("\"" + one_line(kind, 40) + "\" is not a step", "do", "give compression, roll or performance");
  }
  return entry;
}

void read_abi_document(StrictObject& o, AbiLog& log) {
  std::string schema = "percuss/abi-log/1", metric = "besr";
  o.read("schema", schema);
  if (schema != "percuss/abi-log/1") o.fail("not a log of a break-in", "schema", "give percuss/abi-log/1");
  for (const char* key : {"bat", "entries"}) o.need(key);
  o.read_part("bat", [&](StrictObject& bat) {
    bat.need("id");
    bat.read("id", log.bat);
    bat.read("material", log.material);
    bat.read_within("length_in", 20, 50, log.length_in);
    bat.read_within("moi_oz_in2", 1, 1e6, log.moi_ozin2);
  });
  o.read("metric", metric);
  if (metric != "besr" && metric != "bbcor") o.fail("no such metric", "metric", "give besr or bbcor");
  log.bbcor = metric == "bbcor";
  o.read_within("limit", 0, kMaxLimit, log.limit);
  o.read_within("displacement_in", kMinDisplacement_in, kMaxDisplacement_in, log.displacement_in);
  o.read("continued_after_failure", log.continued);
  o.read_list("entries", [&](StrictObject& entry) {
    if (log.entries.size() == kMaxEntries) o.fail("more than 10000 entries", "entries", "keep one bat per log");
    log.entries.push_back(read_abi_entry(entry));
  });
}

}  // namespace

double AbiCompression::mean_lbf() const { return mean_of(force_lbf); }

AbiLog parse_abi_log(std::string_view text, const std::string& where) {
  AbiLog log;
  read_strict_json({.text = text, .where = where, .options = {"abi.example"}},
                   [&](StrictObject& o) { read_abi_document(o, log); });
  return log;
}

AbiLog read_abi_log(const std::string& path) {
  return parse_abi_log(read_input(path, kMaxLog_bytes).view(), input_name(path));
}

std::string abi_log_example() {
  return R"({
  "schema": "percuss/abi-log/1",
  "bat": {"id": "AS333", "material": "composite"},
  // The metric, besr or bbcor, and its limit, which the bat must not exceed.
  "metric": "besr",
  "limit": 0.728,
  // The displacement of every compression. Where the force exceeds the load cell, a smaller one is permitted,
  // such as 0.025 in.
  "displacement_in": 0.03,
  // The steps in the order of testing. A compression holds the forces in lbf at 0, 90, 45 and -45 degrees, a roll the
  // depth of the rollers in inches. A performance test holds the value at its best location. Optional: "damage" and
  // "broken" (true or false), "hoop_hz" (first hoop frequency before the test), "z_in" (the location), and "id" (of
  // this state of the bat in a study).
  "entries": [
    {"do": "compression", "force_lbf": [612, 604, 598, 606]},
    {"do": "performance", "value": 0.7138, "damage": false, "hoop_hz": 1970},
    {"do": "compression", "force_lbf": [601, 590, 588, 597]},
    {"do": "roll", "depth_in": 0.1},
    {"do": "compression", "force_lbf": [588, 580, 571, 585]},
    {"do": "roll", "depth_in": 0.1125},
    {"do": "compression", "force_lbf": [566, 560, 551, 563]},
    {"do": "performance", "value": 0.7195, "hoop_hz": 1880}
  ]
}
)";
}

}  // namespace percuss::metrics
