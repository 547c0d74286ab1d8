# The window in other sizes, also changed while playing: everything stays in its place.

open_game
for size in "900 500" "1280 720" "1920 1080"; do
  read -r width height <<<"$size"
  resize "$width" "$height"
  expect "menu-${width}x$height" size "$width" "$height"
  expect "menu-${width}x$height" shows "$accent" 0 0 100 45 0.3
done
close_game

open_game play 1
expect level-1-first hud
for size in "900 500" "1920 1080" "1280 720"; do
  read -r width height <<<"$size"
  resize "$width" "$height"
  expect "level-1-${width}x$height" size "$width" "$height"
  expect "level-1-${width}x$height" hud
done
