//! The quantities to plot: a row a family, x, y and size beside each other; motion on the left, forces on the right.

use crate::instruments::quantity::{Quantity, VectorPart};
use crate::physics::ForceKind;

/// A family's name and its quantities.
pub type Row = (&'static str, Vec<Quantity>);
pub const MOST_OF_A_ROW: usize = 3;
pub const NAME: usize = 14;

/// In two blocks; of the forces only those that have acted.
pub fn choices(time: bool, acted: impl Fn(ForceKind) -> bool) -> [Vec<Row>; 2] {
    let parts = |of: &dyn Fn(VectorPart) -> Quantity| VectorPart::ALL.map(of).to_vec();
    let row = |quantities: Vec<Quantity>| (quantities[0].family(), quantities);
    let mut motion = Vec::new();
    if time {
        motion.push(row(vec![Quantity::Time]));
    }
    motion.extend([
        row(vec![Quantity::X, Quantity::Y]),
        row(parts(&Quantity::Velocity)),
        row(parts(&Quantity::Acceleration)),
        row(parts(&Quantity::Momentum)),
        row(vec![Quantity::Kinetic, Quantity::Potential, Quantity::Mechanical]),
    ]);
    let kinds = ForceKind::ALL.into_iter().filter(|kind| acted(*kind));
    let forces = kinds.map(|kind| row(parts(&|part| Quantity::Force(kind, part))));
    [motion, std::iter::once(row(parts(&Quantity::Resultant))).chain(forces).collect()]
}

/// The words of a button: forces by their part alone, since their row has the name.
pub fn label(quantity: Quantity) -> String {
    match quantity {
        Quantity::Force(_, VectorPart::X) => "F_x".to_owned(),
        Quantity::Force(_, VectorPart::Y) => "F_y".to_owned(),
        Quantity::Force(_, VectorPart::Size) => "|F|".to_owned(),
        other => other.symbol(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_can_be_chosen_once_and_has_room() {
        let all = choices(true, |_| true);
        let quantities: Vec<Quantity> = all.iter().flatten().flat_map(|(_, row)| row.clone()).collect();
        for (i, quantity) in quantities.iter().enumerate() {
            assert!(!quantities[..i].contains(quantity), "{quantity:?}");
        }
        assert_eq!(quantities.len(), 1 + 2 + 3 * 3 + 3 + 3 + 3 * ForceKind::ALL.len());
        assert!(all.iter().flatten().all(|(name, row)| name.len() <= NAME && row.len() <= MOST_OF_A_ROW));
        assert_eq!(choices(false, |kind| kind == ForceKind::Weight)[1].len(), 2);
        assert!(!choices(false, |_| true).iter().flatten().any(|(_, row)| row.contains(&Quantity::Time)));
    }
}
