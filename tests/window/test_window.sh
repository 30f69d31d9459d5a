#!/usr/bin/env bash
# The window: opened under Xvfb, played with keys and mouse by xdotool, seen through its screenshots.
# Nothing here waits for a time: it waits for an event, or for the end of the program that should cause
# it. PATIENCE [s] only ends a run that hangs; however slow the machine, no test fails for its speed.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh
PATIENCE=${PATIENCE:-600}
# Mesa leaves 112 bytes when the window library unloads it, and what a driver leaks cannot be told
# apart then; our own leaks show in the headless tests
export ASAN_OPTIONS=detect_leaks=0
unset LSAN_OPTIONS
xvfb='' player=''
trap '[ -z "$player" ] || kill "$player"; [ -z "$xvfb" ] || kill "$xvfb"; wait; rm -rf "$scratch"' EXIT

# until_true command…: it succeeds while the program runs, before patience ends
until_true() {
    local end=$((SECONDS + PATIENCE))
    until "$@" 2>/dev/null; do
        if [ -n "$player" ] && ! kill -0 "$player" 2>/dev/null; then # it may have been its last act
            "$@" 2>/dev/null && return
            echo "  the program ended before: $*"
            return 1
        fi
        [ $SECONDS -lt $end ] || { echo "  waited in vain for: $*"; return 1; }
        sleep 0.05
    done
}

# --- without a display
ok "no display is one sentence" refuses 1 "no display.*balloon render" \
    env -u WAYLAND_DISPLAY DISPLAY= "$balloon" play tether

# --- a display of our own; a number that another server has just given up may be refused once
open_display() {
    local attempt
    unset WAYLAND_DISPLAY
    for attempt in 1 2 3 4 5; do
        : >"$scratch/display"
        Xvfb -noreset -displayfd 3 -screen 0 1024x768x24 3>"$scratch/display" 2>"$scratch/xvfb" &
        xvfb=$!
        until_true grep -q '[0-9]' "$scratch/display"
        export DISPLAY=:$(cat "$scratch/display")
        PATIENCE=60 until_true xdotool getdisplaygeometry >"$scratch/geometry" && return
        kill "$xvfb" 2>/dev/null
        wait "$xvfb" 2>/dev/null
        xvfb=''
    done
    cat "$scratch/xvfb"
    return 1
}
ok "a display opens" open_display
[ -n "$xvfb" ] || { finish; exit 1; }

# a red balloon that grows fast while the key is held, in air so thick that it does not swing
scene=(tether --set balloons.0.inflation.rate=15 --set balloons.0.inflation.max=30
    --set 'balloons.0.color=[0.9,0.1,0.1]' --set balloons.0.damping.coefficient=0.2)

window() { # the id of the program's window, once it is there
    xdotool search --onlyvisible --name '^balloon$' 2>/dev/null | head -1
}
is_open() { [ -n "$(window)" ]; }

start() { # start options…: play in the scratch folder
    (cd "$scratch" && exec "$balloon" play "${scene[@]}" --size 640x480 "$@" >hash 2>said) &
    player=$!
}

leave() { # wait for the program's end, keep its exit code
    wait "$player"
    status=$?
    player=''
}

# shot: the program's own screenshot, as FILE; shown on the next frame, renamed into place
shots=0
shot() {
    shots=$((shots + 1))
    file=$scratch/$(printf 'balloon-%04d.png' $shots)
    xdotool key p
    until_true test -f "$file"
}

root() { import -silent -window root "$1"; } # what the display itself shows

red() { # pixels that are much more red than green
    convert "$1" -color-matrix '1 -1 0 0 0 0 0 0 0' -channel R -separate +channel \
        -threshold 30% -format '%[fx:round(mean*w*h)]' info:
}

differing() { # pixels that differ between two pictures by more than 5 %
    compare -metric AE -fuzz 5% "$1" "$2" null: 2>&1 | sed 's/e+/*10^/' | cut -d' ' -f1
}

size() { identify -format '%wx%h' "$1"; }
grown() { root "$scratch/root.png" && [ "$(red "$scratch/root.png")" -gt "$1" ]; }
shrunk() { root "$scratch/root.png" && [ "$(red "$scratch/root.png")" -lt "$1" ]; }

# --- it opens, and the balloon is there
start --record log --hash
ok "a window opens" until_true is_open
is_open || { cat "$scratch/said"; finish; exit 1; }
ok "the balloon is on the display" until_true grown 2000
xdotool key o # the overlay off: what is compared below is the scene alone
shot
first=$(red "$file")
ok "the balloon is in the program's screenshot" less 2000 "$first"

# --- keys that are held
xdotool keydown Up
ok "the balloon grows while its key is held" until_true grown $((first * 15 / 10))
xdotool keyup Up
larger() { shot && large=$(red "$file") && [ "$large" -gt $((first * 13 / 10)) ]; }
ok "the screenshot shows it grown" until_true larger
xdotool keydown Down
ok "it shrinks while the other is held" until_true shrunk $((large * 9 / 10))
xdotool keyup Down

