//! Records anew what the tests compare with: expansions, pictures and messages. Read the difference before you commit it.

use crate::command::{Result, run as run_command};
use crate::project::cargo;

/// Records the expansions and programs of `tests/golden`, the pictures of `tests/pictures` and `docs/pictures`, what the commands of
/// `docs/tool.md` show, the suites of `tests/suites`, what is made of the files of `tests/imported`, and the messages of `tests/ui` and `tests/record/tests/refused`.
///
/// # Errors
/// A chart does not do what it should: a neighbour does not compile, or a chart with a mistake does.
pub(crate) fn run() -> Result {
    run_command(
        cargo(&["test", "--package", "grafcet", "--test", "golden", "--test", "shapes", "--test", "pictures"])
            .env("BLESS", "1"),
    )?;
    run_command(
        cargo(&["test", "--package", "grafcet-conformance", "--test", "programs", "--test", "printed"])
            .env("BLESS", "1"),
    )?;
    run_command(cargo(&["test", "--package", "grafcet-exchange", "--test", "imported"]).env("BLESS", "1"))?;
    // The page shows it.
    run_command(cargo(&["test", "--package", "grafcet-record", "--test", "layout"]).env("BLESS", "1"))?;
    run_command(cargo(&["test", "--package", "cargo-grafcet", "--test", "page", "--test", "suite"]).env("BLESS", "1"))?;
    run_command(cargo(&["test", "--package", "grafcet", "--test", "ui"]).env("TRYBUILD", "overwrite"))?;
    run_command(cargo(&["test", "--package", "grafcet-record", "--test", "own_types"]).env("TRYBUILD", "overwrite"))
}
