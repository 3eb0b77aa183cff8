#!/bin/bash
# Plays a bag of cable_states to the node twice, with ~reset between, and compares the estimates bit for bit. Without
# BAG it records one of the simulated rig first.   scripts/replay.sh [--robot NAME] [BAG]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

robot=cogiro
bag=
while [ $# -gt 0 ]; do
  case "$1" in
    --robot) robot=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    -h | --help | -*) sed -n '2,3s/^# *//p' "$0" && exit 2 ;;
    *) bag=$1 && shift ;;
  esac
done

"$repository/scripts/setup.sh"
log=$(mktemp)
launch=
stop() {
  if [ -n "$launch" ] && kill -INT "$launch" 2>/dev/null; then
    wait "$launch" || true
  fi
  launch=
}
trap 'stop; rm -f "$log"' EXIT
if ! build >"$log" 2>&1; then
  cat "$log"
  exit 1
fi
source_workspace
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://localhost:$port ROS_HOSTNAME=localhost
unset ROS_IP

# start ARGUMENT...: launches and waits until the master answers.
start() {
  roslaunch -p "$port" cdpr_kinetostatics replay.launch robot:="$robot" "$@" >"$log" 2>&1 &
  launch=$!
  until rosparam get /kinetostatics/queue_size >/dev/null 2>&1; do
    kill -0 "$launch" 2>/dev/null || { cat "$log" && exit 1; }
  done
}

if [ -z "$bag" ]; then
  bag=$(mktemp -d)/$robot.bag
  start rig:=true
  "$repository/scripts/replay_client.py" "$bag" --record 300
  stop
fi
start
"$repository/scripts/replay_client.py" "$bag"
