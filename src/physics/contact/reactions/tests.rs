//! Contact forces of whole groups: answers in closed form, and Coulomb's law where rounds between the axes do not settle.

use crate::physics::contact::reactions::*;
use crate::random::Random;

/// What `face` answers is what the network answers, to the bit.
#[test]
fn a_body_on_one_face_has_the_same_answer_directly_and_by_the_network() {
    let mut generator = Random(3);
    let mut random = || generator.unit();
    let mut moved = 0;
    for _ in 0..5000 {
        let masses = [DVec2::splat(0.1 + 10.0 * random())];
        let free = [DVec2::new(20.0 * random() - 10.0, if random() < 0.1 { 0.0 } else { 30.0 * random() - 15.0 }), DVec2::ZERO];
        let (lo, hi) = if random() < 0.5 { (0, 1) } else { (1, 0) };
        let static_friction = random();
        let mut direct = [Contact {
            static_friction,
            kinetic_friction: static_friction * random(),
            slides: (3.0 * random()).floor() - 1.0,
            ..Contact::between(lo, hi, usize::from(random() < 0.7))
        }];
        let mut network = direct;
        let (mut by_face, mut by_network) = ([DVec2::NAN], [DVec2::NAN]);
        let mut reactions = Reactions::default();
        let parts = Parts { masses: &masses, free: &free };
        reactions.accelerate(&mut direct, &parts, &mut by_face);
        reactions.accelerate_group(&mut network, &parts, &mut by_network);
        assert_eq!(by_face, by_network, "{direct:?} {network:?}");
        let found = |[contact]: [Contact; 1]| [contact.normal, contact.friction, contact.slides];
        assert_eq!(found(direct), found(network));
        moved += u32::from(by_face[0] != DVec2::ZERO);
    }
    assert!((1000..4900).contains(&moved), "{moved}");
}

/// Random levels found this group: the rounds between the axes went in circles, and friction was left that nothing pressed for. Its contacts
/// have their axes and slides.
#[test]
fn no_contact_rubs_harder_than_it_presses_where_the_rounds_go_in_circles() {
    let contacts = [
        (0, 6, 0, -1.0),
        (8, 0, 1, 0.0),
        (10, 0, 0, 1.0),
        (3, 8, 0, -1.0),
        (8, 4, 0, -1.0),
        (6, 5, 0, 0.0),
        (5, 7, 0, 0.0),
        (5, 9, 1, 0.0),
        (6, 9, 1, 0.0),
    ];
    let masses = [100.0, 6.0, 74.0, 25.0, 66.0, 20.0, 28.0, 65.0, 18.0];
    let free = [
        (6.477590650225734, 2.346331352698204),
        (-12.0, 10.0),
        (-12.0, 10.0),
        (-12.0, 10.0),
        (0.0, 0.0),
        (-12.0, 10.0),
        (-12.0, 10.0),
        (-12.0, 10.0),
        (-12.0, 10.0),
    ];
    let between = |&(lo, hi, axis, slides): &(u32, u32, usize, f64)| Contact {
        static_friction: 0.9,
        kinetic_friction: 0.65,
        slides,
        ..Contact::between(lo, hi, axis)
    };
    let mut contacts: Vec<Contact> = contacts.iter().map(between).collect();
    let masses: Vec<DVec2> = masses.iter().map(|mass| DVec2::splat(*mass)).collect();
    let mut free: Vec<DVec2> = free.iter().map(|a| DVec2::from(*a)).collect();
    free.resize(masses.len() + 2, DVec2::ZERO);
    let mut out = free.clone();
    let mut reactions = Reactions::default();
    reactions.accelerate(&mut contacts, &Parts { masses: &masses, free: &free }, &mut out);
    assert_eq!(reactions.unsettled, 1);
    let mut forces: Vec<DVec2> = masses.iter().zip(&free).map(|(mass, a)| *mass * *a).collect();
    for contact in &contacts {
        let most = if contact.slides == 0.0 { 0.9 } else { 0.65 } * contact.normal;
        assert!(contact.normal >= 0.0 && contact.friction.abs() <= most * (1.0 + 1e-9) + 1e-9, "{contact:?}");
        let mut force = DVec2::ZERO;
        (force[contact.axis], force[1 - contact.axis]) = (contact.normal, contact.friction);
        for (item, sign) in [(contact.lo, -1.0), (contact.hi, 1.0)] {
            if let Some(sum) = forces.get_mut(item as usize) {
                *sum += sign * force;
            }
        }
    }
    for (i, force) in forces.iter().enumerate() {
        assert!((*force - masses[i] * out[i]).length() < 1e-6, "{force} N on body {i}, which gets {} m/s²", out[i]);
    }
    let parting = |contact: &Contact| {
        let of = |item: u32| out.get(item as usize).map_or(0.0, |a| a[contact.axis]);
        of(contact.hi) - of(contact.lo)
    };
    assert!(contacts.iter().all(|contact| parting(contact) > -1e-9));
}
