#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {

struct CsvColumns;
struct ReadOptions;

/// At most so many samples of a signal are read to guess or check its role: enough for a hit.
inline constexpr std::size_t kGuessedSamples = std::size_t{1} << 18U;
inline constexpr std::size_t kMaxGuessedSignals = 64;  // more than a command line should list
/// Signals whose hammer_dissimilarity() differs by less than this factor count as alike. A response has at least 20
/// times the value of its hammer.
inline constexpr double kMaxDissimilarityRatio = 10;
/// The largest hammer_dissimilarity() of a hammer. A haversine of 5 ms in 0.3 s has 4e-4, the decay of a mode of 2 kHz
/// and 1 % in 1 s has 5e-3.
inline constexpr double kMaxHammerDissimilarity = 1e-3;

/// The likely force and accelerations of a file that does not name them, as the options accept them. Empty: no guess.
struct RoleGuess {
  std::string force;
  std::vector<std::string> accel;
  bool rate_known = true;       // false: nothing in the file states the sampling rate
  bool in_volts = false;        // accelerations are in volts, and nothing states their sensitivity
  bool force_in_volts = false;  // likewise the force
  /// The sampling rate if a column that rises evenly is a time: in ms for a first column without a unit, in s for
  /// another column. 0: no such column.
  double assumed_rate_Hz = 0;
  bool frf_table = false;  // the file is a table of FRFs: real and imaginary parts beside a column that rises evenly
};

/// The share of samples in which a signal is active: (Σ x²)² / (N Σ x⁴), where x is the distance from the median (of at
/// most kGuessedSamples evenly spaced samples). A hammer pulse has a few thousandths, a decay more, noise 1/3. 1 for a
/// constant signal and for numbers that are not finite. (1)
double active_share(std::span<const double> samples);

/// How little a signal resembles a hammer's force, small for a hammer: (1) times the larger of 0.05 and the ratio of
/// the extremes on both sides of the median. A decay swings to both sides, a pulse to one.                      (2)
double hammer_dissimilarity(std::span<const double> samples);

/// The fewest numbers that show whether they rise evenly.
inline constexpr std::size_t kMinRisingSamples = 8;

/// Whether the numbers rise evenly, as times do: none is more than half a step from its place. False for fewer than
/// kMinRisingSamples.
bool rises_evenly(std::span<const double> samples);

/// Guesses the unknown roles from the samples. A signal that rises evenly is a time. The force is the signal with the
/// smallest hammer_dissimilarity(), unless a unit or the user states that a signal is a response. Times,
/// counters, signals that the set-up ignores, and signals of another quantity (a velocity, an angle) get no role. All
/// others are accelerations, also a single signal and signals that are all alike. Of hits side by side, each with a
/// force by its unit, only the first is taken. The force in `known` stays, as do the accelerations that the options
/// name and the roles of their set-up. `read` gives up to the demanded number of samples. `name_of`: how the options
/// name a signal; by default its name if it is unique and holds no character that a shell changes, else its number.
/// errors  None: a signal that cannot be read is no candidate.
RoleGuess guess_roles(const std::vector<CsvColumn>& signals, const CsvColumns& known, const ReadOptions& options,
                      const std::function<std::vector<double>(std::size_t index, std::size_t max_samples)>& read,
                      const std::function<std::string(const CsvColumn&)>& name_of = {});

/// A note for a file that is read without a force, if an unread signal looks like the hammer's: its name has a word for
/// a force, or its unit may be a force's and its samples look like pulses. `signals`, `read` as above.
std::optional<Message> unread_hammer_note(
    const std::vector<CsvColumn>& signals, const CsvColumns& known,
    const std::function<std::vector<double>(std::size_t index, std::size_t max_samples)>& read);

}  // namespace percuss::acquire
