//! The page of the first chart, followed from command to command in a clean folder.
//!
//! What the reader does stands in the page's blocks: `sh` is typed line by line, `text` after it has to be among what that
//! printed, `diff` is done to a file, any other block is a new file. The name of the file is the last one in backquotes in
//! the paragraph in front of it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Result, capture};
use crate::toolchain::BareMetal;
use crate::{firmware, processor, project};

const PAGE: &str = include_str!("../../docs/first-chart.md");

/// The clone of the repository, as the page calls it.
const CLONE: &str = "../grafcet";

/// What a command has in it that builds for the controller.
const TARGET: &str = "--target ";

/// What a command has after it that has to fail.
const FAILS: &str = "# fails";

/// What cargo says when it builds what takes longest.
const BUILDS_COMPILER: &str = "Compiling grafcet-compiler";

/// Where the reader's crates are built.
const BUILD: &str = "first-chart-build";

/// A block of the page.
#[derive(Debug, PartialEq, Eq)]
struct Block<'p> {
    language: &'p str,
    text: &'p str,
    /// The last words in backquotes before it.
    named: &'p str,
}

/// Follows the page.
///
/// # Errors
/// A command does other than the page says, or the page cannot be followed.
pub(crate) fn run() -> Result {
    // Outside of the project, or cargo would make the crates members of its workspace.
    let folder = std::env::temp_dir().join("grafcet-first-chart");
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    // As on the reader's machine: nothing has been built yet.
    let built = project::target(BUILD);
    if built.exists() {
        fs::remove_dir_all(&built).map_err(|error| format!("{}: {error}", built.display()))?;
    }
    let mut reader = Reader { folder, printed: None, commands: 0, compilers: 0 };
    let blocks = blocks(PAGE)?;
    blocks.iter().try_for_each(|block| reader.follow(block))?;
    if reader.compilers != 1 {
        return Err(format!(
            "the compiler of charts was built {} times for what the page does, not once",
            reader.compilers
        ));
    }
    let made = std::env::temp_dir().join("grafcet-first-chart");
    fs::remove_dir_all(&made).map_err(|error| format!("{}: {error}", made.display()))?;
    println!("first-chart: {} commands did what the page says", reader.commands);
    Ok(())
}

fn blocks(page: &str) -> Result<Vec<Block<'_>>> {
    let parts: Vec<&str> = page.split("\n```").collect();
    if parts.len() % 2 == 0 {
        return Err("a block of the page has no end".to_owned());
    }
    let blocks = parts.chunks_exact(2).map(|pair| {
        let (language, text) = pair[1].split_once('\n').ok_or("a block of the page is empty")?;
        let paragraph = pair[0].trim_end().rsplit("\n\n").next().unwrap_or_default();
        let named = paragraph.rsplit('`').nth(1).unwrap_or_default();
        Ok(Block { language, text, named })
    });
    blocks.collect()
}

/// Somebody who does what the page says.
struct Reader {
    /// Where they stand.
    folder: PathBuf,
    /// What the last block of commands has printed, where nothing has been read after it.
    printed: Option<String>,
    commands: usize,
    /// How often the compiler of charts was built, with the toolchain in use.
    compilers: usize,
}

impl Reader {
    fn follow(&mut self, block: &Block<'_>) -> Result {
        let printed = self.printed.take();
        match (block.language, printed) {
            ("sh", _) => {
                let printed: Result<String> = block.text.lines().map(|line| self.command(line)).collect();
                self.printed = Some(printed?);
                Ok(())
            }
            ("text", Some(printed)) => shows(&printed, block.text),
            ("diff", _) => self.edit(block),
            _ => self.write(block.named, &format!("{}\n", block.text)),
        }
    }

