//! Floors: a module of the engine may reach only modules on strictly lower floors.
//!
//! The rule reads tokens rather than syntax, because a path climbs just as well from inside a macro's arguments, a macro's
//! body, an attribute or a test. Every path that starts at `crate`, `$crate`, `self` or `super` is resolved against the
//! module it stands in, through brace lists and renames; its first name below the crate root is the module it reaches. A
//! path that cannot be resolved, or reaches the root itself (`use crate as c`, `use super::*` at a module's root), fails: it
//! could climb anywhere. Tests inside the modules obey too, or moving a module would break them.

use super::source::{attribute, engine, group, inside, is_doc, line, read, repository, sign, tokens, word};
use proc_macro2::{Delimiter, TokenTree};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use syn::{Item, UseTree, Visibility};

/// The floor of each module of the engine; `lib.rs` lists those that exist in this order.
const FLOORS: [(&str, i32); 18] = [
    ("error", -1),
    ("math", 0),
    ("store", 0),
    ("par", 0),
    ("mass", 1),
    ("shape", 2),
    ("field", 3),
    ("collide", 3),
    ("integrate", 3),
    ("model", 4),
    ("state", 5),
    ("articulated", 6),
    ("constraint", 7),
    ("solve", 8),
    ("step", 9),
    ("world", 10),
    ("record", 11),
    ("prelude", 12),
];

/// The floor of a module, if it has one.
pub(super) fn floor(module: &str) -> Option<i32> {
    FLOORS.iter().find(|(name, _)| *name == module).map(|&(_, floor)| floor)
}

/// Names that the crate root re-exports, and the module each comes from.
type Reexports = BTreeMap<String, String>;

/// Where a token stands.
#[derive(Clone)]
struct Place {
    /// The module, from the crate root.
    module: Vec<String>,
    /// Inside a macro's body: the depth of the module around the definition. The call may stand elsewhere, so no `super`
    /// may climb out of it.
    macro_depth: Option<usize>,
}

/// Reads the tokens of one file and collects the complaints.
struct Reader<'a> {
    reexports: &'a Reexports,
    complaints: Vec<String>,
}

