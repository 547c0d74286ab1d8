//! A flight as one line of text that a player can hand on: base64url (RFC 4648, §5) of
//!
//! | bytes | content |
//! |---|---|
//! | 1 | [`VERSION`] |
//! | 32 | the level's SHA-256 |
//! | 1 + n, 1 + n, 1 + n | length and UTF-8 of the level's name, the player (0: none) and the program |
//! | 1 | how it ended |
//! | 8, 8, 8 | time (s, a float), score, hash of the last state |
//! | 1 … a row of keys | bits 0 to 3: thrust, reverse, left, right; 4 to 6: the lowest bits of its ticks; 7: more follow, 7 bits a byte |
//! | 4 | the beginning of the SHA-256 of all before |
//!
//! The hashes of the seconds are left out: a proof compares the last state alone.

use super::clock::{Controls, TICK_RATE};
use super::{event::Outcome, fingerprint::LevelHash, inputs::Inputs, replay::Replay};
use crate::words::tr;
use base64::{Engine, prelude::BASE64_URL_SAFE_NO_PAD};
use sha2::{Digest, Sha256};

const VERSION: u8 = 1;
/// Characters.
const LONGEST: usize = 1500;
/// Half an hour of ticks: a longer flight is no race, and a forged one would keep its judge for as long.
const MOST_TICKS: u64 = 30 * 60 * TICK_RATE as u64;
const CHECK: usize = 4;
const OUTCOMES: [Outcome; 3] = [Outcome::Running, Outcome::Completed, Outcome::Failed];

impl Replay {
    /// Errors: the flight has too many changes of keys for 1500 characters, lasts too long, has another tick rate than the game
    pub fn code(&self) -> Result<String, String> {
        if self.tick_rate != TICK_RATE {
            return Err(tr!("found {rate} ticks a second, expected the game's {usual}", rate = self.tick_rate, usual = TICK_RATE));
        }
        lasts(self.inputs.ticks())?;
        let mut bytes = vec![VERSION];
        bytes.extend(self.level_hash.0);
        let player = self.player.as_deref().unwrap_or_default();
        for text in [&self.level, player, &self.program] {
            let length = u8::try_from(text.len())
                .map_err(|_| tr!("found a name of {count} bytes, expected at most 255", count = text.len()))?;
            bytes.push(length);
            bytes.extend(text.as_bytes());
        }
        bytes.extend(OUTCOMES.iter().position(|known| *known == self.outcome).map(|index| index as u8));
        bytes.extend(self.time.to_le_bytes());
        bytes.extend(self.score.to_le_bytes());
        bytes.extend(self.hash.to_le_bytes());
        for (controls, ticks) in self.inputs.rows() {
            write_row(&mut bytes, controls, ticks);
        }
        let check = Sha256::digest(&bytes);
        bytes.extend(&check[..CHECK]);
        let code = BASE64_URL_SAFE_NO_PAD.encode(bytes);
        if code.len() > LONGEST {
            return Err(tr!(
                "found {count} characters, expected at most {most}: too many changes of keys; keep it as a file",
                count = code.len(),
                most = LONGEST
            ));
        }
        Ok(code)
    }

    /// The flight of a code, not proven yet. White space round it does not matter.
    /// Errors: in words, the text is no code, one of another version, cut or altered.
    pub fn from_code(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text.len() > LONGEST {
            return Err(tr!("found {count} characters, expected at most {most}", count = text.len(), most = LONGEST));
        }
        let altered = tr("it is cut or altered: its last characters do not fit the others");
        let known = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_');
        if let Some(other) = text.chars().find(|letter| !known(*letter)) {
            let letter = format_args!("{other:?}");
            return Err(tr!("found {letter}, expected the letters, digits, - and _ of a flight's code", letter));
        }
        let bytes = BASE64_URL_SAFE_NO_PAD.decode(text).map_err(|_| altered)?;
        match bytes.first() {
            Some(&VERSION) => {}
            Some(other) => return Err(tr!("found a code of version {other}, expected version {usual}", other, usual = VERSION)),
            None => return Err(tr("found nothing, expected the text of a flight's code").to_owned()),
        }
        let (said, check) = bytes.split_at_checked(bytes.len().saturating_sub(CHECK)).ok_or(altered)?;
        if Sha256::digest(said)[..CHECK] != *check {
            return Err(altered.to_owned());
        }
        let replay = Rest(&said[1..]).replay().ok_or(tr("found a flight that no game has written"))?;
        lasts(replay.inputs.ticks())?;
        Ok(replay)
    }
}

fn lasts(ticks: u64) -> Result<(), String> {
    match ticks > MOST_TICKS {
        true => Err(tr!("found a flight of {ticks} ticks, expected at most {most}", ticks, most = MOST_TICKS)),
        false => Ok(()),
    }
}

