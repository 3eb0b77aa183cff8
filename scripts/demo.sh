#!/bin/bash
# Installs, builds, starts the simulated rig and the node, calls the services once per cable model, then tracks the rig;
# prints both and saves pictures. Exits 0 if every pose is recovered and tracking is as exact as it predicts.
#   scripts/demo.sh [--robot NAME] [--rviz] [--output DIR]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$repository/scripts/nodes.sh"

usage() {
  echo "usage: scripts/demo.sh [--robot NAME] [--rviz] [--output DIR]"
  echo "  --rviz     opens RViz and runs until it is closed; without it nothing needs a screen"
  echo "  --output   where pictures go; default: a new directory for temporary files"
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

prepare
rviz_config=$scratch/$robot.rviz
"$repository/scripts/rviz_view.py" "$repository/config/robots/$robot.yaml" >"$rviz_config"
launch demo.launch robot:="$robot" rviz:="$rviz" rviz_config:="$rviz_config"
if [ "$rviz" = true ]; then
  echo "RViz is open; close it to end"
  wait "$launch"
  exit
fi
output=${output:-$(mktemp -d)}
mkdir -p "$output"
point_mass=()
! grep -q 'type: point_mass' "$repository/config/robots/$robot.yaml" || point_mass=(--point-mass)

beside "$repository/scripts/demo_client.py"
beside "$repository/scripts/track_client.py" --plot "$output/error.png" "${point_mass[@]}"
beside "$repository/scripts/demo_picture.sh" "$rviz_config" "$output/rviz.png"
echo
echo "pictures: $output/error.png $output/rviz.png"
