#!/usr/bin/env bash
# Tests the real window on a virtual display: presses keys, drags a body with the mouse, and reads back the result.
# usage: window_test.sh CAIRN_PROGRAM DRIVER_PROGRAM [drops]
# The driver (window_test.cpp and others) sends input and checks the reports; this script starts and ends the programs.
# With `drops`, files are then dropped on another viewer.
set -u
cairn=$1
driver=$2
for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

folder=$(mktemp -d)
viewer=
server=
finish() {
    [ -n "$viewer" ] && kill "$viewer" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT

# The server chooses a free display number and reports it.
Xvfb -displayfd 3 -screen 0 1024x640x24 +extension GLX -nolisten tcp 3>"$folder/display" 2>"$folder/server.log" &
server=$!
for _ in $(seq 100); do
    [ -s "$folder/display" ] && break
    sleep 0.1
done
[ -s "$folder/display" ] || { echo "Xvfb did not start:"; cat "$folder/server.log"; exit 1; }
DISPLAY=:$(cat "$folder/display")
export DISPLAY
unset WAYLAND_DISPLAY
export XDG_CONFIG_HOME=$folder/config # not the configuration of the user who runs this

# A plane and one box of 1 m, seen from nearby: little to draw.
cat >"$folder/scene.gltf" <<'GLTF'
{"asset": {"version": "2.0"},
 "extensionsUsed": ["KHR_implicit_shapes", "KHR_physics_rigid_bodies", "CAIRN_world"],
 "extensions": {"KHR_implicit_shapes": {"shapes": [
   {"type": "plane", "plane": {}}, {"type": "box", "box": {"size": [1, 1, 1]}}]}},
 "scene": 0,
 "scenes": [{"nodes": [0, 1], "extensions": {"CAIRN_world": {"title": "One box",
   "camera": {"position": [0, 2, 8], "target": [0, 1, 0], "vertical_fov_degrees": 45}}}}],
 "nodes": [
  {"name": "ground", "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 0}}}}},
  {"name": "crate", "translation": [0, 0.5, 0], "extensions": {"KHR_physics_rigid_bodies": {
    "motion": {"mass": 500}, "collider": {"geometry": {"shape": 1}}}}}]}
GLTF

# Stands in for the desktop's browser launcher: notes which page is opened.
mkdir "$folder/bin"
printf '#!/bin/sh\necho "$1" >%s/opened\n' "$folder" >"$folder/bin/xdg-open"
chmod +x "$folder/bin/xdg-open"
PATH=$folder/bin:$PATH

# The viewer writes its state to a file at each `report` line of a script: ten times per second.
for _ in $(seq 2000); do printf 'wait 0.1\nreport %s/state.json\n' "$folder"; done >"$folder/script"
cd "$folder" || exit 1 # where files are saved
"$cairn" view "$folder/scene.gltf" --width 800 --height 500 --script "$folder/script" --report "$folder/last.json" \
    --exit-after 200 2>"$folder/viewer.log" &
viewer=$!

"$driver" "$folder" "$viewer"
code=$?
cat "$folder/viewer.log"
[ "$code" -eq 0 ] || exit "$code"

wait "$viewer"
code=$?
viewer=
[ "$code" -eq 0 ] || { echo "FAILED  the viewer's exit code is $code"; exit 1; }
[ -s "$folder/last.json" ] || { echo "FAILED  no report was written on exit"; exit 1; }
echo "ok      the viewer quit and wrote its report"

# Window positions are remembered for the next start. A driver that moved a window has written its position.
if [ -s "$folder/moved" ]; then
    read -r x y <"$folder/moved"
    for step in 'wait 0.5' 'key F3' 'wait 1' "report $folder/next.json" quit; do echo "$step"; done >"$folder/script"
    "$cairn" view "$folder/scene.gltf" --width 800 --height 500 --script "$folder/script" --exit-after 60 ||
        { echo "FAILED  the next viewer"; exit 1; }
    python3 - "$folder/next.json" "$x" "$y" <<'PYTHON' || { echo "FAILED  a moved window is kept there"; exit 1; }
import json, sys
place = json.load(open(sys.argv[1]))["places"]["plots.group"]
assert all(abs(place[i] - float(sys.argv[2 + i])) < 2.0 for i in range(2)), place
PYTHON
    echo "ok      a moved window is there again in the next run"
    for step in 'wait 0.5' 'key F3' 'wait 1.5' "report $folder/next.json" quit; do echo "$step"; done >"$folder/script"
    "$cairn" view "$folder/scene.gltf" --width 600 --height 300 --script "$folder/script" --exit-after 60 ||
        { echo "FAILED  the viewer in a smaller window"; exit 1; }
    python3 - "$folder/next.json" <<'PYTHON' || { echo "FAILED  windows are in the picture of a smaller window"; exit 1; }
import json, sys
state = json.load(open(sys.argv[1]))
x, y = state["places"]["plots.csv"]  # at the lower end
assert state["left"] < x < 600 and 0 < y < 260, (x, y)
PYTHON
    echo "ok      in a smaller window it is in the picture, too"
fi
[ "${3:-}" = drops ] || exit 0

# A script's mouse reaches the panels: it clicks a body, which opens its inspector, and then a button there. Their
# positions are read from the reports of the previous runs.
clicks=()
for place in crate inspector.duplicate counted; do
    for step in 'wait 0.5' "${clicks[@]}" "report $folder/script.json" quit; do echo "$step"; done >"$folder/script"
    "$cairn" view "$folder/scene.gltf" --width 800 --height 500 --script "$folder/script" --exit-after 60 ||
        { echo "FAILED  the viewer whose script clicks"; exit 1; }
    at=$(python3 - "$folder/script.json" "$place" <<'PYTHON'
import json, sys
state, place = json.load(open(sys.argv[1])), sys.argv[2]
if place == "counted":
    assert state["dynamic_count"] == 2, state["dynamic_count"]
else:
    print(*(state["bodies"][1]["screen"] if place == "crate" else state["places"][place]))
PYTHON
    ) || { echo "FAILED  a script's click reaches $place"; exit 1; }
    [ "$place" = inspector.duplicate ] && button=$at
    clicks+=("cursor $at" 'wait 0.3' 'press left' 'wait 0.2' 'release left' 'wait 1')
done
echo "ok      a script clicks a button in a panel"

# The inspector was at the right edge of the picture; in a wider one it is there, too.
clicks=()
for place in crate inspector.duplicate; do
    for step in 'wait 0.5' "${clicks[@]}" "report $folder/script.json" quit; do echo "$step"; done >"$folder/script"
    "$cairn" view "$folder/scene.gltf" --width 1000 --height 500 --script "$folder/script" --exit-after 60 ||
        { echo "FAILED  the viewer in a larger window"; exit 1; }
    at=$(python3 - "$folder/script.json" "$place" ${button:-} <<'PYTHON'
import json, sys
state, place = json.load(open(sys.argv[1])), sys.argv[2]
if place == "crate":
    print(*state["bodies"][1]["screen"])
else:
    x, before = state["places"][place][0], float(sys.argv[3])
    assert abs(x - before - 200) < 3, (x, before)
PYTHON
    ) || { echo "FAILED  the inspector stays at the right edge of a wider picture"; exit 1; }
    clicks+=("cursor $at" 'wait 0.3' 'press left' 'wait 0.2' 'release left' 'wait 1')
done
echo "ok      the inspector stays at the right edge of a wider picture"

# Dropped files: a file that cannot be opened keeps the scene and shows a message; a valid one replaces the scene.
sed 's/One box/Another box/' "$folder/scene.gltf" >"$folder/other.gltf"
echo '{"asset": 1' >"$folder/broken.gltf"
printf 'v 0 0 0\nv 0 0 4\nv 4 0 0\nf 1 2 3\n' >"$folder/ramp.obj"
"$cairn" record "$folder/scene.gltf" -o "$folder/run.mcap" --seconds 2 >/dev/null || exit 1
for step in "drop $folder/run.mcap" 'wait 1' 'key Space' 'wait 4' "report $folder/recording.json" \
    "drop $folder/broken.gltf" 'wait 1' "report $folder/broken.json" \
    "drop $folder/other.gltf" 'wait 1' "report $folder/other.json" "drop $folder/ramp.obj" 'wait 1' quit; do
    echo "$step"
done >"$folder/script"
"$cairn" view "$folder/scene.gltf" --width 400 --height 300 --script "$folder/script" --report "$folder/last.json" \
    --exit-after 60 || { echo "FAILED  the viewer that files were dropped on"; exit 1; }
grep -q '"title": "run.mcap"' "$folder/recording.json" && grep -q '"now": 120' "$folder/recording.json" &&
    grep -q '"first_different": null' "$folder/recording.json" && grep -q '"paused": true' "$folder/recording.json" ||
    { echo "FAILED  a dropped recording must be played to its end"; cat "$folder/recording.json"; exit 1; }
# A recording is shown with the camera and colors of its scene. Without the fix it had another camera and other colors.
python3 - "$folder/recording.json" <<'PYTHON' || { echo "FAILED  a recording has the camera of its scene"; exit 1; }
import json, sys
position = json.load(open(sys.argv[1]))["camera"]["position"]
assert all(abs(a - b) < 1e-3 for a, b in zip(position, [0, 2, 8])), position
PYTHON
grep -q '"title": "run.mcap"' "$folder/broken.json" && grep -q '"notice": ".*broken.gltf' "$folder/broken.json" ||
    { echo "FAILED  a broken file must leave the scene and a message"; cat "$folder/broken.json"; exit 1; }
# The force fields of the scene are saved with it.
sed 's/"camera"/"force_fields": [{"kind": "uniform", "direction": [0, 0, 1]}], "camera"/' "$folder/scene.gltf" \
    >"$folder/windy.gltf"
mkdir "$folder/saved" && cd "$folder/saved" || exit 1
printf 'wait 0.5\nkey Ctrl+S\nwait 1\nquit\n' >"$folder/script"
"$cairn" view "$folder/windy.gltf" --width 400 --height 300 --script "$folder/script" --exit-after 60 &&
    grep -q '"force_fields"' ./*.gltf || { echo "FAILED  a force field is lost when the scene is saved"; exit 1; }
cd "$folder" || exit 1
echo "ok      force fields are saved with a scene"
for opened in other.json:'Another box' last.json:ramp; do
    grep -q "\"title\": \"${opened#*:}\"" "$folder/${opened%%:*}" ||
        { echo "FAILED  a dropped scene must be opened"; cat "$folder/${opened%%:*}"; exit 1; }
done
echo "ok      dropped files are opened, or refused with a message"
