#!/bin/bash
# Installs, builds, runs every test and check. Exits non-zero if any fails, or if none ran.
#   scripts/test.sh                                 everything
#   scripts/test.sh --sanitize=address,undefined    tests only, built with these sanitizers in a workspace of their own
#   scripts/test.sh --fuzz                          everything, then a minute of each target of scripts/fuzz.sh
# CI=true makes warnings errors and adds clang-tidy.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

sanitize=
fuzz=
for argument in "$@"; do
  case "$argument" in
    --sanitize=*) sanitize=${argument#*=} ;;
    --fuzz) fuzz=yes ;;
    *) sed -n '2,6s/^# *//p' "$0" >&2 && exit 2 ;;
  esac
done
ci=OFF
[ "${CI:-}" = true ] && ci=ON
[ -z "$sanitize" ] || workspace=$workspace-${sanitize//,/-}

checks_passed=0
checks_failed=0
# check NAME COMMAND...: runs one check and counts it.
check() {
  local name=$1
  shift
  echo "--- $name"
  if "$@"; then
    checks_passed=$((checks_passed + 1))
  else
    checks_failed=$((checks_failed + 1))
    echo "FAILED: $name"
  fi
}

verdict() {
  echo
  echo "$1 passed, $2 failed${3:+, $3 skipped}"
  [ "$2" -eq 0 ] && [ "$1" -gt 0 ]
}

our_sources() { (cd "$repository" && find include src test benchmark -name '*.h' -o -name '*.cpp' | sort); }
format() { (cd "$repository" && our_sources | xargs clang-format --dry-run -Werror); }
tidy() {
  # Each run counts on stderr the warnings that it does not show, those of the system's headers.
  (cd "$repository" && our_sources | grep '^src/.*\.cpp$' |
    xargs -P "$(nproc)" -n 1 clang-tidy -p "$workspace/build" --quiet 2> >(grep -v 'warnings\? generated' >&2))
}

"$repository/scripts/setup.sh"
if ! build -DCDPR_WARNINGS_AS_ERRORS="$ci" -DCDPR_SANITIZE="$sanitize" -DCDPR_BUILD_BENCHMARKS=ON; then
  echo "FAILED: build"
  verdict 0 1
fi
results=$workspace/build/test_results
rm -rf "$results"
export LSAN_OPTIONS=suppressions=$repository/test/lsan.supp:print_suppressions=0
export ROS_HOME=${ROS_HOME:-$workspace/ros_home}
# One job more than processors: tests of nodes mostly wait.
check "test programs build and run" catkin_make -C "$workspace" -j"$(($(nproc) + 1))" run_tests
if [ -z "$sanitize" ]; then
  check "benchmarks run" "$repository/scripts/benchmarks.sh" --quick
  check "no loop of links in the package" find -L "$workspace/src/cdpr_kinetostatics" -name package.xml
  check clang-format format
  check catkin_lint catkin_lint --strict -W2 --offline --ignore external_interface_path --ignore global_var_collision \
    --ignore literal_project_name --ignore uninstalled_script "$workspace/src/cdpr_kinetostatics"
  [ $ci = OFF ] || check clang-tidy tidy
fi
[ -z "$fuzz" ] || check fuzz "$repository/scripts/fuzz.sh"

echo "--- results"
counted=$("$repository/scripts/count_tests.py" "$results")
sed '$d' <<<"$counted"
read -r passed failed skipped <<<"$(tail -n 1 <<<"$counted")"
if ! catkin_test_results "$results" && [ "$failed" -eq 0 ]; then
  failed=1
fi
if [ $((passed + failed)) -eq 0 ]; then
  echo "FAILED: no test ran"
  failed=1
fi
[ "$skipped" -gt 0 ] || skipped=
verdict $((passed + checks_passed)) $((failed + checks_failed)) "$skipped"
