#!/bin/bash
# Runs the simulated rig at a rate, and beside it the node with its default model, and prints how the node keeps up:
# messages in, poses out, latency, processor time, memory. Without arguments it runs 60 s at 1000 Hz on CoGiRo.
#   scripts/sustained_rate.sh [--duration S] [--rate HZ] [--robot NAME] [--model NAME] [--json FILE]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$repository/scripts/nodes.sh"

robot=cogiro
rate=1000
period=5 # [s], of the circle: the rig solves during its first lap only, more slowly than the rate
model=
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --duration | --json) arguments+=("$1" "${2?}") && shift 2 ;;
    --rate) rate=${2?} && shift 2 ;;
    --model) model=${2?} && shift 2 ;;
    --robot) robot=${2?} && shift 2 ;;
    *) sed -n '2,4s/^# *//p' "$0" && exit 2 ;;
  esac
done

prepare
launch demo.launch robot:="$robot" model:="$model" rate:="$rate" path_period:="$period" load_noise:=0 rviz:=false output:=log
beside "$repository/scripts/sustained_rate_client.py" "${arguments[@]}"
