# The settings are reached from the menu and from a flight, hold at once and are kept.

open_game
expect settings-menu shows "$accent" 0 0 100 45 0.3
click $(column_button 4) # More
click $(column_button 3)
expect settings differs settings-menu 5
press Left Left
expect settings-quieter differs settings 0.005
grep -q '^volume,60,$' "$data/settings.csv" || fail "the volume was not kept"
press Escape
press Escape
expect settings-back shows "$accent" 0 0 100 45 0.3
close_game

open_game play 1
expect settings-flight hud
press Escape
expect settings-pause differs settings-flight 5
press Down Down Return
expect settings-in-flight differs settings-pause 5
press Escape Escape
expect settings-flying hud
