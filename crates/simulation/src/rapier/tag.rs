//! What a collider belongs to, packed into its user data.

use crate::Part;
use pairtrawl_model::Side;

const KIND: u32 = 64;

pub(crate) fn obstacle(index: Option<usize>) -> u128 {
    index.map_or(0, |i| i as u128 + 1)
}

pub(crate) fn robot(side: Side) -> u128 {
    (1 << KIND) | side.index() as u128
}

pub(crate) fn link(index: usize) -> u128 {
    (2 << KIND) | index as u128
}

pub(crate) fn object(index: usize) -> u128 {
    (3 << KIND) | index as u128
}

pub(crate) fn part(user_data: u128) -> Part {
    let index = (user_data & ((1 << KIND) - 1)) as usize;
    match user_data >> KIND {
        0 => Part::Obstacle(index.checked_sub(1)),
        1 if index == Side::Left.index() => Part::Robot(Side::Left),
        1 => Part::Robot(Side::Right),
        2 => Part::Link(index),
        _ => Part::Object(index),
    }
}
