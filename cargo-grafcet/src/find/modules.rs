//! From the first file of a target to all its files: `mod name;` leads on, as in rustc.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use proc_macro2::Span;
use syn::{Attribute, Expr, ExprLit, Item, ItemMod, Lit, Meta};

use super::File;
use crate::Failure;
use crate::report::human;

/// The files of a crate, each once.
#[derive(Default)]
pub(super) struct Files {
    pub(super) all: Vec<File>,
    seen: BTreeSet<PathBuf>,
}

/// Where the modules of a file lie.
struct Folders {
    /// The folder of the file.
    file: PathBuf,
    /// That of modules without a path.
    modules: PathBuf,
    /// The names of the modules within which we are in this file.
    inside: PathBuf,
    /// `lib.rs`, `mod.rs`, or a file that a path has named.
    owns_folder: bool,
}

impl Files {
    /// The first file of a target, and all that it leads to.
    pub(super) fn add_target(&mut self, file: &Path) -> Result<(), Failure> {
        self.add(file, true)
    }

    fn add(&mut self, path: &Path, owns_folder: bool) -> Result<(), Failure> {
        let known = path.canonicalize().map_err(|error| Failure::file(path, &error))?;
        if !self.seen.insert(known) {
            return Ok(());
        }
        let file = File::read(path)?;
        let parsed: syn::File = syn::parse2(file.tokens.clone())
            .map_err(|error| Failure::Shown(human::at(&file.source, error.span(), &format!("not Rust: {error}"))))?;
        let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
        let modules = if owns_folder { folder.clone() } else { path.with_extension("") };
        let mut inside = Folders { file: folder, modules, inside: PathBuf::new(), owns_folder };
        let mut found = Vec::new();
        collect(&parsed.items, &mut inside, &mut found);
        let mut next = Vec::new();
        for module in found {
            match module.file() {
                Some(found) => next.push((found, module.has_path)),
                // Another system has it, or another set of features.
                None if module.is_conditional => {}
                None => return Err(Failure::Shown(human::at(&file.source, module.span, &module.missing()))),
            }
        }
        self.all.push(file);
        // `name/mod.rs` has its modules beside itself, `name.rs` in the folder of its name.
        next.iter().try_for_each(|(file, has_path)| self.add(file, *has_path || file.ends_with("mod.rs")))
    }
}

/// `mod name;`
struct Module {
    /// Where it may be.
    files: Vec<PathBuf>,
    has_path: bool,
    is_conditional: bool,
    span: Span,
}

impl Module {
    fn file(&self) -> Option<PathBuf> {
        self.files.iter().find(|file| file.is_file()).cloned()
    }

    fn missing(&self) -> String {
        let files: Vec<String> = self.files.iter().map(|file| format!("`{}`", super::shown(file).display())).collect();
        format!("there is no file for this module: {}", files.join(" or "))
    }
}

fn collect(items: &[Item], folders: &mut Folders, found: &mut Vec<Module>) {
    for item in items {
        let Item::Mod(module) = item else { continue };
        let name = module.ident.to_string();
        let name = name.trim_start_matches("r#");
        match &module.content {
            Some((_, items)) => {
                folders.inside.push(path_of(&module.attrs).as_deref().unwrap_or(name));
                collect(items, folders, found);
                folders.inside.pop();
            }
            None => found.push(outside(module, name, folders)),
        }
    }
}

fn outside(module: &ItemMod, name: &str, folders: &Folders) -> Module {
    let path = path_of(&module.attrs);
    let files = match &path {
        // From the folder of the file on; within another module from that module's folder on.
        Some(path) if folders.inside.as_os_str().is_empty() || folders.owns_folder => {
            vec![folders.file.join(&folders.inside).join(path)]
        }
        Some(path) => vec![folders.modules.join(&folders.inside).join(path)],
        None => {
            let folder = folders.modules.join(&folders.inside);
            vec![folder.join(format!("{name}.rs")), folder.join(name).join("mod.rs")]
        }
    };
    let is_conditional =
        module.attrs.iter().any(|attribute| attribute.path().is_ident("cfg") || attribute.path().is_ident("cfg_attr"));
    Module { files, has_path: path.is_some(), is_conditional, span: module.ident.span() }
}

/// `x.rs` of `#[path = "x.rs"]`
fn path_of(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| match &attribute.meta {
        Meta::NameValue(value) if value.path.is_ident("path") => match &value.value {
            Expr::Lit(ExprLit { lit: Lit::Str(path), .. }) => Some(path.value()),
            _ => None,
        },
        _ => None,
    })
}
