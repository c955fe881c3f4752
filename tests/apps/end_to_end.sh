#!/usr/bin/env bash
# What only a real process can show: exit codes, streams, signals, and that a resolved scene gives the same run.
#   end_to_end.sh MESOPIX DATA_FOLDER
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

small=(--width "30 mm" --height "30 mm" --pixel-size "1 mm" --fraction 0.3 --d-max "10 mm")

# Generate, then break, with nothing but defaults.
expect 0 generate "${small[@]}" -o specimen.h5
is_empty out
expect 0 simulate specimen.h5 -o first
is_empty out
grep -q $'\r' err && fail "a progress line where there is no terminal"
for file in curve.csv result.h5 summary.json scene.toml specimen.png report.html; do exists "first/$file"; done

# The resolved scene gives the same run: the same curve to the last digit, and the same scene.
expect 0 simulate first/scene.toml -o second -q
is_empty err
same first/curve.csv second/curve.csv
same first/scene.toml second/scene.toml

# So it does for a scene whose specimen is random, and for one that lists its ellipses.
cat >scene.toml <<'SCENE'
[generate]
width = "30 mm"
height = "30 mm"
pixel_size = "1 mm"
d_max = "10 mm"
fraction = 0.3
[phases.mortar]
tensile_scale = "8 MPa"
SCENE
expect 0 simulate scene.toml
expect 0 simulate runs/scene/scene.toml
exists runs/scene-2/curve.csv
same runs/scene/curve.csv runs/scene-2/curve.csv
expect 0 simulate scene.toml -o other --seed 2
cmp -s runs/scene/curve.csv other/curve.csv && fail "another seed gave the same curve"
printf 'x_mm,y_mm,a_mm,b_mm\n15,15,8,5\n' >list.csv
printf '[specimen]\nellipses = "list.csv"\n[generate]\nwidth = "30 mm"\nheight = "30 mm"\npixel_size = "1 mm"\n' >list.toml
expect 0 simulate list.toml -o listed
rm list.csv
expect 0 simulate listed/scene.toml -o listed_again
same listed/curve.csv listed_again/curve.csv

# JSON is alone on standard output.
expect 0 simulate specimen.h5 -o third --json
has out '"peak_stress_Pa"'
python3 -c 'import json; json.load(open("out"))' || fail "the summary is no JSON"

# Inspect a folder, a result and a specimen.
expect 0 inspect third
has out "result: peak"
expect 0 inspect third/result.h5 --json
expect 0 inspect specimen.h5

# A picture and back gives the same labels.
expect 0 generate "${small[@]}" -o labels.png
expect 0 convert labels.png -o back.png
expect 0 convert back.png -o again.png --reference labels.png --json
same back.png again.png
same labels.png back.png
has out '"mortar": 1.0'

# A calibration meets its target, and its scene runs as it is; Ctrl-C keeps the best so far.
expect 0 calibrate scene.toml --peak-stress "1.5 MPa" --peak-strain "70 microstrain" -o fitted --json
has out '"met": true'
grep -q $'\r' err && fail "a progress line where there is no terminal"
for file in calibration.json scene.toml report.html; do exists "fitted/$file"; done
expect 0 simulate fitted/scene.toml -o fitted_run --json
python3 - <<'CHECK' || fail "the fitted scene does not give the peak that was fitted"
import json
fitted = json.load(open("fitted/calibration.json"))["fitted"]["runs"][0]
run = json.load(open("out"))
assert (fitted["peak_stress_Pa"], fitted["peak_strain"]) == (run["peak_stress_Pa"], run["peak_strain"])
CHECK
python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse("fitted/report.html")' || fail "the report is not well formed"
expect 65 calibrate scene.toml --peak-stress "0.1 MPa" --free "tensile_scale=6 MPa..20 MPa" -o unreached
has err "phases.mortar.tensile_scale at its lower bound of 6 MPa; what was found is in unreached"
exists unreached/report.html
"$mesopix" calibrate "$data/two_aggregates.toml" --peak-stress "1.75 MPa" --seeds 1000 -o kept 2>err &
process=$!
sleep 2  # of minutes
kill -INT "$process"
wait "$process"
code=$?
[ "$code" -eq 75 ] || fail "a calibration interrupted with exit code $code, not 75: $(cat err)"
[ ! -d kept ] || exists kept/calibration.json

