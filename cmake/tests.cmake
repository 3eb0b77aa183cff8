# Unit tests test/<layer>/<name>_test.cpp become the targets <layer>_<name>_test; test/<layer>/<name>.test are rostests and
# run <layer>_<name>_rostest, of test/<layer>/<name>_rostest.cpp.

function(cdpr_test_target target)
  target_include_directories(${target} PRIVATE test/support)
  target_compile_definitions(${target} PRIVATE
    SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    ROBOT_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/robots"
    TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/golden")
  target_link_libraries(${target} cdpr_test_support gtest_main gtest)
  cdpr_compile_options(${target})
endfunction()

# What the tests of a layer link beside the core.
set(cdpr_libraries_of_ros cdpr_kinetostatics_ros)
set(cdpr_libraries_of_rig cdpr_rig)
set(cdpr_libraries_of_tradeoff cdpr_tradeoff)

foreach(layer cable geometry residuals robot estimation ros rig tradeoff structure)
  file(GLOB test_sources CONFIGURE_DEPENDS test/${layer}/*_test.cpp)
  foreach(test_source ${test_sources})
    get_filename_component(name ${test_source} NAME_WE)
    set(target ${layer}_${name})
    catkin_add_gtest(${target} ${test_source})
    target_link_libraries(${target} ${cdpr_libraries_of_${layer}} cdpr_kinetostatics)
    cdpr_test_target(${target})
  endforeach()

  file(GLOB rostest_sources CONFIGURE_DEPENDS test/${layer}/*_rostest.cpp)
  foreach(rostest_source ${rostest_sources})
    get_filename_component(name ${rostest_source} NAME_WE)
    set(target ${layer}_${name})
    string(REPLACE _rostest.cpp .test launch_file ${rostest_source})
    add_rostest_gtest(${target} ${launch_file} ${rostest_source})
    target_link_libraries(${target} ${cdpr_libraries_of_${layer}})
    target_compile_definitions(${target} PRIVATE NODE_EXECUTABLE="$<TARGET_FILE:kinetostatics_node>"
      RIG_EXECUTABLE="$<TARGET_FILE:rig_simulator>")
    add_dependencies(${target} kinetostatics_node rig_simulator)
    cdpr_test_target(${target})
  endforeach()
endforeach()

add_dependencies(tradeoff_command_test tradeoff)
target_compile_definitions(tradeoff_command_test PRIVATE TRADEOFF_EXECUTABLE="$<TARGET_FILE:tradeoff>")
target_link_libraries(tradeoff_command_test nlohmann_json::nlohmann_json)

# Each public header compiles alone, as its users see it: with include/ and what the package asks of them on the path.
file(GLOB_RECURSE public_headers CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}/include" include/*.h)
set(public_header_sources)
foreach(public_header ${public_headers})
  string(REPLACE / _ name ${public_header})
  set(public_header_source "${CMAKE_CURRENT_BINARY_DIR}/public_headers/${name}.cpp")
  file(GENERATE OUTPUT "${public_header_source}" CONTENT "#include \"${public_header}\"\n")
  list(APPEND public_header_sources "${public_header_source}")
endforeach()
add_library(public_headers_alone OBJECT EXCLUDE_FROM_ALL ${public_header_sources})
target_include_directories(public_headers_alone PRIVATE include)
target_include_directories(public_headers_alone SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS} ${CERES_INCLUDE_DIRS})
cdpr_compile_options(public_headers_alone)
add_dependencies(structure_public_headers_test public_headers_alone)
