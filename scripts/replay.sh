#!/bin/bash
# Plays a bag of cable_states to the node twice, with ~reset between, and compares the estimates bit for bit. Without
# BAG it records one of the simulated rig first.   scripts/replay.sh [--robot NAME] [BAG]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$repository/scripts/nodes.sh"

robot=cogiro
bag=
while [ $# -gt 0 ]; do
  case "$1" in
    --robot) robot=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    -h | --help | -*) sed -n '2,3s/^# *//p' "$0" && exit 2 ;;
    *) bag=$1 && shift ;;
  esac
done

prepare
if [ -z "$bag" ]; then
  bag=$(mktemp -d)/$robot.bag
  launch replay.launch robot:="$robot" rig:=true
  beside "$repository/scripts/replay_client.py" "$bag" --record 300
  stop
fi
launch replay.launch robot:="$robot"
beside "$repository/scripts/replay_client.py" "$bag"
