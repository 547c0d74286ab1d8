# Menu → Lab: the charts one after the other, where methods are stable, the stress tests, two methods side by side; by keyboard and by
# mouse, in three sizes.

open_game
expect lab-menu shows "$accent" 0 0 100 45 0.3
press Down Down Down Down Return Return Tab # its overview, then its charts
expect lab-charts differs lab-menu 3
expect lab-charts drawn
expect lab-charts shows "$accent" 5 20 70 60 0.1 # the shipped engine's curve
press Right
expect lab-next differs lab-charts 0.3
press Left
expect lab-charts-again resembles lab-charts 0.3
press Down
expect lab-picked differs lab-charts 0.3
press Tab
expect lab-plane differs lab-picked 3
expect lab-plane shows "$accent" 5 20 60 60 0.1 # the two rays
press Down
expect lab-plane-picked differs lab-plane 0.3
press Tab
sleep 2
expect lab-stress differs lab-plane-picked 3
expect lab-stress shows "$good" 50 15 15 70 0.02 # what survives all
expect lab-stress shows "$yellow" 65 20 32 50 0.02 # how the first one fails, large
press End
expect lab-stress-end differs lab-stress 0.3
press Tab space # side by side, paused
expect lab-side differs lab-stress-end 3
expect lab-side shows "$yellow" 5 20 42 55 0.05
press Down
sleep 2
press space
expect lab-throw differs lab-side 0.3
click 28 5 # the tab of the charts
expect lab-charts-by-mouse resembles lab-picked 3
press Up # no method is picked out any more
for size in "900 500" "1280 720" "1920 1080"; do
  read -r width height <<<"$size"
  resize "$width" "$height"
  expect "lab-${width}x$height" size "$width" "$height"
  expect "lab-${width}x$height" shows "$accent" 5 20 70 60 0.05
done
resize 1280 720
press Escape Escape
expect lab-menu-again resembles lab-menu 8

# Damaged charts are named, and those that came with the game are shown.
mkdir "$data/charts"
echo nonsense >"$data/charts/setting.csv"
press Return Return Tab
expect lab-damaged shows "$bad" 10 80 80 10 0.1
close_game
