# A goal and a death box look in a liquid as they do in the air, and the rock of two levels is of two tints.

for place in dry wet 101 102; do
  mkdir "$data/levels/$place"
  printf 'name,value\nwidth,1280\nheight,720\ngravity,0\n' >"$data/levels/$place/constants.csv"
  printf '150,300,100,500,2000\n' >"$data/levels/$place/player.csv"
  printf 'PLAYER,480,300,200,120\n' >"$data/levels/$place/objectives.csv"
  printf '800,300,120,120\n' >"$data/levels/$place/obstacles.csv"
  printf '0,600,1280,120\n' >"$data/levels/$place/world.csv"
done
printf '300,200,900,400,1,1,40,140,220\n' >"$data/levels/wet/fluids.csv"

# Places are percent of the window: the goal with its yellow edge, the inside of the goal right of its label, the death box, the liquid.
goal='36.5 40.5 18 18.5' inside='51.5 49 1 2' box='62.5 41.7 9.4 16.6' beside='56 45 5 10'
for place in dry wet; do
  open_game play "$place"
  expect "$place" shows "$yellow" $goal 3
  expect "$place" shows '#4C4221' $inside 80
  expect "$place" shows '#E23C44' $box 25 # the bright stripes
  close_game
done
shows dry '#10141B' $beside 60 || fail "the paper is not dark"
hides wet '#10141B' $beside 20 || fail "the liquid is not to be seen"

for place in 101 102; do
  open_game play "$place"
  expect "rock-of-$place" hud
  close_game
done
# Both show rock in the lower left corner of the window.
one=$(measure "$out/rock-of-101.png" -alpha off -crop '20x20+4+650' -format '%[pixel:p{10,10}]')
two=$(measure "$out/rock-of-102.png" -alpha off -crop '20x20+4+650' -format '%[pixel:p{10,10}]')
[ "$one" != "$two" ] || fail "levels 101 and 102 have rock of one colour: $one"
