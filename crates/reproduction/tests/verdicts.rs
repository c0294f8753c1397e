//! A verdict follows from its evidence: a number that changes flips it, and nothing else does.

use pairtrawl_reproduction::claims::CLAIMS;
use pairtrawl_reproduction::evidence::Evidence;
use pairtrawl_reproduction::verdict::judge;
use std::collections::BTreeSet;

/// Evidence from names and values.
fn evidence(numbers: &[(&str, f64)]) -> Evidence {
    let add = |all: Evidence, (name, value): &(&str, f64)| all.with(name, *value, "");
    numbers.iter().fold(Evidence::default(), add)
}

/// A claim, numbers with their verdict, and numbers that are put in their place one at a time with the verdict that follows.
struct Case {
    claim: &'static str,
    numbers: &'static [(&'static str, f64)],
    verdict: &'static str,
    planted: &'static [(&'static str, f64, &'static str)],
}

include!("verdicts/cases.rs");

#[test]
fn every_claim_is_judged_by_its_numbers() {
    for case in CASES {
        let judged = judge(case.claim, &evidence(case.numbers));
        assert_eq!(judged.name(), case.verdict, "{}: {judged:?}", case.claim);
        assert!(!judged.words().is_empty(), "{}", case.claim);
    }
}

#[test]
fn a_planted_number_flips_the_verdict() {
    for case in CASES {
        assert!(!case.planted.is_empty(), "{}", case.claim);
        for (name, value, verdict) in case.planted {
            let mut numbers = case.numbers.to_vec();
            let number = numbers.iter_mut().find(|(known, _)| known == name);
            number.unwrap_or_else(|| panic!("{}: {name}", case.claim)).1 = *value;
            let judged = judge(case.claim, &evidence(&numbers));
            assert_eq!(
                judged.name(),
                *verdict,
                "{} with {name} {value}",
                case.claim
            );
            assert_ne!(
                judged.name(),
                case.verdict,
                "{} with {name} {value}",
                case.claim
            );
        }
    }
}

#[test]
fn without_evidence_nothing_is_shown() {
    for claim in CLAIMS {
        let judged = judge(claim.key, &Evidence::default());
        assert_eq!(judged.name(), "not shown", "{}: {judged:?}", claim.key);
    }
}

#[test]
fn every_claim_has_a_case_and_a_name_of_its_own() {
    let claims: BTreeSet<&str> = CLAIMS.iter().map(|claim| claim.key).collect();
    let cases: BTreeSet<&str> = CASES.iter().map(|case| case.claim).collect();
    assert_eq!(claims, cases);
    assert_eq!(claims.len(), CLAIMS.len());
}
