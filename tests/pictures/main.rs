//! Pictures of mechanisms: well-formed, complete, reproducible, and without overlapping labels.
//!
//! After an intended change, `REULEAUX_GOLDEN=write cargo test --test pictures` redraws the picture of the README. If `REULEAUX_PICTURES`
//! names a folder, all pictures are written there for inspection.

mod run_time;
mod textbook;

use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use reuleaux_compiler::{Compiled, compile};
use reuleaux_tests::common::all::{Visitor, visit};
use reuleaux_tests::common::declared::Declared;

/// A declaration with its name.
type Declaration = (String, TokenStream);

/// The text between the braces of every `mechanism!` in some Rust code.
fn declarations(name: &str, rust: &str) -> Vec<Declaration> {
    fn search(tokens: TokenStream, name: &str, found: &mut Vec<Declaration>) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        for window in trees.windows(3) {
            if let [TokenTree::Ident(word), TokenTree::Punct(_), TokenTree::Group(group)] = window
                && word == "mechanism"
            {
                found.push((format!("{name}_{}", found.len()), group.stream()));
            }
        }
        for tree in trees {
            if let TokenTree::Group(group) = tree {
                search(group.stream(), name, found);
            }
        }
    }
    let mut found = Vec::new();
    search(rust.parse().expect("Rust consists of tokens"), name, &mut found);
    // Only rustc can resolve imported constraints and macro variables.
    found.retain(|(_, tokens)| !["use crate", "$"].iter().any(|from_outside| tokens.to_string().contains(from_outside)));
    found
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests are a folder of the workspace")
}