fn write_row(bytes: &mut Vec<u8>, controls: Controls, ticks: u64) {
    let Controls { thrust, reverse, left, right } = controls;
    let keys = [thrust, reverse, left, right].into_iter().enumerate().map(|(bit, held)| u8::from(held) << bit).sum::<u8>();
    let mut rest = ticks >> 3;
    bytes.push(keys | ((ticks & 7) as u8) << 4 | u8::from(rest > 0) << 7);
    while rest > 0 {
        let low = (rest & 0x7f) as u8;
        rest >>= 7;
        bytes.push(low | u8::from(rest > 0) << 7);
    }
}

struct Rest<'a>(&'a [u8]);

impl Rest<'_> {
    fn replay(mut self) -> Option<Replay> {
        let level_hash = LevelHash(self.take()?);
        let [level, player, program] = [self.text()?, self.text()?, self.text()?];
        let [outcome] = self.take()?;
        let outcome = *OUTCOMES.get(usize::from(outcome))?;
        let time = f64::from_le_bytes(self.take()?);
        let (score, hash) = (i64::from_le_bytes(self.take()?), u64::from_le_bytes(self.take()?));
        (time.is_finite() && time >= 0.0).then_some(())?;
        let mut inputs = Inputs::default();
        while !self.0.is_empty() {
            let (controls, ticks) = self.row()?;
            inputs.hold(controls, ticks);
        }
        let given = |text: String| Some(text).filter(|text| !text.is_empty());
        let level = given(level)?;
        let (player, seconds) = (given(player), Vec::new());
        Some(Replay { program, player, level, level_hash, tick_rate: TICK_RATE, outcome, time, score, hash, seconds, inputs })
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*first)
    }

    fn text(&mut self) -> Option<String> {
        let [length] = self.take()?;
        let (text, rest) = self.0.split_at_checked(usize::from(length))?;
        self.0 = rest;
        String::from_utf8(text.to_vec()).ok().filter(|text| !text.chars().any(char::is_control))
    }

    fn row(&mut self) -> Option<(Controls, u64)> {
        let [first] = self.take()?;
        let held = |bit: u8| first & (1 << bit) != 0;
        let controls = Controls { thrust: held(0), reverse: held(1), left: held(2), right: held(3) };
        let (mut ticks, mut shift, mut more) = (u64::from(first >> 4 & 7), 3, held(7));
        while more {
            let [next] = self.take()?;
            // Beyond this a flight would be longer than any.
            (shift < 32).then_some(())?;
            ticks |= u64::from(next & 0x7f) << shift;
            (shift, more) = (shift + 7, next & 0x80 != 0);
        }
        (ticks > 0).then_some((controls, ticks))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn flight(rows: Vec<(u8, u64)>) -> Replay {
        let mut inputs = Inputs::default();
        for (keys, ticks) in rows {
            let held = |bit: u8| keys & (1 << bit) != 0;
            inputs.hold(Controls { thrust: held(0), reverse: held(1), left: held(2), right: held(3) }, ticks);
        }
        Replay {
            program: "resultant 1.0.0".to_owned(),
            player: Some("Zoë".to_owned()),
            level: "7".to_owned(),
            level_hash: LevelHash([7; 32]),
            tick_rate: TICK_RATE,
            outcome: Outcome::Completed,
            time: 12.25,
            score: -3,
            hash: u64::MAX - 5,
            seconds: Vec::new(),
            inputs,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn a_flight_comes_back_from_its_code(rows in prop::collection::vec((0_u8..16, 1_u64..700), 0..300)) {
            let flight = flight(rows);
            let code = flight.code().unwrap();
            prop_assert!(code.len() <= LONGEST);
            prop_assert_eq!(Replay::from_code(&format!(" {code}\n")), Ok(flight));
        }

        #[test]
        fn a_changed_or_cut_code_is_refused(place in 0_usize..200, letter in "[A-Za-z0-9_-]") {
            let code = flight([(1, 60), (5, 9), (0, 120)].repeat(20)).code().unwrap();
            let place = place % code.len();
            prop_assert!(Replay::from_code(&code[..place]).is_err());
            if !code[place..].starts_with(&letter) {
                let changed = format!("{}{letter}{}", &code[..place], &code[place + 1..]);
                prop_assert!(Replay::from_code(&changed).is_err());
            }
        }
    }

    #[test]
    fn each_refusal_says_why() {
        let problem = |text: &str| Replay::from_code(text).unwrap_err();
        assert!(problem("hello there").starts_with("found ' ', expected the letters"));
        assert!(problem("").starts_with("found nothing"));
        assert_eq!(problem(&BASE64_URL_SAFE_NO_PAD.encode([9; 60])), "found a code of version 9, expected version 1");
        assert!(problem(&"A".repeat(3000)).starts_with("found 3000 characters"));
        assert!(flight(vec![(0, MOST_TICKS + 1)]).code().unwrap_err().contains("ticks"));
        assert!(flight([(1, 90), (2, 90)].repeat(600)).code().unwrap_err().contains("keep it as a file"));
    }
}
