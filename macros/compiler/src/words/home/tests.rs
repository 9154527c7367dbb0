//! The table against the library.

use super::{HOMES, Home};
use crate::library;
use crate::quantity::Ambient;

/// A line to type names a page of the library, and its parameters up to the first that has a default.
#[test]
fn homes_are_pages_of_the_library() {
    for (words, plane, space) in HOMES {
        for (home, ambient) in [(plane, Ambient::Plane), (space, Ambient::Space)] {
            let calls: &[&str] = match &home {
                Home::Joint(calls) => calls,
                Home::Drive(call) | Home::Force(call) => &[*call],
                Home::Body | Home::Equation | Home::Nothing => &[],
            };
            for call in calls {
                let (name, parameters) = call.trim_end_matches(')').split_once('(').expect("a call");
                let page = library::find(name, ambient).unwrap_or_else(|| panic!("{words:?}: no page `{name}`"));
                let wanted: Vec<String> =
                    page.parameters.iter().filter(|formal| formal.default.is_none()).map(|formal| formal.name.to_string()).collect();
                assert_eq!(parameters.split(", ").collect::<Vec<_>>(), wanted, "{call}");
            }
        }
    }
}