fn readme() -> Vec<Declaration> {
    let text = fs::read_to_string(root().join("README.md")).expect("the README is there");
    let blocks: Vec<&str> = text.split("\n```rust\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    declarations("readme", &blocks.join("\n"))
}

fn examples() -> Vec<Declaration> {
    let files = fs::read_dir(root().join("examples")).expect("the folder is there").map(|entry| entry.expect("an entry").path());
    let mut files: Vec<_> = files.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect();
    files.sort();
    let of = |path: &std::path::PathBuf| {
        let stem = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        declarations(&stem, &fs::read_to_string(path).expect("an example"))
    };
    files.iter().flat_map(of).collect()
}

fn textbook() -> Vec<Declaration> {
    textbook::MECHANISMS.iter().map(|(name, text)| ((*name).to_owned(), text.parse().expect("tokens"))).collect()
}

/// The declarations of the other tests.
fn reference() -> Vec<Declaration> {
    #[derive(Default)]
    struct Gather(Vec<Declaration>);
    impl Visitor for Gather {
        fn visit<D: Declared>(&mut self, name: &'static str) {
            self.0.push((name.replace("::", "_"), D::TEXT.parse().expect("tokens")));
        }
    }
    let mut gather = Gather::default();
    visit(&mut gather);
    gather.0
}

fn compiled((name, tokens): &Declaration) -> Compiled {
    compile(tokens.clone()).unwrap_or_else(|refusals| {
        let sentences: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
        panic!("{name}: {}", sentences.join("\n"))
    })
}

/// Mechanisms in space.
fn space() -> Vec<Declaration> {
    declarations("space", &fs::read_to_string(root().join("tests/space/mechanisms.rs")).expect("the mechanisms are there"))
}

/// Properties of every picture.
fn is_sound(name: &str, compiled: &Compiled, svg: &str) {
    let tree = roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{name}: {error}\n{svg}"));
    assert!(svg.lines().all(|line| !line.trim().is_empty()), "{name}: a blank line ends HTML in Markdown");
    for wrong in ["NaN", "inf", "e-", "e+", "-0 "] {
        let numbers = tree.descendants().flat_map(|node| node.attributes().collect::<Vec<_>>());
        let numbers = numbers.filter(|attribute| ["d", "x", "y", "cx", "cy", "r", "viewBox"].contains(&attribute.name()));
        assert!(!numbers.map(|attribute| attribute.value()).any(|value| value.contains(wrong)), "{name}: {wrong} in\n{svg}");
    }
    let texts: Vec<&str> = tree.descendants().filter(|node| node.is_element()).filter_map(|node| node.text()).collect();
    let words: Vec<&str> = texts.iter().flat_map(|text| text.split(|c: char| !(c.is_alphanumeric() || "_[].".contains(c)))).collect();
    let bodies = compiled.model.bodies.iter().map(|body| body.name.to_string());
    let joints = compiled.model.joints.iter().map(|joint| joint.name.to_string());
    for item in bodies.chain(joints) {
        assert!(words.contains(&item.as_str()), "{name}: `{item}` is not in the picture\n{svg}");
    }
    let labels = compiled.picture.drawn().map_or(&[][..], |picture| picture.labels());
    for (index, one) in labels.iter().enumerate() {
        for two in &labels[..index] {
            let is_apart = (0..2).any(|axis| one.high[axis] <= two.low[axis] || two.high[axis] <= one.low[axis]);
            assert!(is_apart, "{name}: `{}` lies on `{}`", one.text, two.text);
        }
    }
    if let Some(folder) = std::env::var_os("REULEAUX_PICTURES") {
        fs::write(Path::new(&folder).join(name).with_extension("svg"), svg).expect("the folder can be written");
    }
}

#[test]
fn every_mechanism_that_is_assembled_has_a_sound_picture() {
    for declaration in [readme(), examples(), textbook(), reference(), space()].concat() {
        let compiled = compiled(&declaration);
        match compiled.picture.svg() {
            Some(svg) => is_sound(&declaration.0, &compiled, svg),
            None => assert!(compiled.picture.words().starts_with("There is no picture: "), "{}", declaration.0),
        }
    }
}

#[test]
fn what_a_textbook_draws_is_drawn_with_all_names() {
    for declaration in [readme(), examples(), textbook(), space()].concat() {
        let compiled = compiled(&declaration);
        let svg = compiled.picture.svg().unwrap_or_else(|| panic!("{}: {}", declaration.0, compiled.picture.words()));
        let is_large = compiled.model.bodies.len() > 12;
        assert!(svg.len() < if is_large { 20_000 } else { 12_000 }, "{} has {} bytes", declaration.0, svg.len());
        let tree = roxmltree::Document::parse(svg).expect("XML");
        let shown: Vec<&str> = tree
            .descendants()
            .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")))
            .filter_map(|node| node.text())
            .collect();
        let is_shown = |name: &str| shown.iter().any(|text| text.split([',', ' ', ':']).any(|word| word == name));
        if compiled.model.bodies.len() <= 8 {
            let names = compiled.model.bodies.iter().map(|body| &body.name).chain(compiled.model.joints.iter().map(|joint| &joint.name));
            for name in names.map(ToString::to_string) {
                assert!(is_shown(&name), "{}: `{name}` has no place among {shown:?}", declaration.0);
            }
        }
    }
}

#[test]
fn the_same_declaration_gives_the_same_picture() {
    for declaration in [textbook(), space()].concat() {
        assert_eq!(compiled(&declaration).picture.svg(), compiled(&declaration).picture.svg());
    }
}

#[test]
fn what_is_not_assembled_or_too_large_says_so() {
    let chain = "pub mechanism Chain { ground { axis u = (1, 0); } for i in 0..201 { body b[i] { }
        joint guide[i] = translational(ground.u, ground.position, b[i].position); drive d[i] = drive_x(b[i].position, 1mm * i); } }";
    let large = compiled(&("chain".into(), chain.parse().expect("tokens")));
    assert_eq!(large.picture.svg(), None);
    assert_eq!(large.picture.words(), "There is no picture: in one of 201 bodies nothing could be told apart.");
}

#[test]
fn the_picture_of_the_readme_is_that_of_its_first_mechanism() {
    let page = compiled(&readme()[0]).picture.drawn().map(reuleaux_picture::Picture::page).expect("it is assembled");
    for place in ["examples/gallery/crank_rocker.svg", "runtime/src/guide/crank_rocker.svg"] {
        let file = root().join(place);
        if std::env::var_os("REULEAUX_GOLDEN").is_some_and(|mode| mode == "write") {
            fs::write(&file, &page).expect("the file can be written");
        }
        assert!(fs::read_to_string(&file).expect("the picture is there") == page, "{} is out of date", file.display());
    }
}
