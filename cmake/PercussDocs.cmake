# Target docs: the pages of docs/ as HTML, with the C++ and the Python reference. Never part of the default build.
set(docs_dir ${PROJECT_BINARY_DIR}/docs)
# The packages belong to Debian's Python, /usr/bin/python3, which need not come first in the path.
find_program(PERCUSS_SPHINX sphinx-build)
find_program(PERCUSS_DOXYGEN doxygen)
if(PERCUSS_SPHINX AND PERCUSS_DOXYGEN AND NOT DEFINED CACHE{PERCUSS_SPHINX_EXTENSIONS})
  execute_process(COMMAND /usr/bin/python3 -c "import sphinx, myst_parser, breathe, furo" RESULT_VARIABLE missing
                  OUTPUT_QUIET ERROR_QUIET)
  if(missing EQUAL 0)
    set(PERCUSS_SPHINX_EXTENSIONS ON CACHE INTERNAL "Sphinx's extensions and theme were found")
  endif()
endif()
if(NOT PERCUSS_SPHINX_EXTENSIONS)
  add_custom_target(docs
    COMMAND ${CMAKE_COMMAND} -E echo "The documentation needs these Debian packages; install them and configure again:"
    COMMAND ${CMAKE_COMMAND} -E echo "  apt-get install python3-sphinx python3-myst-parser furo python3-breathe doxygen"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
     ${PROJECT_SOURCE_DIR}/include/percuss/*.hpp)
if(headers)
  file(CONFIGURE OUTPUT ${docs_dir}/Doxyfile CONTENT [[
INPUT = @PROJECT_SOURCE_DIR@/include/percuss
RECURSIVE = YES
STRIP_FROM_PATH = @PROJECT_SOURCE_DIR@/include
OUTPUT_DIRECTORY = @docs_dir@/doxygen
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
EXTRACT_ALL = YES
EXCLUDE_SYMBOLS = percuss::api*
INPUT_FILTER = "/usr/bin/python3 @PROJECT_SOURCE_DIR@/docs/sphinx/doxygen_filter.py"
WARN_IF_UNDOCUMENTED = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
QUIET = YES
]])
  set(run_doxygen COMMAND ${CMAKE_COMMAND} -E make_directory ${docs_dir}/doxygen COMMAND ${PERCUSS_DOXYGEN} ${docs_dir}/Doxyfile)
endif()
list(JOIN headers ":" headers)
set(package)
if(TARGET percuss_python)
  set(package ${PROJECT_BINARY_DIR}/python)
endif()
add_custom_target(docs
  ${run_doxygen}
  COMMAND ${CMAKE_COMMAND} -E env PERCUSS_VERSION=${PROJECT_VERSION} PERCUSS_DOXYGEN_XML=${docs_dir}/doxygen/xml
          PERCUSS_HEADERS=${headers} PERCUSS_PYTHON_PACKAGE=${package}
          ${PERCUSS_SPHINX} -q -W --keep-going -E -j auto -b html -c ${PROJECT_SOURCE_DIR}/docs -d ${docs_dir}/doctrees
          ${PROJECT_SOURCE_DIR} ${docs_dir}/html
  COMMAND ${CMAKE_COMMAND} -E echo "open ${docs_dir}/html/index.html"
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM)
if(TARGET percuss_python)
  add_dependencies(docs percuss_python)
endif()
