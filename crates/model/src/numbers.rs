//! Numbers as people read them: `1.639 m`, not `1.63852645380624` and not `1.639e0`.
//!
//! Texts, tables and pictures use these functions, so the same number looks the same everywhere. Files for programs (JSON,
//! CSV) keep full precision and do not use them. What is not finite becomes a dash.

use pairtrawl_geometry::Point;

/// What stands for a number that is not finite.
const NONE: &str = "\u{2013}";

/// A length given in m, in the unit that suits its size: `0.31 mm`, `49.1 mm`, `1.639 m`, `163.9 m`, `2.320 km`.
pub fn length(meters: f64) -> String {
    scaled(meters, "m")
}

/// A length given in m that is enough: as [`length`] shows it, rounded up, so that a length as shown suffices.
pub fn enough_length(meters: f64) -> String {
    length(shown_steps(meters, f64::ceil, -1e-6))
}

/// A length given in m that is not too much: as [`length`] shows it, rounded down.
pub fn most_length(meters: f64) -> String {
    length(shown_steps(meters, f64::floor, 1e-6))
}

/// The length rounded to the last decimal that [`length`] shows; what is a whole number of them but for rounding stays.
fn shown_steps(meters: f64, round: fn(f64) -> f64, hair: f64) -> f64 {
    let steps_per_meter = match meters.abs() {
        s if s < 0.009_99 => 1e5,
        s if s < 99.99 => 1e3,
        s if s < 999.0 => 10.0,
        s if s < 99_999.0 => 1.0,
        _ => 0.01,
    };
    round(meters * steps_per_meter + hair) / steps_per_meter
}

/// A speed given in m/s: `0.260 m/s`, `5.40 mm/s`.
pub fn speed(meters_per_second: f64) -> String {
    scaled(meters_per_second, "m/s")
}

/// An angle given in rad: `0.123 rad`.
pub fn angle(radians: f64) -> String {
    fixed(radians, 3, " rad")
}

/// A place given in m: `(1.250, 8.031) m`, with as many decimals as its size asks for.
pub fn place(point: Point) -> String {
    if !point.is_finite() {
        return NONE.to_owned();
    }
    let decimals = match point.x.abs().max(point.y.abs()) {
        s if s < 0.1 => 5,
        s if s < 1.0 => 4,
        s if s < 100.0 => 3,
        s if s < 1e4 => 1,
        _ => 0,
    };
    let number = |v: f64| without_minus_zero(format!("{v:.decimals$}"));
    format!("({}, {}) m", number(point.x), number(point.y))
}

/// A time given in s: `12.0 ms`, `3.14 s`, `81.3 s`, `4 min 08 s`.
pub fn duration(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => NONE.to_owned(),
        0.0 => "0 s".to_owned(),
        s if s.abs() < 0.1 => format!("{:.1} ms", 1e3 * s),
        s if s.abs() < 9.995 => format!("{s:.2} s"),
        s if s < 99.95 => format!("{s:.1} s"),
        s => {
            let s = s.round() as u64;
            format!("{} min {:02} s", s / 60, s % 60)
        }
    }
}

/// A cost, which has no unit: `5588.0`, `0.125`.
pub fn cost(value: f64) -> String {
    match value.abs() {
        s if !s.is_finite() => NONE.to_owned(),
        0.0 => "0".to_owned(),
        s if s < 0.999_5 => fixed(value, 3, ""),
        s if s < 1e9 => format!("{value:.1}"),
        _ => format!("{value:.3e}"),
    }
}

/// An error of a solver, which is a power of ten more than a number: `1.0e-7`.
pub fn residual(value: f64) -> String {
    match value {
        v if !v.is_finite() => NONE.to_owned(),
        0.0 => "0".to_owned(),
        v => format!("{v:.1e}"),
    }
}

/// A value in any unit (empty: none). Lengths and speeds take the unit that suits their size; others have three decimals,
/// large ones one.
pub fn quantity(value: f64, unit: &str) -> String {
    let suffix = match unit {
        "m" => return length(value),
        "m/s" => return speed(value),
        "rad" => return angle(value),
        "" => String::new(),
        _ => format!(" {unit}"),
    };
    match value.abs() {
        s if s >= 1e6 && s.is_finite() => format!("{value:.3e}{suffix}"),
        s if s >= 99.999_5 => fixed(value, 1, &suffix),
        _ => fixed(value, 3, &suffix),
    }
}

/// An amount of memory in bytes, in whole megabytes that hold it.
pub fn memory(bytes: u64) -> String {
    format!("{} MB", bytes.div_ceil(1_000_000))
}

/// Ascending indices with runs of three or more as ranges: `0, 2, 5-9`.
pub fn index_list(indices: &[usize]) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut rest = indices;
    while let [first, ..] = rest {
        let run = (rest.iter().zip(*first..))
            .take_while(|(index, expected)| *index == expected)
            .count();
        let (run, after) = rest.split_at(run);
        match run {
            [first, _, .., last] => parts.push(format!("{first}-{last}")),
            few => parts.extend(few.iter().map(usize::to_string)),
        }
        rest = after;
    }
    parts.join(", ")
}

/// A unit that several lengths share, in a table or along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit {
    /// `mm`, `m` or `km`.
    pub name: &'static str,
    /// How many of it make a meter.
    pub per_meter: f64,
}

impl LengthUnit {
    /// The unit for lengths of which the greatest is as given, m.
    pub fn of(greatest: f64) -> Self {
        let (name, per_meter) = match greatest.abs() {
            s if s < 1.0 => ("mm", 1e3),
            s if s >= 3e3 => ("km", 1e-3),
            _ => ("m", 1.0),
        };
        Self { name, per_meter }
    }

