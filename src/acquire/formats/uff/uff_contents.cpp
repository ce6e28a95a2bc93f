#include "acquire/formats/uff/uff_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "acquire/formats/uff/uff_nodes.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr int kFactorColumns = 25;

[[noreturn]] void refuse_set(const UffSet& set, const FileBytes& file, std::string_view at, const char* what) {
  throw InputError(fmt::format("data set {}: {}", set.number, what), uff_location(file, at), "export the file again");
}

UffUnits parse_units(const UffSet& set, const FileBytes& file) {
  std::string_view rest = set.text;
  take_uff_line(rest);
  const std::string_view line = take_uff_line(rest);
  UffFields fields(line);
  const auto length = fields.number(kFactorColumns), force = fields.number(kFactorColumns);
  const auto usable = [](const std::optional<double>& x) { return x && std::isfinite(*x) && *x > 0; };
  if (!usable(length) || !usable(force)) refuse_set(set, file, set.text, "cannot read the units' factors");
  return {.length = *length, .force = *force};
}

}  // namespace

UffContents read_uff_contents(const FileBytes& file) {
  UffContents out;
  const std::vector<UffSet> sets = split_uff(file);
  for (const UffSet& set : sets) {
    ++out.sets[set.number];
    if (set.number == 58) out.functions.push_back(parse_uff_function(set, file));
    if (set.number == 164) out.units = parse_units(set, file);
    if (set.number == 55 || set.number == 2414) ++out.shapes;
  }
  out.connections = read_uff_trace_lines(sets, file);
  UffNodes nodes = read_uff_nodes(sets, file, out.units.value_or(UffUnits{}).length);
  out.nodes_m = std::move(nodes.nodes_m);
  out.axes = std::move(nodes.axes);
  out.nodes_left_out = nodes.left_out;
  return out;
}

std::vector<Message> uff_notes(const UffContents& contents) {
  static const std::set<int> kRead{15, 18, 55, 58, 82, 151, 164, 2411, 2412, 2414, 2420};
  std::vector<Message> notes;
  std::string unused;
  for (const auto& [number, count] : contents.sets) {
    if (!kRead.contains(number)) unused += fmt::format("{}{} ({})", unused.empty() ? "" : ", ", number, count);
  }
  const UffTraceLines& connections = contents.connections;
  if (contents.nodes_left_out > 0) {
    notes.emplace_back(
        fmt::format("nodes in coordinate systems of data set 2420: {}, not used; export them in global "
                    "coordinates",
                    contents.nodes_left_out));
  }
  if (!connections.lines.empty() && contents.nodes_m.empty()) notes.emplace_back("lines without nodes are not used");
  if (!connections.unreadable.empty()) notes.emplace_back("not used: " + connections.unreadable);
  if (connections.other_elements > 0)
    notes.push_back(information(fmt::format("elements of other kinds: {}, not used", connections.other_elements)));
  if (contents.shapes > 0) notes.push_back(information(fmt::format("mode shapes: {}, not used", contents.shapes)));
  if (!unused.empty()) notes.push_back(information("data sets not used: " + unused));
  return notes;
}

std::vector<std::vector<double>> uff_geometry(const UffContents& contents, int offset, std::vector<Message>& notes) {
  if (contents.nodes_m.empty()) return {};
  const auto last = static_cast<std::int64_t>(contents.nodes_m.rbegin()->first) - offset;
  const auto most = static_cast<std::int64_t>(max_points(contents.nodes_m.size()));
  if (contents.nodes_m.begin()->first < offset || last > most) {
    notes.emplace_back("the geometry is not used: its nodes are numbered too far apart");
    return {};
  }
  std::vector<std::vector<double>> out(static_cast<std::size_t>(last) + 1,
                                       std::vector<double>(3, std::numeric_limits<double>::quiet_NaN()));
  for (const auto& [node, place] : contents.nodes_m)
    out[static_cast<std::size_t>(node - offset)].assign(place.begin(), place.end());
  return out;
}

std::vector<TraceLine> uff_trace_lines(const UffContents& contents, int offset) {
  std::vector<TraceLine> out;
  for (const auto& [from, to] : contents.connections.lines) {
    if (contents.nodes_m.contains(from) && contents.nodes_m.contains(to)) out.push_back({from - offset, to - offset});
  }
  return out;
}

std::vector<TraceFace> uff_trace_faces(const UffContents& contents, int offset) {
  std::vector<TraceFace> out;
  for (TraceFace face : contents.connections.faces) {
    const std::set<int> corners(face.begin(), face.end());
    if (corners.size() != face.size()) continue;
    if (!std::all_of(face.begin(), face.end(), [&](int node) { return contents.nodes_m.contains(node); })) continue;
    for (int& node : face) node -= offset;
    out.push_back(std::move(face));
  }
  return out;
}

}  // namespace percuss::acquire
