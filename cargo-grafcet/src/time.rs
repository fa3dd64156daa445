//! Times that somebody types.

use std::time::Duration;

/// `60s`, `1.5s`, `500ms`, `5min`, `1h`.
pub(crate) fn duration(text: &str) -> Result<Duration, String> {
    let digits = text.len() - text.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '.').len();
    let (number, unit) = text.split_at(digits);
    let nanos: u64 = match unit.trim_start() {
        "us" | "µs" => 1_000,
        "ms" => 1_000_000,
        "s" => 1_000_000_000,
        "min" => 60_000_000_000,
        "h" => 3_600_000_000_000,
        "" => return Err("there is no unit, as in `60s`".to_owned()),
        other => return Err(format!("`{other}` is none of `ms`, `s`, `min` and `h`")),
    };
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let no_number = || "that is no number with a unit, as in `60s`".to_owned();
    let whole: u64 = whole.parse().map_err(|_| no_number())?;
    let mut all = whole.checked_mul(nanos);
    let mut place = nanos;
    for digit in part.chars() {
        place /= 10;
        let digit = digit.to_digit(10).ok_or_else(no_number)?;
        all = all.and_then(|all| all.checked_add(u64::from(digit) * place));
    }
    all.map(Duration::from_nanos).ok_or_else(|| "that is longer than can be counted".to_owned())
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn times_with_their_units() {
        let ms = |text| duration(text).map(|time| time.as_millis());
        assert_eq!(
            ["60s", "1.5s", "1.25 s", "500ms", "5min", "0.5h"].map(ms),
            [60_000, 1_500, 1_250, 500, 300_000, 1_800_000].map(Ok)
        );
        for wrong in ["60", "s", "1.2.3s", ".5s", "-1s", "5days", "", "999999999999h"] {
            assert!(duration(wrong).is_err(), "{wrong}");
        }
    }
}
