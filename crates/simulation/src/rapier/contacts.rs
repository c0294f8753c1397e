//! Who touches whom.

use super::settings::{point, vector};
use super::tag;
use crate::{Contact, Part};
use pairtrawl_geometry::Point;
use rapier2d_f64::prelude::PhysicsWorld;

/// Every touch after the last step, in no particular but reproducible order; links of the net among themselves left out.
pub(crate) fn touching(world: &PhysicsWorld) -> Vec<Contact> {
    let mut contacts = Vec::new();
    for pair in world.narrow_phase.contact_pairs() {
        if !pair.has_any_active_contact() {
            continue;
        }
        let (a, b) = (
            &world.colliders[pair.collider1],
            &world.colliders[pair.collider2],
        );
        let (part_a, part_b) = (tag::part(a.user_data), tag::part(b.user_data));
        if matches!((part_a, part_b), (Part::Link(_), Part::Link(_))) {
            continue;
        }
        let mut depth = f64::NEG_INFINITY;
        let mut place = Point::ZERO;
        let mut impulse = 0.0;
        for manifold in pair.manifolds() {
            for contact in &manifold.points {
                impulse += contact.data.impulse;
                if -contact.dist > depth {
                    depth = -contact.dist;
                    place = point(
                        a.position()
                            .transform_point(vector(point(contact.local_p1))),
                    );
                }
            }
        }
        if depth < 0.0 && impulse <= 0.0 {
            continue;
        }
        let (first, second) = if part_a <= part_b {
            (part_a, part_b)
        } else {
            (part_b, part_a)
        };
        contacts.push(Contact {
            first,
            second,
            place,
            depth,
            impulse,
        });
    }
    contacts
}
