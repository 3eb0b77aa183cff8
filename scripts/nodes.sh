# What the scripts share that start nodes: build, a master of their own, launch, and an end without leftovers.
# Sourced after common.sh, not run.

scratch=$(mktemp -d) # gone at the end
launch_log=$scratch/roslaunch.log
launch=              # process of roslaunch
client=              # process that `beside` waits for

stop() {
  local process
  for process in $client $launch; do
    if kill -INT "$process" 2>/dev/null; then wait "$process" || true; fi
  done
  client= launch=
}
trap 'stop; rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM

# Installs and builds; says nothing of it but that it takes time, unless it fails.
prepare() {
  "$repository/scripts/setup.sh"
  echo "building (the first time takes some minutes)"
  if ! build >"$scratch/build.log" 2>&1; then
    cat "$scratch/build.log"
    exit 1
  fi
  source_workspace
  # A master of our own on a free port: whatever runs on this machine is left alone.
  port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
  export ROS_MASTER_URI=http://localhost:$port ROS_HOSTNAME=localhost
  unset ROS_IP
}

fail() {
  echo "$1; what roslaunch said:"
  cat "$launch_log"
  exit 1
}

# launch FILE [ARGUMENT...]: starts nodes, and returns as soon as their master answers.
launch() {
  local limit=$((SECONDS + 30))
  roslaunch -p "$port" cdpr_kinetostatics "$@" >"$launch_log" 2>&1 &
  launch=$!
  until (exec 3<>"/dev/tcp/localhost/$port") 2>/dev/null; do
    kill -0 "$launch" 2>/dev/null || fail "roslaunch ended"
    [ $SECONDS -lt $limit ] || fail "no master after 30 s"
    sleep 0.05
  done
}

# beside COMMAND...: runs it as long as the nodes run.
beside() {
  local status=0
  "$@" &
  client=$!
  wait -n "$client" "$launch" || status=$?
  kill -0 "$launch" 2>/dev/null || fail "the nodes ended too early"
  [ "$status" -eq 0 ] || fail "$(basename "$1") failed"
  client=
}
