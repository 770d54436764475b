//! `docs/WHERE.md`: “where is … computed?”, and every answer is true.
//!
//! A row is `| question | answer |`. The answer names, in backticks, one place or several, in one of three forms:
//!
//! - `polhode::math::quat::Quat::rotate`: the path of an item, through the file that defines it, private modules included;
//! - `viewer/FORMAT.md`: a file or a folder, from the root of the repository;
//! - `viewer/src/plot.js::drawPlot`: something defined in a file.

use super::documents::{cells, code_spans};
use super::source::{is, read, repository, rust_files};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use syn::{Fields, Ident, ImplItem, Item, TraitItem, Type};

/// The name of an item, if it has one of its own.
fn name(item: &Item) -> Option<&Ident> {
    match item {
        Item::Const(i) => Some(&i.ident),
        Item::Enum(i) => Some(&i.ident),
        Item::Fn(i) => Some(&i.sig.ident),
        Item::Macro(i) => i.ident.as_ref(),
        Item::Mod(i) => Some(&i.ident),
        Item::Static(i) => Some(&i.ident),
        Item::Struct(i) => Some(&i.ident),
        Item::Trait(i) => Some(&i.ident),
        Item::Type(i) => Some(&i.ident),
        Item::Union(i) => Some(&i.ident),
        _ => None,
    }
}

/// The names of a type's named fields.
fn fields(fields: &Fields) -> Vec<&Ident> {
    fields.iter().filter_map(|field| field.ident.as_ref()).collect()
}

/// What `item` defines under the name `owner`: fields, variants, functions, constants and types.
fn members<'a>(item: &'a Item, owner: &str) -> Vec<&'a Ident> {
    match item {
        Item::Struct(i) if i.ident == owner => fields(&i.fields),
        Item::Enum(i) if i.ident == owner => i.variants.iter().map(|variant| &variant.ident).collect(),
        Item::Trait(i) if i.ident == owner => (i.items.iter())
            .filter_map(|item| match item {
                TraitItem::Const(i) => Some(&i.ident),
                TraitItem::Fn(i) => Some(&i.sig.ident),
                TraitItem::Type(i) => Some(&i.ident),
                _ => None,
            })
            .collect(),
        Item::Impl(i) => {
            let Type::Path(of) = &*i.self_ty else { return Vec::new() };
            if of.path.segments.last().is_none_or(|last| last.ident != owner) {
                return Vec::new();
            }
            (i.items.iter())
                .filter_map(|item| match item {
                    ImplItem::Const(i) => Some(&i.ident),
                    ImplItem::Fn(i) => Some(&i.sig.ident),
                    ImplItem::Type(i) => Some(&i.ident),
                    _ => None,
                })
                .collect()
        }
        _ => Vec::new(),
    }
}

/// Whether these items define `path`: an item, a member of one, or either inside an inline module.
fn defines(items: &[Item], path: &[&str]) -> bool {
    // No path at all is the file itself, also an empty one.
    path.is_empty()
        || items.iter().any(|item| match path {
            [only] if name(item).is_some_and(|n| n == only) => true,
            [owner, member] if members(item, owner).iter().any(|m| m == member) => true,
            [first, rest @ ..] if !rest.is_empty() => match item {
                Item::Mod(module) if module.ident == first => {
                    module.content.as_ref().is_some_and(|(_, inner)| defines(inner, rest))
                }
                _ => false,
            },
            _ => false,
        })
}

/// Whether a text that is not Rust defines `name`: after a word that defines, or as a heading or key at the line's start.
fn defines_elsewhere(text: &str, name: &str) -> bool {
    let mut words =
        text.split(|c: char| !(c.is_alphanumeric() || "_$-".contains(c))).filter(|w| !w.is_empty()).peekable();
    while let Some(word) = words.next() {
        let defining = ["function", "class", "const", "let", "var", "def"].contains(&word);
        if defining && words.peek() == Some(&name) {
            return true;
        }
    }
    text.lines().any(|line| {
        let rest = line.trim_start_matches(['#', '[', ' ']).strip_prefix(name);
        rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
    })
}

