# The colours of goals, hazards and rock stay apart in the three common kinds of colour blindness, as they are on the screen.

mkdir "$data/levels/colours"
printf 'width,1280\nheight,720\noptimal_time,10\n' >"$data/levels/colours/constants.csv"
printf 'x,y,mass,fuel,thrust\n1180,560,100,500,3000\n' >"$data/levels/colours/player.csv"
printf 'x,y,width,height\n0,640,1280,80\n140,300,100,100\n' >"$data/levels/colours/world.csv"
printf 'PLAYER,400,300,100,100\nPHYS,660,300,100,100\nOBJECT,60,600,box:30x30,10,120,200,255,0.2,1.0\n' >"$data/levels/colours/objectives.csv"
printf '920,300,100,100\n' >"$data/levels/colours/obstacles.csv"

for palette in safe contrast; do
  printf 'setting,value,player\ncolours,%s,\nparticles,0,\n' "$palette" >"$data/settings.csv"
  open_game play colours
  expect "colours-$palette" drawn
  sleep 4 # the introduction is over
  shot "colours-$palette"
  for sight in normal protan deutan tritan; do
    # Rock, the ship's goal, the keys' goal, a death box: its top edge, which has its own colour in full.
    told_apart "colours-$palette" "$sight" 12 14.8,41.67 35,41.67 55.5,41.67 76,41.67
  done
  close_game
done
