//! The files of the corpus.

use std::fs;

/// Their names and texts, in alphabetical order.
///
/// # Errors
/// A file cannot be read.
pub(crate) fn files() -> Result<Vec<(String, String)>, String> {
    let folder = env!("CARGO_MANIFEST_DIR");
    let entries = fs::read_dir(folder).map_err(|error| format!("{folder}: {error}"))?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.extension().is_some_and(|extension| extension == "chart") {
            let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            files.push((path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), text));
        }
    }
    files.sort();
    Ok(files)
}
