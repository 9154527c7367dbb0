//! The pages of the error index: the wrong model of each page is refused with the code of the page, its right models are accepted, and
//! the page shows the compiler's message.
//!
//! `REULEAUX_GOLDEN=write cargo test -p reuleaux-compiler --test errors` writes the message under each wrong model. The doc tests of
//! `reuleaux` check that rustc accepts the right models too.

mod page;

use page::{Block, blocks};
use proc_macro2::{TokenStream, TokenTree};
use reuleaux_compiler::diag::{PAGES, Refusal};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Longest line of a page, for comfortable reading.
const WIDTH: usize = 132;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("errors")
}

/// All refusals of the macros in a block.
fn refusals(source: &str) -> Vec<Refusal> {
    let tokens: TokenStream = source.parse().expect("a block consists of tokens");
    refused(tokens)
}

fn refused(tokens: TokenStream) -> Vec<Refusal> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = Vec::new();
    for (index, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let inside = group.stream();
        found.extend(match trees[..index] {
            [.., TokenTree::Ident(ref name), TokenTree::Punct(ref bang)] if bang.as_char() == '!' && name == "mechanism" => {
                reuleaux_compiler::compile(inside).err().unwrap_or_default()
            }
            [.., TokenTree::Ident(ref name), TokenTree::Punct(ref bang)] if bang.as_char() == '!' && name == "constraint" => {
                reuleaux_compiler::check_constraint(inside).err().unwrap_or_default()
            }
            _ => refused(inside),
        });
    }
    found
}

fn is_wrong(block: &Block) -> bool {
    block.language == "compile_fail"
}

#[test]
fn codes_are_in_order_and_given_once() {
    let codes: Vec<&str> = PAGES.iter().map(|(code, _)| *code).collect();
    assert!(codes.is_sorted_by(|one, next| one < next), "{codes:?}");
    assert!(codes.iter().all(|code| code.len() == 5 && code[1..].bytes().all(|digit| digit.is_ascii_digit())));
}

#[test]
fn every_page_has_a_code() {
    let files = fs::read_dir(folder()).expect("the pages are there").map(|file| file.expect("a file").file_name());
    let files: BTreeSet<String> = files.map(|name| name.to_string_lossy().into_owned()).collect();
    let codes: BTreeSet<String> = PAGES.iter().map(|(code, _)| format!("{code}.md")).collect();
    assert_eq!(files, codes);
}

/// Each page has a heading, one wrong model with its message, and right models.
#[test]
fn pages_are_of_one_shape() {
    of_each_page(|_, page| {
        let heading = page.lines().next().unwrap_or("");
        let languages: Vec<&str> = blocks(page).iter().map(|block| block.language).collect();
        // Compiler messages are exempt from the limit.
        let mut long = page.lines().filter(|line| line.chars().count() > WIDTH && !line.starts_with("  ") && !line.starts_with("error: "));
        match () {
            () if !heading.ends_with('.') || page.lines().nth(1) != Some("") => Err("begins with one sentence on one line".into()),
            () if !matches!(languages[..], ["compile_fail", "text", "", ..]) => Err(format!("has other blocks: {languages:?}")),
            () => long.next().map_or(Ok(()), |line| Err(format!("has a long line: {line}"))),
        }
    });
}

#[test]
fn the_wrong_model_is_refused_for_this_reason_only() {
    let writes = env::var_os("REULEAUX_GOLDEN").is_some_and(|mode| mode == "write");
    of_each_page(|code, page| {
        let blocks = blocks(page);
        let wrong = blocks.iter().find(|block| is_wrong(block)).ok_or("has no wrong model")?;
        let shown = shown(&wrong.source());
        let [(found, text)] = shown.as_slice() else { return Err(format!("is about one mistake, found {shown:#?}")) };
        if found != code {
            return Err(format!("is refused for {found}:\n{text}"));
        }
        if writes {
            let page = wrong.followed_by(page, "text", text);
            fs::write(folder().join(format!("{code}.md")), page).expect("the page can be written");
        }
        let said = blocks.iter().find(|block| block.language == "text").map(|block| block.text);
        if writes || said == Some(text) { Ok(()) } else { Err(format!("shows {said:?}, but the compiler says\n{text}")) }
    });
}

#[test]
fn the_right_models_are_accepted() {
    of_each_page(|_, page| {
        let blocks = blocks(page);
        let mut refused = blocks.iter().filter(|block| block.language.is_empty()).flat_map(|right| shown(&right.source()));
        refused.next().map_or(Ok(()), |(_, text)| Err(format!("has a right model that is refused:\n{text}")))
    });
}

/// Runs a check on each page, and reports all failures.
fn of_each_page(check: impl Fn(&str, &str) -> Result<(), String>) {
    let complain = |(code, page): &(&str, &str)| check(code, page).err().map(|why| format!("{code} {why}"));
    let complaints: Vec<String> = PAGES.iter().filter_map(complain).collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// The code of each refusal, and its rendered message.
fn shown(source: &str) -> Vec<(String, String)> {
    refusals(source).iter().map(|refusal| (refusal.fact.code().to_owned(), refusal.shown(source))).collect()
}
