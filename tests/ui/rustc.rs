//! The compiler, called as cargo calls it for a package that depends on `reuleaux` and `elsewhere`.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// rustc with the libraries that a case may use.
pub(crate) struct Rustc {
    /// Name and file of each.
    libraries: Vec<(String, PathBuf)>,
    /// Folder of their dependencies.
    dependencies: PathBuf,
    /// Folder for output files.
    folder: PathBuf,
}

impl Rustc {
    /// Asks cargo which libraries this test was linked with. When the whole workspace is tested, cargo has just built them.
    pub(crate) fn of_this_build() -> Self {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["test", "--workspace", "--test", "ui", "--no-run", "--quiet", "--message-format", "json"]);
        let output = cargo.output().expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let messages = String::from_utf8(output.stdout).expect("cargo writes text");
        let messages = messages.lines().map(|line| serde_json::from_str::<Value>(line).expect("cargo writes JSON"));
        let libraries: Vec<(String, PathBuf)> = messages.filter_map(|message| library(&message)).collect();
        assert_eq!(libraries.len(), 2, "{libraries:?}");
        let dependencies = libraries[0].1.parent().expect("a file lies in a folder").to_owned();
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ui");
        std::fs::create_dir_all(&folder).expect("a folder for what is written");
        Self { libraries, dependencies, folder }
    }

    /// Compiles like `cargo check`, and accepted files to a program as well; the error is rustc's output.
    pub(crate) fn compile(&self, case: &Path) -> Result<(), String> {
        said(&self.command(case, "metadata", "rmeta").output().expect("rustc runs"))?;
        said(&self.command(case, "link", std::env::consts::EXE_EXTENSION).output().expect("rustc runs"))
    }

    /// Compiles and runs.
    pub(crate) fn run(&self, case: &Path) -> Result<(), String> {
        self.compile(case)?;
        said(&Command::new(self.written(case, std::env::consts::EXE_EXTENSION)).output().expect("the program starts"))
    }

    fn command(&self, case: &Path, kind: &str, extension: &str) -> Command {
        let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
        rustc.args(["--edition", "2024", "--crate-type", "bin", "--emit", kind, "--color", "never", "--diagnostic-width", "140"]);
        rustc.arg("-o").arg(self.written(case, extension));
        rustc.arg("-L").arg(format!("dependency={}", self.dependencies.display()));
        for (name, file) in &self.libraries {
            rustc.arg("--extern").arg(format!("{name}={}", file.display()));
        }
        rustc.arg(case);
        rustc
    }

    /// A file of one case: no two families have cases in the same folder.
    fn written(&self, case: &Path, extension: &str) -> PathBuf {
        let name = case.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("-");
        self.folder.join(name).with_extension(extension)
    }
}

/// Name and file of a library that a case may use.
fn library(message: &Value) -> Option<(String, PathBuf)> {
    let name = message["target"]["name"].as_str().filter(|name| ["reuleaux", "elsewhere"].contains(name))?;
    let files = message["filenames"].as_array()?.iter().filter_map(Value::as_str);
    let file = files.map(PathBuf::from).find(|file| file.extension().is_some_and(|extension| extension == "rlib"))?;
    Some((name.to_owned(), file))
}

fn said(output: &Output) -> Result<(), String> {
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
}

/// Output without its margins and without rustc's closing lines, which depend on how it is called.
pub(crate) fn plain(output: &str) -> Vec<&str> {
    let closing = ["error: aborting due to", "For more information about this error", "Some errors have detailed explanations"];
    let lines = output.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.filter(|line| !closing.iter().any(|start| line.starts_with(start))).collect()
}
