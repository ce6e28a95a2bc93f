#include "acquire/formats/uff/uff_trace_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kNodesPerLine = 8, kNodeWidth = 10, kMaxNodes = 250, kMaxCorners = 16;
constexpr int kColour = 11;

using Edges = std::span<const std::array<int, 2>>;
constexpr std::array<std::array<int, 2>, 6> kTetrahedron{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 2>, 9> kWedge{
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<std::array<int, 2>, 12> kBrick{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

// Elements have two lines. Beams have three: the second one states the orientation.
bool is_beam(std::int64_t kind) { return kind == 11 || (kind >= 21 && kind <= 24); }
// Plane stress and strain, plates, membranes, axisymmetric solids, thin shells: nodes go around.
bool is_face(std::int64_t kind) { return kind >= 41 && kind <= 96; }

Edges edges_of_solid(std::int64_t kind) {
  if (kind == 111) return kTetrahedron;
  if (kind == 112) return kWedge;
  if (kind == 115) return kBrick;
  return {};
}

class LineReader {
 public:
  explicit LineReader(const FileBytes& file) : file_(file) {}

  // Lines: number, count of nodes and colour; a name; nodes, eight per line.
  void trace_lines(const UffSet& set) {
    for_each_entry(set, [this](UffFields& fields, std::string_view head, std::string_view& rest) {
      const std::size_t count = node_count(fields, head);
      take_uff_line(rest);
      int last = 0;
      for (const int node : nodes(rest, count)) {
        if (last != 0 && node != 0) add(last, node);
        last = node;
      }
    });
  }

  // Lines: number, kind, three unused fields and the count of nodes; for beams their orientation; nodes.
  void elements(const UffSet& set) {
    for_each_entry(set, [this](UffFields& fields, std::string_view head, std::string_view& rest) {
      const int kind = whole_number(fields, head);
      fields.take(3 * kNodeWidth);
      const std::size_t count = node_count(fields, head);
      if (is_beam(kind)) take_uff_line(rest);
      element(kind, nodes(rest, count));
    });
  }

  void note_unreadable(const char* problem) {
    if (out_.unreadable.empty()) out_.unreadable = problem;
  }
  UffTraceLines result() { return std::move(out_); }

 private:
  // Calls take(fields, head, rest) for each entry of a set: `head` is the entry's first line, `fields` are the fields
  // of this line after the entry's number, `rest` are the lines after it.
  template <class Take>
  void for_each_entry(const UffSet& set, Take&& take) {
    std::string_view rest = set.text;
    while (!rest.empty()) {
      const std::string_view head = take_uff_line(rest);
      UffFields fields(head);
      if (fields.blank()) return;
      whole_number(fields, head);
      take(fields, head, rest);
    }
  }

  std::size_t node_count(UffFields& fields, std::string_view line) const {
    return static_cast<std::size_t>(std::max(0, whole_number(fields, line)));
  }

  int whole_number(UffFields& fields, std::string_view line) const {
    const auto value = fields.integer(kNodeWidth);
    if (value && *value >= std::numeric_limits<int>::min() / 2 && *value <= std::numeric_limits<int>::max() / 2)
      return static_cast<int>(*value);
    throw InputError("lines or elements: cannot read a whole number", uff_location(file_, line),
                     "export the file again");
  }

  std::vector<int> nodes(std::string_view& rest, std::size_t count) const {
    std::vector<int> out;
    while (out.size() < count && !rest.empty()) {
      const std::string_view line = take_uff_line(rest);
      UffFields fields(line);
      for (std::size_t i = 0; i < kNodesPerLine && out.size() < count; ++i) out.push_back(whole_number(fields, line));
    }
    return out;
  }

  void element(int kind, const std::vector<int>& nodes) {
    const Edges solid = edges_of_solid(kind);
    const std::size_t corners = kind == 111 ? 4 : kind == 112 ? 6 : 8;
    if (!solid.empty() && nodes.size() >= corners) {
      for (const auto& [from, to] : solid)
        add(nodes[static_cast<std::size_t>(from)], nodes[static_cast<std::size_t>(to)]);
    } else if ((is_beam(kind) || is_face(kind)) && nodes.size() >= 2) {
      for (std::size_t i = 1; i < nodes.size(); ++i) add(nodes[i - 1], nodes[i]);
      if (is_face(kind) && nodes.size() > 2) {
        add(nodes.back(), nodes.front());
        if (nodes.size() <= kMaxCorners) out_.faces.push_back(nodes);
      }
    } else {
      ++out_.other_elements;
    }
  }

  void add(int from, int to) {
    if (from != to && seen_.emplace(std::min(from, to), std::max(from, to)).second) out_.lines.push_back({from, to});
  }

  const FileBytes& file_;
  UffTraceLines out_;
  std::set<std::pair<int, int>> seen_;
};

}  // namespace

UffTraceLines read_uff_trace_lines(const std::vector<UffSet>& sets, const FileBytes& file) {
  LineReader reader(file);
  for (const UffSet& set : sets) {
    if (set.binary) continue;
    try {
      if (set.number == 82) reader.trace_lines(set);
      if (set.number == 2412) reader.elements(set);
    } catch (const InputError& problem) {
      reader.note_unreadable(problem.what());
    }
  }
  return reader.result();
}

std::vector<std::string> uff_trace_line_sets(const std::vector<TraceLine>& lines, int offset) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < lines.size();) {
    std::vector<int> path{lines[i][0], lines[i][1]};
    for (++i; i < lines.size() && lines[i][0] == path.back() && path.size() < kMaxNodes; ++i)
      path.push_back(lines[i][1]);
    std::string text = fmt::format("{:10}{:10}{:10}\nNONE", out.size() + 1, path.size(), kColour);
    for (std::size_t n = 0; n < path.size(); ++n)
      text += fmt::format("{}{:10}", n % kNodesPerLine == 0 ? "\n" : "", path[n] + offset);
    out.push_back(text + '\n');
  }
  return out;
}

bool is_uff_element(const TraceFace& face) { return face.size() == 3 || face.size() == 4; }

std::string uff_element_lines(const std::vector<TraceFace>& faces, int offset) {
  constexpr int kTriangle = 91, kQuadrilateral = 94;
  std::string out;
  int number = 0;
  for (const TraceFace& face : faces) {
    if (!is_uff_element(face)) continue;
    out += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", ++number, face.size() == 3 ? kTriangle : kQuadrilateral, 1,
                       1, kColour, face.size());
    for (const int corner : face) out += fmt::format("{:10}", corner + offset);
    out += '\n';
  }
  return out;
}

}  // namespace percuss::acquire
