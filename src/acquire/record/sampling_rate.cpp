#include "acquire/record/sampling_rate.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace percuss::acquire {

double checked_rate_Hz(double fs_Hz, std::string_view where) {
  if (fs_Hz >= 1e-3 && fs_Hz <= 1e9) return fs_Hz;
  throw InputError(fmt::format("a sampling rate of {:g} Hz is not usable", fs_Hz), where, "state it in Hz", {"fs"});
}

}  // namespace percuss::acquire
