# A flight by hand is saved, watched and raced; its score is proven by the command line.

# The level is done by thrusting from where the ship stands.
mkdir "$data/levels/0"
printf 'width,800\nheight,600\noptimal_time,10\n' >"$data/levels/0/constants.csv"
# A floor keeps the ship above the fuel bar, which would step aside for it.
printf '0,540,800,60,Asphalt\n' >"$data/levels/0/world.csv"
printf 'x,y,mass,fuel,thrust\n400,514,100,500,2500\n' >"$data/levels/0/player.csv"
printf 'PLAYER,350,60,100,40\n' >"$data/levels/0/objectives.csv"

open_game play 0
expect flights-start hud
hold 4 space
expect flights-score hides "$accent" 1 95 16 5 5 # the fuel bar has gone: this is the score
expect flights-score shows "$good" 0 0 100 100 0.02
expect flights-score still
press Down Down Down
expect flights-chosen differs flights-score 0.1
press Return # Save Score
sleep 0.5 # until the field for a name is there
type_text ann
press Return
sleep 1 # until the keys of menus count
press Down Right Right Return # Board
expect flights-board shows "$yellow" 15 24 70 8 0.1
expect flights-board shows "$accent" 18 24 6 8 0.3 # the mark: its flight is kept
[ "$(cat "$data"/scores/flights/0/ann-*.replay.csv | grep -c '^# outcome: completed')" = 1 ] || fail "the flight was not kept"
"$game" --data "$data" verify --scores >"$out/flights-verified.txt" || fail "the score does not hold"
grep -qx '0: 1 proven' "$out/flights-verified.txt" || fail "the score is not proven"

# Watch it: from the board over the list of flights. It stands still at its end; a second back is another picture, and the end is the same.
press Return
expect flights-list differs flights-board 0.5
press Return
expect flights-watch shows "$accent" 0 80 100 20 0.1
press End
expect flights-end shows "$accent" 22 85 54 4 30 # the line of time is full
press Prior
expect flights-back differs flights-end 0.3
press End
expect flights-end-again resembles flights-end 3
press Tab
expect flights-forces differs flights-end-again 0.3
press Escape
expect flights-list-again resembles flights-list 2

# Race it, and come in behind it.
press Right Return
expect flights-race hud
hold 4 space
expect flights-raced hides "$accent" 1 95 16 5 5
press Escape
