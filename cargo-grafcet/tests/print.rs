//! What `draw` writes as PDF and PNG.
#![cfg(feature = "print")]

mod common;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use common::{MANIFEST, folder, tool};
use pdf_extract::{Document, MediaBox, Object, OutputDev, OutputError, Transform, output_doc};

const LAMP: &str = "grafcet! { sfc Lamp { input on: bool; output lit: bool; initial step Off; step Lit { lit; } Off -[on]-> Lit -[!on]-> Off; } }";

/// A sequence of forty steps.
fn long() -> String {
    let mut text = "grafcet! { grafcet Long { input go: bool; output lit: bool; initial step Step0;\n".to_owned();
    for step in 1..40 {
        _ = writeln!(text, "step Step{step} {{ lit; }}");
    }
    for step in 0..40 {
        let is = if step % 2 == 0 { "go" } else { "!go" };
        _ = writeln!(text, "Step{step} -[{is}]-> Step{};", (step + 1) % 40);
    }
    text + "} }"
}

/// Letter by letter, from where each stands: what goes on in one line without a gap is a word.
#[derive(Default)]
struct Words {
    pages: Vec<Vec<String>>,
    /// Where the last letter stands, if a word goes on after it.
    last: Option<(f64, f64)>,
}

impl OutputDev for Words {
    fn begin_page(&mut self, _: u32, _: &MediaBox, _: Option<(f64, f64, f64, f64)>) -> Result<(), OutputError> {
        self.pages.push(Vec::new());
        self.last = None;
        Ok(())
    }

    fn output_character(
        &mut self,
        place: &Transform,
        _: f64,
        _: f64,
        size: f64,
        letter: &str,
    ) -> Result<(), OutputError> {
        let (x, y) = (place.m31, place.m32);
        let size = size * place.m11.abs();
        // A letter is six tenths of its size wide, or as much as is needed to fill its squares.
        let goes_on =
            self.last.is_some_and(|(left, row)| (row - y).abs() < 0.1 && (0.0..size * 0.9).contains(&(x - left)));
        let words = self.pages.last_mut().expect("a page");
        match words.last_mut() {
            Some(word) if goes_on => word.push_str(letter),
            _ => words.push(letter.to_owned()),
        }
        self.last = Some((x, y));
        Ok(())
    }

    fn end_page(&mut self) -> Result<(), OutputError> {
        Ok(())
    }

    fn begin_word(&mut self) -> Result<(), OutputError> {
        Ok(())
    }

    fn end_word(&mut self) -> Result<(), OutputError> {
        Ok(())
    }

    fn end_line(&mut self) -> Result<(), OutputError> {
        Ok(())
    }
}

/// The words of each page, and its width and height in points.
fn pages(file: &Path) -> Vec<(Vec<String>, (f32, f32))> {
    let document = Document::load(file).expect("a PDF");
    let mut words = Words::default();
    output_doc(&document, &mut words).expect("texts");
    let sizes = document.get_pages().into_values().map(|page| {
        let page = document.get_dictionary(page).expect("a page");
        let sides = page.get(b"MediaBox").and_then(Object::as_array).expect("a size");
        let sides: Vec<f32> = sides.iter().map(|side| side.as_float().expect("a length")).collect();
        assert_eq!((sides[0], sides[1]), (0.0, 0.0));
        (sides[2].round(), sides[3].round())
    });
    // A blank is a letter of its text.
    let split = |text: &String| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let words = words.pages.iter().map(|texts| texts.iter().flat_map(split).collect());
    words.zip(sizes).collect()
}

fn count(words: &[String], word: &str) -> usize {
    words.iter().filter(|one| *one == word).count()
}

