//! The runtime consists of layers: each uses the layers below it only. Nor do files of a layer name each other in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// The folders of `src`, from the bottom to the top.
const LAYERS: [&str; 11] = ["number", "names", "linear", "state", "dynamics", "newton", "solve", "path", "explain", "enclosure", "api"];

/// Every file of a folder and of those in it.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { found.extend(files(&path)?) } else { found.push(path) }
    }
    Ok(found)
}

/// The paths after `crate::` in the code of a line; none for a list in braces, which would hide its targets.
fn targets(line: &str) -> impl Iterator<Item = &str> {
    let code = line.split("//").next().unwrap_or_default();
    code.split("crate::").skip(1).map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default())
}

/// Hence no cycle of files spans two folders.
#[test]
fn arrows_between_folders_go_down() -> Result<(), Box<dyn Error>> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let folders = fs::read_dir(&source)?.filter_map(|entry| entry.ok().filter(|entry| entry.path().join("mod.rs").exists()));
    assert_eq!(folders.count(), LAYERS.len(), "a folder has no place among the layers");
    for (height, layer) in LAYERS.into_iter().enumerate() {
        for file in files(&source.join(layer))? {
            for line in fs::read_to_string(&file)?.lines() {
                let goes_up = |target: &str| !LAYERS[..=height].contains(&target);
                assert!(!targets(line).any(goes_up), "{}: `{}` goes up", file.display(), line.trim());
                assert!(!line.contains("super::super"), "{}: `{}` leaves its folder", file.display(), line.trim());
            }
        }
    }
    Ok(())
}

/// The files that each file of a folder names by `super::`; names that the folder re-exports do not count.
fn named_beside(folder: &Path) -> Result<BTreeMap<String, BTreeSet<String>>, Box<dyn Error>> {
    let mut named = BTreeMap::new();
    for file in files(folder)?.into_iter().filter(|file| file.parent() == Some(folder)) {
        let own = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut others = BTreeSet::new();
        for line in fs::read_to_string(&file)?.lines() {
            let code = line.split("//").next().unwrap_or_default();
            let target = |rest: &str| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default().to_owned();
            others.extend(code.split("super::").skip(1).map(target).filter(|other| folder.join(other).with_extension("rs").exists()));
        }
        others.remove(&own);
        named.insert(own, others);
    }
    Ok(named)
}

#[test]
fn files_of_a_layer_do_not_name_each_other_in_a_circle() -> Result<(), Box<dyn Error>> {
    let (source, mut count) = (Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), 0);
    for layer in LAYERS {
        let mut open = named_beside(&source.join(layer))?;
        count += open.values().map(BTreeSet::len).sum::<usize>();
        // Files that name no file which is still open are taken away, until none is left.
        while !open.is_empty() {
            let left: BTreeSet<String> = open.keys().cloned().collect();
            open.retain(|_, others| others.iter().any(|other| left.contains(other)));
            assert!(open.len() < left.len(), "circle in `{layer}`: {:?}", open.keys());
        }
    }
    assert!(count > 0, "no file was read");
    Ok(())
}
