#include "pipeline/skipped_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace percuss::pipeline {
namespace {

constexpr double kMinShare = 1e-3;

class SkippedWorkList {
 public:
  explicit SkippedWorkList(const Analysis& analysis) : analysis_(analysis) {
    for (const auto& stage : analysis.trace().stages()) ran_.insert(stage.name);
  }

  std::vector<SkippedWork> take() {
    if (ran_.contains("hits")) accelerations();
    if (ran_.contains("fft")) {
      force_zeros();
      lines();
    }
    stages();
    return std::move(out_);
  }

 private:
  void add(const char* code, const char* what, std::string why, double part, double whole) {
    const double share = whole > 0 ? part / whole : 0;
    if (share >= kMinShare) out_.push_back({.code = code, .what = what, .why = std::move(why), .share = share});
  }

  void accelerations() {
    double all = 0, within = 0, rejected = 0, tails = 0;
    for (const acquire::RowInfo& row : analysis_.record().rows) all += static_cast<double>(row.samples);
    if (!ran_.contains("read acceleration")) {
      add("channels", "all accelerations", "only the force was demanded", all, all);
      return;
    }
    std::size_t rejected_hits = 0;
    const std::size_t block = ran_.contains("fft") ? analysis_.lines().samples : 0;
    for (const AnalysedHit& hit : analysis_.force_hits()) {
      const auto samples = static_cast<double>(hit.hit.samples);
      within += samples;
      if (!hit.accepted) {
        rejected += samples;
        ++rejected_hits;
      } else if (block > 0 && block < hit.hit.samples) {
        tails += static_cast<double>(hit.hit.samples - block);
      }
    }
    add("silence", "accelerations between the hits", "no hit is there", all - within, all);
    add("rejected", "accelerations of hits that cannot be used",
        fmt::format("{} of {} hits are rejected by their force or by the user", rejected_hits,
                    analysis_.force_hits().size()),
        rejected, all);
    add("tail", "accelerations after the decay", "they are noise, or beyond the end of the shortest row", tails, all);
  }

  void force_zeros() {
    double pulses = 0, whole = 0;
    for (const AnalysedHit& hit : analysis_.force_hits()) {
      if (!hit.accepted || !hit.hit.ungated_N.empty()) continue;
      pulses += static_cast<double>(hit.hit.gated_N.size());
      whole += static_cast<double>(analysis_.lines().samples);
    }
    add("force_zeros", "the force outside its pulses", "it is zero there, and its noise would disturb each mode",
        whole - pulses, whole);
  }

  void lines() {
    const double all = static_cast<double>(analysis_.lines().samples) / 2 + 1;
    const auto [low_Hz, high_Hz] = analysis_.band_Hz();
    add("lines", "spectral lines of the transforms",
        fmt::format("they lie outside the band {:.6g} to {:.6g} Hz and its margin, or beyond the usable bandwidth",
                    low_Hz, high_Hz),
        all - static_cast<double>(analysis_.lines().count), all);
  }

  void stages() {
    struct Stage {
      const char *name, *code, *what;
    };
    for (const Stage& stage :
         {Stage{"modes", "modes", "modes"}, Stage{"classes", "classes", "types of the modes (bending or hoop)"},
          Stage{"stabilisation", "stabilisation", "the stabilisation diagram"},
          Stage{"modes per hit", "per_hit", "the modes of each hit alone"}}) {
      if (!ran_.contains(stage.name))
        out_.push_back({.code = stage.code, .what = stage.what, .why = "not demanded", .share = {}});
    }
  }

  const Analysis& analysis_;
  std::set<std::string> ran_;
  std::vector<SkippedWork> out_;
};

}  // namespace

std::vector<SkippedWork> skipped_work(const Analysis& analysis) { return SkippedWorkList(analysis).take(); }

}  // namespace percuss::pipeline
