#!/bin/bash
# Builds the libFuzzer programs of fuzz/ with clang and sanitizers, in a workspace of their own, and runs each from its
# committed corpus. A finding leaves its input in the workspace, under findings/, and makes the script fail.
#   scripts/fuzz.sh [--seconds N] [--keep] [NAME...]     N seconds each, default 60; 0: the corpus alone, nothing new
#                                                        NAME: cable_problems, forward, ...; default all
#                                                        --keep: adds new inputs that reach new code to fuzz/corpus
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
workspace=$workspace-fuzz

seconds=60
keep=
names=()
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds) seconds=$2 && shift ;;
    --keep) keep=yes ;;
    -*) sed -n '2,6s/^# *//p' "$0" >&2 && exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done
if [ ${#names[@]} -eq 0 ]; then
  for source in "$repository"/fuzz/*_fuzz.cpp; do names+=("$(basename "$source" _fuzz.cpp)"); done
fi

"$repository/scripts/setup.sh"
mkdir -p "$workspace/src" "$workspace/findings"
ln -sfn "$repository" "$workspace/src/cdpr_kinetostatics"
source_ros
echo "building in $workspace"
catkin_make -C "$workspace" -j"$(nproc)" fuzzers --cmake-args -DCDPR_BUILD_FUZZERS=ON -DCMAKE_CXX_COMPILER=clang++ \
  -DCDPR_SANITIZE=address,undefined,fuzzer-no-link -DCATKIN_ENABLE_TESTING=OFF
programs=$workspace/devel/lib/cdpr_kinetostatics
export LSAN_OPTIONS=suppressions=$repository/test/lsan.supp:print_suppressions=0
export ASAN_OPTIONS=detect_container_overflow=0  # yaml-cpp and Ceres come from Debian, without annotations

failed=0
for name in "${names[@]}"; do
  corpus=$repository/fuzz/corpus/$name
  grown=$workspace/corpus/$name
  mkdir -p "$corpus" "$grown"
  how=(-max_total_time="$seconds")
  [ "$seconds" -gt 0 ] || how=(-runs=0)
  echo "--- $name"
  "$programs/${name}_fuzz" "${how[@]}" -timeout=20 -malloc_limit_mb=64 -rss_limit_mb=1024 -max_len=4096 -print_final_stats=1 \
    -artifact_prefix="$workspace/findings/$name-" "$grown" "$corpus" > "$workspace/$name.log" 2>&1 || failed=1
  grep -E 'VIOLATED|ERROR|SUMMARY|DONE|number_of_executed_units|peak_rss_mb|Done ' "$workspace/$name.log" || true
  if [ -n "$keep" ]; then "$programs/${name}_fuzz" -merge=1 "$corpus" "$grown" > /dev/null 2>&1 || failed=1; fi
done
[ $failed -eq 0 ] || echo "FAILED: inputs and logs are in $workspace"
exit $failed