    /// A length given in m as a number in this unit, without the unit's name.
    pub fn number(&self, meters: f64) -> String {
        let value = meters * self.per_meter;
        let decimals = match self.name {
            "mm" if value.abs() < 9.995 => 2,
            "mm" => 1,
            _ => 3,
        };
        fixed(value, decimals, "")
    }
}

/// Lengths given in m, in one unit, the unit once: `8.7 / 12.3 mm`.
pub fn lengths(meters: &[f64]) -> String {
    let finite = meters.iter().filter(|v| v.is_finite());
    let unit = LengthUnit::of(finite.fold(0.0, |m, v| v.abs().max(m)));
    let numbers: Vec<String> = meters.iter().map(|v| unit.number(*v)).collect();
    format!("{} {}", numbers.join(" / "), unit.name)
}

/// A value whose unit begins with `m`: in mm, m or km and what follows.
fn scaled(value: f64, unit: &str) -> String {
    match value.abs() {
        0.0 => format!("0 {unit}"),
        s if s < 0.009_995 => fixed(1e3 * value, 2, &format!(" m{unit}")),
        s if s < 0.099_95 => fixed(1e3 * value, 1, &format!(" m{unit}")),
        s if s < 99.999_5 => fixed(value, 3, &format!(" {unit}")),
        s if s < 999.95 => fixed(value, 1, &format!(" {unit}")),
        s if s < 99_999.5 => fixed(1e-3 * value, 3, &format!(" k{unit}")),
        s if s < 1e9 => fixed(1e-3 * value, 1, &format!(" k{unit}")),
        _ => match value.is_finite() {
            true => format!("{value:.3e} {unit}"),
            false => NONE.to_owned(),
        },
    }
}

/// A number with its decimals and what follows it; one that would read as zero and is none is given by its bound.
fn fixed(value: f64, decimals: usize, suffix: &str) -> String {
    if !value.is_finite() {
        return NONE.to_owned();
    }
    if value == 0.0 {
        return format!("0{suffix}");
    }
    let text = format!("{value:.decimals$}");
    if !is_zero(&text) {
        return format!("{text}{suffix}");
    }
    let least = format!("0.{}1", "0".repeat(decimals.saturating_sub(1)));
    match value > 0.0 {
        true => format!("< {least}{suffix}"),
        false => format!("> -{least}{suffix}"),
    }
}

fn is_zero(text: &str) -> bool {
    !text.contains(|c: char| c.is_ascii_digit() && c != '0')
}

fn without_minus_zero(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if is_zero(&text) => rest.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_take_the_unit_of_their_size() {
        for (meters, text) in [
            (1.638_526_453_806_24, "1.639 m"),
            (-0.031_24, "-31.2 mm"),
            (0.0, "0 m"),
            (-0.0, "0 m"),
            (0.004_82, "4.82 mm"),
            (0.009_996, "10.0 mm"),
            (0.099_96, "0.100 m"),
            (1e-4, "0.10 mm"),
            (3e-7, "< 0.01 mm"),
            (-3e-7, "> -0.01 mm"),
            (99.999_6, "100.0 m"),
            (163.852, "163.9 m"),
            (2320.0, "2.320 km"),
            (149_000.0, "149.0 km"),
            (f64::NAN, "\u{2013}"),
            (f64::INFINITY, "\u{2013}"),
        ] {
            assert_eq!(length(meters), text, "{meters}");
        }
        assert_eq!(speed(0.26), "0.260 m/s");
        assert_eq!(speed(0.0054), "5.40 mm/s");
        assert_eq!(lengths(&[0.0087, 0.012_34]), "8.70 / 12.3 mm");
        assert_eq!(lengths(&[1.2, 0.012_34]), "1.200 / 0.012 m");
        assert_eq!(lengths(&[4200.0, f64::NAN]), "4.200 / \u{2013} km");
    }

    #[test]
    fn a_machine_of_any_size_keeps_three_digits() {
        // The margin of a robot a fiftieth, and a thousand times as large as the paper's.
        for (scale, text) in [(0.02, "6.25 mm"), (1.0, "0.313 m"), (1e3, "312.6 m")] {
            assert_eq!(length(0.312_6 * scale), text);
        }
    }

    #[test]
    fn other_numbers_read_well() {
        assert_eq!(angle(0.123_456), "0.123 rad");
        assert_eq!(angle(-1e-9), "> -0.001 rad");
        assert_eq!(quantity(0.5, "N"), "0.500 N");
        assert_eq!(quantity(123.456, "N"), "123.5 N");
        assert_eq!(quantity(0.5, ""), "0.500");
        assert_eq!(quantity(-0.02, "rad"), "-0.020 rad");
        assert_eq!(cost(5588.04), "5588.0");
        assert_eq!(cost(0.0), "0");
        assert_eq!(cost(0.125), "0.125");
        assert_eq!(cost(2.5e12), "2.500e12");
        assert_eq!(residual(1e-7), "1.0e-7");
        assert_eq!(residual(f64::NAN), "\u{2013}");
        assert_eq!(place(Point::new(1.25, -0.000_01)), "(1.250, 0.000) m");
        assert_eq!(place(Point::new(0.031_25, 0.01)), "(0.03125, 0.01000) m");
        assert_eq!(place(Point::new(1250.0, 2.0)), "(1250.0, 2.0) m");
        assert_eq!(place(Point::new(f64::NAN, 2.0)), "\u{2013}");
        assert_eq!(duration(0.012), "12.0 ms");
        assert_eq!(duration(0.0), "0 s");
        assert_eq!(duration(9.999), "10.0 s");
        assert_eq!(duration(81.34), "81.3 s");
        assert_eq!(duration(99.97), "1 min 40 s");
        assert_eq!(duration(248.0), "4 min 08 s");
    }
}
