#include "acquire/live/sound_cards/portaudio_functions.hpp"

#include <dlfcn.h>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr const char* kPortAudio = "libportaudio.so.2";

[[noreturn]] void refuse_portaudio(const char* problem) {
  throw InputError(problem, kPortAudio, "install PortAudio 19 (Debian: libportaudio2), or record through a pipe",
                   {"device"});
}

template <class Function>
void load(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (function == nullptr) refuse_portaudio("the library of sound cards lacks a function");
}

PortAudioFunctions loaded() {
  void* const library = ::dlopen(kPortAudio, RTLD_NOW | RTLD_LOCAL);  // stays loaded
  if (library == nullptr) refuse_portaudio("the library of sound cards is not installed");
  PortAudioFunctions out{};
  load(library, "Pa_Initialize", out.initialize);
  load(library, "Pa_Terminate", out.terminate);
  load(library, "Pa_GetErrorText", out.error_text);
  load(library, "Pa_GetDeviceCount", out.device_count);
  load(library, "Pa_GetDeviceInfo", out.device_info);
  load(library, "Pa_GetHostApiInfo", out.host_info);
  load(library, "Pa_IsFormatSupported", out.is_format_supported);
  load(library, "Pa_OpenStream", out.open_stream);
  load(library, "Pa_StartStream", out.start_stream);
  load(library, "Pa_AbortStream", out.abort_stream);
  load(library, "Pa_CloseStream", out.close_stream);
  load(library, "Pa_IsStreamActive", out.is_stream_active);
  load(library, "Pa_GetStreamInfo", out.stream_info);
  return out;
}

}  // namespace

const PortAudioFunctions& portaudio() {
  static const PortAudioFunctions functions = loaded();
  return functions;
}

}  // namespace percuss::acquire
