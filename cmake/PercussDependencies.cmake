# Finds the third-party libraries of the layers and the tool once, as imported targets. docs/project/decisions.md says
# why each is used.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(GSL 2.7 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)

find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW3 REQUIRED IMPORTED_TARGET fftw3)
add_library(FFTW3::fftw3 ALIAS PkgConfig::FFTW3)
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile>=1.2)
add_library(SNDFILE::sndfile ALIAS PkgConfig::SNDFILE)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto>=3.0)
add_library(CRYPTO::crypto ALIAS PkgConfig::CRYPTO)
pkg_check_modules(SECCOMP REQUIRED IMPORTED_TARGET libseccomp>=2.5)
add_library(SECCOMP::seccomp ALIAS PkgConfig::SECCOMP)
# The header alone: the library is loaded when a sound card is used.
pkg_check_modules(PORTAUDIO REQUIRED portaudio-2.0)

include(PercussHdf5)
