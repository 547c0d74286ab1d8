# Keyboards of four layouts: what is typed with dead keys, signs, letters, and a flight by the place of W, which is key 25 of each.

mkdir "$data/levels/zz"
printf 'title,même\nwidth,800\nheight,600\noptimal_time,10\n' >"$data/levels/zz/constants.csv"
printf '0,540,800,60,Asphalt\n' >"$data/levels/zz/world.csv"
printf 'x,y,mass,fuel,thrust\n400,514,100,500,2500\n' >"$data/levels/zz/player.csv"
printf 'PLAYER,350,60,100,40\n' >"$data/levels/zz/objectives.csv"

flown=0
# fly_on KEYBOARD NAME CIRCUMFLEX: as setxkbmap and the pictures call it; the key with the dead circumflex, by its number.
fly_on() {
  setxkbmap $1
  open_game
  expect "keyboards-$2-menu" shows "$accent" 0 0 100 45 0.3
  press Down Return
  expect "keyboards-$2-list" differs "keyboards-$2-menu" 3
  xdotool key --delay 40 m $3 e m e
  sleep 0.3
  click 50 50
  expect "keyboards-$2" hud
  press b
  expect "keyboards-$2-frozen" differs "keyboards-$2" 0.05
  press plus
  expect "keyboards-$2-near" differs "keyboards-$2-frozen" 3
  sleep 0.5
  shot "keyboards-$2-near"
  press period
  expect "keyboards-$2-on" differs "keyboards-$2-near" 0.005
  press bracketright b
  xdotool keydown 25
  expect "keyboards-$2-score" hides "$accent" 1 95 16 5 5
  xdotool keyup 25
  flown=$((flown + 1))
  [ "$(grep -c '^zz,Guest,completed' "$data/scores/attempts.csv")" = $flown ] || fail "$1: the level was not flown: $(cat "$data/scores/attempts.csv")"
  close_game
}
fly_on de de 49
fly_on fr fr 34
fly_on 'us -variant intl' intl shift+15

# Umlauts are set, and named as they stand on the keys; the keyboard may change meanwhile.
setxkbmap us
open_game
expect keyboards-settings-menu shows "$accent" 0 0 100 45 0.3
setxkbmap de
click $(column_button 4) # More
click $(column_button 3)
expect keyboards-settings differs keyboards-settings-menu 5
press Tab Return 47
press Down Down Down Down Down Down Down Down Return Down Down Down Return 47 # All keys, then the map
press Down Return plus
press Down Return 20
expect keyboards-set differs keyboards-settings 0.1
for row in 'key_thrust,Semicolon W,' 'key_map,ö,' 'key_closer,Equal KpAdd,' 'key_wider,ß KpSubtract,'; do
  grep -qx "$row" "$data/settings.csv" || fail "$row is not kept: $(cat "$data/settings.csv")"
done
close_game
setxkbmap us