# A study goes on where it was stopped, and gives the table of one that never was.
cp "$data/small_tension.toml" .
printf 'scene = "small_tension.toml"\nseeds = 12\n[vary]\n"loading.velocity" = ["0.02 m/s", "0.1 m/s"]\n' >stopped.toml
"$mesopix" study stopped.toml 2>err &
process=$!
for ((i = 0; i < 500; ++i)); do  # until it has something to lose
  [ -z "$(ls runs/stopped/members 2>/dev/null)" ] || break
  sleep 0.02
done
kill -TERM "$process"
wait "$process"
code=$?
[ "$code" -eq 75 ] || fail "a study interrupted with exit code $code, not 75: $(cat err)"
has err "to go on: mesopix study stopped.toml"
[ ! -e runs/stopped/table.csv ] || fail "a table of a study that was stopped"
expect 0 study stopped.toml
grep -q $'\r' err && fail "a progress line where there is no terminal"
expect 0 study stopped.toml -o whole --jobs 1 -q
is_empty err
same runs/stopped/table.csv whole/table.csv
same runs/stopped/table.h5 whole/table.h5
python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse("whole/report.html")' || fail "the report is not well formed"

# What is refused, and how.
expect 64 simulate specimen.h5 -o first
has err "mesopix: -o: first; is not empty; choose another folder, or add --overwrite"
expect 0 simulate specimen.h5 -o first --overwrite
expect 64 simulate specimen.h5 --velocity 0.05
has err 'mesopix: --velocity: 0.05; needs a unit; write e.g. "0.05 m/s"'
expect 65 simulate specimen.h5 --mortr.young "20 GPa"
has err "did you mean mortar?"
[ "$(wc -l <err)" -eq 1 ] || fail "more than one line for one mistake"
# A map that can be read in two ways: both commands, and one of them does.
python3 -c 'print("P2 80 60 9\n" + "\n".join(" ".join("7" if c < 40 else "1" for c in range(80)) for r in range(60)))' >halves.pgm
expect 65 convert halves.pgm --width "80 mm" -o halves.h5
has err "the map can be read in two ways"
has err 'mesopix convert halves.pgm --width '"'80 mm'"' --label-phases 1:aggregate,7:mortar -o halves.h5'
has err "--label-phases 1:mortar,7:aggregate -o halves.h5"
expect 0 convert halves.pgm --width "80 um" --label-phases 1:mortar,7:aggregate -q -o halves.h5
has err "warning: the specimen is 0.08 mm wide"
expect 0 convert halves.pgm --width "80 um" --label-phases 1:mortar,7:aggregate --json -q -o halves.h5
has out '"warnings": ['
echo "no picture" >note.png
expect 65 convert note.png
printf '\x89HDF\r\n\x1a\n and no more' >broken.h5
expect 65 simulate broken.h5
[ "$(wc -l <err)" -eq 1 ] || fail "more than one line for one damaged file: $(cat err)"
expect 74 generate "${small[@]}" -o no/such/folder.h5
if [ -e /dev/full ]; then
  "$mesopix" inspect specimen.h5 --json >/dev/full 2>err
  [ $? -eq 74 ] || fail "a full disk was not noticed"
fi

