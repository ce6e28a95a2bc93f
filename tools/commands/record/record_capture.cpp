#include "commands/record/record_capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "acquire/live/open_device.hpp"
#include "cli/option_error.hpp"
#include "cli/read_flags.hpp"
#include "commands/record/record_plan.hpp"
#include "core/error.hpp"
#include "synth/simulated_device.hpp"

namespace percuss::tools {
namespace {

// A wrong description of a pipe is found before a byte is read: the command line is wrong, not the input.
std::unique_ptr<acquire::Device> open_named_device(const std::string& name, const acquire::DeviceOptions& wanted) {
  const bool describes_pipe = name.starts_with("stdin:") && name != "stdin:" && name != "stdin:wav";
  try {
    return acquire::open_device(name, wanted, synth::open_simulated_device);
  } catch (const InputError& error) {
    if (!describes_pipe || error.options() != std::vector<OptionId>{"device"}) throw;
    throw OptionError({"device"}, fmt::format("is not understood: {} ({})", error.problem(), error.where()),
                      error.remedy());
  }
}

}  // namespace

Recording open_recording(const RecordFlags& flags, const InterruptedSession& interrupted) {
  const bool resumed = interrupted.journal != nullptr;
  acquire::ReadOptions read = resolved_read_options(flags.read);
  acquire::DeviceOptions wanted{.fs_Hz = flags.fs_Hz, .fast = flags.fast, .setup = read.setup};
  acquire::CaptureOptions options{
      .journal = journal_of(flags.output), .overwrite = flags.force, .resume = resumed, .channels = {}};
  for (const std::size_t channel : flags.channels) {
    options.channels.push_back(channel - 1);
    wanted.channels = std::max(wanted.channels.value_or(0), channel);
  }
  if (resumed && repeats_itself(flags.device)) {
    wanted.start_frame = interrupted.journal->end_frame();
    options.seamless = true;
  }
  auto device = open_named_device(flags.device, wanted);
  if (!device->format().setup.empty()) read.setup = acquire::stream_setup(device->format(), options.channels);
  Recording out{.stream = nullptr,
                .channels = pipeline::live_channels(acquire::stream_format(device->format(), options.channels), read,
                                                    device->format().notes)};
  check_recording(out.channels.description, flags);
  out.stream = std::make_unique<acquire::CaptureStream>(std::move(device), options);
  return out;
}

}  // namespace percuss::tools
