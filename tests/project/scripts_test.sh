#!/usr/bin/env bash
# What the scripts say when something is wrong. Usage: scripts_test.sh SOURCE_DIR
set -u
source_dir=$1
stubs=$(mktemp -d)
trap 'rm -rf "$stubs"' EXIT

stub() { printf '#!/bin/bash\n%s\n' "$2" >"$stubs/$1" && chmod +x "$stubs/$1"; }
for tool in bash env mktemp rm tail cat dirname readlink; do ln -s "$(command -v $tool)" "$stubs/$tool"; done
failures=0

# expect STATUS TEXT COMMAND...: with only the stubs to run
expect() {
  local status=$1 text=$2 output met
  shift 2
  output=$(cd / && PATH=$stubs "$@" 2>&1 </dev/null)
  met=$?
  [ $met -eq "$status" ] && [[ $output == *"$text"* ]] && return
  echo "FAILED: $*: status $met, not $status, or not a word of '$text' in:" "$output"
  failures=$((failures + 1))
}
install=$source_dir/.ci/install-packages

stub id 'echo 0'
stub dpkg-query 'echo installed'
stub apt-get 'echo "apt-get was called"; exit 1'
expect 0 "" "$install" check
expect 0 "" "$install" package
expect 2 "usage:" "$install"
expect 2 "'nonsense' is no step; the steps are: format gcc clang fuzz tsan coverage tidy cppcheck package, and all" "$source_dir/check" nonsense
expect 2 "usage: ./quickstart [all]" "$source_dir/quickstart" nonsense

stub dpkg-query '[[ $* == *libtiff-dev* ]] && exit 1; echo installed'
expect 1 "Installing 1 Debian packages: libtiff-dev" "$install" build
expect 1 "apt-get was called
mesopix: apt-get failed, see above. These packages are missing:
  libtiff-dev" "$install" build
stub apt-get 'exit 0'
expect 0 "Installing 1 Debian packages: libtiff-dev" "$install" build

stub id 'echo 1000'
expect 1 "As root, run:
  apt-get install --no-install-recommends libtiff-dev" "$install" build
stub sudo 'echo "sudo: $*"; exit 1'
expect 1 "sudo: env DEBIAN_FRONTEND=noninteractive apt-get" "$install" build

expect 1 "debootstrap and chroot need root" "$source_dir/tests/project/clean_debian_test.sh" "$source_dir" .

rm "$stubs/dpkg-query"
expect 0 "this is no Debian system" "$install" build

[ $failures -eq 0 ] && echo "the scripts say what they should"
exit $failures
