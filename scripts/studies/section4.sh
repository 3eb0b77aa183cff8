#!/bin/bash
# Everything in docs/section4.md: builds, solves, checks against the independent solver, times, draws.   [2 minutes]
#     scripts/studies/section4.sh [--quick]      --quick: fewer points, no pictures: does it all still run?   [half a minute]
# Results go to section4/ in the workspace, pictures to docs/images.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

"$repository/scripts/setup.sh"
build -DCMAKE_BUILD_TYPE=Release -DCDPR_BUILD_BENCHMARKS=ON
results=$workspace/section4
mkdir -p "$results"
export OPENBLAS_NUM_THREADS=1 # small matrices: threads only disturb
"$workspace/devel/lib/cdpr_kinetostatics/section4" "$results" "$@"
/usr/bin/python3 "$repository/scripts/studies/section4_reference.py" "$results" "$@"
/usr/bin/python3 "$repository/scripts/studies/section4_bvp.py" "$results" "$@"
if [ $# -eq 0 ]; then
  /usr/bin/python3 "$repository/scripts/studies/plot_section4.py" "$results" "$repository/docs/images"
fi
