# Menu → Classics → each of the three → back, by keyboard.

open_game
expect 20 classics-menu shows "$accent" 0 0 100 45 0.3
press Down Down Down Return
expect 5 classics differs classics-menu 3
downs=()
for scene in tile-run jumper pi; do
  press "${downs[@]}" Return
  expect 10 "classics-$scene" differs classics 3
  expect 5 "classics-$scene" drawn
  press Escape
  expect 5 classics-again resembles classics 5
  downs=(Down) # the focus stays on the scene that was left
done
press Escape
expect 5 classics-menu-again resembles classics-menu 5
