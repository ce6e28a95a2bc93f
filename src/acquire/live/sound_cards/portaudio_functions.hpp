#pragma once
#include <portaudio.h>

namespace percuss::acquire {

/// The functions of PortAudio that percuss calls. A linked PortAudio would load ALSA and JACK too at the start of every
/// command, which takes 1 ms.
struct PortAudioFunctions {
  decltype(&Pa_Initialize) initialize;
  decltype(&Pa_Terminate) terminate;
  decltype(&Pa_GetErrorText) error_text;
  decltype(&Pa_GetDeviceCount) device_count;
  decltype(&Pa_GetDeviceInfo) device_info;
  decltype(&Pa_GetHostApiInfo) host_info;
  decltype(&Pa_IsFormatSupported) is_format_supported;
  decltype(&Pa_OpenStream) open_stream;
  decltype(&Pa_StartStream) start_stream;
  decltype(&Pa_AbortStream) abort_stream;
  decltype(&Pa_CloseStream) close_stream;
  decltype(&Pa_IsStreamActive) is_stream_active;
  decltype(&Pa_GetStreamInfo) stream_info;
};

/// The functions of the shared library, which the first call loads.
/// errors  InputError: the library is not installed, or lacks a function
const PortAudioFunctions& portaudio();

}  // namespace percuss::acquire