impl Reader<'_> {
    fn complain(&mut self, at: &TokenTree, message: &str) {
        self.complaints.push(format!("{}: {message}", line(at)));
    }

    /// Follows every token of `tokens`, which stand in `place`.
    fn read(&mut self, tokens: &[TokenTree], place: &Place) {
        let mut i = 0;
        while let Some(token) = tokens.get(i) {
            if let Some((inner, next)) = attribute(tokens, i) {
                if !is_doc(&inner) {
                    self.read_attribute(&inner, place);
                    self.read(&inner, place);
                }
                i = next;
                continue;
            }
            if let TokenTree::Group(g) = token {
                self.read(&inside(g), place);
                i += 1;
                continue;
            }
            i = match word(tokens, i).as_deref() {
                Some("pub") if restricted(tokens, i + 1) => i + 2,
                Some("extern") if word(tokens, i + 1).as_deref() == Some("crate") => {
                    if word(tokens, i + 2).as_deref() == Some("self") {
                        self.complain(token, "`extern crate self` gives the crate root a second name");
                    }
                    i + 3
                }
                Some("include") if sign(tokens, i + 1, '!') => {
                    self.complain(token, "`include!` puts source where no rule reads it");
                    i + 2
                }
                Some("mod") => self.read_module(tokens, i, place),
                Some("macro_rules") if sign(tokens, i + 1, '!') => self.read_macro(tokens, i, place),
                Some("crate" | "super") => self.follow(tokens, i, None, place),
                Some("self") if sign(tokens, i + 1, ':') && sign(tokens, i + 2, ':') => {
                    self.follow(tokens, i, None, place)
                }
                _ => i + 1,
            };
        }
    }

    /// An attribute can move a module to another file, or name a path in a string (`serde(with = "crate::x")`).
    fn read_attribute(&mut self, inner: &[TokenTree], place: &Place) {
        for (i, token) in inner.iter().enumerate() {
            if word(inner, i).as_deref() == Some("path") && sign(inner, i + 1, '=') {
                self.complain(token, "`#[path]` hides which module a file is");
            }
            match token {
                TokenTree::Group(g) => self.read_attribute(&inside(g), place),
                TokenTree::Literal(literal) => {
                    let Ok(syn::Lit::Str(text)) = syn::parse_str(&literal.to_string()) else { continue };
                    let text = text.value();
                    if ["crate::", "super::", "self::"].iter().any(|start| text.contains(start)) {
                        self.read(&tokens(&text), place);
                    }
                }
                _ => {}
            }
        }
    }

    /// `mod name { .. }`, also with `$name`: its tokens stand one module deeper.
    fn read_module(&mut self, tokens: &[TokenTree], i: usize, place: &Place) -> usize {
        let at = if sign(tokens, i + 1, '$') { i + 2 } else { i + 1 };
        let (Some(name), Some(body)) = (word(tokens, at), group(tokens, at + 1, Delimiter::Brace)) else {
            return i + 1;
        };
        let mut deeper = place.clone();
        deeper.module.push(name);
        self.read(&inside(body), &deeper);
        at + 2
    }

    /// `macro_rules! name { .. }`: its body is expanded elsewhere.
    fn read_macro(&mut self, tokens: &[TokenTree], i: usize, place: &Place) -> usize {
        if place.module.is_empty() {
            self.complain(&tokens[i], "a macro of the crate root has no floor: define it in a module");
        }
        if let Some(TokenTree::Group(body)) = tokens.get(i + 3) {
            let body_place = Place { module: place.module.clone(), macro_depth: Some(place.module.len()) };
            self.read(&inside(body), &body_place);
        }
        i + 4
    }

    /// Follows the path at token `i`, which continues `prefix` inside a brace list; returns the index after it.
    fn follow(&mut self, tokens: &[TokenTree], mut i: usize, prefix: Option<&[String]>, place: &Place) -> usize {
        let mut path = prefix.unwrap_or(&place.module).to_vec();
        loop {
            let Some(token) = tokens.get(i) else { return i };
            if let Some(list) = group(tokens, i, Delimiter::Brace) {
                for entry in inside(list).split(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ',')) {
                    self.follow(entry, 0, Some(&path), place);
                }
                return i + 1;
            }
            match word(tokens, i).as_deref() {
                Some("crate") => path.clear(),
                Some("self") => {}
                Some("super") => {
                    if path.pop().is_none() || place.macro_depth.is_some_and(|depth| path.len() < depth) {
                        self.complain(token, "`super` climbs out of what it stands in: write the path from `crate`");
                        return i + 1;
                    }
                }
                Some(name) => path.push(name.to_string()),
                // `*`, or `$name`, or `<`: whatever it is, it lies below `path`.
                None => {
                    self.reach(token, &path, place);
                    return i + 1;
                }
            }
            if !(sign(tokens, i + 1, ':') && sign(tokens, i + 2, ':')) {
                self.reach(token, &path, place);
                return i + 1;
            }
            i += 3;
            if sign(tokens, i, '<') {
                self.reach(token, &path, place);
                return i;
            }
        }
    }

    /// Judges a resolved path, found in `place`.
    fn reach(&mut self, at: &TokenTree, path: &[String], place: &Place) {
        let Some(own) = place.module.first() else { return };
        let Some(target) = path.first() else {
            self.complain(at, "reaches the crate root, which is above every floor: name the module");
            return;
        };
        if target == own {
            return;
        }
        let shown = format!("crate::{}", path.join("::"));
        let module = if floor(target).is_some() { target } else { self.reexports.get(target).unwrap_or(target) };
        let complaint = match (floor(own), floor(module)) {
            (Some(here), Some(there)) if there < here => return,
            (Some(here), Some(there)) => {
                format!("`{own}` (floor {here}) reaches `{shown}` in `{module}` (floor {there}): only lower floors")
            }
            (Some(_), None) => format!("`{shown}` is neither a module with a floor nor re-exported from one"),
            (None, _) => format!("`{own}` has no floor"),
        };
        self.complain(at, &complaint);
    }
}

/// Whether token `i` is the bracket of `pub(crate)`, `pub(super)`, `pub(in ..)`.
fn restricted(tokens: &[TokenTree], i: usize) -> bool {
    group(tokens, i, Delimiter::Parenthesis)
        .and_then(|g| word(&inside(g), 0))
        .is_some_and(|first| ["crate", "self", "super", "in"].contains(&first.as_str()))
}

