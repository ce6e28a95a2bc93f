#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <regex>

#include "support/scratch_folder.hpp"

// The libraries that the tool loads are the dependencies that the build, percussConfig.cmake and the container image
// state.
namespace percuss::dependencies_test {

struct Library {
  const char* name;     // of the shared library, up to .so
  const char* package;  // the Debian package for linking
  const char* found;    // what percussConfig.cmake finds
};

constexpr std::array kLibraries{
    Library{"libfftw3", "libfftw3-dev", "FFTW3"},
    Library{"libgsl", "libgsl-dev", "GSL"},
    Library{"libgslcblas", "libgsl-dev", "GSL"},  // loaded only if the linker keeps unused libraries
    Library{"libtbb", "libtbb-dev", "TBB"},
    Library{"libfmt", "libfmt-dev", "fmt"},
    Library{"libsndfile", "libsndfile1-dev", "SNDFILE"},
    Library{"libseccomp", "libseccomp-dev", "SECCOMP"},
    Library{"libcrypto", "libssl-dev", "CRYPTO"},
    Library{"libz", "zlib1g-dev", "ZLIB"},
    Library{"libmatio", "libmatio-dev", "MATIO"},
    Library{"libhdf5_serial", "libhdf5-dev", "HDF5"},
};
// The libraries of the compiler and of C, and the libraries that a sanitizer or a static HDF5 needs.
constexpr std::array kOfTheCompiler{"libc",  "libm",    "libstdc++", "libgcc_s", "ld-linux-x86-64", "ld-linux-aarch64",
                                    "libdl", "libasan", "libubsan",  "libtsan",  "librt",           "libpthread",
                                    "libsz", "libaec"};

// The names of the libraries that the tool loads, up to ".so" or "_debug.so".
std::vector<std::string> loaded_libraries() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen("readelf -d '" PERCUSS_EXECUTABLE "'", "r"), ::pclose);
  std::string text;
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) text += static_cast<char>(c);
  std::vector<std::string> names;
  const std::regex needed(R"(\(NEEDED\).*\[([^\]]*?)(_debug)?\.so[^\]]*\])");
  for (std::sregex_iterator at(text.begin(), text.end(), needed); at != std::sregex_iterator(); ++at)
    names.push_back((*at)[1]);
  return names;
}

bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("(^|[^A-Za-z0-9_-])" + word + "($|[^A-Za-z0-9_-])"));
}

TEST(Dependencies, OfTheToolAreStatedWhereverTheyAreListed) {
  const auto loaded = loaded_libraries();
  ASSERT_THAT(loaded, testing::Contains("libseccomp"));
  for (const std::string& name : loaded) {
    if (std::find(kOfTheCompiler.begin(), kOfTheCompiler.end(), name) != kOfTheCompiler.end()) continue;
    const auto* const known =
        std::find_if(kLibraries.begin(), kLibraries.end(), [&](const Library& one) { return name == one.name; });
    EXPECT_NE(known, kLibraries.end()) << name;
  }
  for (const char* list :
       {"start", "cmake/PercussInstall.cmake", "docs/guides/cpp-library.md", "docs/guides/batch/Containerfile"}) {
    const std::string text = test::bytes_of(std::string(PERCUSS_SOURCE_DIR "/") + list);
    for (const Library& library : kLibraries)
      EXPECT_TRUE(has_word(text, library.package)) << list << " " << library.package;
  }
  for (const char* list : {"cmake/percussConfig.cmake.in", "CMakeLists.txt"}) {
    const std::string text = test::bytes_of(std::string(PERCUSS_SOURCE_DIR "/") + list);
    for (const Library& library : kLibraries) {
      // cmake/PercussHdf5.cmake finds matio.
      const bool found_elsewhere = library.found == std::string("MATIO") && list == std::string("CMakeLists.txt");
      EXPECT_TRUE(found_elsewhere || text.find(library.found) != std::string::npos) << list << " " << library.found;
    }
  }
}

// If the tool were linked to PortAudio, every command would load ALSA and JACK when it starts. The packages still
// depend on PortAudio.
TEST(Dependencies, OfSoundCardsAreLoadedOnlyWhereTheyAreUsed) {
  EXPECT_THAT(loaded_libraries(), testing::Not(testing::Contains("libportaudio")));
  for (const char* list : {"start", "docs/guides/batch/Containerfile"})
    EXPECT_TRUE(has_word(test::bytes_of(std::string(PERCUSS_SOURCE_DIR "/") + list), "portaudio19-dev")) << list;
  for (const char* list : {"cmake/PercussInstall.cmake", "docs/guides/cpp-library.md"})
    EXPECT_TRUE(has_word(test::bytes_of(std::string(PERCUSS_SOURCE_DIR "/") + list), "libportaudio2")) << list;
}

}  // namespace percuss::dependencies_test
