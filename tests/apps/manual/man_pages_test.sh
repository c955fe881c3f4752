#!/usr/bin/env bash
# What other programs say to the manual pages: man-db sets each one without a warning, mandoc finds nothing that is worse
# than a matter of style, and man and the shells find what is installed.   man_pages_test.sh BUILD_FOLDER
set -uo pipefail
pages=$1/manual/man
failures=0
export MANWIDTH=80 LC_ALL=C.UTF-8

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

[ "$(find "$pages" -name '*.[15]' | wc -l)" -gt 15 ] || fail "few pages in $pages"
for page in "$pages"/*; do
  said=$(man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
  [ -z "$said" ] || fail "man says of $page: $said"
  # There is no date on a page, since a page made again must be the same.
  said=$(mandoc -T lint -W warning "$page" | grep -v 'missing date')
  [ -z "$said" ] || fail "mandoc says: $said"
done

prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
env -u DESTDIR cmake --install "$1" --prefix "$prefix" --component program >/dev/null || fail "it cannot be installed"
for page in "1 mesopix" "1 mesopix-simulate" "1 mesopix-study-submit" "5 mesopix-scene"; do
  man -M "$prefix/share/man" -w ${page} >/dev/null || fail "man does not find $page"
done
for file in bash-completion/completions/mesopix zsh/vendor-completions/_mesopix fish/vendor_completions.d/mesopix.fish; do
  [ -s "$prefix/share/$file" ] || fail "$file is not installed"
done

[ "$failures" -eq 0 ] && echo "all as expected"
exit $((failures > 0))
