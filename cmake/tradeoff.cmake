# tradeoff: measures error and time of every cable model on a robot. A user's tool, without ROS.
add_custom_target(tradeoff_build
  COMMAND ${CMAKE_COMMAND} "-DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/tradeoff_build.h" -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/tradeoff_build.cmake"
  BYPRODUCTS "${CMAKE_CURRENT_BINARY_DIR}/tradeoff_build.h"
)
file(GLOB tradeoff_sources CONFIGURE_DEPENDS src/tradeoff/*.cpp)
add_executable(tradeoff ${tradeoff_sources})
add_dependencies(tradeoff tradeoff_build)
target_include_directories(tradeoff PRIVATE src ${CMAKE_CURRENT_BINARY_DIR})
target_link_libraries(tradeoff cdpr_kinetostatics cdpr_timing Boost::program_options nlohmann_json::nlohmann_json)
cdpr_compile_options(tradeoff)
install(TARGETS tradeoff RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
