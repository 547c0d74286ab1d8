# A lesson with real keys and mouse: a fall is stopped, a ball picked out, its velocity plotted and taken along; g is in the file.

cp -r levels/experiments/free-fall "$data/levels/fall"
open_game play fall
press b # it waits for that
sleep 0.7
press b
# However slow the window is, the table has rows enough.
for _ in $(seq 33); do press period; done
expect lesson-frozen shows "$accent" 20 85 60 15 0.1
press i
click 5.5 36.7 # Plot, on the rail
# The first ball is followed from the start.
blue='#7FA7FF' pink='#F28DB2' # height and velocity
expect lesson-plot shows "$blue" 38 72 61 25 0.05
expect lesson-plot shows "$pink" 38 72 61 25 0.05
click 40.9 69.9 # CSV
expect lesson-written shows "$good" 0 95 60 5 0.2
click 43.7 69.9 # SVG

table=$data/exports/fall-y-v_y.csv
[ -s "$table" ] && [ -s "${table%.csv}.svg" ] || fail "nothing was written to $data/exports"
[ "$(head -n 1 "$table")" = 'tick,t (s),Ball 1 y (m),Ball 1 v_y (m/s)' ] || fail "another head: $(head -n 1 "$table")"
awk -F, 'NR == 2 { t = $2; v = $4 } NR == 32 { d = -($4 - v) / ($2 - t) / 9.81 - 1; good = d < 1e-9 && d > -1e-9 } END { exit !good }' "$table" ||
  fail "the slope is not g: $(sed -n 32p "$table")"

# A click in the plot takes the world to another moment; B lets it fall again from there.
click 45 85
expect lesson-earlier differs lesson-written 0.3
press b
expect lesson-on differs lesson-earlier 0.3