/// The file and the rest of a Rust path, walking down from the crate's root file through `mod` files.
fn descend<'a>(root: &Path, path: &[&'a str]) -> Option<(PathBuf, Vec<&'a str>)> {
    let (krate, mut rest) = path.split_first()?;
    let mut folder = root.join("crates").join(krate.replace('_', "-")).join("src");
    let mut file = ["lib.rs", "main.rs"].map(|name| folder.join(name)).into_iter().find(|f| f.is_file())?;
    while let Some((module, deeper)) = rest.split_first() {
        let candidates = [folder.join(format!("{module}.rs")), folder.join(module).join("mod.rs")];
        let Some(found) = candidates.into_iter().find(|f| f.is_file()) else { break };
        (file, rest) = (found, deeper);
        folder.push(module);
    }
    Some((file, rest.to_vec()))
}

/// What is wrong with an answer, if anything.
fn falsehood(root: &Path, answer: &str) -> Option<String> {
    if answer.contains('/') || answer.contains('.') {
        let (file, item) = answer.split_once("::").map_or((answer, None), |(file, item)| (file, Some(item)));
        let path = root.join(file);
        if !path.exists() {
            return Some(format!("there is no `{file}`"));
        }
        let item = item?;
        let found = if is(file, "rs") {
            defines(&syn::parse_file(&read(&path)).expect("Rust").items, &item.split("::").collect::<Vec<_>>())
        } else {
            defines_elsewhere(&read(&path), item)
        };
        return (!found).then(|| format!("`{file}` does not define `{item}`"));
    }
    let path: Vec<&str> = answer.split("::").collect();
    let Some((file, rest)) = descend(root, &path) else {
        return Some(format!("there is no crate `{}`", path[0]));
    };
    if defines(&syn::parse_file(&read(&file)).expect("Rust").items, &rest) {
        return None;
    }
    let file = file.strip_prefix(root).expect("below the root").display().to_string();
    Some(format!("`{file}` does not define `{}`{}", rest.join("::"), elsewhere(root, &rest)))
}

/// Where the item is instead, for the message.
fn elsewhere(root: &Path, item: &[&str]) -> String {
    // A re-export has lost the private module's name; the item itself is the last one or two words.
    let wanted = &item[item.len().saturating_sub(2)..];
    let here = |file: &String| defines(&syn::parse_file(&read(&root.join(file))).expect("Rust").items, wanted);
    let found: Vec<String> = rust_files(root).into_iter().filter(here).collect();
    if found.is_empty() { String::new() } else { format!("; it is defined in {}", found.join(", ")) }
}

/// Complaints about the rows of a page.
fn complaints(root: &Path, page: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut asked = BTreeSet::new();
    for (i, line) in page.lines().enumerate() {
        let mut complain = |what: &str| complaints.push(format!("docs/WHERE.md:{}: {what}\n    {line}", i + 1));
        // The first two lines of a table are its header and the rule below it.
        let dashes = |line: &str| line.contains("---");
        if !line.starts_with('|') || dashes(line) || page.lines().nth(i + 1).is_some_and(dashes) {
            continue;
        }
        let Some(row) = cells(line).filter(|row| row.len() == 2) else {
            complain("a row is `| question | answer |`, with the answer's places in backticks");
            continue;
        };
        if !asked.insert(row[0].clone()) {
            complain("this question was asked before");
        }
        let answers = code_spans(&row[1]);
        if answers.is_empty() {
            complain("the answer names no place in backticks");
        }
        answers.iter().filter_map(|answer| falsehood(root, answer)).for_each(|what| complain(&what));
    }
    complaints
}

