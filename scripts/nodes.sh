# Shared by the scripts that start nodes: they build, start a master of their own, launch, and leave no process behind.
# To be sourced after common.sh, not to be run.

scratch=$(mktemp -d) # removed at the end
launch_log=$scratch/roslaunch.log
launch=              # number of the process of roslaunch
client=              # number of the process that `beside` waits for

stop() {
  local process
  for process in $client $launch; do
    if kill -INT "$process" 2>/dev/null; then wait "$process" || true; fi
  done
  client= launch=
}
trap 'stop; rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM

# Installs and builds. Prints what the build says only if it fails.
prepare() {
  "$repository/scripts/setup.sh"
  echo "building (the first time takes some minutes)"
  if ! build >"$scratch/build.log" 2>&1; then
    cat "$scratch/build.log"
    exit 1
  fi
  source_workspace
  # The master is our own, on a free port, so that whatever else runs on this machine is left alone.
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

# beside COMMAND...: runs the command beside the nodes; ends if either fails.
beside() {
  local status=0
  "$@" &
  client=$!
  wait -n "$client" "$launch" || status=$?
  kill -0 "$launch" 2>/dev/null || fail "the nodes ended too early"
  [ "$status" -eq 0 ] || fail "$(basename "$1") failed"
  client=
}
