#include "acquire/record/point_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percuss::acquire {
namespace {

std::pair<int, std::size_t> key_of_motion(const PointMotion& motion) { return {motion.point, motion.channel}; }

bool by_key(const PointMotion& a, const PointMotion& b) { return key_of_motion(a) < key_of_motion(b); }

// Whether both move the same place along the same line.
bool moves_alike(const PointMotion& a, const PointMotion& b) {
  constexpr double kSameLine = 0.99;  // cosine
  if (a.place != b.place) return false;
  if (!a.along || !b.along) return true;
  double cosine = 0;
  for (std::size_t i = 0; i < 3; ++i) cosine += a.along->at(i) * b.along->at(i);
  return std::abs(cosine) > kSameLine;
}

}  // namespace

void sort_motions(std::vector<PointMotion>& motions) {
  std::stable_sort(motions.begin(), motions.end(), by_key);
  const auto same = [](const PointMotion& a, const PointMotion& b) { return key_of_motion(a) == key_of_motion(b); };
  motions.erase(std::unique(motions.begin(), motions.end(), same), motions.end());
}

const PointMotion* find_motion(const std::vector<PointMotion>& motions, int point, std::size_t channel) {
  const PointMotion wanted{.point = point, .channel = channel};
  const auto found = std::lower_bound(motions.begin(), motions.end(), wanted, by_key);
  return found != motions.end() && key_of_motion(*found) == key_of_motion(wanted) ? &*found : nullptr;
}

int place_of_point(const std::vector<PointMotion>& motions, int point) {
  const auto found = std::lower_bound(motions.begin(), motions.end(), PointMotion{.point = point}, by_key);
  return found != motions.end() && found->point == point ? found->place : point;
}

std::vector<PointMotion> motions_at(const std::vector<PointMotion>& motions, const std::vector<std::size_t>& channels) {
  std::vector<PointMotion> out;
  for (PointMotion motion : motions) {
    const auto channel = std::find(channels.begin(), channels.end(), motion.channel);
    if (channel == channels.end()) continue;
    motion.channel = static_cast<std::size_t>(channel - channels.begin());
    out.push_back(motion);
  }
  sort_motions(out);
  return out;
}

bool same_geometry(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return !a.empty() && std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& p, const auto& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(), same);
  });
}

void note_mixed_roving(std::vector<Message>& notes) {
  const Message note(
      "one place was struck and the sensors moved in some files only: state whether the hammer or the sensors moved",
      {"roving"});
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

bool move_alike(const std::vector<PointMotion>& some, const std::vector<PointMotion>& others) {
  return std::any_of(some.begin(), some.end(), [&](const PointMotion& one) {
    return std::any_of(others.begin(), others.end(), [&](const PointMotion& other) { return moves_alike(one, other); });
  });
}

}  // namespace percuss::acquire
