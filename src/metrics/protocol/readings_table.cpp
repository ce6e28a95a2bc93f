#include "metrics/protocol/readings_table.hpp"

#include <fmt/format.h>

#include <set>

#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"

namespace percuss::metrics {
namespace {

constexpr std::size_t kMaxRows = 2000, kMaxText = 80, kMaxTimes = 10'000, kRings = 7;
constexpr double kMinBatLength_in = 12, kMaxReading = 1e6;
constexpr double kMinReading = 1e-9;

void read_passed(StrictObject& row, ReadingsRow& out) {
  for (const std::string& column : copied_columns()) {
    if (!row.has(column)) continue;
    if (column.ends_with("_hz")) {
      double freq_Hz = 0;
      row.read_within(column, kMinReading, kMaxReading, freq_Hz);
      out.properties[column] = fmt::format("{}", freq_Hz);
    } else {
      row.read(column, out.properties[column]);
      if (out.properties[column].size() > kMaxText) row.fail("more than 80 characters", column, "give a shorter text");
    }
  }
}

void read_lists(StrictObject& row, LabReadings& r) {
  const auto read = [&](const char* key, std::size_t most, std::vector<double>& to) {
    row.read(key, to);
    if (to.size() > most) row.fail(fmt::format("more than {} values", most), key, "give fewer");
  };
  read("period_s", kMaxTimes, r.periods_s);
  read("gate_times_s", kMaxTimes, r.crossings_s);
  read("diameter_in", kRings, r.diameters_in);
  for (const double diameter_in : r.diameters_in) {
    if (!(diameter_in > 0)) row.fail("a diameter of 0 or less", "diameter_in", "give inches");
  }
}

// Where the row holds one of several alternative readings, the alternatives from `common` do not count.
void drop_replaced(StrictObject& row, LabReadings& r) {
  const auto any = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
      if (row.has(key)) return true;
    }
    return false;
  };
  if (any({"moi_oz_in2", "period_s", "gate_times_s"})) {
    r.moi_ozin2.reset();
    r.periods_s.clear();
    r.crossings_s.clear();
  }
  if (any({"besr", "bbcor", "v_out_mph"})) {
    r.besr.reset();
    r.bbcor.reset();
    r.out_mph.reset();
  }
}

ReadingsRow read_row(StrictObject& row, const LabReadings& common) {
  ReadingsRow out{.place = row.place(), .id = {}, .properties = {}, .readings = common};
  row.need("id");
  row.read("id", out.id);
  if (out.id.empty() || out.id.size() > kMaxText)
    row.fail("an id that is empty or longer than 80 characters", "id", "give the bat's id");
  read_passed(row, out);
  LabReadings& r = out.readings;
  drop_replaced(row, r);
  row.read_within("length_in", kMinBatLength_in + kMinReading, kMaxReading, r.length_in);
  for (const auto& [key, to] : {std::pair{"weight_oz", &r.weight_oz},
                                {"cg_in", &r.cg_in},
                                {"moi_oz_in2", &r.moi_ozin2},
                                {"ball_g", &r.ball_g},
                                {"v_in_mph", &r.in_mph},
                                {"v_swing_mph", &r.swing_mph},
                                {"handle_diameter_in", &r.handle_diameter_in}})
    row.read_within(key, kMinReading, kMaxReading, *to);
  row.read_within("z_in", 0, kMaxReading, r.z_in);
  for (const auto& [key, to] : {std::pair{"v_out_mph", &r.out_mph}, {"besr", &r.besr}, {"bbcor", &r.bbcor}})
    row.read_within(key, -kMaxReading, kMaxReading, *to);
  read_lists(row, r);
  return out;
}

}  // namespace

const std::vector<std::string>& copied_columns() {
  static const std::vector<std::string> columns{"bat",     "maker",       "model",       "material", "condition",
                                                "program", "bending1_hz", "bending2_hz", "hoop1_hz", "hoop2_hz"};
  return columns;
}

std::vector<ReadingsRow> parse_readings_table(std::string_view text, const std::string& where,
                                              const LabReadings& common) {
  std::vector<ReadingsRow> out;
  std::set<std::string> ids;
  const JsonText input{.text = text, .where = where, .options = {"metrics.example"}};
  const auto read = [&](StrictObject& o) {
    std::string schema = "percuss/metrics-table/1";
    o.read("schema", schema);
    if (schema != "percuss/metrics-table/1")
      o.fail("not a table of readings", "schema", "give percuss/metrics-table/1");
    o.need("bats");
    o.read_list("bats", [&](StrictObject& row) {
      if (out.size() == kMaxRows) o.fail("more than 2000 bats", "bats", "split the table");
      out.push_back(read_row(row, common));
      if (!ids.insert(out.back().id).second)
        row.fail("the id " + one_line(out.back().id, 40) + " is in two rows", "id", "give each bat and impact its own");
    });
  };
  looks_like_json(text) ? read_strict_json(input, read) : read_strict_table(input, "bats", read);
  if (out.empty()) throw InputError("no bats", where, "add a row per bat", {"metrics.example"});
  return out;
}

std::string readings_table_example() {
  return "id,material,length_in,weight_oz,cg_in,period_s,ball_g,z_in,v_in_mph,v_out_mph\n"
         "W1,wood,33,30.5,11.4,1.388 1.389,145.4,6,136,24.5\n"
         "W2,wood,34,31.6,11.9,1.402 1.402,145.4,6,136,26.4\n"
         "A1,aluminum,33,30.1,12.6,1.371 1.372,145.4,6,136,28.6\n";
}

}  // namespace percuss::metrics