# --- pause: nothing moves, and the display shows what the screenshot holds
still() { # two screenshots are the same; the first is kept
    shot && cp "$file" "$scratch/before.png" && shot &&
        [ "$(differing "$scratch/before.png" "$file")" = 0 ]
}
moved() { shot && [ "$(differing "$scratch/before.png" "$file")" -gt "$1" ]; }
xdotool key space
ok "paused, nothing moves" until_true still
root "$scratch/root.png"
convert "$scratch/root.png" -crop "$(size "$file")+0+0" +repage "$scratch/root.png"
ok "the display shows the screenshot's pixels" less "$(differing "$scratch/root.png" "$file")" 100

# --- the mouse moves the eye
drag() { # drag BUTTON DX DY
    xdotool mousemove 320 240 mousedown "$1" mousemove_relative -- "$2" "$3" mouseup "$1"
}
drag 1 150 60
ok "a left drag orbits" until_true moved 2000
until_true still
before=$(red "$file")
farther() { shot && [ "$(red "$file")" -lt $((before * 7 / 10)) ]; }
xdotool click --repeat 8 --delay 5 5
ok "the wheel zooms" until_true farther
until_true still
drag 3 120 0
ok "a right drag pans" until_true moved 2000
until_true still

# --- every display mode draws something of its own
for mode in quads springs forces pressure stretch normals skin; do # those of rubber are passed by
    shot && cp "$file" "$scratch/before.png"
    xdotool key m
    ok "the mode key shows $mode" until_true moved 50
done

# --- the lab's page
shot && cp "$file" "$scratch/before.png"
xdotool key g
ok "the lab's page is shown" until_true moved 5000
xdotool key g
gone() { shot && [ "$(differing "$scratch/before.png" "$file")" = 0 ]; }
ok "and goes again, and nothing is left of it" until_true gone

# --- the window's size
sized() { shot && [ "$(size "$file")" = "$1" ]; }
xdotool windowsize "$(window)" 500 400
ok "a resized window is drawn in its new size" until_true sized 500x400
xdotool key F11
ok "full screen fills the screen" until_true sized 1024x768
xdotool key F11
ok "and goes back to the window" until_true sized 500x400

# --- the end, and the same again without a window
xdotool key space key q
leave
ok "it quits by its key with exit code 0" test $status = 0
ok "it had nothing to complain about" test ! -s "$scratch/said"
replays() { # a run of the log ends in the window's hash
    local steps seconds
    steps=$(sed -nE 's/^# ([0-9]+) steps.*/\1/p' "$scratch/log")
    seconds=$(awk -v n="${steps:-0}" 'BEGIN { printf "%.17g", 0.002 * n }')
    [ "$("$balloon" run "${scene[@]}" --input "$scratch/log" --seconds "$seconds" --hash --quiet)" = \
        "$(cat "$scratch/hash")" ]
}
ok "the log holds the keys" grep -q "key inflate down" "$scratch/log"
ok "a run replays the log to the same bits" replays

# --- balls
middle() { # of what is much more red than green [px]
    convert "$1" -color-matrix '1 -1 0 0 0 0 0 0 0' -channel R -separate +channel \
        -threshold 30% -trim -format '%[fx:round(page.x+w/2)] %[fx:round(page.y+h/2)]' info:
}
logged() { [ "$(grep -c "$1" "$scratch/log")" = "$2" ]; }
field() { grep ' throw ' "$scratch/log" | sed -n "$1p" | cut -d' ' -f"$2"; }
rm -f "$scratch"/balloon-*.png
shots=0
start --record log --hash
until_true is_open
ok "another window shows the balloon" until_true grown 2000
shot
read -r x y < <(middle "$file")
xdotool mousemove "$x" "$y" key b
ok "a key throws a ball" until_true logged ' throw ' 1
# the balloon is about the origin, with a radius of 1: how near the ball's line comes to it
ok "to where the mouse points" near "$(field 1 3-8 | awk '{
    t = -($1 * $4 + $2 * $5 + $3 * $6) / ($4 ^ 2 + $5 ^ 2 + $6 ^ 2)
    x = $1 + t * $4; y = $2 + t * $5; z = $3 + t * $6
    print sqrt(x * x + y * y + z * z) }')" 0 1
xdotool key w mousemove $((x - 200)) "$y" keydown ctrl click 1 keyup ctrl
ok "so does a click with ctrl" until_true logged ' throw ' 2
ok "and the weight key has made it heavier" near "$(field 2 9)" "$(field 1 9 | awk '{ print 10 * $1 }')" 0
xdotool key x
ok "a key takes all balls away" until_true logged 'key clear down' 1
xdotool key q
leave
ok "a session with balls ends well" test $status = 0
ok "and has nothing to complain about" test ! -s "$scratch/said"
ok "a run replays the throws to the same bits" replays

