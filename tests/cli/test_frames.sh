#!/usr/bin/env bash
# Captured frames: the balloon is visible, grows when inflated, shrinks when deflated, and looks like
# pictures that were checked by eye (tests/golden, within a tolerance for other machines).
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

# number of pixels of saturated color: balloons, not floor or sky
colored() {
    convert "$1" -colorspace HSL -channel G -separate -threshold 40% -format '%[fx:mean*w*h]' info:
}

render() { # render OUT SECONDS options…
    local out=$1 seconds=$2
    shift 2
    "$balloon" render "$scene" --out "$out" --seconds "$seconds" --size 320x180 --quiet "$@" >"$scratch/hash"
}

# --- grows and shrinks by the keys, through an input log
scene=squirrel-inflates
still=(--set "balloons.0.inflation={law: area, amount: 4, rate: 8}")
printf '# balloon input 1 %s\n250 key inflate down\n1250 key inflate up\n1500 key deflate down\n2500 key deflate up\n' $scene >"$scratch/log"
render "$scratch/first.png" 0.4 "${still[@]}" --input "$scratch/log"
render "$scratch/grown.png" 3 "${still[@]}" --input "$scratch/log"
render "$scratch/shrunk.png" 8 "${still[@]}" --input "$scratch/log"
first=$(colored "$scratch/first.png") grown=$(colored "$scratch/grown.png") shrunk=$(colored "$scratch/shrunk.png")
ok "the balloon is there" less 1000 "$first"
ok "it grows when blown up" less "$(awk -v a="$first" 'BEGIN { print 1.15 * a }')" "$grown"
ok "it shrinks when let out" less "$shrunk" "$(awk -v a="$grown" 'BEGIN { print a / 1.15 }')"

# --- numbers of frames, names, sizes
render "$scratch/frames" 0.25 --fps 20
ok "a frame for the start and one for each 20th" test "$(ls "$scratch/frames" | wc -l)" = 6
ok "frames have the size asked for" test "$(identify -format '%wx%h' "$scratch/frames/frame-00000.png")" = 320x180
ok "nothing moves before the scene begins" cmp "$scratch/frames/frame-00000.png" "$scratch/frames/frame-00001.png"
render "$scratch/again" 0.25 --fps 20
ok "same input, same pixels" cmp "$scratch/frames/frame-00005.png" "$scratch/again/frame-00005.png"
for film in mp4:11 webm:11 gif:14; do # a GIF plays at 25 a second: 11 frames of 1/20 s are 14
    kind=${film%:*}
    render "$scratch/film.$kind" 0.5 --fps 20
    ok "a film as .$kind has ${film#*:} frames" test "$(ffprobe -v error -count_frames -select_streams v \
        -show_entries stream=nb_read_frames -of csv=p=0 "$scratch/film.$kind" | tr -d ',')" = "${film#*:}"
done

bad "not a format of pictures or films: .png, .mp4" "$balloon" render tether --seconds 0.01 --out "$scratch/film.jpg"
ok "and no folder takes its place" test ! -e "$scratch/film.jpg"
bad "^balloon: --size: a film as .mp4 has even sides, not 17x19" \
    "$balloon" render tether --seconds 0.01 --size 17x19 --out "$scratch/odd.mp4"

# --- every display mode gives a picture of its own, on springs or on rubber; with SHORT a little after
# the start
moment=$([ -z "${SHORT:-}" ] && echo 1 || echo 0.1)
for mode in $("$balloon" list | sed -n '/^display modes/,$p' | awk 'NR > 1 { print $1 }'); do
    scene=squirrel-inflates render "$scratch/mode-$mode.png" "$moment" --mode "$mode"
    scene=peak render "$scratch/rubber-$mode.png" "$moment" --mode "$mode" \
        --set 'balloons.0.skin.membrane.patches=[{at: [0, -0.1, 0], radius: 0.17, thickness: 1.2e-4}]'
    cat "$scratch/rubber-$mode.png" >>"$scratch/mode-$mode.png"
    for picture in mode rubber; do
        ok "mode $mode draws $picture" test "$(convert "$scratch/$picture-$mode.png" -format '%k' info:)" -gt 500
    done
done
ok "modes differ" test "$(md5sum "$scratch"/mode-*.png | awk '{ print $1 }' | sort -u | wc -l)" = \
    "$(ls "$scratch"/mode-*.png | wc -l)"

# --- golden pictures; not in a slow build, because the modes above draw the same
[ -n "${SHORT:-}" ] ||
for golden in tests/golden/*.png; do
    name=$(basename "$golden" .png)
    scene=${name%@*}
    render "$scratch/now.png" "${name#*@}"
    # one bit may differ between machines; a wrong shape or color is far above this
    off=$(compare -metric RMSE "$golden" "$scratch/now.png" null: 2>&1 | sed -E 's/.*\((.*)\)/\1/')
    ok "$name looks as it did ($off)" less "$off" 0.01
done

# --- the lab's page, of a scene that the lab measures in tenths of a second
scene=sphere-gas
for name in without with again; do
    page=()
    [ $name = without ] || page=(--lab)
    render "$scratch/lab-$name.png" 0.1 "${page[@]}" --hash --size 640x480 && cat "$scratch/hash" >"$scratch/lab-$name"
done
right() { convert "$1" -gravity east -crop 45%x100%+0+0 +repage -format '%#' info:; }
left() { convert "$1" -gravity northwest -crop 50%x60%+0+0 +repage -format "%#" info:; } # above the slider
ok "the lab's page is drawn" test "$(right "$scratch/lab-with.png")" != "$(right "$scratch/lab-without.png")"
ok "and leaves the rest alone" test "$(left "$scratch/lab-with.png")" = "$(left "$scratch/lab-without.png")"
ok "the same input draws the same page" cmp "$scratch/lab-with.png" "$scratch/lab-again.png"
ok "and the state is the same without it" cmp "$scratch/lab-with" "$scratch/lab-without"

# --- the times of a frame's stages are printed
"$balloon" render party --out "$scratch/timed" --seconds 0.1 --fps 20 --size 320x180 --quiet --time >"$scratch/stages"
ok "all stages of 3 frames are said" grep -qE \
    "^3 frames; of a frame \[ms\]: steps [0-9.]+ picture [0-9.]+ upload .* shadow .* scene .* resolve .* overlay .* present .*; in all" \
    "$scratch/stages"

finish
