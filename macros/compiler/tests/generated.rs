//! Every function and constant that is generated for a mechanism has a name that no output may take, and only those names are refused.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::{ImplItem, Item, Type};

/// A crank whose drive and attributes are given.
fn crank(attributes: &str, more: &str) -> String {
    format!(
        "{attributes} mechanism Crank {{
            ground {{ point O = (0mm, 0mm); }}
            body crank {{ point O = (0mm, 0mm); point A = (100mm, 0mm); }}
            joint o = revolute(ground.O, crank.O);
            {more}
        }}"
    )
}

const DRIVE: &str = "drive turn = drive_angle(crank, 60rpm * t);";

/// Mechanisms of every kind, and of every attribute that adds functions.
fn declarations() -> Vec<String> {
    let heavy = |more: &str| {
        crank("", more).replace("point A", "mass = 1kg; inertia = disk(50mm); center = (50mm, 0mm); point A") // A disk beside its axle.
    };
    let coupled = "
        body coupler { point A = (0mm, 0mm); point B = (300mm, 0mm); }
        body slide { point B = (0mm, 0mm); start x = 380mm; }
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, slide.B);
        joint rail = translational((1, 0), ground.O, slide.B);";
    vec![
        crank("", DRIVE),
        crank("#[points] #[outputs] #[picture]", &format!("{DRIVE} output tip = crank.A;")),
        crank("#[equations_only]", &format!("{DRIVE} output tip = crank.A;")),
        crank("", &format!("{DRIVE} slice output tip = crank.A; output turned = crank.angle;")),
        crank("", "input angle: Angle; drive turn = drive_angle(crank, angle);"),
        crank("", "drive turn = drive_angle(crank, table(t, [(0s, 0deg), (1s, 90deg), (2s, 360deg)], hold));"),
        crank("", &format!("param length: Length = 30mm; {DRIVE} {coupled}")),
        heavy(DRIVE),
        heavy(&format!("slice {DRIVE} {coupled}")),
        heavy("freedom turn = crank.angle;"),
        heavy(&format!("freedom turn = crank.angle; {coupled}")),
        heavy(&format!("freedom turn = crank.angle; {coupled} slice force push = {{ at slide.B: (1N, 0N); }};")),
    ]
}

/// Functions and constants of the mechanism itself.
fn names(declaration: &str) -> BTreeSet<String> {
    let tokens: TokenStream = declaration.parse().expect("tokens");
    let file: syn::File = syn::parse2(reuleaux_compiler::mechanism(tokens)).expect("Rust");
    let mut names = BTreeSet::new();
    for item in &file.items {
        let Item::Impl(block) = item else { continue };
        let Type::Path(of) = &*block.self_ty else { continue };
        if block.trait_.is_some() || of.path.segments.last().is_none_or(|last| last.ident != "Crank") {
            continue;
        }
        names.extend(block.items.iter().filter_map(|item| match item {
            ImplItem::Fn(function) => Some(function.sig.ident.to_string()),
            ImplItem::Const(constant) => Some(constant.ident.to_string()),
            _ => None,
        }));
    }
    names
}

/// What is said of a mechanism with an output of this name.
fn said(declaration: &str, output: &str) -> Vec<String> {
    let end = declaration.rfind('}').expect("braces");
    let with_output = format!("{} output {output} = crank.A; }}", &declaration[..end]);
    let refusals = reuleaux_compiler::compile(with_output.parse().expect("tokens")).err().unwrap_or_default();
    refusals.iter().map(|refusal| refusal.fact.to_string()).collect()
}

