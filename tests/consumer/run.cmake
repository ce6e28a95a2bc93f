# cmake -DBUILD=… -DWORK=… -DCXX=… -DGENERATOR=… -P run.cmake: installs the build tree BUILD under WORK, then configures, builds and runs
# the project beside this file against that installation alone.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/prefix/bin/percuss --version)
foreach(made man/man1/percuss.1 man/man1/percuss-model-beam.1 bash-completion/completions/percuss zsh/site-functions/_percuss
        fish/vendor_completions.d/percuss.fish)
  file(SIZE ${WORK}/prefix/share/${made} bytes)  # an error when there is none
  if(bytes LESS 500)
    message(FATAL_ERROR "${made} holds ${bytes} bytes")
  endif()
endforeach()
