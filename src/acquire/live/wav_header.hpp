#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/live/pcm_encoding.hpp"

namespace percuss::acquire {

struct WavHeader {
  PcmEncoding encoding = PcmEncoding::s16;
  double fs_Hz = 0;
  std::size_t channels = 0;
  std::uint64_t data_bytes = std::numeric_limits<std::uint64_t>::max();  // this default: the stream does not state it
  std::optional<SoundCalibration> calibration{};  // of a WAV that percuss wrote; one signal for each channel
};

/// Reads the header of a WAV or RF64 stream up to its first sample. `fill` reads exactly as many bytes as the span has,
/// or returns false.
/// errors  InputError: the stream ends; not WAV; compressed, of 8 bits, more than 1024 channels; more than 16 MiB
/// before the samples; a calibration that is damaged or has other channels
WavHeader read_wav_header(const std::function<bool(std::span<std::byte>)>& fill);

}  // namespace percuss::acquire
