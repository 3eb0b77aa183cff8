# Run at every build: writes OUTPUT with the commit that SOURCE_DIR is at, if that has changed.
get_filename_component(list_file "${SOURCE_DIR}/CMakeLists.txt" REALPATH)  # a link in the workspace that scripts make
get_filename_component(repository "${list_file}" DIRECTORY)
execute_process(COMMAND git -C "${repository}" describe --always --dirty --abbrev=10
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file("${SOURCE_DIR}/src/tradeoff/tradeoff_build.h.in" "${OUTPUT}" @ONLY)
