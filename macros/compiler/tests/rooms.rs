//! The rooms of the compiler stand in one order, and each uses only those below it.
//!
//! Two things are read from the sources: every `crate::room` that a file names, and the `use` items of each file, from which circles of
//! files are found.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Item, UseTree, Visibility};

/// From the bottom up; `compile` enters them from the top.
const ROOMS: [&str; 19] = [
    "expr",
    "quantity",
    "diag",
    "structure",
    "syntax",
    "library",
    "model",
    "system",
    "numeric",
    "connectivity",
    "redundancy",
    "mobility",
    "assembly",
    "travel",
    "plan",
    "picture",
    "emit",
    "expansion",
    "compile",
];

/// Files that use each other in a circle, at most.
const LARGEST_CIRCLE: usize = 9;

#[test]
fn rooms_use_only_rooms_below_them() {
    let mut wrong = Vec::new();
    for (name, text) in sources() {
        let Some(own) = place(room(&name)) else { continue };
        for (start, _) in text.match_indices("crate::") {
            let named: String = text[start + 7..].chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect();
            if place(&named).is_some_and(|other| other > own) && !name.contains("tests") {
                wrong.push(format!("{name} uses {named}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_folder_is_a_room() {
    let names: BTreeSet<String> = sources().iter().map(|(name, _)| room(name).to_owned()).filter(|name| name != "lib").collect();
    assert_eq!(names, ROOMS.iter().map(|room| (*room).to_owned()).collect());
}

#[test]
fn circles_of_files_are_small_and_within_a_room() {
    for circle in circles() {
        let rooms: BTreeSet<&str> = circle.iter().map(|file| room(file)).collect();
        assert!(rooms.len() == 1 && circle.len() <= LARGEST_CIRCLE, "{circle:#?}");
    }
}

fn place(room: &str) -> Option<usize> {
    ROOMS.iter().position(|other| *other == room)
}

/// `model` of `model/names.rs`
fn room(file: &str) -> &str {
    file.split('/').next().unwrap_or(file).trim_end_matches(".rs")
}

/// Path and text of every source file.
fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut open: Vec<PathBuf> = vec![root.clone()];
    let mut found = Vec::new();
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(fs::read_dir(&path).expect("a folder").map(|entry| entry.expect("an entry").path()));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let name = path.strip_prefix(&root).expect("a file in it").to_string_lossy().replace('\\', "/");
            found.push((name, fs::read_to_string(&path).expect("text")));
        }
    }
    found.sort();
    found
}

/// `["model", "names"]` of `model/names.rs`, `["model"]` of `model/mod.rs`
fn module(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    path.split('/').map(str::to_owned).filter(|part| part != "lib").collect()
}

/// The groups of files that use each other.
fn circles() -> Vec<Vec<String>> {
    let tree = Tree::new();
    let uses: Vec<BTreeSet<usize>> = (0..tree.names.len()).map(|file| tree.used(file)).collect();
    let reach: Vec<BTreeSet<usize>> = (0..uses.len()).map(|file| reached(&uses, file)).collect();
    let mut seen = BTreeSet::new();
    let mut circles = Vec::new();
    for file in 0..uses.len() {
        let circle: Vec<usize> = reach[file].iter().copied().filter(|other| reach[*other].contains(&file)).collect();
        if circle.len() > 1 && seen.insert(circle.clone()) {
            circles.push(circle.into_iter().map(|file| tree.names[file].clone()).collect());
        }
    }
    circles
}

fn reached(uses: &[BTreeSet<usize>], file: usize) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut open = vec![file];
    while let Some(next) = open.pop() {
        open.extend(uses[next].iter().filter(|other| found.insert(**other)));
    }
    found
}

/// All files, with what they use.
struct Tree {
    names: Vec<String>,
    modules: BTreeMap<Vec<String>, usize>,
    /// The paths of the `use` items of each file; of those that re-export something, and of the others.
    uses: Vec<[Vec<Vec<String>>; 2]>,
}

impl Tree {
    fn new() -> Tree {
        let sources: Vec<(String, String)> = sources().into_iter().filter(|(name, _)| !name.contains("tests")).collect();
        let modules = sources.iter().enumerate().map(|(index, (name, _))| (module(name), index)).collect();
        let uses = sources.iter().map(|(_, text)| {
            let mut uses = [Vec::new(), Vec::new()];
            for item in syn::parse_file(text).expect("Rust").items {
                if let Item::Use(item) = item {
                    let is_private = matches!(item.vis, Visibility::Inherited);
                    spread(&item.tree, Vec::new(), &mut uses[usize::from(is_private)]);
                }
            }
            uses
        });
        Tree { uses: uses.collect(), modules, names: sources.into_iter().map(|(name, _)| name).collect() }
    }

    /// The files that a file uses.
    fn used(&self, file: usize) -> BTreeSet<usize> {
        self.uses[file][1].iter().filter_map(|path| self.target(file, path)).filter(|other| *other != file).collect()
    }

    /// The file in which a path ends, re-exports gone through.
    fn target(&self, file: usize, path: &[String]) -> Option<usize> {
        let own = module(&self.names[file]);
        let up = path.iter().take_while(|part| *part == "super").count();
        let mut full = match path.first()?.as_str() {
            "crate" => Vec::new(),
            _ => own[..own.len() - up].to_vec(),
        };
        full.extend(path.iter().filter(|part| !["crate", "super", "self"].contains(&part.as_str())).cloned());
        let (length, found) = (1..=full.len()).rev().find_map(|length| Some((length, *self.modules.get(&full[..length])?)))?;
        let exported = |name: &String| self.uses[found][0].iter().find(|path| path.last() == Some(name));
        match full.get(length).and_then(exported) {
            Some(path) if found != file => self.target(found, path),
            _ => Some(found),
        }
    }
}

/// The paths of a tree.
fn spread(tree: &UseTree, before: Vec<String>, paths: &mut Vec<Vec<String>>) {
    match tree {
        UseTree::Path(path) => spread(&path.tree, [before, vec![path.ident.to_string()]].concat(), paths),
        UseTree::Group(group) => group.items.iter().for_each(|tree| spread(tree, before.clone(), paths)),
        UseTree::Name(name) => paths.push([before, vec![name.ident.to_string()]].concat()),
        UseTree::Rename(rename) => paths.push([before, vec![rename.ident.to_string()]].concat()),
        UseTree::Glob(_) => paths.push(before),
    }
}
