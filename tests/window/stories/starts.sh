# No start of the menu takes more memory than another, and less than 260 MB with software OpenGL: STARTS=50 tests/window/run starts

most=0
for ((start = 0; start < ${STARTS:-4}; start++)); do
  open_game
  expect menu-started shows "$accent" 0 0 100 45 0.3
  peak=$(awk '/VmHWM/ { print $2 }' "/proc/$game_process/status")
  [ "$peak" -le "$most" ] || most=$peak
  close_game
done
echo "the menu takes at most $((most / 1000)) MB in ${STARTS:-4} starts"
[ "$most" -le 260000 ] || fail "the menu takes $most kB, expected at most 260000"
