# For scripts that try the program: SCRIPT MESOPIX DATA_FOLDER, each in an empty folder of its own.
set -u
mesopix=$(realpath "$1")
data=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE ARGUMENTS...: run the program, keep its streams in out and err.
expect() {
  local wanted=$1
  shift
  "$mesopix" "$@" >out 2>err
  local code=$?
  [ "$code" -eq "$wanted" ] || fail "mesopix $*: exit code $code, not $wanted: $(cat err)"
}

same() { cmp -s "$1" "$2" || fail "$1 and $2 differ"; }
has() { grep -qF -- "$2" "$1" || fail "$1 lacks \"$2\": $(cat "$1")"; }
is_empty() { [ ! -s "$1" ] || fail "$1 is not empty: $(cat "$1")"; }
exists() { [ -e "$1" ] || fail "$1 is missing"; }

# The last line of a script: how many things were not as expected.
conclude() {
  [ "$failures" -eq 0 ] && echo "all as expected"
  exit $((failures > 0))
}
