# Run after the tests are linked: writes LIST, in which every suite of the EXECUTABLE is one test of CTest. A suite has twenty
# minutes: the longest takes a quarter of a minute, and twenty times that with the thread sanitizer on a busy machine.
execute_process(COMMAND ${EXECUTABLE} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+\\.[^\n]*" suites "${listed}")  # a suite ends in a dot; its tests are indented
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX MATCH "[^ \n]+\\." suite "${suite}")
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  string(APPEND tests "add_test([==[${suite}]==] [==[${EXECUTABLE}]==] [==[--gtest_filter=${suite}.*]==])\n"
                      "set_tests_properties([==[${suite}]==] PROPERTIES TIMEOUT 1200)\n")
endforeach()
if(NOT tests)
  message(FATAL_ERROR "no tests in ${EXECUTABLE}")
endif()
file(WRITE ${LIST} "${tests}")
