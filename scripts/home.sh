#!/bin/bash
# Homing on the simulated rig: its winches have unknown zeros, 20 mm off, until ~home finds them at a known pose.
#   scripts/home.sh [--robot NAME]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$repository/scripts/nodes.sh"

robot=cogiro
while [ $# -gt 0 ]; do
  case "$1" in
    --robot) robot=${2:-} && shift $(($# > 1 ? 2 : 1)) ;;
    *) sed -n '2,3s/^# *//p' "$0" && exit 2 ;;
  esac
done

prepare
launch demo.launch robot:="$robot" rviz:=false path:=target load_noise:=0 offset_error:=0.02
beside "$repository/scripts/home_client.py"
