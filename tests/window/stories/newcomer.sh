# A newcomer's first sitting: a name, and from the menu through level select into level 1, which a recording then flies to its end.

inputs=tests/inputs/1.csv # the recorded run that proves the level completable
user=bob445

# Who plays: a name that breaks the rules is refused under the field; the next one stays.
open_game
expect menu drawn
expect menu shows "$accent" 0 0 100 30 0.3
click $(column_button 3) # Players
expect new-player differs menu 3
type_text 1bob
press Return
expect refused shows "$bad" 20 50 60 12 0.2 # just under the field
press BackSpace BackSpace BackSpace BackSpace
type_text "$user"
press Return
expect named differs refused 3
grep -q "^$user," "$data/scores/players.csv" || fail "$user is not in players.csv"

# Menu → level select → level 1 by its title, by keys and by mouse; each press does one thing.
press Up Up Return
expect level-select differs named 3
expect level-select drawn
choose_level "$(sed -n 's/^title,//p' "$data/levels/1/constants.csv")" 10 33
expect level-1 hud

# The keys fly the ship, Tab opens the details, Esc pauses.
hold 1 space
expect flying differs level-1 0.2
press Tab
expect details differs flying 0.5
press Escape
expect paused differs details 3
close_game

# Level 1 from its recorded inputs. A player who watches has not flown: no score is saved.
score=$("$game" --data "$data" run 1 --inputs "$inputs" | sed -n 's/^score=//p')
[ "$score" -ge 1 ] || fail "$inputs does not complete level 1"
open_game play 1 --inputs "$inputs"
expect flown-start fuel_left_end
patience=180 expect scoring hides "$accent" 1 95 16 5 5
expect scoring shows "$good" 0 0 100 100 0.02
expect scoring still
press Return # the next level has the keyboard
expect next-level hud
[ ! -e "$data/scores/attempts.csv" ] || fail "a recording was written down as an attempt"
close_game

# A flight by hand, in a level that is done at once: its score is saved under the player's name.
mkdir "$data/levels/0"
printf 'name,value\nwidth,1280\nheight,720\ntitle,At once\n' >"$data/levels/0/constants.csv"
printf 'x,y,mass,fuel,thrust\n640,360,100,500,3000\n' >"$data/levels/0/player.csv"
printf 'PLAYER,600,330,80,60,0.001\n' >"$data/levels/0/objectives.csv"
open_game play 0
expect done hides "$accent" 1 95 16 5 5 # the fuel bar has gone: this is the score
expect done shows "$good" 0 0 100 100 0.02
expect done still
press Down Right Right
expect done-chosen differs done 0.1
press Return # Board
expect leaderboard shows "$yellow" 22 24 56 8 0.1 # the best row
grep -q "^$user,[0-9]*,[0-9.]*,$user-" "$data/scores/0.csv" || fail "$user is not in 0.csv: $(cat "$data/scores/0.csv")"
grep -q "^0,$user,completed," "$data/scores/attempts.csv" || fail "the attempt is not in attempts.csv"
grep -q "^$user,0,0" "$data/scores/players.csv" || fail "what was done is not in players.csv"
press Escape
sleep 1
press Return # Next
expect led-on hud