#[test]
fn no_output_has_the_name_of_a_generated_function() {
    let mut wrong = Vec::new();
    for declaration in declarations() {
        let names = names(&declaration);
        assert!(names.contains("phi"), "nothing is found in {declaration}");
        for name in names.iter().filter(|name| !["tip", "turned"].contains(&name.as_str())) {
            let said = said(&declaration, name);
            let beginning = format!("an output cannot be called `{name}`: a generated ");
            if !matches!(said.as_slice(), [only] if only.starts_with(&beginning)) {
                wrong.push(format!("{name}: {said:?} in {declaration}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// `T` is refused as the name of a mechanism, and what stands for it is Rust all the same.
#[test]
fn a_mechanism_called_t_leaves_items() {
    for declaration in declarations() {
        let tokens: TokenStream = declaration.replace("Crank", "T").parse().expect("tokens");
        let items = syn::parse2::<syn::File>(reuleaux_compiler::mechanism(tokens)).expect("Rust").items;
        assert!(items.iter().any(|item| matches!(item, Item::Macro(error) if error.mac.path.is_ident("compile_error") || error.mac.path.segments.last().is_some_and(|last| last.ident == "compile_error"))), "{declaration}");
    }
}

/// The page of a function shows a link to its source: it leads to the line of the item that declares it, if the function's first and last token
/// lie there.
#[test]
fn functions_lie_where_their_items_are_declared() {
    let declaration = "#[points] mechanism Crank {
        param length: Length = 100mm;
        body crank {
            mass = 1kg; inertia = disk(50mm); center = (50mm, 0mm);
            point A = (length, 0mm);
        }
        joint axle = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
        slice output height = crank.A.y;
    }";
    let tokens: TokenStream = declaration.parse().expect("tokens");
    let mut found = Vec::new();
    ends_of_functions(reuleaux_compiler::mechanism(tokens), &mut found);
    let wanted = [("crank", 3), ("crank_A", 5), ("axle", 7), ("motor", 8), ("tip", 9), ("height", 10), ("solve_for_height", 10)];
    for (name, line) in wanted {
        let ends = found.iter().find(|(function, ..)| function == name).map(|(_, first, last)| [*first, *last]);
        assert_eq!(ends, Some([line; 2]), "{name}");
    }
}

/// The names of all public functions, with the lines of their first and of their last token.
fn ends_of_functions(tokens: TokenStream, found: &mut Vec<(String, usize, usize)>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (place, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(group) = token {
            ends_of_functions(group.stream(), found);
        }
        let is = |at: usize, word: &str| matches!(tokens.get(at), Some(TokenTree::Ident(found)) if found == word);
        let (true, true, Some(TokenTree::Ident(name))) = (is(place, "pub"), is(place + 1, "fn"), tokens.get(place + 2)) else { continue };
        let body = tokens[place..].iter().find_map(|token| match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
            _ => None,
        });
        let line = |span: Span| span.start().line;
        found.extend(body.map(|body| (name.to_string(), line(token.span()), line(body.span_close()))));
    }
}

/// rustc warns about capitals in the names of fields unless the struct allows them: that of the mechanism, and those of components.
#[test]
fn structs_allow_capitals_where_parameters_have_them() {
    let source = "mechanism Arms {
        component Arm(P: Point) {
            param R: Length = 100mm;
            param speed: AngularVelocity = 1rad_s;
            body link { point A = (R, 0mm); }
            joint o = revolute(P, link.position);
            drive turn = drive_angle(link, speed * t);
            output tip = link.A;
        }
        param L: Length = 1m;
        ground { point O = (L, 0m); }
        part arm = Arm(ground.O);
    }";
    let expanded = |source: &str| {
        let file: syn::File = syn::parse2(reuleaux_compiler::mechanism(source.parse().expect("tokens"))).expect("Rust");
        let structs = file.items.into_iter().filter_map(|item| if let Item::Struct(item) = item { Some(item) } else { None });
        let is_allowed =
            |attribute: &syn::Attribute| attribute.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "non_snake_case");
        structs.map(|item| (item.ident.to_string(), item.attrs.iter().any(is_allowed))).collect::<Vec<_>>()
    };
    let named = |one: &str, two: &str| ["Arms", "ArmsArm"].map(str::to_owned).into_iter().zip([one == "L", two == "R"]).collect::<Vec<_>>();
    for (one, two) in [("L", "R"), ("length", "R"), ("L", "radius")] {
        let found = expanded(
            &source
                .replace("param L", &format!("param {one}"))
                .replace("(L,", &format!("({one},"))
                .replace("param R", &format!("param {two}"))
                .replace("(R,", &format!("({two},")),
        );
        let mut wanted = named(one, two);
        wanted.retain(|(name, _)| found.iter().any(|(known, _)| known == name));
        assert_eq!(wanted.len(), 2, "{found:?}");
        assert!(wanted.iter().all(|each| found.contains(each)), "{found:?}, not {wanted:?}");
    }
}

/// Points, axes and centres that are written by others of their body are those that are written out.
#[test]
fn points_of_a_body_stand_for_their_coordinates() {
    let expanded = |space: &str, ground: &str, bar: &str| {
        let (inertia, joint, angle) = match space {
            "" => ("0.1kgm2", "revolute(ground.C, bar.B)", "bar.angle"),
            _ => ("(0.1kgm2, 0.1kgm2, 0.1kgm2)", "revolute(ground.C, ground.u, bar.B, bar.n)", "c.angle"),
        };
        let declaration = format!(
            "mechanism Bar {space} {{
                param length: Length = 300mm;
                let D = length;
                ground {{ {ground} }}
                body bar {{ mass = 2kg; inertia = {inertia}; {bar} }}
                joint c = {joint};
                freedom swing = {angle};
                output tip = bar.P;
            }}"
        );
        reuleaux_compiler::mechanism(declaration.parse().expect("tokens")).to_string()
    };
    let [one, two] = [
        [
            "point O = (1m, 2m); point C = O + (3m, 0m);",
            "point P = B + u * 2m + (E[1].y, 0m); point B = (length, 0m); center = (bar.B + bar.position) / 2; axis u = (0, 1);
             for i in 0..2 { point E[i] = (0m, 1m * i); } point D = (length, 5m); point F = (D, 0m);",
        ],
        [
            "point O = (1m, 2m); point C = (4m, 2m);",
            "point P = (length + 1m, 2m); point B = (length, 0m); center = (length / 2, 0m); axis u = (0, 1);
             for i in 0..2 { point E[i] = (0m, 1m * i); } point D = (length, 5m); point F = (length, 0m);",
        ],
    ]
    .map(|[ground, bar]| expanded("", ground, bar));
    assert!(one == two && !one.contains("compile_error"), "{one}\n{two}");
    // An axis keeps the direction from which angles count.
    let [one, two] = [
        [
            "point C = (1m, 2m, 3m); axis u = (0, 0, 1); axis v = (0, 2, 0) from (0, 0, 1);",
            "axis u = (0, 2, 0) from (0, 0, 1); axis n = cross(P - B, u) / 1m; point B = (0m, 0m, 1m); axis w = x_axis(u);
             point P = (length, 0m, B.z); center = B / 2;",
        ],
        [
            "point C = (1m, 2m, 3m); axis u = (0, 0, 1); axis v = (0, 2, 0) from (0, 0, 1);",
            "axis u = (0, 2, 0) from (0, 0, 1); axis n = (0, 0, 2 * length / 1m); point B = (0m, 0m, 1m); axis w = x_axis(ground.v);
             point P = (length, 0m, 1m); center = (0m, 0m, 1m / 2);",
        ],
    ]
    .map(|[ground, bar]| expanded("in space", ground, bar));
    assert!(one == two && !one.contains("compile_error"), "{one}\n{two}");
}
