#!/usr/bin/env bash
# Installs the packages of a folder on a Debian 12 that has nothing else, made by debootstrap in a temporary folder, and uses
# them there as an ordinary user: the program, the Python package, and each library without what the other needs.
# Usage, as root: clean_debian_test.sh SOURCE_DIR PACKAGES_DIR
set -euo pipefail
[ "$(id -u)" -eq 0 ] || { echo "clean_debian_test.sh: debootstrap and chroot need root" >&2; exit 1; }
source_dir=$(realpath "$1") packages=$(realpath "$2")
# /var/tmp, since /tmp may be small, or not allow devices
work=$(mktemp -d /var/tmp/mesopix-clean-XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT
version=$(sed -n 's/^project(mesopix VERSION \([^ ]*\).*/\1/p' "$source_dir/CMakeLists.txt")
tried=0

# inside ROOT USER COMMAND...: in a namespace of its own, so that nothing stays mounted and nothing goes on
inside() {
  local root=$1 user=$2
  shift 2
  unshare --mount --pid --fork --mount-proc="$root/proc" chroot --userspec="$user" "$root" env -i \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/home/user LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy="$http_proxy"} "$@" </dev/null
}
apt() { inside "$1" root apt-get -q -y -o Dpkg::Use-Pty=0 --no-install-recommends "${@:2}" >>"$work/apt.log" 2>&1 ||
  { tail -n 30 "$work/apt.log"; echo "apt-get failed: ${*:2}"; exit 1; } }

# try ROOT WHAT SCRIPT: as the ordinary user, in the home folder
try() {
  local status=0
  inside "$1" user bash -euo pipefail -c "cd; version=$version; $3" >"$work/try.log" 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    cat "$work/try.log"
    echo "FAILED: $2: status $status"
    exit 1
  fi
  echo "ok: $2"
  tried=$((tried + 1))
}

# lacks ROOT PATTERN: no package that matches is installed there
lacks() {
  local met
  met=$(inside "$1" root dpkg-query -W -f '${Package}\n' | grep -E "$2" || true)
  [ -z "$met" ] || { echo "FAILED: came along: $met"; exit 1; }
}

count_packages() { inside "$1" root dpkg-query -W | wc -l; }

copy() { cp -a --reflink=auto "$1" "$2"; }

