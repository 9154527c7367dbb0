//! Writes the expansion of a mechanism to a file, for reading the generated code.
//!
//! If the environment variable `REULEAUX_EXPAND` names a folder, `cargo check` writes `<folder>/<Name>.rs` for each mechanism that it
//! compiles. Cargo does not track the variable: it does not recompile a crate that is up to date.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::quote;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The environment variable that names the folder.
const VARIABLE: &str = "REULEAUX_EXPAND";

/// Writes the expansion of a mechanism if requested. Returns a `compile_error!` if the file cannot be written.
pub(crate) fn write(name: &str, tokens: &TokenStream) -> TokenStream {
    let Some(folder) = std::env::var_os(VARIABLE).filter(|folder| !folder.is_empty()) else { return quote!() };
    let path = path(folder, name);
    match save(&path, &printed(tokens)) {
        Ok(()) => quote!(),
        Err(error) => {
            let sentence = format!("the expansion of `{name}` cannot be written to `{}`: {error}", path.display());
            quote!(::core::compile_error! { #sentence })
        }
    }
}

/// The tokens as text, with doc attributes as comments and blank lines between items.
fn printed(tokens: &TokenStream) -> String {
    let mut text = String::new();
    print(tokens.clone(), true, &mut text);
    text
}

/// Prints tokens. `of_items`: given, true if the tokens are items, false inside an item.
fn print(tokens: TokenStream, of_items: bool, text: &mut String) {
    let mut tokens = tokens.into_iter().peekable();
    // The keyword of the current item.
    let mut kind: Option<String> = None;
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(punct) => {
                if let ('#', Some(lines)) = (punct.as_char(), tokens.peek().and_then(documentation)) {
                    tokens.next();
                    comment(&lines, of_items || tokens.peek().is_some_and(belongs_to_an_item), text);
                    continue;
                }
                text.push(punct.as_char());
                if punct.spacing() == Spacing::Alone {
                    text.push(' ');
                }
                if punct.as_char() == ';' {
                    kind = None;
                }
            }
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{ ", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                let is_body = group.delimiter() == Delimiter::Brace;
                text.push_str(open);
                print(group.stream(), is_body && matches!(kind.as_deref(), Some("impl" | "mod")), text);
                text.push_str(close);
                let is_end = of_items && is_body && !matches!(tokens.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() != '#');
                text.push_str(if is_end { "\n\n" } else { " " });
                if is_end {
                    kind = None;
                }
            }
            TokenTree::Ident(word) => {
                let word = word.to_string();
                text.push_str(&word);
                text.push(' ');
                if kind.is_none() && ITEMS.contains(&word.as_str()) {
                    kind = Some(word);
                }
            }
            TokenTree::Literal(literal) => {
                text.push_str(&literal.to_string());
                text.push(' ');
            }
        }
    }
}

/// Keywords that begin items.
const ITEMS: [&str; 8] = ["impl", "mod", "fn", "const", "static", "type", "struct", "use"];

/// The lines of `[doc = "…"]`.
fn documentation(attribute: &TokenTree) -> Option<Vec<String>> {
    let TokenTree::Group(group) = attribute else { return None };
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    let [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Literal(text)] = tokens.as_slice() else { return None };
    let text = syn::parse_str::<syn::LitStr>(&text.to_string()).ok().filter(|_| name == "doc")?;
    let text = text.value();
    Some(if text.is_empty() { vec![text] } else { text.lines().map(str::to_owned).collect() })
}

/// True if the token after a comment begins an item or a field, not a statement.
fn belongs_to_an_item(next: &TokenTree) -> bool {
    match next {
        TokenTree::Ident(word) => word == "pub" || ITEMS.contains(&word.to_string().as_str()),
        TokenTree::Punct(punct) => punct.as_char() == '#',
        _ => false,
    }
}

/// Documentation of an item, or a comment above statements.
fn comment(lines: &[String], is_documentation: bool, text: &mut String) {
    text.push_str(if is_documentation { "\n" } else { "\n\n" });
    for line in lines {
        let space = if line.is_empty() || line.starts_with(' ') { "" } else { " " };
        text.push_str(if is_documentation { "///" } else { "//" });
        text.push_str(space);
        text.push_str(line);
        text.push('\n');
    }
}

fn path(folder: OsString, name: &str) -> PathBuf {
    Path::new(&folder).join(name.trim_start_matches("r#")).with_extension("rs")
}

fn save(path: &Path, code: &str) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    // Without rustfmt the code is written unformatted, in one long line.
    let code = formatted(code).unwrap_or_else(|| code.as_bytes().to_vec());
    std::fs::write(path, code)
}

/// Formats the code with rustfmt; `None` if rustfmt is not available.
fn formatted(code: &str) -> Option<Vec<u8>> {
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--emit", "stdout"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    // Dropped at the end of the statement, so that rustfmt sees the end of its input.
    rustfmt.stdin.take()?.write_all(code.as_bytes()).ok()?;
    let output = rustfmt.wait_with_output().ok()?;
    output.status.success().then_some(output.stdout)
}

#[cfg(test)]
mod tests {
    use super::{formatted, path, printed, save};

    #[test]
    fn a_file_is_named_after_the_mechanism() {
        assert_eq!(path("expanded".into(), "FourBar").to_str(), Some("expanded/FourBar.rs"));
        assert_eq!(path("expanded".into(), "r#Box").to_str(), Some("expanded/Box.rs"));
    }

    #[test]
    fn documentation_is_written_as_comments() {
        let tokens = quote::quote! {
            impl Wheel {
                /// Turns.
                fn turn(&self) -> f64 { #[doc = " hub (revolute): wheel.x"] let x = -0.5; x }
                fn stop(&self) {}
            }
            #[doc = "\n| a |\n"]
            struct Wheel;
        };
        let lines: Vec<String> = printed(&tokens).lines().map(|line| line.trim().to_owned()).collect();
        for line in ["/// Turns.", "// hub (revolute): wheel.x", "/// | a |"] {
            assert!(lines.iter().any(|found| found == line), "`{line}` is in {lines:?}");
        }
        assert!(syn::parse_str::<proc_macro2::TokenStream>(&lines.join("\n")).is_ok());
    }

    #[test]
    fn what_is_written_is_rust_on_many_lines() {
        let folder = std::env::temp_dir().join(format!("reuleaux-expansion-{}", std::process::id()));
        let file = folder.join("FourBar.rs");
        save(&file, "pub struct FourBar < T = f64 > { pub speed : T , }").expect("a file in a temporary folder");
        let code = std::fs::read_to_string(&file).expect("the file");
        std::fs::remove_dir_all(&folder).expect("our own folder");
        let is_formatted = formatted("").is_some();
        assert_eq!(code.lines().count(), if is_formatted { 3 } else { 1 });
    }
}
