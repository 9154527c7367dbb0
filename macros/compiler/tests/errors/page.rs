//! Code blocks of a Markdown page.

/// A fenced code block.
pub(crate) struct Block<'a> {
    /// Text after the opening fence.
    pub(crate) language: &'a str,
    /// Lines between the fences.
    pub(crate) text: &'a str,
    /// Offset in the page of the end of the closing fence's line.
    end: usize,
}

const FENCE: &str = "```";

/// All blocks of a page, in order.
pub(crate) fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut blocks = Vec::new();
    let mut open: Option<(&str, usize)> = None;
    let mut at = 0;
    for line in page.split_inclusive('\n') {
        let (start, end) = (at, at + line.len());
        at = end;
        let Some(language) = line.strip_prefix(FENCE) else { continue };
        open = match open {
            None => Some((language.trim(), end)),
            Some((language, first)) => {
                blocks.push(Block { language, text: &page[first..start], end });
                None
            }
        };
    }
    blocks
}

impl Block<'_> {
    /// Rust source of the block, with the lines that rustdoc hides.
    pub(crate) fn source(&self) -> String {
        let plain = |line: &str| match line.strip_prefix('#') {
            Some(hidden) if hidden.is_empty() || hidden.starts_with(' ') => hidden.strip_prefix(' ').unwrap_or("").to_owned(),
            _ => line.to_owned(),
        };
        self.text.lines().map(|line| plain(line) + "\n").collect()
    }

    /// The page with a block after this one, which replaces an existing block of the same language there.
    pub(crate) fn followed_by(&self, page: &str, language: &str, text: &str) -> String {
        let (before, after) = page.split_at(self.end);
        let known = blocks(after).into_iter().next().filter(|next| after.starts_with(&format!("\n{FENCE}{language}\n{}", next.text)));
        let after = known.map_or(after, |known| &after[known.end..]);
        format!("{before}\n{FENCE}{language}\n{text}{FENCE}\n\n{}", after.trim_start_matches('\n'))
    }
}
