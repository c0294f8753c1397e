//! Values of the command line and their bounds.

use clap::ValueEnum;

/// A value's name on the command line; `None` for one that is hidden.
pub fn name(value: &impl ValueEnum) -> Option<String> {
    Some(value.to_possible_value()?.get_name().to_owned())
}

/// Greatest net length that the command line takes, m.
const LONGEST_NET: f64 = 1000.0;

/// A length of the net in meters, or `auto`.
pub fn parse_net_length(text: &str) -> Result<pairtrawl::NetLength, String> {
    if text == "auto" {
        return Ok(pairtrawl::NetLength::Auto);
    }
    parse_length(text)
        .map(pairtrawl::NetLength::Fixed)
        .map_err(|error| format!("{error}, or `auto`"))
}

/// A length of the net in meters.
pub fn parse_length(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(length) if length > 0.0 && length <= LONGEST_NET => Ok(length),
        _ => Err(format!("give a length above 0 and up to {LONGEST_NET} m")),
    }
}

/// A time limit in seconds.
pub fn parse_seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds <= 1e6 => Ok(seconds),
        _ => Err("give a number of seconds above 0 and up to 1000000".to_owned()),
    }
}

/// A relative residual to which a plan is polished.
pub fn parse_tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(tolerance) if (1e-9..=1e-3).contains(&tolerance) => Ok(tolerance),
        _ => Err("give a relative residual from 1e-9 to 1e-3, such as 1e-6".to_owned()),
    }
}

/// A number above 0.
pub fn parse_positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err("give a finite number above 0".to_owned()),
    }
}

/// A number that is not negative.
pub fn parse_not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number >= 0.0 && number.is_finite() => Ok(number),
        _ => Err("give a finite number, 0 or more".to_owned()),
    }
}

/// Longest side of a hall, m.
const LONGEST_SIDE: f64 = 200.0;

/// `WxD`: width and depth of a hall in meters.
pub fn parse_size(text: &str) -> Result<[f64; 2], String> {
    let side = |text: &str| match text.parse::<f64>() {
        Ok(side) if (1.0..=LONGEST_SIDE).contains(&side) => Some(side),
        _ => None,
    };
    text.split_once('x')
        .and_then(|(width, depth)| Some([side(width)?, side(depth)?]))
        .ok_or_else(|| format!("give width and depth as in 15x10, each from 1 to {LONGEST_SIDE} m"))
}

/// `LOW:HIGH`, or one number that stands for both.
pub fn parse_range(text: &str) -> Result<[f64; 2], String> {
    let (low, high) = text.split_once(':').unwrap_or((text, text));
    let range = [parse_not_negative(low)?, parse_not_negative(high)?];
    if range[0] <= range[1] {
        Ok(range)
    } else {
        Err(format!("{low} is above {high}: give the lower bound first"))
    }
}

#[cfg(test)]
mod tests {
    use super::{parse_net_length, parse_range, parse_seconds, parse_size, parse_tolerance};

    #[test]
    fn net_lengths_are_positive_finite_numbers_or_auto() {
        assert_eq!(parse_net_length("auto"), Ok(pairtrawl::NetLength::Auto));
        assert_eq!(
            parse_net_length("2.5"),
            Ok(pairtrawl::NetLength::Fixed(2.5))
        );
        for bad in ["", "0", "-1", "nan", "inf", "1e9", "2m", "Auto "] {
            assert!(parse_net_length(bad).is_err(), "{bad:?} was taken");
        }
    }

    #[test]
    fn tolerances_are_small_and_within_reach() {
        assert_eq!(parse_tolerance("1e-6"), Ok(1e-6));
        for bad in ["", "0", "-1e-6", "nan", "1e-10", "0.01"] {
            assert!(parse_tolerance(bad).is_err(), "{bad:?} was taken");
        }
    }

    #[test]
    fn time_limits_are_positive_and_finite() {
        assert_eq!(parse_seconds("0.5"), Ok(0.5));
        for bad in ["", "0", "-1", "nan", "inf", "1e7"] {
            assert!(parse_seconds(bad).is_err(), "{bad:?} was taken");
        }
    }

    #[test]
    fn sizes_are_two_lengths() {
        assert_eq!(parse_size("15x10"), Ok([15.0, 10.0]));
        assert_eq!(parse_size("7.5x4"), Ok([7.5, 4.0]));
        for bad in [
            "", "x", "15", "15x", "15x0", "nanx10", "infx10", "15X10", "1e9x10",
        ] {
            assert!(parse_size(bad).is_err(), "{bad:?} was taken");
        }
    }

    #[test]
    fn ranges_are_ordered_and_not_negative() {
        assert_eq!(parse_range("0.5:2"), Ok([0.5, 2.0]));
        assert_eq!(parse_range("1.5"), Ok([1.5, 1.5]));
        for bad in ["", ":", "2:1", "-1:1", "nan:1", "1:inf", "1:2:3"] {
            assert!(parse_range(bad).is_err(), "{bad:?} was taken");
        }
    }
}
