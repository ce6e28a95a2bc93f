#include "metrics/study/study_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/strict_json.hpp"
#include "metrics/study/batch_columns.hpp"

namespace percuss::metrics {
namespace {

using Json = nlohmann::json;

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

// The rows of a record are adjacent, so only the last bat can have the id.
BatProperties& bat_named(std::vector<BatProperties>& bats, const std::string& id) {
  if (bats.empty() || bats.back().at("id") != id) bats.push_back({{"id", id}});
  return bats.back();
}

void take_row(StrictObject& row, std::vector<BatProperties>& bats) {
  for (const std::string& column : batch_columns()) row.has(column);  // marks the column as known
  std::string kind, id, family;
  std::size_t order = 0;
  double freq_Hz = 0;
  row.read("row", kind);
  row.read("id", id);
  row.read("family", family);
  row.read("order", order);
  row.read("frequency_hz", freq_Hz);
  if (kind != "mode") return;
  BatProperties& bat = bat_named(bats, id);
  add_frequency(bat, family, static_cast<std::int64_t>(order), freq_Hz);
  if (order == 0) bat.emplace(kWithoutFamily, "");
}

void take_line(const Json& row, std::vector<BatProperties>& bats) {
  if (row.at("row") != "mode") return;
  BatProperties& bat = bat_named(bats, row.at("id").get<std::string>());
  const Json& order = row.at("order");
  if (order.is_null()) {
    bat.emplace(kWithoutFamily, "");
    return;
  }
  add_frequency(bat, row.at("family").get<std::string>(), order.get<std::int64_t>(),
                row.at("frequency_hz").get<double>());
}

std::vector<BatProperties> bats_of_lines(std::string_view text, const std::string& where) {
  constexpr int kRowDepth = 2;
  constexpr std::array<std::string_view, 5> kWanted{"row", "id", "order", "family", "frequency_hz"};
  std::vector<BatProperties> bats;
  std::size_t number = 1;
  for (text.remove_prefix(std::min(first_line(text).size() + 1, text.size())); !text.empty(); ++number) {
    const std::string_view line = first_line(text);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    try {
      take_line(
          parse_json<nlohmann::json>({.text = line, .where = where, .remedy = "", .max_depth = kRowDepth}, kWanted),
          bats);
    } catch (const std::exception&) {
      throw InputError("not a row of a batch", fmt::format("{}, line {}", where, number + 1), "merge the batch again");
    }
  }
  return bats;
}

// Frequencies of other modes of a bat remove the mark.
std::vector<BatProperties> marked(std::vector<BatProperties> bats) {
  for (BatProperties& bat : bats) {
    if (bat.size() > 2) bat.erase(kWithoutFamily);  // more than this and the id
  }
  return bats;
}

}  // namespace

void add_frequency(BatProperties& bat, const std::string& family, std::int64_t order, double freq_Hz) {
  const std::string column = fmt::format("{}{}_hz", family, order);
  const auto& known = study_columns();
  if (std::find(known.begin(), known.end(), column) != known.end()) bat.emplace(column, fmt::format("{}", freq_Hz));
}

bool holds_batch(std::string_view text) {
  const std::string_view line = first_line(text);
  if (line.starts_with("row,id,")) return true;
  if (!line.starts_with('{')) return false;
  constexpr std::array<std::string_view, 1> kWanted{"schema"};
  const Json head = json_if_valid<nlohmann::json>(line, kWanted);
  const auto schema = head.is_object() ? head.find("schema") : head.end();
  return head.is_object() && schema != head.end() && *schema == kBatchSchema;
}

std::vector<BatProperties> batch_bats(std::string_view text, const std::string& where) {
  if (text.starts_with('{')) return marked(bats_of_lines(text, where));
  std::vector<BatProperties> bats;
  read_strict_table({.text = text, .where = where, .remedy = "merge the batch again"}, "rows",
                    [&](StrictObject& o) { o.read_list("rows", [&](StrictObject& row) { take_row(row, bats); }); });
  return marked(std::move(bats));
}

}  // namespace percuss::metrics
