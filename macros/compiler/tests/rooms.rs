//! The rooms of the compiler are ordered, and each uses only those below it.
//!
//! Two properties are read from the sources: every `crate::room` that a file names, and the `use` items of each file, in which cycles of
//! files are found.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::spanned::Spanned as _;
use syn::visit::{self, Visit};
use syn::{Item, UseTree, Visibility};

/// From the bottom up; `compile` enters them from the top.
const ROOMS: [&str; 31] = [
    "linear",
    "expr",
    "geometry",
    "quantity",
    "words",
    "diag",
    "structure",
    "syntax",
    "library",
    "model",
    "names",
    "hints",
    "profile",
    "resolve",
    "system",
    "numeric",
    "connectivity",
    "redundancy",
    "mobility",
    "assembly",
    "travel",
    "dynamics",
    "plan",
    "picture",
    "docs",
    "export",
    "import",
    "emit",
    "stub",
    "expansion",
    "compile",
];

/// Largest number of files in a cycle.
const LARGEST_CIRCLE: usize = 4;

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

/// Types with equal names could only be distinguished by their rooms.
#[test]
fn no_two_types_share_a_name() {
    let mut places: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (name, counted) in counted() {
        for declared in counted.types {
            places.entry(declared).or_default().insert(name.clone());
        }
    }
    places.retain(|_, files| files.len() > 1);
    assert!(places.is_empty(), "{places:#?}");
}

/// Largest number of lines of a function. Tables of sentences are excluded: each line there stands by itself.
const LONGEST_FUNCTION: usize = 70;

#[test]
fn functions_are_short() {
    let long: Vec<(String, usize)> = counted()
        .into_iter()
        .filter(|(name, _)| !name.starts_with("diag/message"))
        .flat_map(|(_, counted)| counted.functions)
        .filter(|(_, lines)| *lines > LONGEST_FUNCTION)
        .collect();
    assert!(long.is_empty(), "{long:?}");
}

/// Largest number of lines of a room.
const LARGEST_ROOM: usize = 5000;

/// `cargo test -p reuleaux-compiler --test rooms -- --nocapture` shows the table.
#[test]
fn rooms_are_small() {
    let mut rooms: BTreeMap<String, (usize, usize, (usize, String))> = BTreeMap::new();
    for ((name, text), (_, counted)) in sources().into_iter().zip(counted()) {
        let room = rooms.entry(room(&name).to_owned()).or_default();
        room.0 += 1;
        room.1 += text.lines().count();
        if let Some((function, lines)) = counted.functions.into_iter().max_by_key(|(_, lines)| *lines) {
            room.2 = room.2.clone().max((lines, format!("{function} in {name}")));
        }
    }
    println!("| room | files | lines | longest function |\n| --- | ---: | ---: | --- |");
    for (room, (files, lines, (longest, function))) in &rooms {
        println!("| {room} | {files} | {lines} | {longest}: {function} |");
    }
    assert!(rooms.iter().all(|(_, (_, lines, _))| *lines <= LARGEST_ROOM), "a room is too large");
    let circles = circles();
    println!("lines in all: {}", rooms.values().map(|(_, lines, _)| lines).sum::<usize>());
    println!("circles of files: {}, the largest of {}", circles.len(), circles.iter().map(Vec::len).max().unwrap_or(0));
}

/// Types and functions of a file, tests excluded.
#[derive(Default)]
struct Counted {
    types: Vec<String>,
    /// Functions with their numbers of lines.
    functions: Vec<(String, usize)>,
}

impl<'a> Visit<'a> for Counted {
    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        self.types.push(item.ident.to_string());
    }

    fn visit_item_enum(&mut self, item: &'a syn::ItemEnum) {
        self.types.push(item.ident.to_string());
    }

    fn visit_item_trait(&mut self, item: &'a syn::ItemTrait) {
        self.types.push(item.ident.to_string());
        visit::visit_item_trait(self, item);
    }

    fn visit_item_fn(&mut self, item: &'a syn::ItemFn) {
        self.functions.push((item.sig.ident.to_string(), lines(&item.block)));
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'a syn::ImplItemFn) {
        self.functions.push((item.sig.ident.to_string(), lines(&item.block)));
    }
}

fn lines(block: &syn::Block) -> usize {
    let span = block.span();
    span.end().line - span.start().line + 1
}

fn counted() -> Vec<(String, Counted)> {
    let count = |(name, text): (String, String)| {
        let mut counted = Counted::default();
        if !name.contains("tests") {
            counted.visit_file(&syn::parse_file(&text).expect("Rust"));
        }
        (name, counted)
    };
    sources().into_iter().map(count).collect()
}

fn place(room: &str) -> Option<usize> {
    ROOMS.iter().position(|other| *other == room)
}

/// The room of a file: `model` for `model/names.rs`.
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

/// The module of a file: `["model", "names"]` for `model/names.rs`, `["model"]` for `model/mod.rs`.
fn module(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    path.split('/').map(str::to_owned).filter(|part| part != "lib").collect()
}

/// Cycles: groups of files that use each other.
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

/// All files with the paths they use.
struct Tree {
    names: Vec<String>,
    modules: BTreeMap<Vec<String>, usize>,
    /// Paths of the `use` items of each file: re-exports, and others.
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

    /// Files that a file uses.
    fn used(&self, file: usize) -> BTreeSet<usize> {
        self.uses[file][1].iter().filter_map(|path| self.target(file, path)).filter(|other| *other != file).collect()
    }

    /// The file that a path leads to, through re-exports.
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

/// Collects the paths of a `use` tree.
fn spread(tree: &UseTree, before: Vec<String>, paths: &mut Vec<Vec<String>>) {
    match tree {
        UseTree::Path(path) => spread(&path.tree, [before, vec![path.ident.to_string()]].concat(), paths),
        UseTree::Group(group) => group.items.iter().for_each(|tree| spread(tree, before.clone(), paths)),
        UseTree::Name(name) => paths.push([before, vec![name.ident.to_string()]].concat()),
        UseTree::Rename(rename) => paths.push([before, vec![rename.ident.to_string()]].concat()),
        UseTree::Glob(_) => paths.push(before),
    }
}