/// Complaints about a file whose module is `module`, from the crate root.
fn climbs(text: &str, module: &[&str], reexports: &Reexports) -> Vec<String> {
    let mut reader = Reader { reexports, complaints: Vec::new() };
    let place = Place { module: module.iter().map(ToString::to_string).collect(), macro_depth: None };
    reader.read(&tokens(text), &place);
    reader.complaints
}

/// What `lib.rs` re-exports by name. A glob gives no names, so nothing may be reached through it.
fn reexports(lib: &str) -> Reexports {
    fn collect(tree: &UseTree, first: Option<&str>, found: &mut Reexports) {
        match tree {
            UseTree::Path(path) => {
                let name = path.ident.to_string();
                let first = first.or(if name == "self" || name == "crate" { None } else { Some(name.as_str()) });
                collect(&path.tree, first, found);
            }
            UseTree::Group(group) => group.items.iter().for_each(|item| collect(item, first, found)),
            UseTree::Name(name) => {
                found.extend(first.map(|module| (name.ident.to_string(), module.to_string())));
            }
            UseTree::Rename(rename) => {
                found.extend(first.map(|module| (rename.rename.to_string(), module.to_string())));
            }
            UseTree::Glob(_) => {}
        }
    }
    let mut found = Reexports::new();
    for item in syn::parse_file(lib).expect("lib.rs is Rust").items {
        if let Item::Use(item) = item {
            collect(&item.tree, None, &mut found);
        }
    }
    found
}

/// Complaints about the modules that `lib.rs` declares: public, each on a floor, low to high.
fn disorder(lib: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut highest = ("", i32::MIN);
    for item in &syn::parse_file(lib).expect("lib.rs is Rust").items {
        let Item::Mod(module) = item else { continue };
        let name = module.ident.to_string();
        if !matches!(module.vis, Visibility::Public(_)) {
            complaints.push(format!("`{name}` is not `pub mod`: a module of the engine is public"));
        }
        match FLOORS.iter().find(|(known, _)| *known == name) {
            None => complaints.push(format!("`{name}` has no floor")),
            Some((_, floor)) if *floor < highest.1 => complaints.push(format!(
                "`{name}` (floor {floor}) is declared after `{}` (floor {}): low floors first",
                highest.0, highest.1
            )),
            Some(known) => highest = *known,
        }
    }
    complaints
}

/// Every Rust file below `folder` with the module it is.
fn modules(folder: &Path, module: &[String]) -> Vec<(String, Vec<String>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("a readable folder").path();
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let mut inner = module.to_vec();
        if path.is_dir() {
            inner.push(stem);
            found.extend(modules(&path, &inner));
        } else if path.extension().is_some_and(|e| e == "rs") {
            if stem != "mod" && !(stem == "lib" && module.is_empty()) {
                inner.push(stem);
            }
            found.push((path.to_string_lossy().into_owned(), inner));
        }
    }
    found.sort();
    found
}

