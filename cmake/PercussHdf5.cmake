# HDF5 and matio, linked statically into executables where possible. Debian's shared HDF5 supports Amazon's S3 and
# therefore loads thirty more libraries (curl, TLS, Kerberos, LDAP ...) at start-up, which takes half of the time of
# `percuss --version`. A static library contributes only the used objects. Modules use the shared libraries, since the
# static ones are not position independent.
include(CheckCSourceCompiles)
find_package(HDF5 REQUIRED COMPONENTS C)
pkg_check_modules(MATIO REQUIRED IMPORTED_TARGET matio>=1.5.23)

set(archives)
foreach(name matio hdf5 sz aec)
  find_library(PERCUSS_${name}_ARCHIVE NAMES lib${name}.a HINTS ${MATIO_STATIC_LIBRARY_DIRS} PATH_SUFFIXES hdf5/serial)
  list(APPEND archives ${PERCUSS_${name}_ARCHIVE})
endforeach()
list(APPEND archives z m ${CMAKE_DL_LIBS})
set(CMAKE_REQUIRED_INCLUDES ${HDF5_C_INCLUDE_DIRS} ${MATIO_INCLUDE_DIRS})
set(CMAKE_REQUIRED_LIBRARIES ${archives})
check_c_source_compiles("
#include <hdf5.h>
#include <matio.h>
int main(void) { return Mat_Open(\"a\", MAT_ACC_RDONLY) != 0 || H5Fopen(\"a\", 0, 0) >= 0 || H5Zfilter_avail(H5Z_FILTER_SZIP); }
" PERCUSS_HDF5_ARCHIVES_LINK)
unset(CMAKE_REQUIRED_INCLUDES)
unset(CMAKE_REQUIRED_LIBRARIES)

add_library(percuss_hdf5 INTERFACE)
target_include_directories(percuss_hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS} ${MATIO_INCLUDE_DIRS})
set(PERCUSS_HDF5_SHARED PkgConfig::MATIO ${HDF5_C_LIBRARIES})
if(PERCUSS_HDF5_ARCHIVES_LINK)
  set(executable "$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>")
  target_link_libraries(percuss_hdf5 INTERFACE "$<IF:${executable},${archives},${PERCUSS_HDF5_SHARED}>")
else()
  target_link_libraries(percuss_hdf5 INTERFACE ${PERCUSS_HDF5_SHARED})
endif()
# The libraries that a layer links with. Programs that link an installed percuss use the
# shared libraries.
set(PERCUSS_HDF5 $<BUILD_INTERFACE:percuss_hdf5> $<INSTALL_INTERFACE:HDF5::HDF5> $<INSTALL_INTERFACE:PkgConfig::MATIO>)
