//! Known solutions pass every claim.

mod support;

use pairtrawl_certificate::certify;

const NAMES: [&str; 14] = [
    "endpoints",
    "step",
    "turn",
    "forward",
    "no_sideways_slip",
    "speed",
    "abreast",
    "robot_clearance",
    "robots_miss_objects",
    "net_encloses_no_obstacle",
    "every_object_covered",
    "separation",
    "net_reach",
    "inside_area",
];

#[test]
fn witnesses_pass_every_claim_in_the_order_of_the_format() {
    for n in 1..=9 {
        let case = support::witness(n);
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
        let names: Vec<&str> = certificate.claims.iter().map(|c| c.id.name()).collect();
        assert_eq!(names, NAMES);
        for claim in &certificate.claims {
            assert!(claim.holds, "witness {n}: {claim:?}");
        }
        assert!(certificate.is_valid());
    }
}
