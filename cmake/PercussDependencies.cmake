# Finds every third-party library once, as imported targets; docs/decisions.md says why each is used.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(GSL 2.7 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)

find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW3 REQUIRED IMPORTED_TARGET fftw3)
add_library(FFTW3::fftw3 ALIAS PkgConfig::FFTW3)

if(NOT TARGET HDF5::HDF5)
  add_library(percuss_hdf5 INTERFACE)
  target_include_directories(percuss_hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
  target_link_libraries(percuss_hdf5 INTERFACE ${HDF5_C_LIBRARIES})
  add_library(HDF5::HDF5 ALIAS percuss_hdf5)
endif()
