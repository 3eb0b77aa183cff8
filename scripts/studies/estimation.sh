#!/bin/bash
# Everything measured in docs/estimation.md: builds, simulates, writes its tables and its picture.   [an hour]
#     scripts/studies/estimation.sh [--quick]      --quick: fewer samples, document untouched: does it all still run?
# Results go to estimation/ in the workspace.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

"$repository/scripts/setup.sh"
build -DCMAKE_BUILD_TYPE=Release -DCDPR_BUILD_BENCHMARKS=ON
results=$workspace/estimation
mkdir -p "$results"
for experiment in consistency faults offsets recovery load observability timing; do
  "$workspace/devel/lib/cdpr_kinetostatics/estimation_study" --directory "$results" "$@" "$experiment" \
    2>"$results/$experiment.log" | tee "$results/$experiment.md"
done
if [ $# -eq 0 ]; then
  /usr/bin/python3 "$repository/scripts/studies/plot_estimation.py" "$results" "$repository/docs"
fi
