# In debug builds, gold links the tests in a third of the time of the default linker (decision 220).
find_program(PERCUSS_GOLD ld.gold)
if(PERCUSS_GOLD AND CMAKE_BUILD_TYPE STREQUAL "Debug" AND NOT PERCUSS_SANITIZE)
  add_link_options($<$<CXX_COMPILER_ID:GNU>:-fuse-ld=gold>)
endif()

# percuss_options(TARGET): the language level, warnings and sanitizers of all targets of percuss.
function(percuss_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wnon-virtual-dtor
    -Wold-style-cast -Wcast-align -Woverloaded-virtual
    # Option structs are written with designated initialisers, which leave members at their defaults.
    -Wno-missing-field-initializers
    # g++ 12 reports a false overlap in "x" + std::string (GCC bug 105329).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    # With precompiled headers, g++ 12 reports false warnings in library headers.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<BOOL:${CMAKE_DISABLE_PRECOMPILE_HEADERS}>>>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-maybe-uninitialized>
    # Reproducible results on machines of one kind: no contraction into fused multiply-add.
    -ffp-contract=off
    $<$<BOOL:${PERCUSS_WERROR}>:-Werror>)
  # Larger heap limits avoid garbage collections of the compiler, which take a tenth of its time.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=1000;--param=ggc-min-heapsize=1000000>)
  # Unity builds compile common template instantiations once.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${PERCUSS_UNITY_BUILD} UNITY_BUILD_BATCH_SIZE 24)
  if(PERCUSS_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${PERCUSS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${PERCUSS_SANITIZE})
    # The vptr check opens a pipe to test whether memory can be read, which the sandbox forbids.
    target_compile_options(${target} PUBLIC -fno-sanitize=vptr)
    # Library headers are excluded: their own assertions, above all Eigen's, find the same errors, and the checks take two
    # thirds of the tests' time.
    target_compile_options(${target} PUBLIC
      $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/sanitizers.ignore>)
  endif()
endfunction()

# percuss_code(TARGET): the settings of a layer or of the tool. These targets share a precompiled header, which requires
# equal compiler options. The preset tidy does not use it, so that it detects missing includes.
add_library(percuss_headers OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
target_precompile_headers(percuss_headers PRIVATE
  <Eigen/Core> <nlohmann/json.hpp> <fmt/format.h> <algorithm> <filesystem> <string> <vector>)
function(percuss_code target)
  percuss_options(${target})
  target_compile_options(${target} PRIVATE -fPIC)
  # Eigen and nlohmann_json are header-only: an installation does not need them. fmt is linked.
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:Eigen3::Eigen> $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>
                        fmt::fmt)
  if(NOT target STREQUAL "percuss_headers")
    target_precompile_headers(${target} REUSE_FROM percuss_headers)
  endif()
endfunction()
percuss_code(percuss_headers)

# percuss_unity_folders(TARGET ROOT): one unity unit per folder, so that file-local names must be unique only within a
# folder.
function(percuss_unity_folders target root)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    file(RELATIVE_PATH folder ${root} ${folder})
    string(MAKE_C_IDENTIFIER "folder_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# percuss_layer(NAME PUBLIC libs PRIVATE libs): the layer src/NAME as a static library, percuss_NAME.
function(percuss_layer name)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${name}/*.cpp)
  add_library(percuss_${name} STATIC ${sources})
  add_library(percuss::${name} ALIAS percuss_${name})
  set_target_properties(percuss_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(percuss_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
  target_link_libraries(percuss_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  percuss_code(percuss_${name})
  percuss_unity_folders(percuss_${name} ${CMAKE_CURRENT_SOURCE_DIR}/src)
  set_property(GLOBAL APPEND PROPERTY PERCUSS_LAYERS percuss_${name})
endfunction()