lint() {
  lintian --fail-on error,warning --allow-root "$packages"/*.deb
  echo "ok: lintian has nothing to say"
}

make_bare_debian() {
  local mirror
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' 'Component: main' |
    head -n 1)
  debootstrap --variant=minbase bookworm "$1" "${mirror:-http://deb.debian.org/debian}" >"$work/apt.log" ||
    { tail -n 30 "$work/apt.log"; exit 1; }
  mkdir "$1/packages"
  cp "$packages"/*.deb "$1/packages"
  (cd "$1/packages" && dpkg-scanpackages . >Packages 2>/dev/null)
  echo "deb [trusted=yes] file:/packages ./" >>"$1/etc/apt/sources.list"
  inside "$1" root useradd --create-home user
  apt "$1" update
}

try_program() {
  local root=$work/program
  copy "$bare" "$root"
  apt "$root" install mesopix
  lacks "$root" '^(gcc|g\+\+)(-[0-9]+)?$|^cmake|^python3|-dev$'
  echo "mesopix brought $(($(count_packages "$root") - $(count_packages "$bare") - 1)) packages"
  try "$root" "every file is as it was packed" 'dpkg --verify mesopix && [ -s /var/lib/dpkg/info/mesopix.md5sums ]'
  try "$root" "mesopix --version" '[ "$(mesopix --version)" = "mesopix $version" ]'
  try "$root" "the examples are there, and none but they" 'cp -r /usr/share/doc/mesopix/examples . && [ -s examples/README.md ]'
  try "$root" "mesopix generate" 'mesopix generate --width "40 mm" --height "40 mm" --d-min "4 mm" --d-max "10 mm" \
    --itz-mode none -o cut.png && [ -s cut.png ]'
  try "$root" "mesopix convert" 'mesopix convert cut.png --width "40 mm" -o cut.h5 && mesopix inspect cut.h5'
  try "$root" "mesopix simulate, until it is broken" 'mesopix simulate cut.h5 --velocity "0.1 m/s" --stop-drop 0.2 \
    -o runs/cut && [ -s runs/cut/report.html ] && [ -s runs/cut/result.h5 ]'
  try "$root" "mesopix plot, with the fonts that came along" 'mesopix plot runs/cut -o damage.pdf && [ -s damage.pdf ]'
  local example
  for example in "$root"/usr/share/doc/mesopix/examples/{,paper/}*.toml; do
    example=${example#"$root"/usr/share/doc/mesopix/}
    [[ $example == *_study.toml ]] ||
      try "$root" "$example is a scene" "mesopix simulate --print-scene /usr/share/doc/mesopix/$example >scene.toml &&
        [ -s scene.toml ]"
  done
  try "$root" "an example, short" 'mesopix simulate examples/two_aggregates.toml --stop-strain 1e-5 -o runs/two'
  try_manuals "$root"
  leaves_nothing "$root" mesopix
}

try_manuals() {
  local root=$1
  apt "$root" install man-db bash-completion
  try "$root" "man mesopix" 'man --warnings mesopix >page.txt 2>errors && grep -q mesopix page.txt && [ ! -s errors ]'
  try "$root" "bash completes mesopix" 'bash -c ". /usr/share/bash-completion/bash_completion; _completion_loader mesopix || true
    complete -p mesopix"'
}

try_python() {
  local root=$work/python
  compgen -G "$packages/python3-mesopix_*.deb" >/dev/null || return 0
  copy "$bare" "$root"
  apt "$root" install python3-mesopix
  lacks "$root" '^(gcc|g\+\+)(-[0-9]+)?$|^cmake|^mesopix|-dev$'
  try "$root" "import mesopix" "python3 -c 'import mesopix; assert mesopix.__version__ == \"$version\"'"
  try "$root" "mesopix.simulate" "python3 -c 'import mesopix
specimen = mesopix.generate(width=0.04, height=0.04, d_min=4e-3, d_max=10e-3)
assert mesopix.simulate(specimen, velocity=0.2, stop_strain=1e-4).curve.stress.max() > 1e5'"
  try "$root" "its modules are compiled" 'ls /usr/lib/python3/dist-packages/mesopix/__pycache__/*.pyc'
  leaves_nothing "$root" python3-mesopix
}

# try_library ROOT LIBRARY PATTERN: built and run with no package there that matches
try_library() {
  local root=$work/$1
  copy "$tools" "$root"
  apt "$root" install "libmesopix-$1-dev"
  lacks "$root" "$2"
  cp -r "$source_dir/tests/project/consumer" "$root/home/user/consumer"
  try "$root" "a project with the library $1 alone" "cmake -S consumer -B build -G Ninja -DCOMPONENTS=$1 &&
    cmake --build build && build/use_$1"
}

try_libraries() {
  tools=$work/tools
  copy "$bare" "$tools"
  apt "$tools" install g++ cmake ninja-build
  try_library specimen 'eigen|mesopix-mpm'
  try_library mpm 'opencv|libpng-dev|libtiff|mesopix-specimen'  # libhdf5-dev brings libjpeg-dev
  apt "$work/mpm" install libmesopix-specimen-dev
  try "$work/mpm" "a project with both libraries" 'cmake -S consumer -B both -G Ninja && cmake --build both && both/use_both'
}

# leaves_nothing ROOT PACKAGE: once it is purged, with what came along
leaves_nothing() {
  apt "$1" purge --autoremove "$2"
  local left
  left=$(find "$1" -xdev \( -path "$1/home" -o -path "$1/packages" -o -path "$1/var/lib/apt" -o -path "$1/var/cache" \
    -o -path "$1/var/log" \) -prune -o -name '*mesopix*' -print)
  [ -z "$left" ] || { echo "FAILED: $2 leaves behind: $left"; exit 1; }
  echo "ok: $2 is purged, and leaves nothing behind"
  tried=$((tried + 1))
}

lint
bare=$work/bare
make_bare_debian "$bare"
try_program
try_python
try_libraries
echo "In all: $tried things tried with $(ls "$packages"/*.deb | wc -l) packages on a Debian 12 that had nothing else"
