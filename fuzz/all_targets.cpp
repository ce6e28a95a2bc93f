#include <array>

#include "targets.hpp"

namespace percuss::fuzz {

std::span<const Target> targets() {
  static constexpr std::array kTargets{
      Target{"csv", run_csv},
      Target{"lvm", run_lvm},
      Target{"uff", run_uff, mutate_uff},
      Target{"frf_text", run_frf_text},
      Target{"mat", run_mat, mutate_mat_recipe},
      Target{"hdf5", run_hdf5, mutate_hdf5_recipe},
      Target{"sound_calibration", run_sound_calibration},
      Target{"foreign", run_binary_formats, mutate_binary_formats},
      Target{"channel_setup", run_channel_setup},
      Target{"synth_spec", run_synth_spec},
      Target{"bats", run_bats},
      Target{"tables", run_tables},
      Target{"document", run_document},
      Target{"batch", run_batch},
      Target{"wav_header", run_wav_header},
      Target{"journal", run_journal},
  };
  return kTargets;
}

}  // namespace percuss::fuzz