# What lies in data/ is as its README says.
for scene in "$data"/*.toml; do
  case $scene in
    *_study.toml) expect 0 study "$scene" -q --members 0:2 ;;
    *) expect 0 simulate "$scene" --print-scene ;;
  esac
done
expect 0 generate --itz-mode none -o fresh.h5
expect 0 convert fresh_preview.png -o fresh_labels.png
expect 0 convert "$data/concrete.png" -o concrete_labels.png
same fresh_labels.png concrete_labels.png

cp "$data/concrete.png" .
python3 "$data/cut_disc.py" concrete.png disc.png
same disc.png "$data/disc.png"
expect 0 simulate "$data/disc_impact.toml" -o impact --duration "20 us"
has err "stress on the walls"
expect 0 simulate "$data/brazilian.toml" -o brazilian --stop-strain 1e-5
expect 0 simulate "$data/compression_fragments.toml" -o fragments --stop-strain 1e-4
for run in impact brazilian fragments; do
  has $run/report.html "moving points"
  grep -q '"kinematics": "small_strain"' $run/summary.json && fail "$run is of small strain"
done
for run in impact brazilian; do for file in deformed.png deformed_colour.png; do exists $run/$file; done; done
expect 64 simulate specimen.h5 --shape linear
has err 'has an effect with solver.kinematics = "moving" or "auto" only'
expect 0 simulate specimen.h5 -o flight -q --kinematics moving --direction none --initial-velocity-y "-3 m/s" \
  --bottom smooth_wall --duration "20 us"
expect 0 simulate flight/scene.toml -o flight_again -q
same flight/curve.csv flight_again/curve.csv
same flight/deformed.png flight_again/deformed.png
same flight/scene.toml flight_again/scene.toml

# How wrong a run may be.
expect 0 simulate specimen.h5 --estimate-error -o estimated --stop-strain 2.5e-4
has err "the peak stress may be wrong by"
has estimated/report.html "Error of the peak"
python3 -c 'import json; assert len(json.load(open("estimated/summary.json"))["error_estimate"]["sources"]) == 4' ||
  fail "the summary holds no estimate of the error"

# Physics gone wrong ends with the exit code for bad data, and keeps what was computed.
# Pixels alone in their cells beside a block of mortar bear no such step.
{
  echo "P2 12 12 2"
  for _ in 1 2 3; do
    echo "2 2 2 2 2 2 0 2 0 0 0 0"
    for _ in 1 2 3; do echo "2 2 2 2 2 2 0 0 0 0 0 0"; done
  done
} >lone.pgm
expect 65 simulate lone.pgm --convert.method labels --convert.label-phases 0:void,2:mortar --convert.pixel-size "1 mm" \
  --cfl 1 --mortar.poisson 0.4999 --mortar.tensile-scale unbreakable -o diverged
has err "what was computed is in diverged"
exists diverged/report.html

# Ctrl-C keeps what was computed.
"$mesopix" simulate "$data/concrete_compression.toml" -o stopped --set loading.velocity="0.001 m/s" 2>err &
process=$!
for _ in $(seq 100); do
  [ -d stopped ] && break
  sleep 0.1
done
sleep 0.5
kill -INT "$process"
wait "$process"
code=$?
[ "$code" -eq 75 ] || fail "interrupted with exit code $code, not 75: $(cat err)"
exists stopped/curve.csv
has err "to go on: mesopix simulate --resume stopped"
[ "$(ls stopped/checkpoints | wc -l)" -eq 1 ] || fail "an interrupted run has no checkpoint, or more than one"
expect 65 simulate --resume stopped --velocity "0.002 m/s"
has err "the run began with '0.001 m/s'"
expect 0 inspect stopped
has out "(interrupted)"

# What a terminal shows: a red name before an error and a line of progress, but not to who wants none of it.
shown() { env TERM=xterm "${@:2}" script -qec "$mesopix $1" /dev/null; }
shown simulte | grep -qF $'\e[1;31mmesopix:\e[0m simulte: unknown command' || fail "an error on a terminal is not red"
for plain in NO_COLOR=1 TERM=dumb; do
  shown simulte "$plain" | grep -q $'\e' && fail "an error is coloured in spite of $plain"
done
shown "twin labels.png -n 1 -o twins" | grep -qF $'\r\e[K0 of 1 twins' || fail "no progress is shown on a terminal"
for words in "twin labels.png -n 1 -o dumb_twins" "study stopped.toml --members 0:1 -o dumb_study"; do
  shown "$words" TERM=dumb | grep -q $'\e' && fail "progress is drawn on a terminal that is dumb: $words"
done

conclude
