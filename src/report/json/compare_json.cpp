#include "report/json/compare_json.hpp"

#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json family_json(const metrics::ComparedMode& mode) { return mode.family.empty() ? Json() : Json(mode.family); }
Json order_json(const metrics::ComparedMode& mode) { return mode.order > 0 ? Json(mode.order) : Json(); }

Json pairs_json(const Comparison& c) {
  Json pairs = Json::array();
  for (const metrics::ModePair& pair : c.modes.pairs) {
    const metrics::ComparedMode &a = c.a.modes[pair.a], &b = c.b.modes[pair.b];
    pairs.push_back({{"a", pair.a},
                     {"b", pair.b},
                     {"frequency_a_hz", a.freq_Hz},
                     {"frequency_b_hz", b.freq_Hz},
                     {"difference_percent", pair.difference_percent},
                     {"difference_std_percent", or_null(pair.difference_std_percent)},
                     {"damping_ratio_a", or_null(a.damping_ratio)},
                     {"damping_ratio_b", or_null(b.damping_ratio)},
                     {"damping_difference_percent", or_null(pair.damping_difference_percent)},
                     {"damping_difference_std_percent", or_null(pair.damping_difference_std_percent)},
                     {"mac", pair.mac ? Json(pair.mac->value) : Json()},
                     {"paired_by", name_of(pair.by)},
                     {"exchangeable_a", pair.exchangeable_a},
                     {"family_a", family_json(a)},
                     {"order_a", order_json(a)},
                     {"family_b", family_json(b)},
                     {"order_b", order_json(b)}});
  }
  return pairs;
}

Json unpaired_json(const metrics::ComparedDocument& document, const std::vector<std::size_t>& modes) {
  Json list = Json::array();
  for (const std::size_t m : modes) {
    const metrics::ComparedMode& mode = document.modes[m];
    list.push_back(
        {{"index", m}, {"frequency_hz", mode.freq_Hz}, {"family", family_json(mode)}, {"order", order_json(mode)}});
  }
  return list;
}

Json distant_json(const Comparison& c) {
  Json list = Json::array();
  for (const metrics::DistantPair& pair : c.distant) {
    list.push_back({{"a", pair.a},
                    {"b", pair.b},
                    {"frequency_a_hz", c.a.modes[pair.a].freq_Hz},
                    {"frequency_b_hz", c.b.modes[pair.b].freq_Hz},
                    {"difference_percent", 100 * pair.difference},
                    {"mac", pair.mac.value},
                    {"furthest_percent", 100 * pair.furthest}});
  }
  return list;
}

Json deflections_json(const Comparison& c) {
  Json list = Json::array();
  for (const metrics::DeflectionPair& pair : c.deflections) {
    list.push_back({{"point", or_null(pair.point)},
                    {"position_m", or_null(pair.position_m)},
                    {"peak_a_m", pair.a_m},
                    {"peak_b_m", pair.b_m},
                    {"ratio", pair.ratio},
                    {"ratio_std", pair.ratio_std}});
  }
  return list;
}

Json doubted_json(const std::vector<metrics::DoubtedOrders>& doubted) {
  Json list = Json::array();
  for (const metrics::DoubtedOrders& one : doubted) list.push_back({{"family", one.family}, {"from_order", one.from}});
  return list;
}

// How the points of the shapes were matched; null where a document has no shapes.
Json places_json(const metrics::CommonPlaces& places) {
  if (places.points_a == 0 || places.points_b == 0) return {};
  return {{"matched_by", name_of(places.by)},
          {"common", places.of_b.size()},
          {"points_a", places.points_a},
          {"points_b", places.points_b},
          {"coordinates_differ", places.coordinates_differ}};
}

Json comparison_json(const Comparison& c) {
  const bool inverted = c.a.model && !c.b.model;
  return {{"places", places_json(c.places)},
          {"pairs", pairs_json(c)},
          {"unpaired_a", unpaired_json(c.a, c.modes.unpaired_a)},
          {"unpaired_b", unpaired_json(c.b, c.modes.unpaired_b)},
          {"doubted_orders", doubted_json(c.modes.doubted_orders)},
          {"distant_pairs", distant_json(c)},
          {"deflections", deflections_json(c)},
          {"ratio", inverted ? "a/b" : "b/a"}};
}

}  // namespace

std::string compare_json(const std::vector<metrics::ComparedDocument>& documents,
                         const std::vector<Comparison>& comparisons) {
  Json json{{"schema", "percuss/compare/1"}, {"version", version()}, {"documents", Json::array()}};
  for (const metrics::ComparedDocument& document : documents)
    json["documents"].push_back({{"path", document.name}, {"schema", document.schema}});
  json.update(comparison_json(comparisons.front()));
  json["others"] = Json::array();
  for (std::size_t i = 1; i < comparisons.size(); ++i) {
    Json other{{"document", i + 1}};
    other.update(comparison_json(comparisons[i]));
    json["others"].push_back(std::move(other));
  }
  return indented_text(json) + "\n";
}

}  // namespace percuss::report
