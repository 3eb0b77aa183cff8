# tradeoff: measures error and time of every cable model on a robot. A user's tool, without ROS.
add_custom_target(tradeoff_build
  COMMAND ${CMAKE_COMMAND} "-DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/tradeoff_build.h" -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/tradeoff_build.cmake"
  BYPRODUCTS "${CMAKE_CURRENT_BINARY_DIR}/tradeoff_build.h"
)
file(GLOB tradeoff_sources CONFIGURE_DEPENDS src/tradeoff/*.cpp)
list(FILTER tradeoff_sources EXCLUDE REGEX "main\\.cpp$")
add_library(cdpr_tradeoff STATIC ${tradeoff_sources})
add_dependencies(cdpr_tradeoff tradeoff_build)
target_include_directories(cdpr_tradeoff PUBLIC src PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
target_link_libraries(cdpr_tradeoff cdpr_kinetostatics cdpr_timing Boost::program_options nlohmann_json::nlohmann_json)
cdpr_compile_options(cdpr_tradeoff)

add_executable(tradeoff src/tradeoff/main.cpp)
target_link_libraries(tradeoff cdpr_tradeoff)
cdpr_compile_options(tradeoff)
install(TARGETS tradeoff RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
