# The player: a display without a screen, the game in it, fingers on keys and mouse. Sourced by tests/window/run, which sets `game`
# (the program) and `out` (where pictures go). Whatever fails ends the whole run.

display_process= game_process= game_window= data=

# Keys and buttons are held this long, so that a slow frame sees them, s.
press_time=0.08
# After a press the game gets this long before the next one, s.
settle_time=0.15

clean_up() {
  close_game
  [ -z "$display_process" ] || kill "$display_process" 2>/dev/null || true
  [ -z "$data" ] || rm -rf "$data"
}
trap clean_up EXIT

fail() {
  echo "window: $*" >&2
  if [ -s "$out/output.log" ]; then
    echo "the game's last words:" >&2
    tail -n 5 "$out/output.log" >&2
  fi
  exit 1
}

# open_display WIDTHxHEIGHT: a display of its own, drawn in software. It must not reset itself whenever a game has closed: the next
# one would find no display for a moment.
open_display() {
  local number
  coproc DISPLAY_SERVER { exec Xvfb -displayfd 1 -screen 0 "${1}x24" -nolisten tcp -noreset 2>/dev/null; }
  display_process=$DISPLAY_SERVER_PID
  read -r -t 20 number <&"${DISPLAY_SERVER[0]}" || fail "Xvfb did not start"
  # Nothing holds frames back where there is no screen: a flight is drawn as often as the processors can. One thread draws, which leaves the
  # other processor to what is built and tested meanwhile.
  export DISPLAY=:$number LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=0
}

# new_data_folder: the shipped levels and no scores, in a folder that the game may write to.
new_data_folder() {
  [ -z "$data" ] || rm -rf "$data"
  data=$(mktemp -d)
  cp -r assets levels "$data/"
  mkdir "$data/scores"
}

# open_game [ARG…]: starts the game with these arguments and waits for its window.
open_game() {
  "$game" --data "$data" "$@" >>"$out/output.log" 2>&1 &
  game_process=$!
  local try
  for ((try = 0; try < 200; try++)); do
    game_window=$(xdotool search --onlyvisible --pid "$game_process" 2>/dev/null | head -n 1 || true)
    [ -n "$game_window" ] || game_window=$(xdotool search --onlyvisible --name '^Resultant' 2>/dev/null | head -n 1 || true)
    [ -n "$game_window" ] && break
    still_open
    sleep 0.1
  done
  [ -n "$game_window" ] || fail "no window came up"
  xdotool windowfocus "$game_window"
  sleep 0.3
}

close_game() {
  [ -n "$game_process" ] || return 0
  kill "$game_process" 2>/dev/null || true
  wait "$game_process" 2>/dev/null || true
  game_process=
}

# still_open: fails when the game has ended by itself.
still_open() {
  kill -0 "$game_process" 2>/dev/null && return
  local status=0
  wait "$game_process" || status=$?
  game_process=
  fail "the game ended with status $status"
}

# closes_itself: waits for the game to end, with status 0.
closes_itself() {
  local try status=0
  for ((try = 0; try < 50; try++)); do
    kill -0 "$game_process" 2>/dev/null || break
    sleep 0.1
  done
  kill -0 "$game_process" 2>/dev/null && fail "the game did not close"
  wait "$game_process" || status=$?
  game_process=
  [ "$status" = 0 ] || fail "the game closed with status $status"
}

# press KEY…: each for a moment, one after the other, by their X names (Return, Escape, Down, …).
press() {
  local key
  for key in "$@"; do
    xdotool keydown "$key"
    sleep "$press_time"
    xdotool keyup "$key"
    sleep "$settle_time"
  done
}

# hold SECONDS KEY…: all of them at once.
hold() {
  local seconds=$1
  shift
  xdotool keydown "$@"
  sleep "$seconds"
  xdotool keyup "$@"
}

type_text() { xdotool type --delay 80 "$1"; sleep "$settle_time"; }

# click X Y [BUTTON]: 1 is the left button (and what is meant without one), 3 the right one, 4 and 5 turn the wheel up and down;
# at percent of the window's width and height.
click() {
  point "$1" "$2"
  xdotool mousedown "${3:-1}"
  sleep "$press_time"
  xdotool mouseup "${3:-1}"
  sleep "$settle_time"
}

# drag X Y TO_X TO_Y: with the left button, in percent of the window's width and height.
drag() {
  point "$1" "$2"
  xdotool mousedown 1
  sleep "$press_time"
  point "$3" "$4"
  xdotool mouseup 1
  sleep "$settle_time"
}

# point X Y: moves the pointer there, in percent of the window's width and height.
point() {
  local WIDTH HEIGHT WINDOW X Y SCREEN
  eval "$(xdotool getwindowgeometry --shell "$game_window")"
  local x y
  x=$(awk "BEGIN { printf \"%d\", $WIDTH * $1 / 100 }")
  y=$(awk "BEGIN { printf \"%d\", $HEIGHT * $2 / 100 }")
  xdotool mousemove --window "$game_window" "$x" "$y"
  sleep "$settle_time"
}

# choose_level WORDS [X Y]: opens the level that these words alone find in level select. The card of a player's own level is in the
# middle then, one of a world is the first on its shelf, at 10 33.
choose_level() {
  type_text "$1"
  sleep 0.3
  click "${2:-50}" "${3:-50}"
}

# column_button INDEX: where a button of the menu's column is, from 0, for `click`; classic_button INDEX: of the list of classics.
column_button() { awk "BEGIN { printf \"50 %.2f\", 100 * (216 + 24 + 64 * $1) / 720 }"; }
classic_button() { awk "BEGIN { printf \"50 %.2f\", 100 * (216 + 24 + 64 * $1) / 720 }"; }

# resize WIDTH HEIGHT: the window, in pixels.
resize() { xdotool windowsize --sync "$game_window" "$1" "$2"; sleep 0.3; }
