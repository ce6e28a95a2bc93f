#include <array>

#include "targets.hpp"

namespace percuss::fuzz {

// The fuzz targets of percuss_reader_tests; they replace fuzz/all_targets.cpp.
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
  };
  return kTargets;
}

}  // namespace percuss::fuzz
