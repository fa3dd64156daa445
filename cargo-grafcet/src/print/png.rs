//! A picture as PNG.

use resvg::tiny_skia::{Color, Pixmap, Transform};

use super::letters::Letters;

/// At 96 dots an inch a pixel of SVG is one dot.
const DOTS: f32 = 96.0;
/// What is larger to one side no viewer shows.
const MOST: u32 = 32_767;

/// `dots` an inch, dark on white.
pub(super) fn write(svg: &str, dots: u16, letters: &mut Letters) -> Result<Vec<u8>, String> {
    let tree = letters.tree(svg).map_err(|error| format!("the picture cannot be read: {error}"))?;
    let scale = f32::from(dots) / DOTS;
    let size = tree.size().to_int_size().scale_by(scale);
    let fits = size.filter(|size| size.width().max(size.height()) <= MOST);
    let mut pixels = fits.and_then(|size| Pixmap::new(size.width(), size.height())).ok_or_else(|| {
        let (wide, high) = (tree.size().width() * scale, tree.size().height() * scale);
        format!(
            "a picture of {wide:.0} to {high:.0} dots is too large: choose fewer with --dpi, or pages with -o FILE.pdf"
        )
    })?;
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| format!("the picture cannot be written: {error}"))
}
