//! Writes the expansion of a mechanism to a file, for reading the generated code.
//!
//! If the environment variable `REULEAUX_EXPAND` names a folder, `cargo check` writes `<folder>/<Name>.rs` for each mechanism that it
//! compiles. Cargo does not track the variable: it does not recompile a crate that is up to date.

use proc_macro2::TokenStream;
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
    match save(&path, &tokens.to_string()) {
        Ok(()) => quote!(),
        Err(error) => {
            let sentence = format!("the expansion of `{name}` cannot be written to `{}`: {error}", path.display());
            quote!(::core::compile_error! { #sentence })
        }
    }
}

fn path(folder: OsString, name: &str) -> PathBuf {
    Path::new(&folder).join(name.trim_start_matches("r#")).with_extension("rs")
}

fn save(path: &Path, code: &str) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    // Without rustfmt the code is the same, in one long line.
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
    use super::{formatted, path, save};

    #[test]
    fn a_file_is_named_after_the_mechanism() {
        assert_eq!(path("expanded".into(), "FourBar").to_str(), Some("expanded/FourBar.rs"));
        assert_eq!(path("expanded".into(), "r#Box").to_str(), Some("expanded/Box.rs"));
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
