//! A version of a file: on the disk, or as git keeps it.

use std::path::Path;
use std::process::Command;

use crate::Failure;
use crate::find::{self, Found};

/// The charts of one side. `other` is the path of the other one, which a revision alone stands for.
pub(super) fn charts(file: &Path, other: &Path) -> Result<Vec<Found>, Failure> {
    match kept(file, other) {
        Some(object) => find::of_version(Path::new(&object), &from_git(&object)?),
        None => find::of_files(&[file.to_path_buf()]),
    }
}

/// `REV:PATH` as git takes it, where no file is called so.
fn kept(file: &Path, other: &Path) -> Option<String> {
    let (revision, path) = file.to_str()?.split_once(':')?;
    // `C:\motor.rs`
    let is_drive = revision.len() == 1 && path.starts_with(['\\', '/']);
    if file.exists() || revision.is_empty() || is_drive {
        return None;
    }
    if !path.is_empty() {
        return Some(format!("{revision}:{path}"));
    }
    // The same file as the other one, which may be of a revision, too.
    let other = other.to_str()?;
    let from_here = |path: &str| if Path::new(path).is_absolute() { path.to_owned() } else { format!("./{path}") };
    let path = match other.split_once(':') {
        Some((_, path)) if !Path::new(other).exists() => path.to_owned(),
        _ => from_here(&other.replace('\\', "/")),
    };
    Some(format!("{revision}:{path}"))
}

fn from_git(object: &str) -> Result<String, Failure> {
    let said = |why: &str| Failure::Said(format!("{object}: {why}"));
    // A word for git, and none of its options.
    if object.starts_with('-') {
        return Err(said("a revision does not begin with `-`"));
    }
    let done = Command::new("git").args(["cat-file", "blob", object]).output();
    let done = done.map_err(|error| said(&format!("`git`, which keeps it, cannot be run: {error}")))?;
    if !done.status.success() {
        let why = String::from_utf8_lossy(&done.stderr).trim().replace('\n', "; ");
        return Err(said(&format!("git says: {}", why.trim_start_matches("fatal: "))));
    }
    String::from_utf8(done.stdout).map_err(|_| said("it is no text in UTF-8"))
}

#[cfg(test)]
mod tests {
    use super::kept;
    use std::path::Path;

    #[test]
    fn what_stands_for_a_revision() {
        let of = |file: &str, other: &str| kept(Path::new(file), Path::new(other));
        assert_eq!(of("HEAD~1:src/a.rs", "b.rs").as_deref(), Some("HEAD~1:src/a.rs"));
        assert_eq!(of("HEAD:", "src/b.rs").as_deref(), Some("HEAD:./src/b.rs"));
        assert_eq!(of("v1:", "v2:src/b.rs").as_deref(), Some("v1:src/b.rs"));
        assert_eq!([of("a.rs", "b.rs"), of("C:/a.rs", "b.rs"), of(":a.rs", "b.rs")], [None, None, None]);
    }
}
