#!/bin/bash
# Installs, builds, starts the simulated rig and the node, calls the services once per cable model, then tracks the rig;
# prints both and saves pictures. Exits 0 if every pose is recovered and tracking is as exact as it predicts.
#   scripts/demo.sh [--robot NAME] [--rviz] [--output DIR]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  echo "usage: scripts/demo.sh [--robot NAME] [--rviz] [--output DIR]"
  echo "  --rviz     opens RViz and runs until it is closed; without it nothing needs a screen"
  echo "  --output   where pictures go; default: a new directory in /tmp"
  echo "  --robot    a file of config/robots:"
  (cd "$repository/config/robots" && printf '               %s\n' *.yaml | sed 's/\.yaml$//')
}

robot=cogiro
rviz=false
output=
while [ $# -gt 0 ]; do
  case "$1" in
    --robot) robot=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    --robot=*) robot=${1#*=} && shift ;;
    --rviz) rviz=true && shift ;;
    --output) output=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    --output=*) output=${1#*=} && shift ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
done
if [ ! -f "$repository/config/robots/$robot.yaml" ]; then
  usage >&2
  exit 2
fi

"$repository/scripts/setup.sh"
build_log=$(mktemp)
launch_log=$(mktemp)
rviz_config=$(mktemp --suffix=.rviz)
launch=
client=
cleanup() {
  for process in $client $launch; do
    kill "$process" 2>/dev/null && wait "$process" || true
  done
  rm -f "$build_log" "$launch_log" "$rviz_config"
}
trap cleanup EXIT
trap 'exit 130' INT TERM

echo "building (the first time takes some minutes)"
if ! build >"$build_log" 2>&1; then
  cat "$build_log"
  exit 1
fi
source_workspace

# A master of our own on a free port: whatever runs on this machine is left alone.
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://localhost:$port ROS_HOSTNAME=localhost
unset ROS_IP
"$repository/scripts/rviz_view.py" "$repository/config/robots/$robot.yaml" >"$rviz_config"
roslaunch -p "$port" cdpr_kinetostatics demo.launch robot:="$robot" rviz:="$rviz" rviz_config:="$rviz_config" >"$launch_log" 2>&1 &
launch=$!
if [ "$rviz" = true ]; then
  echo "RViz is open; close it to end"
  wait "$launch"
  exit
fi
output=${output:-$(mktemp -d /tmp/cdpr_demo.XXXXXX)}
mkdir -p "$output"
point_mass=()
! grep -q 'type: point_mass' "$repository/config/robots/$robot.yaml" || point_mass=(--point-mass)

# step COMMAND...: runs it as long as the nodes run; tells what roslaunch said if either fails.
step() {
  "$@" &
  client=$!
  local status=0
  wait -n "$client" "$launch" || status=$?
  if ! kill -0 "$launch" 2>/dev/null; then
    echo "the nodes ended before the demonstration did"
    status=1
  fi
  if [ "$status" -ne 0 ]; then
    echo "--- what roslaunch said:"
    cat "$launch_log"
    exit 1
  fi
  client=
}
step "$repository/scripts/demo_client.py"
step "$repository/scripts/track_client.py" --plot "$output/error.png" "${point_mass[@]}"
step "$repository/scripts/demo_picture.sh" "$rviz_config" "$output/rviz.png"
echo
echo "pictures: $output/error.png $output/rviz.png"
