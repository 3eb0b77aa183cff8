#!/bin/bash
# Installs by apt what is missing to build, run and test the package. Safe to call again: it then takes
# less than a second. As root or with sudo; on Debian 12, or on Ubuntu 20.04 with ROS Noetic in /opt/ros.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=(
  # compiler and libraries
  g++ make cmake libboost-program-options-dev libceres-dev libeigen3-dev libgtest-dev libyaml-cpp-dev nlohmann-json3-dev
  # pictures of scripts/demo.sh
  imagemagick libgl1-mesa-dri python3-matplotlib python3-numpy xauth xvfb
  # comparisons of scripts/benchmarks.sh
  libsundials-dev python3-scipy
  # checks of scripts/test.sh; the compiler and its run-time library are those of scripts/fuzz.sh
  clang-format clang-tidy clang libclang-rt-14-dev
)
if [ -d /opt/ros/noetic ]; then
  packages+=(
    python3-catkin-lint ros-noetic-catkin ros-noetic-diagnostic-msgs ros-noetic-diagnostic-updater
    ros-noetic-geometry-msgs ros-noetic-interactive-markers ros-noetic-message-generation
    ros-noetic-message-runtime ros-noetic-rosbag ros-noetic-rosbash ros-noetic-roscpp ros-noetic-roslaunch ros-noetic-rospy
    ros-noetic-rosservice ros-noetic-rostest ros-noetic-rviz ros-noetic-sensor-msgs ros-noetic-std-msgs ros-noetic-std-srvs
    ros-noetic-tf2-msgs ros-noetic-tf2-ros ros-noetic-visualization-msgs
  )
else
  packages+=(
    # build
    catkin catkin-lint libdiagnostic-msgs-dev libdiagnostic-updater-dev libgeometry-msgs-dev libinteractive-markers-dev
    libroscpp-dev librostest-dev libsensor-msgs-dev libstd-msgs-dev libstd-srvs-dev libtf2-ros-dev
    libvisualization-msgs-dev ros-diagnostic-msgs ros-geometry-msgs ros-message-generation ros-message-runtime
    ros-sensor-msgs ros-std-msgs ros-std-srvs ros-visualization-msgs
    # run and test
    python3-diagnostic-msgs python3-geometry-msgs python3-rosbag python3-roslaunch python3-rosparam python3-rospy python3-rosservice
    python3-rostest python3-rostopic python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf2-msgs python3-visualization-msgs
    rosbash rosout rviz
  )
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: missing ${missing[*]}; run as root, or install sudo" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
echo "setup: done"
