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

void* load_portaudio() {
  void* const library = ::dlopen(kPortAudio, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse_portaudio("the library of sound cards is not installed");
  return library;
}

}  // namespace

void* portaudio_address(const char* name) {
  static void* const library = load_portaudio();
  void* const address = ::dlsym(library, name);
  if (address == nullptr) refuse_portaudio("the library of sound cards lacks a function");
  return address;
}

}  // namespace percuss::acquire
