//! `use` items; rustc reports paths that do not lead to a constraint (see `tests/ui/uses`).

crate::refusals! {
    item same_name_twice: "use crate::rolling; use other::«rolling»;" => "the name `rolling` is taken: another `use` has it\nhelp: choose another name";
    item renamed_to_the_same_name: "use crate::{rolling, sliding as «rolling»};" => "the name `rolling` is taken: another `use` has it\nhelp: choose another name";
    item keyword_in_a_path: "use crate::«fn»::rolling;" => "`fn` is a word of Rust and cannot be a name\nhelp: write `fn_`";
    item rename_to_a_keyword: "use crate::rolling as «type»;" => "`type` is a word of Rust and cannot be a name\nhelp: write `type_`";
}
