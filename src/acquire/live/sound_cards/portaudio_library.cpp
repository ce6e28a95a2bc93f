#include "acquire/live/sound_cards/portaudio_library.hpp"

#include <fcntl.h>
#include <portaudio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "acquire/live/sound_cards/portaudio_functions.hpp"
#include "acquire/live/sound_cards/sound_cards.hpp"
#include "core/error.hpp"

// Functions of the leak sanitizer; null in builds without it.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
[[gnu::weak]] void __lsan_disable();
[[gnu::weak]] void __lsan_enable();
}
// NOLINTEND(bugprone-reserved-identifier)

namespace percuss::acquire {
namespace {

constexpr std::array kCommonRates_Hz = {8000.0,  11025.0, 16000.0, 22050.0, 25600.0,  32000.0,  44100.0,  48000.0,
                                        51200.0, 64000.0, 88200.0, 96000.0, 102400.0, 128000.0, 176400.0, 192000.0};

// An assertion in Debian's PortAudio aborts the program if the configuration of ALSA has no device "default". A child
// process therefore tries it first. It takes at most 20 s, since devices may answer slowly.
void check_in_child() {
  constexpr unsigned kPatience_s = 20;
  auto* const initialize = PERCUSS_PORTAUDIO(Pa_Initialize);
  const pid_t child = ::fork();
  if (child < 0) return;
  if (child == 0) {
    const rlimit no_core{};
    ::setrlimit(RLIMIT_CORE, &no_core);
    std::signal(SIGABRT, SIG_DFL);
    ::alarm(kPatience_s);
    initialize();
    ::_exit(0);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
    throw InputError("a sound device does not answer", "portaudio", "unplug the devices that are not needed",
                     {"device"});
  }
  if (WIFSIGNALED(status)) {
    throw InputError("PortAudio cannot look for devices", "portaudio",
                     "check the configuration of ALSA: it needs a device called default", {"device"});
  }
}

}  // namespace

// ALSA's plug-ins never free some of their memory. The leak checker would report it.
SilencedErrors::SilencedErrors() : saved_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)) {
  if (__lsan_disable != nullptr) __lsan_disable();
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  std::fflush(stderr);
  if (saved_ >= 0) ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

SilencedErrors::~SilencedErrors() {
  if (__lsan_enable != nullptr) __lsan_enable();
  if (saved_ < 0) return;
  std::fflush(stderr);
  ::dup2(saved_, STDERR_FILENO);
  ::close(saved_);
}

PortAudioLibrary::PortAudioLibrary() {
  const SilencedErrors quiet;
  check_in_child();
  if (const PaError error = PERCUSS_PORTAUDIO(Pa_Initialize)(); error != paNoError) {
    throw InputError(std::string("PortAudio does not start: ") + PERCUSS_PORTAUDIO(Pa_GetErrorText)(error), "portaudio",
                     "check the sound system", {"device"});
  }
}

PortAudioLibrary::~PortAudioLibrary() {
  const SilencedErrors quiet;
  PERCUSS_PORTAUDIO(Pa_Terminate)();
}

std::vector<PortAudioInput> PortAudioLibrary::inputs() const {
  std::vector<PortAudioInput> out;
  for (PaDeviceIndex i = 0; i < PERCUSS_PORTAUDIO(Pa_GetDeviceCount)(); ++i) {
    const PaDeviceInfo* const info = PERCUSS_PORTAUDIO(Pa_GetDeviceInfo)(i);
    if (info == nullptr || info->maxInputChannels <= 0) continue;
    const PaHostApiInfo* const host = PERCUSS_PORTAUDIO(Pa_GetHostApiInfo)(info->hostApi);
    out.push_back({.index = i,
                   .name = info->name,
                   .host = host != nullptr ? host->name : "",
                   .channels = static_cast<std::size_t>(info->maxInputChannels),
                   .default_fs_Hz = info->defaultSampleRate,
                   .latency_s = info->defaultHighInputLatency});
  }
  return out;
}

std::vector<double> PortAudioLibrary::rates_Hz(const PortAudioInput& input) const {
  const SilencedErrors quiet;
  const PaStreamParameters parameters{.device = input.index,
                                      .channelCount = 1,
                                      .sampleFormat = paInt32,
                                      .suggestedLatency = input.latency_s,
                                      .hostApiSpecificStreamInfo = nullptr};
  std::vector<double> rates;
  for (const double rate : kCommonRates_Hz) {
    if (PERCUSS_PORTAUDIO(Pa_IsFormatSupported)(&parameters, nullptr, rate) == paFormatIsSupported)
      rates.push_back(rate);
  }
  return rates;
}

PortAudioInput find_input(const std::vector<PortAudioInput>& inputs, const std::string& name, bool alsa_only) {
  const auto first_where = [&](const auto& fits) -> const PortAudioInput* {
    for (const PortAudioInput& input : inputs) {
      if ((!alsa_only || input.host == "ALSA") && fits(input)) return &input;
    }
    return nullptr;
  };
  const auto name_contains = [](const PortAudioInput& input, const std::string& text) {
    return input.name.find(text) != std::string::npos;
  };
  if (const auto* exact = first_where([&](const auto& input) { return input.name == name; })) return *exact;
  if (const auto* address = first_where([&](const auto& input) { return name_contains(input, "(" + name + ")"); }))
    return *address;
  const PortAudioInput* const found = first_where([&](const auto& input) { return name_contains(input, name); });
  if (found == nullptr) {
    check_card_is_free(sound_card_inputs(), name);  // PortAudio leaves out what it cannot open
    throw InputError("there is no such recording device", one_line(name), "percuss devices lists what can record",
                     {"device"});
  }
  const auto* const other =
      first_where([&](const auto& input) { return name_contains(input, name) && input.name != found->name; });
  if (other != nullptr) {
    throw InputError("several recording devices have this name", one_line(name),
                     "write more of it: " + one_line(found->name) + ", " + one_line(other->name), {"device"});
  }
  return *found;
}

}  // namespace percuss::acquire
