#pragma once
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "pipeline/channels/channel_findings.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// mass_loading: frequencies that fall where a mode moves most.
std::vector<Warning> mass_loading_warnings(const std::vector<identify::Mode>& modes);

/// What is known of the directions of the accelerometers.
struct SensorDirections {
  bool angles_assumed = false;                 // the angles in the record are assumed, not stated
  std::optional<identify::SensorPair> tube{};  // two sensors of a tube, which tube_warnings() judges instead
  std::vector<bool> hoop{};                    // [modes] hoop modes of a tube; empty: not known
};

/// Whether a channel shows modes.
enum class Silence {
  none,       // it does, or nothing is known
  unexcited,  // it responds to the hits, but shows none of the modes
  dead,       // its residues are zero within their noise
  still,      // it does not rise above its noise at the hits
  constant    // ChannelMotion::constant
};
/// [channels] Judges a channel that is not constant only if another one shows a mode with a residue above 20 standard
/// deviations:
///   still: ChannelMotion::still, and no residue above 10 standard deviations;
///   dead or unexcited: all residues of three modes or more within four standard deviations. Few modes may have a
///   common node.
/// motions  [channels] channel_motions(); empty where they are not known
std::vector<Silence> silences(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                              const std::vector<ChannelMotion>& motions);

/// Whether no mode type may rest on such a channel.
inline bool tells_no_type(Silence silence) { return silence != Silence::none && silence != Silence::unexcited; }

/// skew, clock_mismatch, units_differ, implausible_motion, reversed, same_motion, dead_channel, unexcited_channel.
/// `correctable`: the input is a record in time, from which a delay can be taken out. `silent`: [channels] silences().
/// `types_need`: as channel_warnings().
std::vector<Warning> channel_mode_warnings(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                           const ChannelFindings& findings, bool correctable,
                                           const SensorDirections& sensors = {},
                                           const std::vector<Silence>& silent = {},
                                           const std::vector<bool>& types_need = {});

}  // namespace percuss::pipeline
