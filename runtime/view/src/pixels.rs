//! Frames as PNG, rendered by resvg.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::unviewable::Unviewable;

/// Most pixels of a picture; each takes four bytes of memory.
const MOST: u64 = 1 << 28;

/// Renderer with the fonts of this machine.
pub(crate) struct Painter {
    options: Options<'static>,
}

impl Painter {
    pub(crate) fn new() -> Result<Painter, Unviewable> {
        let mut fonts = fontdb::Database::new();
        fonts.load_system_fonts();
        let names = ["Fira Sans", "DejaVu Sans", "Arial", "Liberation Sans"];
        let is_known =
            |name: &&str| fonts.query(&fontdb::Query { families: &[fontdb::Family::Name(name)], ..Default::default() }).is_some();
        let known = names.into_iter().find(is_known).map(str::to_owned);
        let any = || fonts.faces().next().and_then(|face| Some(face.families.first()?.0.clone()));
        let family = known.or_else(any).ok_or(Unviewable::NoFont)?;
        fonts.set_sans_serif_family(family);
        Ok(Painter { options: Options { fontdb: Arc::new(fonts), ..Options::default() } })
    }

    /// A picture of the given width in pixels.
    pub(crate) fn png(&self, svg: &str, width: u32) -> Result<Vec<u8>, Unviewable> {
        let tree = Tree::from_str(svg, &self.options).map_err(|reason| Unviewable::Pixels(reason.to_string()))?;
        let scale = width as f32 / tree.size().width();
        let height = (tree.size().height() * scale).ceil() as u32;
        let is_small = u64::from(width) * u64::from(height) <= MOST;
        let pixels = if is_small { Pixmap::new(width, height) } else { None };
        let mut pixels = pixels.ok_or_else(|| Unviewable::Pixels(format!("{width} × {height}")))?;
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
        pixels.encode_png().map_err(|reason| Unviewable::Pixels(reason.to_string()))
    }
}
