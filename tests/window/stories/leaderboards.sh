# A leaderboard longer than a page: from the menu to level 1's, scrolled by key, wheel and bar, and back.

{
  echo "name,score"
  for rank in $(seq 24); do echo "user$rank,$((20000 - 100 * rank))"; done
} >"$data/scores/1.csv"
cp "$data/scores/1.csv" "$out/leaderboards-before.csv"

open_game
expect leaderboards-menu shows "$accent" 0 0 100 45 0.3
press Down Down Return
expect leaderboards-levels differs leaderboards-menu 3
press Return
expect leaderboards-top differs leaderboards-levels 3
expect leaderboards-top shows "$yellow" 14 24 50 6 0.1 # the best row
press Down
expect leaderboards-by-key differs leaderboards-top 0.3
press Up Up Up Up Up Up # never past the end
expect leaderboards-top-again resembles leaderboards-top 0.3
click 50 50 5
expect leaderboards-by-wheel differs leaderboards-top 0.3
press Home
drag 88 34 88 95
expect leaderboards-by-bar differs leaderboards-top 0.3
press End
expect leaderboards-end resembles leaderboards-by-bar 0.3
press Escape
expect leaderboards-back differs leaderboards-end 3
cmp -s "$data/scores/1.csv" "$out/leaderboards-before.csv" || fail "looking at a leaderboard changed its file"
