//! Words: what no file may say.
//!
//! Rust is read as tokens, so that a word in a string or in a sentence is no offence; only then is the rest read as text.

use super::source::{attribute, files, inside, is, is_doc, line, read, repository, sign, tokens, word};
use proc_macro2::TokenTree;
use std::fs;

/// The files that may say `unsafe`. While there is none, the workspace forbids it.
const UNSAFE_FILES: [&str; 0] = [];

/// Macros that are stubs or left over from a debugging session.
const MACROS: [&str; 3] = ["todo", "unimplemented", "dbg"];
/// Notes to oneself: an open question is an issue.
const NOTES: [&str; 2] = ["TODO", "FIXME"];
/// The first folder of a path that only exists on somebody's machine.
const MACHINE_FOLDERS: [&str; 5] = ["home", "root", "Users", "tmp", "work"];
/// The languages in which we write notes to ourselves.
const WRITTEN_BY_US: [&str; 9] = ["rs", "toml", "md", "sh", "js", "mjs", "html", "css", "py"];

/// What the tokens of a Rust file say that they may not; `unsafe_allowed` for the listed files.
fn rust_offences(tokens: &[TokenTree], unsafe_allowed: bool) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut i = 0;
    while let Some(token) = tokens.get(i) {
        if let Some((inner, next)) = attribute(tokens, i) {
            found.extend(attribute_offences(&inner, unsafe_allowed).into_iter().map(|what| (line(token), what)));
            i = next;
            continue;
        }
        if let TokenTree::Group(g) = token {
            found.extend(rust_offences(&inside(g), unsafe_allowed));
        }
        match word(tokens, i) {
            Some(name) if MACROS.contains(&name.as_str()) && sign(tokens, i + 1, '!') => {
                found.push((line(token), format!("`{name}!`")));
            }
            Some(name) if name == "unsafe" && !unsafe_allowed => {
                found.push((line(token), "`unsafe` outside the listed files".to_string()));
            }
            _ => {}
        }
        i += 1;
    }
    found
}

/// What an attribute says that it may not.
fn attribute_offences(inner: &[TokenTree], unsafe_allowed: bool) -> Vec<String> {
    if is_doc(inner) {
        let text = inner.get(2).map(ToString::to_string).unwrap_or_default();
        let fence = text.split_once("```").is_some_and(|(_, language)| language.contains("ignore"));
        return if fence { vec!["an example that is ignored".to_string()] } else { Vec::new() };
    }
    let first = word(inner, 0).unwrap_or_default();
    let mut found = Vec::new();
    let mut words = vec![inner.to_vec()];
    while let Some(level) = words.pop() {
        for i in 0..level.len() {
            if let TokenTree::Group(g) = &level[i] {
                words.push(inside(g));
            }
            match word(&level, i).as_deref() {
                Some("ignore") if first == "ignore" || first == "cfg_attr" => {
                    found.push("a test that is ignored".to_string());
                }
                Some("unsafe" | "unsafe_code") if !unsafe_allowed => {
                    found.push("`unsafe` in an attribute outside the listed files".to_string());
                }
                _ => {}
            }
        }
    }
    found
}

/// Paths in a line that only exist on somebody's machine.
fn machine_paths(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for folder in MACHINE_FOLDERS {
        for (start, path) in text.match_indices(&format!("/{folder}/")) {
            // After these, `/tmp/` goes on with another path or an address: `../tmp/`, `a.org/work/`, `${OUT}/tmp/`.
            let goes_on = |c: char| c.is_alphanumeric() || "._-~})]%".contains(c);
            if !text[..start].chars().next_back().is_some_and(goes_on) {
                found.push(path.to_string());
            }
        }
    }
    let windows = text.match_indices(":\\").filter(|(start, _)| {
        let mut before = text[..*start].chars().rev();
        before.next().is_some_and(|c| c.is_ascii_uppercase()) && !before.next().is_some_and(char::is_alphanumeric)
    });
    found.extend(windows.map(|(start, _)| text[start - 1..].chars().take(3).collect()));
    found
}

/// Notes to oneself in a line.
fn notes(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    words.filter(|w| NOTES.contains(w)).map(ToString::to_string).collect()
}

