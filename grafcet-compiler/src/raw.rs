//! Names with and without the mark of a raw identifier: `on` and `r#on` are one.

use proc_macro2::Ident;

/// A name as it is shown and compared.
pub(crate) fn plain(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}
