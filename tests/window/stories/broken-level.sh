# A level that does not load stays in the list; choosing it shows its problems and closes nothing.

# On the one page that fifteen levels fill.
rm -r "$data/levels/15"
mkdir "$data/levels/zz-broken"
printf 'x,y,mass,fuel,thrust\n10,10,heavy,500,3000\n' >"$data/levels/zz-broken/player.csv"
last=$(($(find "$data/levels" -mindepth 1 -maxdepth 1 -type d | wc -l) - 1))

open_game
expect broken-menu shows "$accent" 0 0 100 45 0.3
press Down Return
expect broken-select differs broken-menu 3
click $(level_button "$last")
point 50 2
expect broken-problems differs broken-select 1
press Escape Escape
expect broken-back shows "$accent" 0 0 100 45 0.3