#[test]
fn no_module_reaches_up_or_sideways() {
    let src = engine().join("src");
    let exported = reexports(&read(&src.join("lib.rs")));
    let mut complaints = Vec::new();
    for (file, module) in modules(&src, &[]) {
        let module: Vec<&str> = module.iter().map(String::as_str).collect();
        let found = climbs(&read(Path::new(&file)), &module, &exported);
        complaints.extend(found.into_iter().map(|complaint| format!("{file}:{complaint}")));
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn lib_lists_the_modules_from_the_lowest_floor_up() {
    let complaints = disorder(&read(&engine().join("src/lib.rs")));
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn every_module_has_a_floor_and_is_declared() {
    let src = engine().join("src");
    let lib = syn::parse_file(&read(&src.join("lib.rs"))).expect("lib.rs is Rust");
    let declared: Vec<String> =
        lib.items.iter().filter_map(|i| if let Item::Mod(m) = i { Some(m.ident.to_string()) } else { None }).collect();
    for (file, module) in modules(&src, &[]) {
        let Some(top) = module.first() else { continue };
        assert!(floor(top).is_some(), "{file}: `{top}` has no floor");
        assert!(declared.contains(top), "{file}: `{top}` is not declared in lib.rs");
    }
}

#[test]
fn the_architecture_page_shows_these_floors() {
    let Some(root) = repository() else { return };
    let page = read(&root.join("ARCHITECTURE.md"));
    let mut shown: Vec<(String, i32)> = Vec::new();
    for row in super::documents::table(&page, "## Floors") {
        let level: i32 = row[0].parse().unwrap_or_else(|_| panic!("ARCHITECTURE.md: `{}` is no floor", row[0]));
        shown.extend(super::documents::code_spans(&row[1]).into_iter().map(|name| (name, level)));
    }
    let mut held: Vec<(String, i32)> = FLOORS.iter().map(|&(name, level)| (name.to_string(), level)).collect();
    shown.sort();
    held.sort();
    assert_eq!(shown, held, "ARCHITECTURE.md, `## Floors` (left) and the floors that are held (right) differ");
}

/// The rule itself, on snippets.
mod control {
    use super::*;

    fn complaints(module: &[&str], text: &str) -> Vec<String> {
        let exported =
            reexports("pub use error::Error; pub use {world::{World, BodyRef as Body}, math::*}; pub use libm;");
        climbs(text, module, &exported)
    }

    #[test]
    fn climbing_fails_in_every_form() {
        let mass: &[&str] = &["mass", "mesh"];
        let root: &[&str] = &["mass"];
        let snippets: &[(&[&str], &str)] = &[
            (mass, "use crate::step::advance;"),
            (mass, "use crate::step;"),
            (mass, "use crate::r#step::advance;"),
            (mass, "pub use crate::step::advance;"),
            (mass, "pub(crate) use crate::step::advance;"),
            (mass, "use crate::{math::Vec3, step};"),
            (mass, "use crate::{math::{Vec3, Quat}, step::{advance, Plan}};"),
            (mass, "use crate::{self as engine};"),
            (mass, "use {crate::math::Vec3, crate::step::advance};"),
            (mass, "use crate::step::*;"),
            (mass, "use crate::*;"),
            (mass, "use crate as engine;"),
            (mass, "use super::super as engine;"),
            (mass, "use super::super::step::advance;"),
            (mass, "use super::super::{math::Vec3, step};"),
            (mass, "use super::super::*;"),
            (mass, "use self::super::super::step;"),
            (mass, "use super::{super::step::advance, mesh};"),
            (root, "use super::step;"),
            (root, "use super::*;"),
            (root, "use super::{math::Vec3, step::advance};"),
            (root, "mod inner { use super::super::step; }"),
            (root, "fn f() { mod inner { fn g() { super::super::step::advance() } } }"),
            (mass, "fn f() { crate::step::advance(); }"),
            (mass, "fn f() { let x = 1 + super::super::step::advance(); }"),
            (mass, "fn f(plan: &crate::step::Plan) {}"),
            (mass, "fn f() -> Vec<crate::step::Plan> { todo() }"),
            (mass, "fn f() { Vec::<crate::step::Plan>::new(); }"),
            (mass, "fn f() { crate::math::Vec3::<crate::step::Plan>::new(); }"),
            (mass, "impl crate::step::Stage for X {}"),
            (mass, "fn f() { <crate::step::Plan as Default>::default(); }"),
            (mass, "struct S { plan: crate::step::Plan }"),
            (mass, "fn f() { use crate::step::advance; advance(); }"),
            (mass, "#[cfg(test)] mod tests { use crate::step::advance; }"),
            (mass, "#[cfg(test)] mod tests { use super::super::super::step; }"),
            (mass, "fn f() { assert_eq!(crate::step::advance(), 1); }"),
            (mass, "fn f() { println!(\"{}\", vec![super::super::step::advance()].len()); }"),
            (mass, "macro_rules! m { () => { crate::step::advance() }; }"),
            (mass, "macro_rules! m { () => { $crate::step::advance() }; }"),
            (mass, "macro_rules! m { () => { use $crate::{math::Vec3, step}; }; }"),
            (mass, "macro_rules! m { ($x:ident) => { $crate::$x::advance() }; }"),
            (mass, "macro_rules! m { () => { super::particles::sum() }; }"),
            (mass, "macro_rules! m { () => { mod tests { use super::super::x; } }; }"),
            (mass, "#[derive(X)] #[serde(with = \"crate::step::text\")] struct S;"),
            (mass, "#[path = \"../step/mod.rs\"] mod stolen;"),
            (mass, "#[cfg_attr(unix, path = \"../step/mod.rs\")] mod stolen;"),
            (mass, "include!(\"../step/mod.rs\");"),
            (mass, "extern crate self as polhode;"),
            (mass, "use crate::World;"),
            (mass, "use crate::Body;"),
            (mass, "use crate::Vec3;"),
            (mass, "use crate::libm;"),
            (mass, "use crate::prelude::*;"),
            (mass, "use crate::nowhere::x;"),
            (&["collide"], "use crate::integrate::pdmv;"),
            (&["math", "vec3"], "use crate::par::Executor;"),
            (&["math", "vec3"], "use crate::store::BodyId;"),
            (&["attic"], "use crate::math::Vec3;"),
            (&[], "pub mod math { use crate::step::advance; }"),
            (&[], "pub mod math { use super::step::advance; }"),
            (&[], "macro_rules! m { () => { $crate::step::advance() }; }"),
        ];
        for (module, text) in snippets {
            assert!(!complaints(module, text).is_empty(), "in `{}` this must fail: {text}", module.join("::"));
        }
    }

    #[test]
    fn descending_passes_in_every_form() {
        let snippets: &[(&[&str], &str)] = &[
            (&["mass"], "use crate::math::{Mat3, Vec3}; use super::math::Quat; use crate::Error;"),
            (&["mass"], "pub use mesh::Mesh; mod mesh; pub(crate) fn f() {} pub(in crate::mass) fn g() {}"),
            (&["mass"], "use self::mesh::Mesh; use crate::mass::mesh; fn f(&self) { self.x; self::mesh::g(); }"),
            (&["mass", "mesh"], "use super::*; use super::{Body, super::math::Vec3}; pub(super) fn f() {}"),
            (&["mass", "mesh"], "#[cfg(test)] mod tests { use super::*; use crate::math::Vec3; }"),
            (&["mass", "mesh"], "use std::step; use step::x; fn f() { step::advance(); other::crate_step(); }"),
            (&["mass", "mesh"], "// crate::step\n/// See [`crate::step`].\n#[doc = \"crate::step\"] fn f() {}"),
            (&["mass", "mesh"], "fn f() { panic!(\"crate::step::advance\") }"),
            (&["mass", "mesh"], "macro_rules! m { ($x:ident) => { $crate::math::$x; mod t { use super::*; } }; }"),
            (&["mass", "mesh"], "#[expect(lint, reason = \"it isn't: {\")] fn f() {}"),
            (&["step"], "use crate::{collide::broad, integrate, math::Vec3, solve::*, state::{self, State}};"),
            (&["record"], "use crate::{World, world, Error, Body};"),
            (&["prelude"], "pub use crate::{record::Journal, world::World};"),
            (&[], "pub mod math; pub mod step; pub use step::advance; fn f() { crate::step::advance() }"),
            (&[], "extern crate std; pub mod prelude { pub use crate::world::World; }"),
        ];
        for (module, text) in snippets {
            let found = complaints(module, text);
            assert!(found.is_empty(), "in `{}` this must pass: {text}\n{}", module.join("::"), found.join("\n"));
        }
    }

    #[test]
    fn a_complaint_says_where_and_what() {
        let found = complaints(&["mass"], "\n\nuse crate::{math::Vec3,\n    step::advance};");
        assert_eq!(
            found,
            ["4: `mass` (floor 1) reaches `crate::step::advance` in `step` (floor 9): only lower floors"]
        );
    }

    #[test]
    fn disorder_in_lib_fails() {
        assert!(disorder("pub mod error; pub mod math; pub mod collide; pub mod integrate; pub mod step;").is_empty());
        assert!(disorder("pub mod error; pub mod store; pub mod math; pub mod integrate; pub mod collide;").is_empty());
        assert!(!disorder("pub mod step; pub mod math;").is_empty());
        assert!(!disorder("mod math;").is_empty());
        assert!(!disorder("pub mod attic;").is_empty());
        assert!(!disorder("pub mod prelude {} pub mod math;").is_empty());
    }
}
