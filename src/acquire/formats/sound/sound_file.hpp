#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/atomic_file.hpp"

namespace percuss::acquire {

/// Whether these first bytes are the start of a WAV, RF64 or W64 file.
bool is_sound(std::string_view head);

/// The samples of a WAV, RF64 or W64 file: uncompressed numbers, channels interleaved. Integers are fractions of
/// full scale, −1 … 1; floating-point numbers are as stored.
/// errors  InputError, also from read: damaged, compressed, more samples than the file's bytes allow.
class SoundInput {
 public:
  explicit SoundInput(const std::string& path);
  ~SoundInput();
  SoundInput(const SoundInput&) = delete;
  SoundInput& operator=(const SoundInput&) = delete;

  std::size_t channels() const;
  std::size_t frames() const;
  /// The number of frames that the header states, if the file holds fewer because a copy or recording stopped early.
  std::optional<std::uint64_t> frames_of_whole_file() const;
  int rate_Hz() const;
  std::string format() const;  // for people: "WAV", "RF64", "W64"
  /// The bytes of the custom chunk with this id of four letters; nothing when it is absent.
  std::optional<std::string> chunk(std::string_view id) const;
  /// Samples first … first + out.size() − 1 of a channel. Several threads may call at the same time.
  void read(std::size_t channel, std::size_t first, std::span<double> out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

enum class SoundKind { wav, rf64, w64 };

/// A sound file of 64-bit floating-point numbers that appears whole under its name, or not at all; equal calls give
/// equal bytes.
/// errors  InputError: as AtomicFile; a rate or a number of channels beyond the format's limits.
class SoundOutput {
 public:
  struct Chunk {
    std::string id, text;
  };
  /// `cues` are marked frames; `chunk` precedes the samples. W64 has neither.
  SoundOutput(const std::string& path, bool force, SoundKind kind, std::size_t channels, int rate_Hz,
              const std::vector<std::uint32_t>& cues, const std::optional<Chunk>& chunk);
  ~SoundOutput();
  SoundOutput(const SoundOutput&) = delete;
  SoundOutput& operator=(const SoundOutput&) = delete;

  /// Frames, channels interleaved.
  void append(std::span<const double> values);
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss::acquire