# --- a cell of the lab's map is watched, and the scene comes back
logs() { [ "$(ls "$scratch" | grep -c '^log')" = "$1" ]; }
how() { sed -nE 's/^# with //p' "$1"; }
again() { # a run with what the log says it takes ends in the hash that it says
    local steps step hash
    read -r steps step hash < <(sed -nE 's/^# ([0-9]+) steps of (.*) s, hash (.*)$/\1 \2 \3/p' "$1")
    [ "$(eval "\"\$balloon\" run \"\${scene[@]}\" $(how "$1")" --input "$1" --hash --quiet \
        --seconds "$(awk -v n="$steps" -v h="$step" 'BEGIN { printf "%.17g", n * h }')")" = "$hash" ]
}
rm -f "$scratch"/balloon-*.png "$scratch"/log*
shots=0
start --record log --hash --lab
until_true is_open
xdotool key i j Return
ok "a cell that is watched has a log of its own" until_true logs 2
xdotool keydown Up
ok "the keys act in it" until_true grep -q "key inflate down" "$scratch/log.2"
xdotool keyup Up key BackSpace
ok "so has the scene that comes back" until_true logs 3
ok "the log says what the cell is" test "$(how "$scratch/log.2" | grep -c "guard=\"off\".*step=0.00141.*structural=100")" = 1
ok "a run with that replays it to the same bits" again "$scratch/log.2"
# on a busy machine the cell is opened before the first step; then there is nothing to replay
whole() { grep -q '^# 0 steps of ' "$1" || again "$1"; }
ok "the log before is whole" whole "$scratch/log"
exploded() { # a point of the map that is of the color of cells that exploded
    shot && convert "$file" txt:- | grep -im1 '#CB181D' >"$scratch/point"
}
ok "the map is measured" until_true exploded
IFS=,: read -r x y _ <"$scratch/point"
xdotool mousemove $((x + 2)) $((y + 2)) click 1
ok "a click on the map watches that cell" until_true logs 4
xdotool key g key o
ok "which goes bad, and then nothing moves" until_true still
xdotool key q
leave
ok "it is left with exit code 0" test $status = 0
ok "and says what went bad" grep -q "went bad in step" "$scratch/said"

# --- a notch of the slider is a way that was measured; each has a log that replays
export XDG_CACHE_HOME=$scratch/cache
ok "advice is measured" "$balloon" advise exact-cube --budget 4ms --out "$scratch/advised.yaml"
plain=("${scene[@]}") scene=(exact-cube)
rm -f "$scratch"/balloon-*.png "$scratch"/log*
shots=0
start --record log --hash --lab
until_true is_open
xdotool key bracketright
ok "the fastest notch opens the scene again" until_true logs 2
shot && xdotool mousemove 326 $(($(identify -format %h "$file") - 90)) click 1
ok "a click on the slider's end opens the most accurate one" until_true logs 3
xdotool key BackSpace
ok "and backspace the scene as it was" until_true logs 4
xdotool key q
leave
ok "it ends well" test $status = 0
ok "the logs say how it was stepped" test "$(how "$scratch/log.2")" != "$(how "$scratch/log.3")"
ok "a run with that replays the fast one to the same bits" again "$scratch/log.2"
ok "and the accurate one" again "$scratch/log.3"
scene=("${plain[@]}")

# --- other scenes, and a window that ends by itself
next_log() { test -s "$scratch/log.2"; }
start --record log --hash
until_true is_open
xdotool key Page_Down
ok "another scene begins with a log of its own" until_true next_log
xdotool key q
leave
ok "and quits as well" test $status = 0

start --seconds 0.1 --hash
leave
ok "a window with --seconds ends by itself" test $status = 0
ok "where a run ends" test "$(cat "$scratch/hash")" = \
    "$("$balloon" run "${scene[@]}" --seconds 0.1 --hash --quiet)"

# --- advice that takes time is measured beside the window, and ends with it
start --auto --fresh
ok "a window with --auto opens at once" until_true is_open
measures() { measuring=$(pgrep -P "$player" | head -1) && [ -n "$measuring" ]; }
ok "while the advice is measured" until_true measures
xdotool key q
leave
ok "it quits before the advice is there" test $status = 0
gone() { ! kill -0 "$measuring" 2>/dev/null; }
ok "and the measurement with it" until_true gone

# --- a signal, and a display that goes away: the log is whole
end_logged() { tail -n 1 "$scratch/log" | grep -q hash; }
start --record log
until_true is_open
kill -TERM "$player"
leave
ok "a request to end is obeyed" test $status = 143
ok "and the log has its end" end_logged
start --record log
until_true is_open
kill -KILL "$xvfb"
wait "$xvfb" 2>/dev/null
xvfb=''
leave
ok "a display that goes away ends it" test $status = 1
ok "which is said" grep -q "the display went away" "$scratch/said"
ok "and the log has its end" end_logged
finish
