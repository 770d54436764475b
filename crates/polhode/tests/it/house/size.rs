//! Size: a file is one idea, a function fits a screen.
//!
//! A code line is a line on which something other than a comment, documentation or blank space stands. A function is as
//! long as the lines from `fn` to its closing brace, for that is what a reader has before him.

use super::source::{attribute, inside, is_doc, line, read, repository, rust_files, tokens, word};
use proc_macro2::{Delimiter, TokenTree};
use std::collections::BTreeSet;

/// The most code lines of a file.
const FILE_LINES: usize = 800;
/// The most lines of a function.
const FUNCTION_LINES: usize = 100;

/// What may be larger: (path from the root, name of the function or `""` for the whole file, why).
const ALLOWED: [(&str, &str, &str); 0] = [];

/// Adds the lines on which `tokens` stand.
fn collect_lines(tokens: &[TokenTree], lines: &mut BTreeSet<usize>) {
    let mut i = 0;
    while let Some(token) = tokens.get(i) {
        if let Some((inner, next)) = attribute(tokens, i)
            && is_doc(&inner)
        {
            i = next;
            continue;
        }
        if let TokenTree::Group(g) = token {
            lines.extend([g.span_open().start().line, g.span_close().end().line]);
            collect_lines(&inside(g), lines);
        } else {
            lines.extend(token.span().start().line..=token.span().end().line);
        }
        i += 1;
    }
}

/// The number of code lines.
fn code_lines(text: &str) -> usize {
    let mut lines = BTreeSet::new();
    collect_lines(&tokens(text), &mut lines);
    lines.len()
}

/// Every function, also inside macros: its name, its first line and its number of lines.
fn functions(tokens: &[TokenTree]) -> Vec<(String, usize, usize)> {
    let mut found = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(g) = token {
            found.extend(functions(&inside(g)));
        }
        // `fn` before a bracket is a type.
        if word(tokens, i).as_deref() != Some("fn") || matches!(tokens.get(i + 1), None | Some(TokenTree::Group(_))) {
            continue;
        }
        let signature_ends = |t: &&TokenTree| match t {
            TokenTree::Group(g) => g.delimiter() == Delimiter::Brace,
            TokenTree::Punct(p) => p.as_char() == ';',
            _ => false,
        };
        if let Some(TokenTree::Group(body)) = tokens[i..].iter().find(signature_ends) {
            let name = word(tokens, i + 1).unwrap_or_else(|| format!("${}", word(tokens, i + 2).unwrap_or_default()));
            found.push((name, line(token), body.span_close().end().line + 1 - line(token)));
        }
    }
    found
}

/// What in a file is too large: (name of the function or `""`, what it is).
fn oversized(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let lines = code_lines(text);
    if lines > FILE_LINES {
        found.push((String::new(), format!("{lines} code lines; a file has at most {FILE_LINES}")));
    }
    for (name, first, lines) in functions(&tokens(text)) {
        if lines > FUNCTION_LINES {
            let what = format!("line {first}: `{name}` has {lines} lines; a function has at most {FUNCTION_LINES}");
            found.push((name, what));
        }
    }
    found
}

/// Complaints about `files`, each a path and its text, under an allow-list.
fn complaints(files: &[(String, String)], allowed: &[(&str, &str, &str)]) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut needed = BTreeSet::new();
    for (path, text) in files {
        for (item, what) in oversized(text) {
            match allowed.iter().position(|&(p, i, _)| p == path && i == item) {
                Some(entry) => drop(needed.insert(entry)),
                None => complaints.push(format!("{path}: {what}")),
            }
        }
    }
    for (entry, (path, item, reason)) in allowed.iter().enumerate() {
        if !needed.contains(&entry) {
            complaints.push(format!("the allowance for {path} `{item}` is no longer needed: take it out"));
        }
        if reason.trim().is_empty() {
            complaints.push(format!("the allowance for {path} `{item}` gives no reason"));
        }
    }
    complaints
}

#[test]
fn files_and_functions_have_a_size_one_can_read() {
    let Some(root) = repository() else { return };
    let files: Vec<(String, String)> =
        rust_files(&root).into_iter().map(|path| (path.clone(), read(&root.join(&path)))).collect();
    let complaints = complaints(&files, &ALLOWED);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

mod control {
    use super::*;

    #[test]
    fn only_code_lines_count() {
        let text = "//! Doc.\n\n// Why.\n/// Doc.\n/** Doc\n over lines */\nfn f() {\n\n    g(); // why\n    /* why\n */\n}\n\
                    const T: &str = \"a\n\nb\";\n#[doc = \"x\"]\n#[inline]\nstruct S;\n";
        assert_eq!(code_lines(text), 3 + 3 + 2);
    }

    #[test]
    fn functions_are_measured_wherever_they_stand() {
        let text = "type F = fn(f64) -> f64;\ntrait T { fn a(&self); fn b(&self) {\n} }\nimpl T for X { fn a(&self) where X: Sized {\n\n} }\n\
                    macro_rules! m { ($n:ident) => { fn $n() {\n} } }\nfn c() -> [u8; { 2 }] {\n  fn d() {}\n  [0; 2]\n}\n";
        let found: Vec<(String, usize)> = functions(&tokens(text)).into_iter().map(|(n, _, l)| (n, l)).collect();
        let expected = [("b", 2), ("a", 3), ("$n", 2), ("c", 4), ("d", 1)].map(|(n, l)| (n.to_string(), l));
        assert_eq!(found, expected);
    }

    #[test]
    fn one_line_more_is_too_many() {
        let function = |lines: usize| format!("fn long() {{\n{}}}\n", "\n".repeat(lines - 2));
        let file = |lines: usize| "const A: u8 = 1; // one\n".repeat(lines);
        assert!(oversized(&function(FUNCTION_LINES)).is_empty());
        assert!(oversized(&file(FILE_LINES)).is_empty());
        assert_eq!(oversized(&function(FUNCTION_LINES + 1)).len(), 1);
        assert_eq!(oversized(&file(FILE_LINES + 1)).len(), 1);
    }

    #[test]
    fn an_allowance_is_used_and_has_a_reason() {
        let long = format!("fn long() {{\n{}}}\n", "\n".repeat(FUNCTION_LINES));
        let files = [("a.rs".to_string(), long)];
        assert_eq!(complaints(&files, &[]).len(), 1);
        assert_eq!(complaints(&files, &[("a.rs", "long", "a table of coefficients")]).len(), 0);
        assert_eq!(complaints(&files, &[("a.rs", "long", " ")]).len(), 1);
        assert_eq!(complaints(&files, &[("a.rs", "other", "a reason")]).len(), 2);
        assert_eq!(complaints(&[], &[("a.rs", "long", "a reason")]).len(), 1);
    }
}
