#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "synth/pulse.hpp"
#include "synth/simulated_session.hpp"

namespace percuss::synth {

/// Renders the signals of a session piece by piece, in memory that does not grow with its length. A piece depends only
/// on the session and its place.
class BlowRenderer {
 public:
  explicit BlowRenderer(const SimulatedSession& session);

  /// Force and accelerations: the channels of a frame.
  std::size_t channels() const { return 1 + session_.accels; }
  /// The full scale of each channel, the largest value that it can have, [channels()].
  const std::vector<double>& full_scales() const { return full_scales_; }
  /// Frames first … of interleaved channels, with noise, within the full scales. Pieces are rendered in order.
  void render(std::uint64_t first, std::span<double> out);

 private:
  struct Active {
    std::size_t point = 0;
    std::vector<Pulse> pulses;  // times from the first frame of the session
    double last_frame = 0;
  };
  void activate(double last_frame);
  Active active_of(std::size_t blow) const;
  void add_blow(const Active& blow, std::uint64_t first, std::span<double> out) const;
  void set_levels();

  const SimulatedSession session_;
  std::vector<SynthPole> poles_;
  std::vector<std::vector<std::vector<double>>> residues_;  // [point][sensor][mode]
  std::vector<std::vector<double>> rigid_;                  // [point][sensor]
  std::vector<double> full_scales_, noise_;                 // [channels]
  std::vector<std::size_t> order_;                          // of the blows by their onsets
  std::size_t next_blow_ = 0;
  std::deque<Active> active_;
};

}  // namespace percuss::synth
