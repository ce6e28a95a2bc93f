#include <cstdlib>

#include "acquire/formats/sound/sound_calibration.hpp"
#include "targets.hpp"

namespace percuss::fuzz {

void run_sound_calibration(std::string_view bytes) {
  accepted([&] {
    const acquire::SoundCalibration first = acquire::parse_calibration(bytes, "fuzzed");
    const std::string text = acquire::calibration_text(first);
    if (acquire::calibration_text(acquire::parse_calibration(text, "again")) != text) std::abort();
  });
}

}  // namespace percuss::fuzz
