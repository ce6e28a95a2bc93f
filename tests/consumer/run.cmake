# cmake -DBUILD=… -DWORK=… -DCXX=… -DGENERATOR=… -P run.cmake: installs the build tree BUILD under WORK, then
# configures, builds and runs the project beside this file against that installation alone.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text
                  WORKING_DIRECTORY ${WORK})
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
endfunction()

get_filename_component(source ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)

# The installed headers are exactly the public headers. They include only the standard library and each other.
file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix/include ${WORK}/prefix/include/*)
file(GLOB public RELATIVE ${source}/include ${source}/include/percuss/*)
if(NOT installed STREQUAL public)
  message(FATAL_ERROR "installed headers: ${installed}; public: ${public}")
endif()
foreach(header IN LISTS public)
  file(STRINGS ${source}/include/${header} includes REGEX "^#include")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "^#include <(percuss/[a-z]+[.]hpp|[a-z_]+([.]h)?)>$")
      message(FATAL_ERROR "${header}: ${include}")
    endif()
  endforeach()
endforeach()

# Two dozen programs are linked: with gold in a third of the time. The guide's project below uses the default linker.
find_program(gold ld.gold)
if(gold)
  set(linker -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold)
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX} ${linker}
    -DSOURCE=${source} -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
file(GLOB programs ${WORK}/build/programs/*)
foreach(program IN LISTS programs)
  run(${program})
endforeach()

# The project that the guide describes, with the guide's first program.
file(READ ${source}/docs/guides/cpp-library.md guide)
string(REGEX MATCH "```cmake\n([^`]*)```" block "${guide}")
file(WRITE ${WORK}/guide/CMakeLists.txt "${CMAKE_MATCH_1}")
file(COPY_FILE ${WORK}/build/extracted/cpp-library_1.cpp ${WORK}/guide/main.cpp)
run(${CMAKE_COMMAND} -S ${WORK}/guide -B ${WORK}/guide/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/guide/build)
run(${WORK}/guide/build/my_program)

run(${WORK}/prefix/bin/percuss --version)
foreach(made man/man1/percuss.1 man/man1/percuss-model-beam.1 bash-completion/completions/percuss
        zsh/site-functions/_percuss fish/vendor_completions.d/percuss.fish)
  file(SIZE ${WORK}/prefix/share/${made} bytes)  # fails when the file is missing
  if(bytes LESS 500)
    message(FATAL_ERROR "${made} holds ${bytes} bytes")
  endif()
endforeach()
