#!/bin/bash
# Saves what RViz shows, without a screen. Called by demo.sh, with a master running.
#   scripts/demo_picture.sh CONFIG.rviz FILE.png
set -euo pipefail

config=$1
file=$2
if [ "${3:-}" != inside ]; then
  export LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
  exec timeout 90 xvfb-run -a -s "-screen 0 1280x800x24 +extension GLX +render -noreset" "$0" "$config" "$file" inside
fi
log=$(mktemp)
rviz -d "$config" --fullscreen >"$log" 2>&1 &
rviz=$!
trap 'kill $rviz 2>/dev/null; rm -f "$log"' EXIT

# Takes a picture every half second, 80 times at most. It is the one wanted when two in a row have the background of the
# view in their corner, which the picture at start-up has not, and more than a few colours: RViz paints its grid first
# and then what it receives.
background='srgb(32,34,38)' # of rviz/kinetostatics.rviz
ready=0
for _ in $(seq 80); do
  import -window root "$file" 2>/dev/null || true
  seen=$(identify -format '%[pixel:p{2,2}] %k' "$file" 2>/dev/null || echo nothing 0)
  if [ "${seen% *}" = "$background" ] && [ "${seen#* }" -gt 600 ]; then
    ready=$((ready + 1))
  else
    ready=0
  fi
  [ $ready -lt 2 ] || exit 0
  kill -0 $rviz 2>/dev/null || break
  sleep 0.5
done
cat "$log" >&2
exit 1
