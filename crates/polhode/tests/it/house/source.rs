//! What the rules read: the files of the repository, as text and as Rust tokens.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders that hold what a build, a run or an editor made.
const NOT_OURS: [&str; 7] = ["target", "node_modules", "out", "dist", "corpus", "artifacts", "coverage"];
/// Hidden folders that are part of the repository.
const HIDDEN_BUT_OURS: [&str; 3] = [".ci", ".github", ".cargo"];

/// The folder of the engine crate.
pub(super) fn engine() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The root of the repository, or `None`, with a message, in a package taken out of it.
///
/// `cargo package` leaves `Cargo.toml.orig` beside the manifest it rewrites; nothing else does.
pub(super) fn repository() -> Option<PathBuf> {
    if engine().join("Cargo.toml.orig").exists() {
        eprintln!("skipped: this is the published package, and the rule is about the repository it was made from");
        return None;
    }
    let root = engine().join("../..").canonicalize().expect("the engine lies in crates/ of the repository");
    assert!(root.join("Cargo.toml").is_file(), "no workspace manifest in {}", root.display());
    Some(root)
}

/// Every file of the repository, in order, by its path from the root with `/` between the parts.
///
/// The bundle in `viewer/dist` is not listed: it is compiled text, of which `.ci/run` checks that it is up to date.
pub(super) fn files(root: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![root.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
            let entry = entry.expect("a readable folder");
            let name = entry.file_name().to_string_lossy().into_owned();
            let kind = entry.file_type().expect("a kind of file");
            let hidden = name.starts_with('.') && !HIDDEN_BUT_OURS.contains(&name.as_str());
            if kind.is_dir() && !hidden && !NOT_OURS.contains(&name.as_str()) {
                folders.push(entry.path());
            } else if kind.is_file() && name != ".git" {
                let path = entry.path();
                let path = path.strip_prefix(root).expect("below the root");
                found.push(path.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}

/// Whether the path's extension is `extension`.
pub(super) fn is(path: &str, extension: &str) -> bool {
    Path::new(path).extension().is_some_and(|e| e == extension)
}

/// The Rust files of `crates/` and `fuzz/`.
pub(super) fn rust_files(root: &Path) -> Vec<String> {
    let ours = |path: &String| path.starts_with("crates/") || path.starts_with("fuzz/");
    files(root).into_iter().filter(|path| is(path, "rs") && ours(path)).collect()
}

/// The text of a file.
pub(super) fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The tokens of a Rust text; ordinary comments are none, documentation is `#[doc = ".."]`.
pub(super) fn tokens(text: &str) -> Vec<TokenTree> {
    let stream: TokenStream = text.parse().unwrap_or_else(|e| panic!("not Rust: {e}\n{text}"));
    stream.into_iter().collect()
}

/// The tokens inside a pair of brackets.
pub(super) fn inside(group: &Group) -> Vec<TokenTree> {
    group.stream().into_iter().collect()
}

/// The name that token `i` is, if it is one, without `r#`.
pub(super) fn word(tokens: &[TokenTree], i: usize) -> Option<String> {
    match tokens.get(i) {
        Some(TokenTree::Ident(name)) => Some(name.to_string().trim_start_matches("r#").to_string()),
        _ => None,
    }
}

/// Whether token `i` is the sign `c`.
pub(super) fn sign(tokens: &[TokenTree], i: usize, c: char) -> bool {
    matches!(tokens.get(i), Some(TokenTree::Punct(p)) if p.as_char() == c)
}

/// The bracketed group that token `i` is, if its brackets are `delimiter`.
pub(super) fn group(tokens: &[TokenTree], i: usize, delimiter: Delimiter) -> Option<&Group> {
    match tokens.get(i) {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

/// The inside of the attribute that begins at token `i`, and the index after it.
pub(super) fn attribute(tokens: &[TokenTree], i: usize) -> Option<(Vec<TokenTree>, usize)> {
    if !sign(tokens, i, '#') {
        return None;
    }
    let bracket = if sign(tokens, i + 1, '!') { i + 2 } else { i + 1 };
    let group = group(tokens, bracket, Delimiter::Bracket)?;
    Some((inside(group), bracket + 1))
}

/// Whether the inside of an attribute is documentation.
pub(super) fn is_doc(attribute: &[TokenTree]) -> bool {
    word(attribute, 0).as_deref() == Some("doc") && sign(attribute, 1, '=')
}

/// The line, from 1, at which a token begins.
pub(super) fn line(token: &TokenTree) -> usize {
    token.span().start().line
}
