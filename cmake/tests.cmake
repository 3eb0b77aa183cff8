# Unit tests test/<layer>/<name>_test.cpp become the targets <layer>_<name>_test; test/ros/*.test are rostests.

function(cdpr_test_target target)
  target_include_directories(${target} PRIVATE test/support)
  target_compile_definitions(${target} PRIVATE
    SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    ROBOT_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/robots"
    TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/golden")
  target_link_libraries(${target} cdpr_test_support gtest_main gtest)
  cdpr_compile_options(${target})
endfunction()

foreach(layer cable geometry residuals robot estimation ros rig tradeoff structure)
  file(GLOB test_sources CONFIGURE_DEPENDS test/${layer}/*_test.cpp)
  foreach(test_source ${test_sources})
    get_filename_component(name ${test_source} NAME_WE)
    set(target ${layer}_${name})
    catkin_add_gtest(${target} ${test_source})
    if(layer STREQUAL ros)
      target_link_libraries(${target} cdpr_kinetostatics_ros)
    elseif(layer STREQUAL rig)
      target_link_libraries(${target} cdpr_rig)
    else()
      target_link_libraries(${target} cdpr_kinetostatics)
    endif()
    cdpr_test_target(${target})
  endforeach()
endforeach()

add_dependencies(tradeoff_command_test tradeoff)
target_compile_definitions(tradeoff_command_test PRIVATE TRADEOFF_EXECUTABLE="$<TARGET_FILE:tradeoff>")
target_link_libraries(tradeoff_command_test nlohmann_json::nlohmann_json)

# test/ros/<name>.test runs the executable of test/ros/<name>_rostest.cpp.
foreach(name services bad_requests node_start estimator tracking rig_faults rig_paths master_restart)
  add_rostest_gtest(${name}_rostest test/ros/${name}.test test/ros/${name}_rostest.cpp)
  target_link_libraries(${name}_rostest cdpr_kinetostatics_ros)
  target_compile_definitions(${name}_rostest PRIVATE NODE_EXECUTABLE="$<TARGET_FILE:kinetostatics_node>"
    RIG_EXECUTABLE="$<TARGET_FILE:rig_simulator>")
  add_dependencies(${name}_rostest kinetostatics_node rig_simulator)
  cdpr_test_target(${name}_rostest)
endforeach()
