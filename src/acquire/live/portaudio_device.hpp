#pragma once
#include <memory>
#include <string>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// An input of PortAudio, as find_input() finds it. Samples are 32-bit numbers; their full scale is 1, or stated in V
/// or m/s² by a USB front end (usb_front_end.hpp). A device with more than 32 channels is opened with two, unless the
/// options ask for more.
/// errors  InputError: as find_input; more channels than the device has; busy, no permission, another rate
std::unique_ptr<Device> open_portaudio_device(const std::string& name, bool alsa_only,
                                              const DeviceOptions& options = {});

}  // namespace percuss::acquire
