# The eye: takes pictures of the game's window and says what is on them. Sourced by tests/window/run. Places on a picture are
# percent of its width and height, so that they hold for every size of the window: LEFT TOP WIDTH HEIGHT.

# The look's colours.
accent='#FF9F1C' good='#4CC38A' bad='#F2555A' yellow='#F2C744' text='#E6EBF2'

# How far a colour may lie from the one looked for: soft edges and translucent panels change it a little.
fuzz=8%

# shot NAME: a picture of the window now, as NAME.png.
shot() {
  still_open
  import -window "$game_window" "$out/$1.png"
}

# measure FILE ARGUMENTS…: a number about a picture.
measure() { local file=$1; shift; convert "$file" "$@" info:; }

# holds EXPRESSION: arithmetic comparison of decimal numbers.
holds() { awk "BEGIN { exit !($1) }"; }

# share NAME COLOUR LEFT TOP WIDTH HEIGHT: how many percent of that place have that colour.
share() {
  local file=$out/$1.png width height
  read -r width height < <(identify -format '%w %h\n' "$file")
  local crop
  crop=$(awk "BEGIN { printf \"%dx%d+%d+%d\", $width * $5 / 100, $height * $6 / 100, $width * $3 / 100, $height * $4 / 100 }")
  measure "$file" -alpha off -crop "$crop" +repage -fuzz "$fuzz" -fill black +opaque "$2" -fill white -opaque "$2" \
    -colorspace gray -format '%[fx:100*mean]'
}

# change NAME OTHER: how many percent of the pixels differ. The pictures must be of one size.
change() {
  local pixels changed
  pixels=$(identify -format '%w*%h' "$out/$1.png")
  # compare tells by its status that the pictures differ, and writes the number to standard error.
  changed=$(compare -metric AE -fuzz "$fuzz" "$out/$1.png" "$out/$2.png" null: 2>&1 || true)
  awk "BEGIN { print 100 * $changed / ($pixels) }"
}

# What can be asked of a picture; the first argument is its name.

# drawn NAME: something is there: many colours, neither one flat colour nor next to it.
drawn() {
  holds "$(measure "$out/$1.png" -alpha off -format '%k') > 40" &&
    holds "$(measure "$out/$1.png" -alpha off -format '%[fx:standard_deviation]') > 0.02"
}

# shows NAME COLOUR LEFT TOP WIDTH HEIGHT LEAST: at least LEAST percent of the place have the colour.
shows() { holds "$(share "$1" "$2" "$3" "$4" "$5" "$6") >= $7"; }

# hides NAME COLOUR LEFT TOP WIDTH HEIGHT MOST: at most MOST percent of the place have the colour.
hides() { holds "$(share "$1" "$2" "$3" "$4" "$5" "$6") <= $7"; }

# differs NAME OTHER LEAST: at least LEAST percent of the pixels differ from the other picture's.
differs() { holds "$(change "$1" "$2") >= $3"; }

# resembles NAME OTHER MOST: at most MOST percent of the pixels differ from the other picture's.
resembles() { holds "$(change "$1" "$2") <= $3"; }

# still NAME: the picture is the one before: the page has faded in, and its keys count.
still() {
  local before=$out/before.png same=1
  [ -e "$before" ] && resembles "$1" before 0.01 && same=0
  if [ $same = 0 ]; then rm "$before"; else cp "$out/$1.png" "$before"; fi
  return $same
}

# size NAME WIDTH HEIGHT: the picture's size in pixels.
size() { [ "$(identify -format '%w %h' "$out/$1.png")" = "$2 $3" ]; }

# The head-up display at its places: the fuel bar at the bottom left, 16 % of the width long; mm:ss at the top left.
# hud NAME: both are there, the tank being full.
hud() { fuel_left_end "$1" && fuel_right_end "$1" && shows "$1" "$text" 0 0 14 9 0.4; }
fuel_left_end() { shows "$1" "$accent" 1.5 90 4 10 10; }
fuel_right_end() { shows "$1" "$accent" 12 90 5 10 15; }

# How long a picture may take to become what is expected, s. Only a failure waits so long; less fails on a busy machine, where
# software OpenGL needs seconds for the first frames of a large window.
patience=30

# expect NAME QUESTION [ARG…]: takes the picture NAME again and again until QUESTION NAME ARG… is true, or patience ends.
expect() {
  local name=$1 question=$2
  shift 2
  local end=$((SECONDS + patience))
  while :; do
    shot "$name"
    "$question" "$name" "$@" && break
    [ "$SECONDS" -lt "$end" ] || fail "$out/$name.png: not after $patience s: $question $*"
    sleep 0.1
  done
  echo "$out/$name.png: $question $*"
}

# Colour blindness as a matrix on linear light, after Machado, Oliveira and Fernandes (2009), full strength.
sight_matrix() {
  case $1 in
    normal) echo '1 0 0 0 1 0 0 0 1' ;;
    protan) echo '0.152286 1.052583 -0.204868 0.114503 0.786281 0.099216 -0.003882 -0.048116 1.051998' ;;
    deutan) echo '0.367322 0.860646 -0.227968 0.280085 0.672501 0.047413 -0.011820 0.042940 0.968881' ;;
    tritan) echo '1.255528 -0.076749 -0.178779 -0.078411 0.930809 0.147602 0.004733 0.691367 0.303900' ;;
  esac
}

# told_apart NAME SIGHT LEAST X,Y…: seen with that sight, the colours around those places (percent) lie at least so far from each other in
# CIELAB.
told_apart() {
  local name=$1 sight=$2 least=$3 width height place
  shift 3
  read -r width height < <(identify -format '%w %h\n' "$out/$name.png")
  local labs=()
  for place in "$@"; do
    local crop
    crop=$(awk -v p="$place" "BEGIN { split(p, xy, \",\"); printf \"%dx%d+%d+%.0f\", $width * 0.012, 2, $width * xy[1] / 100, $height * xy[2] / 100 }")
    labs+=("$(convert "$out/$name.png" -alpha off -crop "$crop" +repage -colorspace RGB -color-matrix "$(sight_matrix "$sight")" \
      -scale '1x1!' -colorspace Lab -depth 16 -format '%[fx:100*u.p{0,0}.r] %[fx:255*u.p{0,0}.g-127.5] %[fx:255*u.p{0,0}.b-127.5]' info:)")
  done
  local i j distance
  for ((i = 0; i < ${#labs[@]}; i++)); do
    for ((j = i + 1; j < ${#labs[@]}; j++)); do
      distance=$(echo "${labs[i]} ${labs[j]}" | awk '{ print sqrt(($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2) }')
      holds "$distance >= $least" || fail "$out/$name.png: places ${*:i+1:1} and ${*:j+1:1} look alike with $sight sight: $distance"
    done
  done
  echo "$out/$name.png: told_apart $sight"
}
