//! Everything that a browser keeps for the page as one archive, and back: nothing that was there before is lost.

use super::package::{Package, UNPACKED};
use super::{archive::read_below, write};
use crate::files::{Keeper, Manner, PageFiles, Storage, Symlinks};
use crate::words::tr;
use std::{collections::BTreeMap, path::Path};

const NAME: &str = "resultant-data";
const PARTS: [&str; 6] = ["before-import", "exports", "levels", "results", "scores", "settings.csv"];
/// Where a file goes whose place an imported one takes.
const BEFORE: &str = "before-import";
/// The place of the first name in a ZIP archive, bytes.
const FIRST_NAME: usize = 30;

/// Errors: a file that cannot be read, in words.
pub fn export<K: Keeper>(kept: &PageFiles<K>) -> Result<Vec<u8>, String> {
    let mut files = BTreeMap::new();
    for key in kept.0.keys().into_iter().filter(|key| PARTS.contains(&first(key))) {
        let bytes = kept.0.get(&key).map_err(|fault| format!("{key}: {}", std::io::Error::from(fault)))?;
        files.extend(bytes.map(|bytes| (key, bytes)));
    }
    write(&Package { name: NAME.to_owned(), files })
}

fn first(key: &str) -> &str {
    key.split('/').next().unwrap_or_default()
}

/// Whether these are the bytes of such an archive, by its first name.
pub fn is_export(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK") && bytes.get(FIRST_NAME..).is_some_and(|rest| rest.starts_with(format!("{NAME}/").as_bytes()))
}

/// Writes the files of an archive; a file with other bytes goes to `before-import/` first. The answer says in words how many. Errors: a damaged or
/// foreign archive, and nothing was written; no more room, and the files up to there are written.
pub fn import<K: Keeper>(kept: &PageFiles<K>, bytes: &[u8]) -> Result<String, String> {
    let files = read_below(bytes, NAME, |path| PARTS.contains(&first(path)).then_some(UNPACKED))?;
    let (mut new, mut other) = (0, 0);
    for (path, bytes) in &files {
        let refused = |error: std::io::Error| {
            tr!("{path}: {error}; {new} of {count} files are imported", path, error, new = new + other, count = files.len())
        };
        let at = Path::new(path);
        match kept.read(at, u64::MAX, Symlinks::Never) {
            Ok(same) if same == *bytes => continue,
            Ok(old) => {
                let manner = Manner { links: Symlinks::Never, durable: true, shared: false };
                kept.replace(&Path::new(BEFORE).join(at), &old, manner).map_err(refused)?;
                kept.replace(at, bytes, manner).map_err(refused)?;
                other += 1;
            }
            Err(_) => {
                kept.create(at, bytes).map_err(refused)?;
                new += 1;
            }
        }
    }
    Ok(match (new, other) {
        (0, 0) => tr("Everything of this file was there already").to_owned(),
        (new, 0) => tr!("Imported {count} files", count = new),
        (new, other) => tr!(
            "Imported {count} files; {other} took the place of others, which the next export has in {folder}/",
            count = new + other,
            other,
            folder = BEFORE
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::MemoryStorage;

    fn kept(files: &[(&str, &str)]) -> PageFiles<MemoryStorage> {
        let kept = PageFiles(MemoryStorage::with_room(1 << 20));
        files.iter().for_each(|(path, text)| kept.create(Path::new(path), text.as_bytes()).unwrap());
        kept
    }

    fn text(kept: &PageFiles<MemoryStorage>, path: &str) -> String {
        String::from_utf8(kept.read(Path::new(path), 1 << 20, Symlinks::Never).unwrap()).unwrap()
    }

    #[test]
    fn everything_comes_back_and_nothing_is_lost() {
        let files = [("scores/1.csv", "a"), ("levels/mine/player.csv", "b"), ("settings.csv", "c"), ("other/secret", "d")];
        let archive = export(&kept(&files)).unwrap();
        assert!(is_export(&archive) && !is_export(b"PK\x03\x04") && !is_export(b""));
        let empty = kept(&[]);
        assert_eq!(import(&empty, &archive).unwrap(), "Imported 3 files");
        assert_eq!((text(&empty, "levels/mine/player.csv").as_str(), empty.0.keys().len()), ("b", 3));
        assert_eq!(import(&empty, &archive).unwrap(), "Everything of this file was there already");
        let another = kept(&[("scores/1.csv", "mine"), ("scores/2.csv", "mine")]);
        assert!(import(&another, &archive).unwrap().contains("1 took the place of others"));
        let now = ["scores/1.csv", "scores/2.csv", "before-import/scores/1.csv"].map(|path| text(&another, path));
        assert_eq!(now, ["a", "mine", "mine"]);
    }

    #[test]
    fn a_foreign_or_damaged_archive_changes_nothing() {
        let level =
            write(&Package { name: "tower".to_owned(), files: BTreeMap::from([("player.csv".to_owned(), vec![1])]) }).unwrap();
        let whole = export(&kept(&[("scores/1.csv", "a")])).unwrap();
        let empty = kept(&[]);
        for bad in [&level[..], &whole[..whole.len() / 2], b"no archive"] {
            assert!(import(&empty, bad).is_err());
        }
        assert_eq!(empty.0.keys(), [""; 0]);
    }
}
