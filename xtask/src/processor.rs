//! How much work a program does: processor time does not depend on what else the machine does.

use std::fs;

use crate::command::Result;

/// The processor time, in seconds, of all programs that this one has started and that have ended.
///
/// # Errors
/// The system does not tell.
pub(crate) fn children() -> Result<f64> {
    const FILE: &str = "/proc/self/stat";
    let stat =
        fs::read_to_string(FILE).map_err(|error| format!("{FILE}: {error}; build times are measured on Linux"))?;
    seconds(&stat).ok_or_else(|| format!("{FILE} holds something else: {stat}"))
}

/// The fields `cutime` and `cstime`, in hundredths.
fn seconds(stat: &str) -> Option<f64> {
    // The program's name may hold anything; after its parenthesis the third field follows.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut fields = fields.split_whitespace().skip(13);
    let [user, system] = [fields.next()?, fields.next()?].map(str::parse::<u32>);
    Some(f64::from(user.ok()? + system.ok()?) / 100.0)
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn children_are_in_the_sixteenth_field() {
        let stat = "7 (a) b) S 1 1 1 0 -1 4194304 1 2 3 4 10 20 150 50 20 0 1 0 99";
        assert_eq!(seconds(stat), Some(2.0));
        assert_eq!(seconds("7"), None);
    }
}
