# Shared by the scripts of this folder: pinned packages in a temporary folder, and nothing left behind.
# Sourced, never run. Packages are unpacked beside the system and not installed, so no root is needed.

set -euo pipefail
export LC_ALL=C.UTF-8

FINDINGS_TMP=$(mktemp -d "${TMPDIR:-/tmp}/finding.XXXXXX")
root=$FINDINGS_TMP/root
python=/usr/bin/python3
installed_npm=no
mkdir -p "$root" "$FINDINGS_TMP/work"
cd "$FINDINGS_TMP/work"

leave() {
  cd /
  rm -rf "$FINDINGS_TMP"
  if [ "$installed_npm" = yes ]; then apt-get -qq -y -o Dpkg::Options::=--force-unsafe-io purge --auto-remove npm nodejs >/dev/null 2>&1 || true; fi
}
trap leave EXIT

cannot_check() {
  echo "cannot check: $*" >&2
  exit 2
}

# Lists of this machine where it has them, fresh ones in the temporary folder where it has none.
apt_options=(-o Debug::NoLocking=1 -o APT::Install-Recommends=false -o APT::Sandbox::User=root -o Acquire::Retries=2)
solve() { apt-get "${apt_options[@]}" -o "Dir::State::status=$FINDINGS_TMP/no-status" -s -qq install "$@"; }

# fetch_debian NAME=VERSION...: unpack these packages and what they need below $root. Sets $python and the search paths.
# What this machine has already in the same version is not fetched again, unless parts of it find each other by their folder.
fetch_debian() {
  local plan name version deb folders wanted=()
  : >"$FINDINGS_TMP/no-status"
  if ! plan=$(solve "$@" 2>/dev/null); then
    mkdir -p "$FINDINGS_TMP/apt/lists/partial" "$FINDINGS_TMP/apt/cache/archives/partial"
    apt_options+=(-o "Dir::State::lists=$FINDINGS_TMP/apt/lists" -o "Dir::Cache=$FINDINGS_TMP/apt/cache")
    apt-get "${apt_options[@]}" -qq update >&2 || cannot_check "no package lists"
    plan=$(solve "$@") || cannot_check "$* cannot be had from the package sources of this machine"
  fi
  while read -r name version; do
    case $name in
      libc6 | libc-bin | base-files | dpkg | tar | debconf | perl-base) continue ;;           # every Debian has them
      *-dev | gcc-12 | g++* | cpp* | binutils* | python3-pythran | fonts-*) continue ;;       # not needed to run
      python3-* | *mpi* | *pmix* | *hwloc* | *ucx* | *petsc*) ;;                              # find each other by folder
      *)
        if [[ " $* " != *" $name="* ]] &&
          [ "$(dpkg-query -W -f '${db:Status-Status} ${Version}' "$name" 2>/dev/null)" = "installed $version" ]; then
          continue
        fi
        ;;
    esac
    wanted+=("$name=$version")
  done < <(sed -n 's/^Inst \([^ ]*\) (\([^ ]*\) .*/\1 \2/p' <<<"$plan")
  mkdir -p "$FINDINGS_TMP/deb"
  (cd "$FINDINGS_TMP/deb" && apt-get "${apt_options[@]}" -qq download "${wanted[@]}" >&2)
  for deb in "$FINDINGS_TMP"/deb/*.deb; do dpkg -x "$deb" "$root"; done
  rm -rf "$FINDINGS_TMP/deb"
  folders=$(find "$root/usr/lib" "$root/lib" -name '*.so*' -printf '%h\n' 2>/dev/null | grep -v -e python3 | sort -u | tr '\n' ':' || true)
  export LD_LIBRARY_PATH=$root/usr/lib/x86_64-linux-gnu:$root/lib/x86_64-linux-gnu:$folders
  export PYTHONPATH=$root/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1
  export PATH=$root/usr/bin:$root/bin:$PATH
  if [ -x "$root/usr/bin/python3" ]; then python=$root/usr/bin/python3; fi
  if [ -e "$root/usr/lib/x86_64-linux-gnu/libmpi.so.40" ]; then  # Open MPI of $root, on this machine only
    export OPAL_PREFIX=$root/usr OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm=isolated
    export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
  fi
}

# fetch_npm NAME@VERSION...: unpack these npm packages into node_modules of the folder we are in.
fetch_npm() {
  if ! command -v npm >/dev/null; then
    [ "$(id -u)" = 0 ] || cannot_check "npm is missing; install it with: apt-get install npm"
    [ -n "$(ls /var/lib/apt/lists/*_Packages* 2>/dev/null)" ] || apt-get -qq update >&2
    installed_npm=yes
    DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Dpkg::Options::=--force-unsafe-io --no-install-recommends install npm ca-certificates >/dev/null 2>&1 || cannot_check "npm cannot be installed"
  fi
  echo '{"private": true}' >package.json
  env -u LD_LIBRARY_PATH npm install --loglevel=error --ignore-scripts --no-audit --no-fund --no-package-lock "$@" >&2
}

# mpirun_here N COMMAND...: the mpirun of $root.
mpirun_here() {
  local ranks=$1
  shift
  "$root/usr/bin/mpirun.openmpi" -n "$ranks" --oversubscribe "$@"
}
