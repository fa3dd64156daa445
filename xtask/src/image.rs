//! What the linker keeps for one function.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use object::{Object, ObjectSection, ObjectSymbol};

use crate::command::{Result, capture, run, tool};
use crate::toolchain;

/// Names that only ways to a panic lead to.
const PANICS: [&str; 5] = ["panic", "begin_unwind", "unwrap_failed", "expect_failed", "slice_index"];

/// Links one root of a library with all it needs and nothing else.
pub(crate) struct Linker {
    program: PathBuf,
    library: PathBuf,
    /// gcc's helpers, which code of its own may call.
    libgcc: Option<String>,
}

impl Linker {
    /// For a library in Rust alone.
    ///
    /// # Errors
    /// There is no linker; the message says what to install.
    pub(crate) fn new(library: PathBuf) -> Result<Self> {
        Ok(Self { program: toolchain::linker()?, library, libgcc: None })
    }

    /// For a library of this target, parts of which gcc has compiled.
    ///
    /// # Errors
    /// As [`Self::new`], and where gcc is missing.
    pub(crate) fn with_c(library: PathBuf, target: &str) -> Result<Self> {
        let cpu = if target.starts_with("thumbv6m") { "-mcpu=cortex-m0" } else { "-mcpu=cortex-m3" };
        let gcc = tool("arm-none-eabi-gcc", "gcc-arm-none-eabi")?;
        let path = capture(Command::new(gcc).args(["-mthumb", cpu, "-print-libgcc-file-name"]))?;
        Ok(Self { libgcc: Some(path.trim_end().to_owned()), ..Self::new(library)? })
    }

    /// The image that a root makes, a symbol of the library.
    ///
    /// # Errors
    /// The library lacks the root or what it needs.
    pub(crate) fn link(&self, root: &str) -> Result<Image> {
        let path = self.library.with_file_name(format!("{root}.elf"));
        let mut command = Command::new(&self.program);
        command.args(["-flavor", "gnu", "--gc-sections", "--entry", root, "--undefined", root, "-o"]).arg(&path);
        run(command.arg(&self.library).args(&self.libgcc))?;
        let bytes = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let image = Image { bytes };
        // An entry that is not there is but a warning to the linker.
        if image.elf()?.symbol_by_name(root).is_none() {
            return Err(format!("{} has no {root}", self.library.display()));
        }
        Ok(image)
    }
}

/// A linked image.
pub(crate) struct Image {
    bytes: Vec<u8>,
}

impl Image {
    fn elf(&self) -> Result<object::File<'_>> {
        object::File::parse(&self.bytes[..]).map_err(|error| format!("what the linker wrote is no image: {error}"))
    }

    /// Code and constants, in bytes.
    ///
    /// # Errors
    /// It is no image.
    pub(crate) fn flash(&self) -> Result<u32> {
        let elf = self.elf()?;
        let kept = |name: &str| [".text", ".rodata"].iter().any(|kept| name.starts_with(kept));
        let bytes: u64 = elf.sections().filter(|section| section.name().is_ok_and(kept)).map(|s| s.size()).sum();
        u32::try_from(bytes).map_err(|error| format!("{bytes} bytes: {error}"))
    }

    /// Code and constants, byte by byte.
    ///
    /// # Errors
    /// It is no image.
    pub(crate) fn code(&self) -> Result<Vec<u8>> {
        let elf = self.elf()?;
        let kept = |name: &str| [".text", ".rodata"].iter().any(|kept| name.starts_with(kept));
        let sections = elf.sections().filter(|section| section.name().is_ok_and(kept));
        Ok(sections.filter_map(|section| section.data().ok()).flatten().copied().collect())
    }

    /// The first symbol of the panic machinery.
    ///
    /// # Errors
    /// It is no image.
    pub(crate) fn panics(&self) -> Result<Option<String>> {
        let elf = self.elf()?;
        let mut names = elf.symbols().filter_map(|symbol| symbol.name().ok());
        Ok(names.find(|name| PANICS.iter().any(|part| name.contains(part))).map(str::to_owned))
    }

    /// Whether these bytes stand in the code, the constants or the data.
    ///
    /// # Errors
    /// It is no image.
    pub(crate) fn holds(&self, text: &[u8]) -> Result<bool> {
        let elf = self.elf()?;
        let sections = [".text", ".rodata", ".data"];
        let mut loaded =
            elf.sections().filter(|s| s.name().is_ok_and(|name| sections.iter().any(|l| name.starts_with(l))));
        Ok(loaded.any(|section| section.data().is_ok_and(|data| data.windows(text.len()).any(|part| part == text))))
    }
}
