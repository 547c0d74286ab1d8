# An author's round trip by mouse: a new level, in it a floor, a lift, a switch and a pad; a test flight; saved, checked, flown and verified.
# Then an edit in a text editor while the level is flown.

# level_point X Y: where a point of a level of 1280 × 720 pixels is in the editor, in a window of 1280 × 720, when all of it is in view:
# as src/screens/editor/layout.rs lays it out.
level_point() { awk "BEGIN { s = 895.3 * 0.95 / 1280; printf \"%.3f %.3f\", (571.75 + ($1 - 640) * s) / 12.8, (360.3 + ($2 - 360) * s) / 7.2 }"; }

# draw TOOL X Y TO_X TO_Y: a new thing between two points of the level; tools are counted from the top, Select is 0.
draw() {
  click 5.8 "$(awk "BEGIN { p = (664 - 8) / 21; if (p > 44) p = 44; print (56 + 4 + $1 * p + p / 2) / 7.2 }")"
  drag $(level_point "$2" "$3") $(level_point "$4" "$5")
}

open_game
expect editor-menu shows "$accent" 0 0 100 45 0.3
click $(column_button 4) # More
click $(column_button 2)
expect editor-list differs editor-menu 3
click 23 93.3 # New
type_text my-lift
press Return
expect editor-new differs editor-list 3

draw 1 0 690 1280 720    # a floor
draw 2 90 670 210 690    # a lift under the ship
draw 4 100 380 200 660   # a switch, all the way that the lift goes
# Its wire, from the handle above it onto the lift: with the tool that selects, for tools stay.
press q
read -r x y <<<"$(level_point 150 380)"
drag "$x" "$(awk "BEGIN { print $y - 22 / 7.2 }")" $(level_point 195 680)
draw 5 150 500 240 540   # a pad beside the way
sleep 0.5
expect editor-drawn differs editor-new 1
expect editor-drawn hides "$bad" 11 85 60 15 0.3 # no problem is listed
[ "$(cat "$data/levels/my-lift/"*.csv | wc -l)" -lt 10 ] || fail "something was saved that should not be yet"

press F5
sleep 1
shot editor-flight
press F5
expect editor-after-flight resembles editor-drawn 5
xdotool keydown ctrl
press s
xdotool keyup ctrl
sleep 0.5
expect editor-saved differs editor-new 1

"$game" --data "$data" check my-lift >"$out/editor-check.txt" 2>&1 || fail "the level is refused: $(cat "$out/editor-check.txt")"
# The ship starts in its only goal: that it wins without a key is true.
grep 'warning' "$out/editor-check.txt" | grep -qv 'is won after' && fail "the level is odd: $(cat "$out/editor-check.txt")"
grep -q '1 solid.*1 player objective.*1 mover, 1 switch' "$out/editor-check.txt" || fail "not what was drawn: $(cat "$out/editor-check.txt")"
"$game" --data "$data" run my-lift --seconds 20 --record "$out/editor-flight.csv" >"$out/editor-run.txt"
grep -qx 'outcome=completed' "$out/editor-run.txt" || fail "the lift does not lead to the pad: $(cat "$out/editor-run.txt")"
"$game" --data "$data" verify "$out/editor-flight.csv" >/dev/null || fail "the flight does not verify"

press Escape
press Escape
expect editor-list-again differs editor-saved 3
close_game

# Edited while it is flown: what was saved is on the screen half a second later, and a problem is shown until it is mended.
room=$data/levels/room
mkdir "$room"
printf 'width,1280\nheight,720\n' >"$room/constants.csv"
printf '200,614.5,100,500,2000\n' >"$room/player.csv"
printf 'PLAYER,1200,20,40,40\n' >"$room/objectives.csv"
printf '0,640,1280,80,Asphalt\n' >"$room/world.csv"
open_game play room
expect reload-before hud
printf '500,200,300,300,Ice\n' >>"$room/world.csv"
sleep 0.5
shot reload-after
differs reload-after reload-before 3 || fail "what was saved is not on the screen after half a second"
cp "$room/world.csv" "$out/world.csv"
printf 'here,100,300,40\n' >>"$room/world.csv"
expect reload-broken shows "$bad" 20 0 80 20 0.05
cp "$out/world.csv" "$room/world.csv"
expect reload-mended hides "$bad" 20 0 80 20 0.02
