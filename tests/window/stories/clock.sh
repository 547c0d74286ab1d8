# The system's clock is set: by a year either way, and by as much as a clock can be. The game goes on in time.

printf 0 >"$out/shift"
cc -shared -fPIC -O1 -o "$out/clock.so" "$here/clock.c"
LD_PRELOAD=$out/clock.so CLOCK_SHIFT=$out/shift open_game
expect clock-menu shows "$accent" 0 0 100 45 0.3
for shift in 31557600 -31557600 2000000000 -1900000000; do
  printf '%s' "$shift" >"$out/shift"
  press Down
  shot clock-before
  press Up
  expect "clock-$shift" differs clock-before 0.3
done
close_game
