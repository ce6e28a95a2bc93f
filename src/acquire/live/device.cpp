#include "acquire/live/device.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kMaxRelativeDifference = 1e-6;  // a rate from a column of times is rounded

}  // namespace

void require_rate(double fs_Hz, const DeviceOptions& options, const std::string& where) {
  if (!options.fs_Hz || std::abs(*options.fs_Hz - fs_Hz) <= kMaxRelativeDifference * fs_Hz) return;
  throw InputError(fmt::format("the samples come at {:.10g} Hz, and cannot come at {:.10g} Hz", fs_Hz, *options.fs_Hz),
                   where, "leave the rate out", {"fs"});
}

}  // namespace percuss::acquire
