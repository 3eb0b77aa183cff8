# Each benchmark/<name>.cpp becomes the executable <name>; benchmark/support/*.cpp is common to them.
file(GLOB benchmark_support_sources CONFIGURE_DEPENDS benchmark/support/*.cpp)
add_library(cdpr_benchmark_support STATIC ${benchmark_support_sources})
target_include_directories(cdpr_benchmark_support PUBLIC benchmark)
target_link_libraries(cdpr_benchmark_support cdpr_test_support cdpr_timing)
cdpr_compile_options(cdpr_benchmark_support)

# The comparison with CVODES needs SUNDIALS 6 or later; nothing else does.
find_package(SUNDIALS 6 CONFIG QUIET)

file(GLOB benchmark_sources CONFIGURE_DEPENDS benchmark/*.cpp)
foreach(benchmark_source ${benchmark_sources})
  get_filename_component(name ${benchmark_source} NAME_WE)
  if(name STREQUAL cvodes AND NOT SUNDIALS_FOUND)
    message(STATUS "SUNDIALS 6 was not found: no comparison with CVODES (apt install libsundials-dev)")
    continue()
  endif()
  add_executable(${name} ${benchmark_source})
  target_link_libraries(${name} cdpr_benchmark_support)
  target_compile_definitions(${name} PRIVATE ROBOT_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/robots")
  cdpr_compile_options(${name})
endforeach()
if(TARGET cvodes)
  target_sources(cvodes PRIVATE benchmark/sundials/cvodes_shot.cpp)
  target_link_libraries(cvodes SUNDIALS::cvodes_shared SUNDIALS::nvecserial_shared)
endif()
foreach(name lateness node_memory)  # of the node's own functions
  target_link_libraries(${name} cdpr_kinetostatics_ros)
endforeach()

file(GLOB estimation_study_sources CONFIGURE_DEPENDS benchmark/estimation_study/*.cpp)
target_sources(estimation_study PRIVATE ${estimation_study_sources})
target_link_libraries(estimation_study Boost::program_options)
