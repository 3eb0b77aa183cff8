#!/bin/bash
# Installs, builds, starts the node and calls its services once per cable model; prints a table.
# Exits 0 if every pose is recovered from its cable lengths.   scripts/demo.sh [--robot NAME]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  echo "usage: scripts/demo.sh [--robot NAME]    NAME is a file of config/robots:"
  (cd "$repository/config/robots" && printf '  %s\n' *.yaml | sed 's/\.yaml$//')
}

robot=cogiro
while [ $# -gt 0 ]; do
  case "$1" in
    --robot) robot=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    --robot=*) robot=${1#*=} && shift ;;
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
launch=
client=
cleanup() {
  for process in $client $launch; do
    kill "$process" 2>/dev/null && wait "$process" || true
  done
  rm -f "$build_log" "$launch_log"
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
roslaunch -p "$port" cdpr_kinetostatics kinetostatics.launch robot:="$robot" >"$launch_log" 2>&1 &
launch=$!
"$repository/scripts/demo_client.py" &
client=$!
status=0
wait -n "$client" "$launch" || status=$?
if kill -0 "$client" 2>/dev/null; then
  echo "the node ended before the demonstration did"
  kill "$client"
  status=1
fi
if [ "$status" -ne 0 ]; then
  echo "--- what roslaunch said:"
  cat "$launch_log"
  exit 1
fi