#[test]
fn no_stub_no_ignored_test_no_unsafe() {
    let Some(root) = repository() else { return };
    let mut complaints = Vec::new();
    for path in files(&root).into_iter().filter(|path| is(path, "rs")) {
        let text = read(&root.join(&path));
        let listed = UNSAFE_FILES.contains(&path.as_str());
        let found = rust_offences(&tokens(&text), listed);
        complaints.extend(found.into_iter().map(|(line, what)| format!("{path}:{line}: {what}")));
        if listed && rust_offences(&tokens(&text), false).is_empty() {
            complaints.push(format!("{path} is listed for `unsafe` and has none: take it out"));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn the_lints_forbid_unsafe_in_every_crate() {
    let Some(root) = repository() else { return };
    let manifest = |path: &str| read(&root.join(path)).parse::<toml::Table>().unwrap_or_else(|e| panic!("{path}: {e}"));
    // `forbid` cannot be lifted in a file; `deny` can, and is right once a file is listed.
    let level = if UNSAFE_FILES.is_empty() { "forbid" } else { "deny" };
    let lints = &manifest("Cargo.toml")["workspace"]["lints"]["rust"];
    assert_eq!(lints["unsafe_code"].as_str(), Some(level), "Cargo.toml: workspace.lints.rust.unsafe_code");
    let crates = files(&root).into_iter().filter(|p| p.starts_with("crates/") && p.ends_with("/Cargo.toml"));
    for path in crates {
        let inherits = manifest(&path).get("lints").and_then(|l| l.get("workspace")).and_then(toml::Value::as_bool);
        assert_eq!(inherits, Some(true), "{path} lacks `[lints] workspace = true`");
    }
}

#[test]
fn no_machine_path_and_no_note_to_oneself() {
    let Some(root) = repository() else { return };
    let mut complaints = Vec::new();
    for path in files(&root) {
        let Ok(text) = fs::read_to_string(root.join(&path)) else { continue }; // a picture, a mesh
        let ours = WRITTEN_BY_US.iter().any(|language| is(&path, language));
        let rule_itself = path.ends_with("tests/it/house/words.rs");
        for (i, line) in text.lines().enumerate().filter(|_| !rule_itself) {
            complaints
                .extend(machine_paths(line).iter().map(|p| format!("{path}:{}: the machine's path `{p}`", i + 1)));
            let found = if ours { notes(line) } else { Vec::new() };
            complaints.extend(found.iter().map(|n| format!("{path}:{}: `{n}`: make it an issue", i + 1)));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

mod control {
    use super::*;

    #[test]
    fn offences_in_rust_are_found() {
        for text in [
            "fn f() { todo!() }",
            "fn f() { std::unimplemented!(\"later\") }",
            "fn f() { g(dbg!(1)); }",
            "macro_rules! m { () => { todo!() } }",
            "#[test] #[ignore] fn f() {}",
            "#[test] #[ignore = \"slow\"] fn f() {}",
            "#[cfg_attr(debug_assertions, ignore)] fn f() {}",
            "unsafe fn f() {}",
            "fn f() { unsafe { g() } }",
            "#[unsafe(no_mangle)] fn f() {}",
            "#![allow(unsafe_code)]",
            "/// ```ignore\n/// f();\n/// ```\nfn f() {}",
            "/// ```rust,ignore\n/// f();\n/// ```\nfn f() {}",
        ] {
            assert!(!rust_offences(&tokens(text), false).is_empty(), "this must fail: {text}");
        }
    }

    #[test]
    fn the_same_words_elsewhere_are_no_offence() {
        for text in [
            "// todo!() unsafe\n/// They ignore `unsafe` and `dbg!`.\nfn f() { g(\"todo!() unsafe #[ignore]\") }",
            "fn todo() {} fn f() { if todo() != 1 { ignore() } }",
            "#[expect(clippy::let_underscore, reason = \"unsafe\")] fn f() {}",
            "/// ```\n/// f();\n/// ```\n/// One may ignore it.\nfn f() {}",
        ] {
            assert_eq!(rust_offences(&tokens(text), false), [], "{text}");
        }
        assert!(rust_offences(&tokens("fn f() { unsafe { g() } }"), true).is_empty());
    }

    #[test]
    fn machine_paths_and_notes_are_found() {
        for text in ["see /home/me/x", "\"/tmp/a\"", "(/Users/me/)", "file:///root/x", "C:\\Users", "=/work/x"] {
            assert_eq!(machine_paths(text).len(), 1, "{text}");
        }
        for text in
            ["a.org/work/x", "../tmp/x", "${OUT}/tmp/x", "frame/work/x", "https://a.b/c", "A::\\", "/usr/bin/env"]
        {
            assert!(machine_paths(text).is_empty(), "{text}");
        }
        assert_eq!(notes("// TODO: later, FIXME"), ["TODO", "FIXME"]);
        assert!(notes("TODOS and a_TODO").is_empty());
    }
}