    /// Answers with what the command printed.
    fn command(&mut self, line: &str) -> Result<String> {
        println!("first-chart: {line}");
        self.commands += 1;
        let (typed, fails) = match line.split_once(FAILS) {
            Some((typed, _)) => (typed.trim_end(), true),
            None => (line, false),
        };
        let clone = project::root().display().to_string();
        let words: Vec<String> = typed.split_whitespace().map(|word| word.replace(CLONE, &clone)).collect();
        match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["cd", to] => {
                let to = self.folder.join(to);
                self.folder = fs::canonicalize(&to).map_err(|error| format!("{}: {error}", to.display()))?;
                Ok(String::new())
            }
            // Where rustup has none, another compiler builds for the target.
            ["rustup", "target", "add", target] => BareMetal::find(target).map(|_| String::new()),
            ["cargo", ref rest @ ..] => self.cargo(rest, fails),
            _ => Err(format!("`{line}`: nobody knows here how to do that")),
        }
    }

    fn cargo(&mut self, arguments: &[&str], fails: bool) -> Result<String> {
        let Some((_, target)) = arguments.join(" ").split_once(TARGET).map(|(a, b)| (a.to_owned(), b.to_owned()))
        else {
            if matches!(arguments[..], ["check" | "test" | "run", ..]) {
                self.lock("Cargo.lock")?;
            }
            return self.here(&mut project::cargo(arguments), fails);
        };
        let toolchain = BareMetal::find(&target)?;
        let mut command = toolchain.cargo(arguments[0], &target);
        command.args(arguments[1..].iter().filter(|word| !TARGET.contains(**word) && **word != target));
        if matches!(toolchain, BareMetal::Installed) {
            self.lock("Cargo.lock")?;
            return self.here(&mut command, fails);
        }
        // Another compiler builds everything anew. What the reader's would have to build is what it has to for any other target
        // than the one it takes without being told, be it this very machine.
        let host = capture(Command::new("rustc").arg("-vV"))?;
        let host = host.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc does not say its host")?;
        self.here(project::cargo(&["check", "--target", host]).arg("--manifest-path=../door/Cargo.toml"), false)?;
        self.lock("examples/firmware/Cargo.lock")?;
        self.run(command.env("CARGO_TARGET_DIR", project::target(firmware::FOLDER)), fails)
    }

    /// Runs cargo as the reader does, who has set none of what CI sets.
    fn here(&mut self, command: &mut Command, fails: bool) -> Result<String> {
        for set in ["CARGO_PROFILE_DEV_DEBUG", "CARGO_PROFILE_RELEASE_DEBUG", "CARGO_INCREMENTAL"] {
            command.env_remove(set);
        }
        let text = self.run(command.env("CARGO_TARGET_DIR", project::target(BUILD)), fails)?;
        self.compilers += text.matches(BUILDS_COMPILER).count();
        Ok(text)
    }

    /// Answers with all that it printed.
    fn run(&self, command: &mut Command, fails: bool) -> Result<String> {
        let before = processor::children();
        let output = command.current_dir(&self.folder).output().map_err(|error| format!("cargo: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
        if output.status.success() == fails {
            return Err(format!("cargo: {}\n{text}", output.status));
        }
        if let (Ok(before), Ok(after)) = (before, processor::children()) {
            println!("first-chart: that took {:.1} s of processor time", after - before);
        }
        Ok(text.into_owned())
    }

    /// A crate is built with the versions that the project is tested with; a reader gets the newest ones.
    fn lock(&self, lock: &str) -> Result {
        let to = self.folder.join("Cargo.lock");
        fs::copy(project::root().join(lock), &to).map(drop).map_err(|error| format!("{}: {error}", to.display()))
    }

    fn write(&self, name: &str, text: &str) -> Result {
        println!("first-chart: {name}");
        let file = self.folder.join(name);
        let folder = file.parent().unwrap_or(Path::new(""));
        let written = fs::create_dir_all(folder).and_then(|()| fs::write(&file, text));
        written.map_err(|error| format!("`{name}`: {error}"))
    }

    /// A `diff` replaces the lines with `-` by those with `+`.
    fn edit(&self, block: &Block<'_>) -> Result {
        let file = self.folder.join(block.named);
        let before = fs::read_to_string(&file).map_err(|error| format!("`{}`: {error}", block.named))?;
        let side = |sign| -> String {
            block.text.lines().filter_map(|line| Some(format!("{}\n", line.strip_prefix(sign)?))).collect()
        };
        let (old, new) = (side('-'), side('+'));
        if before.matches(&old).count() != 1 {
            return Err(format!("`{}` does not hold these lines once:\n{old}", block.named));
        }
        self.write(block.named, &before.replace(&old, &new))
    }
}

/// Whether the lines stand in what was printed, one after the other.
fn shows(printed: &str, lines: &str) -> Result {
    let printed: Vec<&str> = printed.lines().map(str::trim_end).collect();
    let lines: Vec<&str> = lines.lines().map(str::trim_end).collect();
    if printed.windows(lines.len()).any(|part| part == lines) {
        return Ok(());
    }
    Err(format!("the page shows\n{}\nbut this was printed:\n{}", lines.join("\n"), printed.join("\n")))
}

#[cfg(test)]
mod tests {
    use super::{Block, PAGE, blocks, shows};

    #[test]
    fn a_block_belongs_to_the_last_name_in_front_of_it() {
        let page = "The `crate` has `src/lib.rs`:\n\n```rust\nfn f() {}\n```\n\n```sh\ncargo test\ncargo run\n```\n";
        let expected = [
            Block { language: "rust", text: "fn f() {}", named: "src/lib.rs" },
            Block { language: "sh", text: "cargo test\ncargo run", named: "" },
        ];
        assert_eq!(blocks(page).as_deref(), Ok(&expected[..]));
    }

    #[test]
    fn a_block_without_end_is_an_error() {
        assert!(blocks("text\n\n```sh\ncargo test\n").is_err());
    }

    #[test]
    fn the_page_has_what_has_to_be_followed() {
        let blocks = blocks(PAGE).expect("blocks");
        let count = |language| blocks.iter().filter(|block| block.language == language).count();
        assert!(count("sh") >= 5 && count("rust") >= 4 && count("text") >= 3 && count("diff") == 2);
    }

    #[test]
    fn lines_have_to_stand_together() {
        assert_eq!(shows("a\nb  \nc\n", "b\nc"), Ok(()));
        assert!(shows("a\nb\nc\n", "a\nc").is_err());
    }
}