#[test]
fn a_small_chart_is_one_page_with_a_title_block() {
    let folder = folder(&[
        ("Cargo.toml", "[package]\nname = \"plant\"\nversion = \"4.7.1\"\nedition = \"2024\"\n[workspace]\n"),
        ("src/main.rs", LAMP),
    ]);
    let draw = |arguments: &[&str]| tool(folder.path(), &[&["draw", "-o", "lamp.pdf"], arguments].concat());
    let done = draw(&["--date", "2026-02-03"]);
    assert_eq!((done.code, done.out.as_str(), done.err.as_str()), (Some(0), "", ""));
    let all = pages(&folder.path().join("lamp.pdf"));
    let [(words, size)] = &all[..] else { panic!("{all:?}") };
    // 210 mm and 297 mm are 595.3 and 841.9 points.
    assert_eq!(*size, (595.0, 842.0));
    let text = words.join(" ");
    for said in [
        "Lamp",
        "Version 4.7.1",
        "Date 2026-02-03",
        "Page 1 of 1",
        "SFC (IEC 61131-3) · src/main.rs",
        "Off",
        "Lit",
        "!on",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
    // A picture as large as the page: PDFium, and so Chrome, finds no text in one that is made larger.
    let document = Document::load(folder.path().join("lamp.pdf")).expect("a PDF");
    let streams = document.objects.values().filter_map(|object| object.as_stream().ok());
    let matrices = streams.filter_map(|stream| stream.dict.get(b"Matrix").and_then(Object::as_array).ok());
    let matrices: Vec<Vec<f32>> =
        matrices.map(|matrix| matrix.iter().filter_map(|number| number.as_float().ok()).collect()).collect();
    assert_eq!(matrices, [[1.0, 0.0, 0.0, 1.0, 0.0, 0.0]]);
    // Who says otherwise is heard.
    assert_eq!(draw(&["--paper", "letter", "--landscape", "--revision", "B7"]).code, Some(0));
    let all = pages(&folder.path().join("lamp.pdf"));
    assert_eq!(all[0].1, (792.0, 612.0));
    assert_eq!((count(&all[0].0, "B7"), count(&all[0].0, "4.7.1")), (1, 0));
}

#[test]
fn sizes_of_paper() {
    let folder = folder(&[("lamp.rs", LAMP)]);
    // ISO 216 in millimetres, the others in inches; a point is a 72nd of an inch.
    for (paper, size) in [
        ("a5", (420.0, 595.0)),
        ("a4", (595.0, 842.0)),
        ("a3", (842.0, 1191.0)),
        ("a2", (1191.0, 1684.0)),
        ("a1", (1684.0, 2384.0)),
        ("a0", (2384.0, 3370.0)),
        ("letter", (612.0, 792.0)),
        ("legal", (612.0, 1008.0)),
        ("tabloid", (792.0, 1224.0)),
    ] {
        let done = tool(folder.path(), &["draw", "lamp.rs", "-o", "lamp.pdf", "--paper", paper, "--portrait"]);
        assert_eq!(done.code, Some(0), "{done:?}");
        assert_eq!(pages(&folder.path().join("lamp.pdf"))[0].1, size, "{paper}");
    }
}

#[test]
fn a_long_chart_goes_on_at_connectors() {
    let folder = folder(&[("long.rs", &long())]);
    let done =
        tool(folder.path(), &["draw", "long.rs", "-o", "long.pdf", "--paper", "a5", "--portrait", "--revision", "1"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let all = pages(&folder.path().join("long.pdf"));
    assert!(all.len() > 1, "{all:?}");
    for (number, (words, size)) in (1..).zip(&all) {
        assert_eq!(*size, (420.0, 595.0));
        let text = words.join(" ");
        assert!(text.contains(&format!("{number} of {}", all.len())), "{text}");
    }
    let on = |word: &str| all.iter().filter(|(words, _)| count(words, word) > 0).count();
    for step in 0..40 {
        assert_eq!(on(&format!("Step{step}")), 1, "Step{step}");
    }
    // Whoever leaves the first page is told where to.
    assert!(count(&all[0].0, "p2") > 0 && count(&all[1].0, "p1") > 0, "{all:?}");
    // And a click goes there.
    let document = Document::load(folder.path().join("long.pdf")).expect("a PDF");
    let ids: Vec<_> = document.get_pages().into_values().collect();
    let mut links = Vec::new();
    for (here, id) in ids.iter().enumerate() {
        for link in document.get_page_annotations(*id).expect("links") {
            let action = link.get(b"A").and_then(Object::as_dict).expect("an action");
            let to = action.get(b"D").and_then(Object::as_array).expect("a page")[0].as_reference().expect("a page");
            links.push((here, ids.iter().position(|page| *page == to).expect("a page of this file")));
        }
    }
    // From each page to another one as often as back.
    assert!(links.contains(&(0, 1)), "{links:?}");
    let mut back: Vec<(usize, usize)> = links.iter().map(|(here, there)| (*there, *here)).collect();
    links.sort_unstable();
    back.sort_unstable();
    assert_eq!(links, back);
}

#[test]
fn pixels_are_as_many_as_asked_for() {
    let folder = folder(&[MANIFEST, ("lamp.rs", LAMP)]);
    let draw = |file: &str, dpi: &str| tool(folder.path(), &["draw", "lamp.rs", "-o", file, "--dpi", dpi]);
    let size = |file: &str| {
        let bytes = fs::read(folder.path().join(file)).expect("a file");
        assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
        // The first chunk has width and height.
        let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
        (side(16), side(20))
    };
    assert_eq!(tool(folder.path(), &["draw", "lamp.rs", "-o", "lamp.svg"]).code, Some(0));
    let svg = fs::read_to_string(folder.path().join("lamp.svg")).expect("a picture");
    let of_svg = |name: &str| -> u32 {
        let (_, rest) = svg.split_once(&format!(" {name}=\"")).expect("a size");
        rest.split('"').next().and_then(|size| size.parse().ok()).expect("a number")
    };
    let (wide, high) = (of_svg("width"), of_svg("height"));
    for (dpi, times) in [("96", 1), ("288", 3)] {
        assert_eq!(draw("lamp.png", dpi).code, Some(0));
        assert_eq!(size("lamp.png"), (wide * times, high * times));
    }
    // Fewer than 24 dots an inch are no picture.
    assert_eq!(tool(folder.path(), &["draw", "lamp.rs", "-o", "lamp.png", "--dpi", "12"]).code, Some(2));
}

#[test]
fn signs_that_the_letters_do_not_have_are_said() {
    let text = LAMP.replace("Lit", "灯");
    let folder = folder(&[("lamp.rs", &text)]);
    for file in ["lamp.png", "lamp.pdf"] {
        let done = tool(folder.path(), &["draw", "lamp.rs", "-o", file]);
        assert_eq!(done.code, Some(0));
        assert_eq!(done.err, "note: Lamp: the letters of prints have no sign for `灯`: a box stands for each\n");
    }
    // Letters of Europe and the arrows of the drawing are there.
    fs::write(folder.path().join("lamp.rs"), LAMP.replace("Lit", "Größe_Ωж")).expect("a file");
    assert_eq!(tool(folder.path(), &["draw", "lamp.rs", "-o", "lamp.pdf"]).err, "");
    assert_eq!(count(&pages(&folder.path().join("lamp.pdf"))[0].0, "Größe_Ωж"), 1);
}

#[test]
fn all_charts_to_a_folder() {
    let folder = folder(&[("lamp.rs", LAMP), ("long.rs", &long())]);
    let done = tool(folder.path(), &["draw", "lamp.rs", "long.rs", "--out", "print", "--format", "pdf"]);
    assert_eq!((done.code, done.out.as_str()), (Some(0), "print/Lamp.pdf\nprint/Long.pdf\n"));
    assert_eq!(pages(&folder.path().join("print/Lamp.pdf")).len(), 1);
}
