#!/usr/bin/env bash
# The commands reproduce and bench, as real processes.
#   evidence.sh MESOPIX DATA_FOLDER
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# The paper's figures: one of them, what is no figure, and the scenes for simulate.
expect 0 reproduce --figure 3 -o paper
is_empty out
has err "wrote paper"
grep -q $'\r' err && fail "a progress line where there is no terminal"
python3 -c 'import json, xml.dom.minidom as x; json.load(open("paper/reproduction.json")); x.parse("paper/report.html")' ||
  fail "report or numbers of a reproduction cannot be read"
expect 64 reproduce --figure 99
has err "mesopix: --figure: 99; must be 1, 2, 3"
for scene in "$data"/paper/*.toml; do expect 0 simulate "$scene" --print-scene; done
"$mesopix" reproduce --figure 5 -o stopped_paper 2>err &
process=$!
sleep 1.5
kill -INT "$process"
wait "$process"
code=$?
[ "$code" -eq 75 ] || fail "a reproduction interrupted with exit code $code, not 75: $(cat err)"
has stopped_paper/report.html "It was interrupted before the runs of these were done: Figure 5."

# How exact the program is for its time.
expect 0 bench error --problem layers -o errors
has out "layers"
grep -q $'\r' err && fail "a progress line where there is no terminal"
for file in error.csv error_vs_time.html layers.png; do exists errors/$file; done
python3 -c 'import xml.dom.minidom as x; x.parse("errors/error_vs_time.html")' || fail "the page of errors cannot be read"
expect 64 bench error --problem layer
has err "did you mean layers?"

conclude
