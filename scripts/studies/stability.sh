#!/bin/bash
# Everything measured in docs/stability.md: builds, judges 20000 cables, draws the maps.   [6 minutes]
#     scripts/studies/stability.sh [--quick]      --quick: 400 cables, document untouched: does it all still run?
# Results go to stability/ in the workspace.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

"$repository/scripts/setup.sh"
build -DCMAKE_BUILD_TYPE=Release -DCDPR_BUILD_BENCHMARKS=ON
results=$workspace/stability
mkdir -p "$results"
"$workspace/devel/lib/cdpr_kinetostatics/stability_map" --csv "$results/map.csv" --cost "$results/cost.csv" "$@" |
  tee "$results/map.txt"
pictures=$repository/docs/images
if [ $# -gt 0 ]; then pictures=$results; fi
/usr/bin/python3 "$repository/scripts/studies/plot_stability.py" "$results/map.csv" "$results/cost.csv" "$pictures"
