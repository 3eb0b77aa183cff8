#!/bin/bash
# Saves what RViz shows, without a screen.   scripts/demo_picture.sh CONFIG.rviz FILE.png   (called by demo.sh with a master running)
set -euo pipefail

config=$1
file=$2
if [ "${3:-}" != inside ]; then
  export LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
  exec timeout 60 xvfb-run -a -s "-screen 0 1280x800x24 +extension GLX +render -noreset" "$0" "$config" "$file" inside
fi
log=$(mktemp)
rviz -d "$config" --fullscreen >"$log" 2>&1 &
rviz=$!
trap 'kill $rviz 2>/dev/null; rm -f "$log"' EXIT

# Asks every half second, 50 times at most. Done when two pictures in a row show more than a few colours: RViz paints its
# frame first, then what it hears.
for _ in $(seq 50); do
  import -window root "$file" 2>/dev/null || true
  colours=$(identify -format %k "$file" 2>/dev/null || echo 0)
  if [ "$colours" -gt 600 ] && [ "${before:-0}" -gt 600 ]; then
    exit 0
  fi
  before=$colours
  kill -0 $rviz 2>/dev/null || break
  sleep 0.5
done
cat "$log" >&2
exit 1
