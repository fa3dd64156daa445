//! Pages as PDF.

use std::collections::BTreeMap;

use grafcet_draw::pages::Page;
use pdf_writer::types::{ActionType, AnnotationType};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use svg2pdf::ConversionOptions;

use super::letters::Letters;
use super::paper::{Block, Sheet};

/// The picture of a page, by this name among what it uses.
const PICTURE: Name<'_> = Name(b"Page");

/// Texts are texts, which can be searched; a click on a connector goes to the page of the other one.
pub(super) fn write(sheet: &Sheet, block: &Block, letters: &mut Letters) -> Result<Vec<u8>, String> {
    let mut next = Ref::new(1);
    let (catalog, tree, info) = (next.bump(), next.bump(), next.bump());
    let pages: Vec<Ref> = sheet.pages.iter().map(|_| next.bump()).collect();
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(tree);
    let count = i32::try_from(pages.len()).map_err(|_| "too many pages".to_owned())?;
    pdf.pages(tree).kids(pages.iter().copied()).count(count);
    pdf.document_info(info).title(TextStr(&block.name)).creator(TextStr("cargo grafcet"));
    let (wide, high) = sheet.size;
    for (number, page) in sheet.pages.iter().enumerate() {
        let picture =
            letters.tree(&sheet.svg(number, block)).map_err(|error| format!("the page cannot be read: {error}"))?;
        let (chunk, root) = svg2pdf::to_chunk(&picture, ConversionOptions::default())
            .map_err(|error| format!("the page cannot be written: {error}"))?;
        let mut numbers = BTreeMap::new();
        let chunk = chunk.renumber(|old| *numbers.entry(old).or_insert_with(|| next.bump()));
        let root = numbers.get(&root).copied().ok_or("the page has no picture")?;
        let content = next.bump();
        let links: Vec<(Rect, usize)> = links(sheet, page).collect();
        let ids: Vec<Ref> = links.iter().map(|_| next.bump()).collect();
        let mut written = pdf.page(pages[number]);
        written.parent(tree).media_box(Rect::new(0.0, 0.0, wide, high)).contents(content);
        written.annotations(ids.iter().copied());
        written.resources().x_objects().pair(PICTURE, root);
        written.finish();
        for (id, (place, to)) in ids.into_iter().zip(links) {
            let mut link = pdf.annotation(id);
            link.subtype(AnnotationType::Link).rect(place).border(0.0, 0.0, 0.0, None);
            link.action().action_type(ActionType::GoTo).destination().page(pages[to - 1]).fit();
        }
        let mut shown = Content::new();
        shown.x_object(PICTURE);
        pdf.stream(content, &shown.finish());
        pdf.extend(&chunk);
    }
    as_large_as_pages(pdf.finish(), pages.len())
}

/// `svg2pdf` makes each picture one point wide and high by its matrix. Some viewers (`PDFium`) find no text in what is drawn so small, so the matrix becomes that
/// of a picture as large as its page, in as many bytes: the places of all objects stay.
fn as_large_as_pages(mut pdf: Vec<u8>, pages: usize) -> Result<Vec<u8>, String> {
    const KEY: &[u8] = b"/Matrix [";
    const SAME: &[u8] = b"1 0 0 1 0 0";
    let starts: Vec<usize> = (0..pdf.len()).filter(|at| pdf[*at..].starts_with(KEY)).map(|at| at + KEY.len()).collect();
    if starts.len() != pages {
        return Err(format!("{} pictures for {pages} pages", starts.len()));
    }
    for start in starts {
        let length = pdf[start..].iter().position(|byte| *byte == b']').filter(|length| *length >= SAME.len());
        let end = start + length.ok_or("a picture without a matrix")?;
        pdf[start..end].fill(b' ');
        pdf[start..start + SAME.len()].copy_from_slice(SAME);
    }
    Ok(pdf)
}

/// Where a click goes to another page: around the circle and the page's number beside it.
fn links(sheet: &Sheet, page: &Page) -> impl Iterator<Item = (Rect, usize)> {
    let ((left, top), scale) = sheet.place(page);
    let connectors = page.connectors.iter().map(|one| (one.at, one.page));
    let targets = connectors.chain(page.references.iter().map(|one| (one.at, one.page)));
    targets.map(move |((x, y), to)| {
        let [x, y] = [x, y].map(|at| f32::from(i16::try_from(at).unwrap_or(i16::MAX)));
        // The middle of the square, after the margin of four pixels; a page is counted from below.
        let (x, y) = (left + (x * 8.0 + 8.0) * scale, sheet.size.1 - top - (y * 16.0 + 12.0) * scale);
        let around = 16.0 * scale;
        (Rect::new(x - around, y - around, x + around, y + around), to)
    })
}