#[test]
fn every_answer_in_where_is_true() {
    let Some(root) = repository() else { return };
    let page = read(&root.join("docs/WHERE.md"));
    assert!(page.lines().filter(|line| line.starts_with('|')).count() > 2, "docs/WHERE.md asks nothing");
    let complaints = complaints(&root, &page);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

mod control {
    use super::*;

    #[test]
    fn items_and_members_are_found() {
        let text = "
            pub struct Body<T> { pub mass: T }
            impl<T: Copy> Body<T> { pub fn spin(&self) {} const N: u32 = 1; }
            impl<T> Default for Body<T> { fn default() -> Self { loop {} } }
            pub enum Kind { Fixed, Dynamic { m: f64 } }
            pub trait Scheme { const ORDER: u32; fn advance(&self); }
            pub const G: f64 = 9.81; static S: u8 = 0; pub type V = f64; macro_rules! say { () => {} }
            mod tests { fn law() {} mod deeper { struct X { y: u8 } } }
            pub use other::Thing;";
        let items = syn::parse_file(text).unwrap().items;
        let there = "Body Body::mass Body::spin Body::N Body::default Kind::Fixed Scheme::ORDER Scheme::advance G S V say \
                     tests tests::law tests::deeper::X tests::deeper::X::y";
        for path in there.split_whitespace() {
            assert!(defines(&items, &path.split("::").collect::<Vec<_>>()), "{path}");
        }
        for path in "spin Body::turn Kind::Free Thing Other::spin law tests::spin Scheme::Body X G::G".split(' ') {
            assert!(!defines(&items, &path.split("::").collect::<Vec<_>>()), "{path}");
        }
    }

    #[test]
    fn other_languages_define_too() {
        let text = "export function drawPlot(x) {}\nclass Page {}\n## The header\n[package]\nname = 1\n";
        for name in ["drawPlot", "Page", "The header", "package", "name"] {
            assert!(defines_elsewhere(text, name), "{name}");
        }
        for name in ["draw", "x", "plot", "Header"] {
            assert!(!defines_elsewhere(text, name), "{name}");
        }
    }

    #[test]
    fn a_false_row_is_named() {
        let Some(root) = repository() else { return };
        let rows = [
            "| A item that is not there? | `polhode::math::quat::Quat::twirl` |",
            "| A re-export instead of the definition? | `polhode::math::Quat::rotate` |",
            "| A file that is not there? | `viewer/NOWHERE.md` |",
            "| A file without that item? | `crates/polhode/src/error.rs::Error::nothing` |",
            "| A crate that is not there? | `polhode_moon::lib` |",
            "| Two answers, one false? | `polhode::error::Error`, `polhode::error::Eror` |",
            "| No place at all? | somewhere |",
            "| Too many cells? | `polhode::error::Error` | more |",
        ];
        let header = "| question | answer |\n|---|---|\n";
        for row in rows {
            let found = complaints(&root, &format!("{header}{row}"));
            assert_eq!(found.len(), 1, "{row}\n{found:?}");
            assert!(found[0].contains(row), "the complaint does not show its row: {}", found[0]);
        }
        let twice = "| Twice? | `polhode::error::Error` |\n| Twice? | `polhode::error::Error` |";
        assert_eq!(complaints(&root, &format!("{header}{twice}")).len(), 1);
        assert!(complaints(&root, rows[1])[0].contains("it is defined in crates/polhode/src/math/quat.rs"));
    }

    #[test]
    fn a_true_row_passes() {
        let Some(root) = repository() else { return };
        let page = "| question | answer |\n|---|---|\n\
            | A method? | `polhode::math::quat::Quat::rotate` |\n| A file? | `viewer/FORMAT.md` |\n\
            | A module? | `polhode::math` |\n| An item of a file? | `crates/polhode/src/error.rs::Error::inside` |\n\
            | Another crate? | `polhode_scene` |\n| A field? | `polhode::math::pose::Pose::rot` |\n";
        assert_eq!(complaints(&root, page), Vec::<String>::new());
    }
}
