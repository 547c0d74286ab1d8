# Sound: what reaches a device. A configuration makes ALSA's default device a file; the other stories have whatever this machine has,
# mostly none.

sound=$data/sound
cat >"$data/asound.conf" <<END
pcm.!default { type file slave.pcm { type null } file "$sound" format raw }
ctl.!default { type hw card 0 }
END
# A second of 48 000 frames, left and right, of 4 bytes.
second=$((48000 * 2 * 4))

# listening COMMAND…: with that device, and with no sound server.
listening() { ALSA_CONFIG_PATH=$data/asound.conf PULSE_SERVER=unix:/nonexistent/pulse "$@"; }

# heard_since BYTE: the root of the mean square, and the peak, of all samples from there on.
heard_since() {
  tail -c "+$(($1 + 1))" "$sound" | od -An -v -t f4 -w8 |
    awk '{ for (i = 1; i <= NF; i++) { s += $i * $i; n++; a = $i < 0 ? -$i : $i; if (a > p) p = a } } END { print n ? sqrt(s / n) : 0, p + 0 }'
}

heard_now() { stat -c %s "$sound" 2>/dev/null || echo 0; }

# The menu has music and buttons.
listening open_game
press Down
sleep 4
close_game
[ "$(heard_now)" -gt $((2 * second)) ] || fail "no sound reached the device in the menu: $(heard_now) bytes"
read -r music peak < <(heard_since 0)
holds "$music > 0.0005 && $peak < 1" || fail "the menu sounds like $music, at most $peak"

# A flight has its engine, which is louder. Nothing is in its way.
sky=$data/levels/sky
mkdir "$sky"
printf 'width,1280\nheight,9000\n' >"$sky/constants.csv"
printf '640,8900,100,500,2000\n' >"$sky/player.csv"
printf 'PLAYER,10,10,20,20\n' >"$sky/objectives.csv"
rm -f "$sound"
listening open_game play sky
hold 0.5 space
begun=$(($(heard_now) / 8 * 8))
hold 2.5 space
close_game
read -r engine peak < <(heard_since "$begun")
holds "$engine > 2 * $music && $engine > 0.005 && $peak < 1" || fail "the engine sounds like $engine, at most $peak, after music like $music"
echo "music $music, engine $engine, peak $peak"

# A device that is not there is silence: the game opens, plays and says nothing of it.
echo 'pcm.!default { type hw card 31 }' >"$data/asound.conf"
listening open_game play sky
hold 0.5 space
close_game
! grep -q ALSA "$out/output.log" || fail "a missing device is spoken of: $(grep -m 1 ALSA "$out/output.log")"
