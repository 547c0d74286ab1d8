# A newcomer's first sitting: from the menu through level select into level 1, which is then flown to completion and saved.

inputs=tests/inputs/1.csv # the recorded run that proves the level completable
user=bob445

# Menu → level select → level 1, by keys and by mouse; each press does one thing.
open_game
expect menu drawn
expect menu shows "$accent" 0 0 100 45 0.3
press Down Return
expect level-select differs menu 3
expect level-select drawn
click $(level_button 0)
expect level-1 hud

# The keys fly the ship, Tab opens the details, Esc pauses.
hold 1 space
expect flying differs level-1 0.2
press Tab
expect details differs flying 0.5
press Escape
expect paused differs details 3
close_game

# Level 1 from its recorded inputs, to the same score that the command line gives them.
score=$("$game" --data "$data" run 1 --inputs "$inputs" | sed -n 's/^score=//p')
[ "$score" -ge 1 ] || fail "$inputs does not complete level 1"
open_game play 1 --inputs "$inputs"
expect flown-start shows "$accent" 14 90 6 10 15
patience=180 expect scoring hides "$accent" 14 90 72 10 5
expect scoring shows "$good" 0 0 100 100 0.02

# A name that breaks the rules is refused under the field; the next one is saved.
press Right Right Right Left Return # Main Menu is the last button, Save Score the one before it
expect save-score differs scoring 3
type_text 1bob
press Return
expect refused shows "$bad" 20 50 60 12 0.2 # just under the field
press BackSpace BackSpace BackSpace BackSpace
[ ! -s "$data/scores/1.csv" ] || fail "a refused name was saved"
type_text "$user"
press Return
expect leaderboard shows "$yellow" 22 24 56 8 0.1 # the best row
expect leaderboard differs save-score 3
grep -qx "$user,$score" "$data/scores/1.csv" || fail "the row $user,$score is not in 1.csv: $(cat "$data/scores/1.csv")"
echo "scores/1.csv: $user,$score"
