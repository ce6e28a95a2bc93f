# Runs after the tests are linked. Writes LIST, in which every suite of EXECUTABLE is one test of CTest. The limit of a
# suite is twenty minutes. The longest suite takes about a minute alone, and ten times as long with the address sanitizer
# on a busy machine.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${EXECUTABLE} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+\\.[^\n]*" suites "${listed}")  # a suite ends in a dot; its tests are indented
# These take longest and start first, the longest before all others, so that none of them runs alone at the end. CTest
# knows the times of former runs only where there were some.
set(long_suites Limits FuzzCorpus Examples Tutorial Survey Truncation Study TrampolineFit HostileTruncation
                ChannelFindings)
# Long computations. Under the sanitizers, .ci/submit leaves them out, and .ci/full runs them.
set(long_computations ChannelFindings Examples Help IdentifyModes ImpactOnset LargestDeflection Study Survey
                      TrampolineFit Tutorial)
# No other suite runs beside these: they measure time.
set(timed_suites GuideLatency)
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX MATCH "[^ \n]+\\." suite "${suite}")
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  string(APPEND tests "add_test([==[${suite}]==] [==[${EXECUTABLE}]==] [==[--gtest_filter=${suite}.*]==])\n"
                      "set_tests_properties([==[${suite}]==] PROPERTIES TIMEOUT 1200)\n")
  list(FIND long_suites ${suite} place)
  if(NOT place EQUAL -1)
    math(EXPR cost "1000 - ${place}")
    string(APPEND tests "set_tests_properties([==[${suite}]==] PROPERTIES COST ${cost})\n")
  endif()
  if(suite IN_LIST timed_suites)
    string(APPEND tests "set_tests_properties([==[${suite}]==] PROPERTIES RUN_SERIAL TRUE)\n")
  endif()
  if(suite IN_LIST long_computations)
    string(APPEND tests "set_tests_properties([==[${suite}]==] PROPERTIES LABELS computation)\n")
  endif()
endforeach()
if(NOT tests)
  message(FATAL_ERROR "no tests in ${EXECUTABLE}")
endif()
file(WRITE ${LIST} "${tests}")
