#pragma once

namespace percuss::acquire {

/// The address of a function of PortAudio. The first call loads the shared library, which then stays loaded. PortAudio
/// is not linked, because it would load ALSA and JACK too at the start of every command, which takes 1 ms.
/// errors  InputError: the library is not installed, or lacks the function
void* portaudio_address(const char* name);

template <class Function>
Function* portaudio_function(const char* name) {
  return reinterpret_cast<Function*>(portaudio_address(name));
}

}  // namespace percuss::acquire

/// A function that portaudio.h declares, such as PERCUSS_PORTAUDIO(Pa_Initialize)().
#define PERCUSS_PORTAUDIO(function) ::percuss::acquire::portaudio_function<decltype(function)>(#function)
