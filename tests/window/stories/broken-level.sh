# A level that does not load stays in the list; choosing it shows its problems and closes nothing.

mkdir "$data/levels/zz-broken"
printf 'x,y,mass,fuel,thrust\n10,10,heavy,500,3000\n' >"$data/levels/zz-broken/player.csv"

open_game
expect broken-menu shows "$accent" 0 0 100 45 0.3
press Down Return
expect broken-select differs broken-menu 3
choose_level zz-broken
point 50 2
expect broken-problems differs broken-select 1
press Escape Escape
expect broken-back shows "$accent" 0 0 100 45 0.3
