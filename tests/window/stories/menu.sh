# The menu by itself: its mini-game, the way back with Esc, and Quit.

open_game
expect menu-first shows "$accent" 0 0 100 45 0.3
click 12 40 3
expect menu-ball differs menu-first 0.01
close_game

open_game
expect menu-first shows "$accent" 0 0 100 45 0.3
press Down Return
expect menu-left differs menu-first 3
press Escape
expect menu-again resembles menu-first 8 # a flight plays behind the buttons
press Up Up Return # over Play to Quit, the last one of the column
closes_itself
