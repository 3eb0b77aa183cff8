#!/bin/bash
# Builds and runs the benchmarks of docs/performance.md one after the other, and prints one table of what they measured
# beside the targets. Fails if a program fails, but never because of a time.
#   scripts/benchmarks.sh [--quick] [--out DIR]     DIR: for the CSV files, default benchmark_results in the workspace
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

quick=()
out=$workspace/benchmark_results
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=(--quick) ;;
    --out) out=$2 && shift ;;
    *) sed -n '2,4s/^# *//p' "$0" >&2 && exit 2 ;;
  esac
  shift
done

if ! build -DCDPR_BUILD_BENCHMARKS=ON >"$workspace/benchmarks_build.log" 2>&1; then
  tail -n 50 "$workspace/benchmarks_build.log" >&2
  exit 1
fi
programs=$workspace/devel/lib/cdpr_kinetostatics
mkdir -p "$out"

echo "machine:  $(nproc) x $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
echo "compiler: $(c++ --version | head -n 1)"
echo "commit:   $(git -C "$repository" describe --always --dirty 2>/dev/null || echo unknown)"

failed=0
results=()
# run NAME COMMAND...: one benchmark, which writes NAME.csv.
run() {
  local name=$1
  shift
  printf '\n--- %s\n' "$name"
  rm -f "$out/$name.csv"
  if "$@" "${quick[@]}" --csv "$out/$name.csv"; then
    results+=("$out/$name.csv")
  else
    echo "FAILED: $name"
    failed=1
  fi
}
for source in "$repository"/benchmark/*.cpp; do
  name=$(basename "$source" .cpp)
  if ! grep -q BenchmarkReport "$source"; then continue; fi
  if [ "$name" = cvodes ] && [ ! -x "$programs/cvodes" ]; then
    printf '\n--- cvodes: not built, SUNDIALS 6 was not found\n'
  else
    run "$name" "$programs/$name"
  fi
done

run compare_scipy "$repository/scripts/studies/compare_scipy.py" --programs "$programs"

printf '\n'
"$repository/scripts/studies/benchmark_table.py" "${results[@]}"
exit $failed
