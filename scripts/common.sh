# Shared by all scripts: where things are, and how the package is built. To be sourced, not to be run.

set -euo pipefail

# Another python3 ahead of the system's breaks catkin's configuration and roslaunch.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
workspace=${CDPR_WORKSPACE:-$repository/.ws}

# ROS Noetic of ros.org, where it is installed; Debian's own packages need no setup file.
source_ros() {
  if [ -f /opt/ros/noetic/setup.bash ]; then
    set +u
    source /opt/ros/noetic/setup.bash
    set -u
  fi
}

# Puts the package into the workspace, as a folder of links to all but the workspace. One link to the repository would lead
# back to the workspace inside it, and rosrun, which searches the package, would say "File system loop detected".
link_package() {
  local package=$workspace/src/cdpr_kinetostatics entry
  [ ! -L "$package" ] || rm "$package"
  mkdir -p "$package"
  find "$package" -maxdepth 1 -type l -delete
  for entry in "$repository"/*; do
    [[ $workspace/ == "$entry"/* ]] || ln -s "$entry" "$package/"
  done
}

# build [CMAKE_ARGUMENT...]: makes the workspace if needed and builds all of the package but its tests.
build() {
  source_ros
  link_package
  echo "building in $workspace"
  catkin_make -C "$workspace" -j"$(nproc)" --cmake-args "$@"
}

source_workspace() {
  set +u
  source "$workspace/devel/setup.bash"
  set -u
}
