# Menu → Classics → each of the three → back, by keyboard and then by mouse.

open_game
expect classics-menu shows "$accent" 0 0 100 45 0.3
press Down Down Down Down Return Down Return
expect classics differs classics-menu 3

scenes=(tile-run jumper pi)
for index in 0 1 2; do
  name=classics-${scenes[index]}
  press Up Up Up
  for ((step = 0; step < index; step++)); do press Down; done
  press Return
  expect "$name" differs classics 3
  expect "$name" drawn
  press Escape
  expect classics-again resembles classics 3
done
press Escape Escape
expect classics-menu-again resembles classics-menu 8

click $(column_button 4) # More
click $(column_button 1)
expect classics-by-mouse resembles classics 3
for index in 0 1 2; do
  click $(classic_button "$index")
  expect "classics-${scenes[index]}-by-mouse" differs classics 3
  press Escape
  expect classics-by-mouse resembles classics 3
done
click $(classic_button 3) # Back
press Escape
expect classics-menu-again resembles classics-menu 8
