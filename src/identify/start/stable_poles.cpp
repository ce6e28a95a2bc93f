#include "identify/start/stable_poles.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/start/stabilisation.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kSectionOrder = 40;                    // largest model order of a section
constexpr std::size_t kMinSectionLines = 4 * kSectionOrder;  // of a section, for kSectionOrder
constexpr double kMinStableShare = 0.5;   // part of the upper half of the orders in which a stable pole appears
constexpr double kSamePole = 0.25;        // half-power bandwidths between the poles of two orders
constexpr double kSameMode = 0.5;         // … and between the poles of two sections
constexpr double kSameWidth = 3;          // ratio of the bandwidths of such poles
constexpr double kMaxStableWidth = 0.25;  // of a section: a broader pole belongs to a longer section

// A section of the band, and the frequencies between which its poles count: away from its ends, where sections overlap.
struct Section {
  std::size_t first = 0, count = 0;
  double from_Hz = 0, to_Hz = 0;
};

// The shortest sections first.
std::vector<Section> sections_of(const acquire::LineRange& lines) {
  std::vector<Section> sections;
  for (std::size_t parts = 1; parts == 1 || lines.count / parts >= kMinSectionLines; parts *= 2) {
    const std::size_t count = lines.count / parts, half = count / 2;
    for (std::size_t i = 0; i + 1 < 2 * parts; ++i) {
      const bool last = i + 2 == 2 * parts;
      Section section{.first = i * half, .count = last ? lines.count - i * half : count};
      section.from_Hz = i == 0 ? 0 : lines.freq_Hz(section.first + count / 4);
      section.to_Hz = lines.freq_Hz(last ? lines.count - 1 : section.first + count / 4 + half);
      sections.push_back(section);
    }
  }
  std::reverse(sections.begin(), sections.end());
  return sections;
}

// The middle of the poles of several orders.
Pole middle_of(const std::vector<Pole>& poles) {
  std::vector<double> freq_Hz, damping;
  for (const Pole& pole : poles) {
    freq_Hz.push_back(pole.freq_Hz);
    damping.push_back(pole.damping_ratio);
  }
  return {.freq_Hz = median(std::move(freq_Hz)), .damping_ratio = median(std::move(damping))};
}

std::vector<Pole> stable_poles_of(const FrfDataset& set, const Section& section) {
  const Stabilisation diagram =
      stabilise(set, {.lscf = {.max_order = kSectionOrder, .first = section.first, .count = section.count}});
  std::size_t top = 0;
  for (const StabilisationPole& at : diagram.poles) top = std::max(top, at.order);
  std::vector<std::vector<Pole>> columns;  // of the diagram
  for (const StabilisationPole& at : diagram.poles) {
    if (at.stability != Stability::stable || 2 * at.order <= top) continue;
    const auto own = std::find_if(columns.begin(), columns.end(), [&](const std::vector<Pole>& column) {
      return std::abs(column.back().freq_Hz - at.pole.freq_Hz) < kSamePole * at.pole.half_power_Hz();
    });
    if (own == columns.end()) {
      columns.push_back({at.pole});
    } else {
      own->push_back(at.pole);
    }
  }
  std::vector<Pole> poles;
  const double widest_Hz = kMaxStableWidth * static_cast<double>(section.count) * set.lines.df_Hz();
  for (const std::vector<Pole>& column : columns) {
    if (static_cast<double>(column.size()) < kMinStableShare * 0.5 * static_cast<double>(top)) continue;
    const Pole pole = middle_of(column);
    const bool whole = section.count == set.lines.count;
    if (pole.freq_Hz < section.from_Hz || pole.freq_Hz > section.to_Hz) continue;
    if (whole || pole.half_power_Hz() < widest_Hz) poles.push_back(pole);
  }
  return poles;
}

}  // namespace

bool same_place(const Pole& a, const Pole& b) {
  const double narrow = std::min(a.half_power_Hz(), b.half_power_Hz());
  const double wide = std::max(a.half_power_Hz(), b.half_power_Hz());
  return std::abs(a.freq_Hz - b.freq_Hz) < kSameMode * wide && wide < kSameWidth * narrow;
}

std::vector<Pole> stable_poles(const FrfDataset& set) {
  if (set.lines.count < 8 || set.channels.empty()) return {};
  const std::vector<Section> sections = sections_of(set.lines);
  std::vector<std::vector<Pole>> found(sections.size());
  constexpr std::size_t kFlops = 1'000'000;  // of a section, at least
  parallel_for_cost(sections.size(), kFlops, [&](std::size_t s) { found[s] = stable_poles_of(set, sections[s]); });
  std::vector<Pole> poles;
  for (const std::vector<Pole>& more : found) {
    for (const Pole& pole : more) {
      const bool known = std::any_of(poles.begin(), poles.end(), [&](const Pole& k) { return same_place(k, pole); });
      if (!known) poles.push_back(pole);
    }
  }
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
  return poles;
}

}  // namespace percuss::identify
