//! Documents: what a page shows is what is there.

use super::floors::floor;
use super::source::{files, is, read, repository};

/// The rows of the first table below `heading`, each as its cells, without the header.
pub(super) fn table(page: &str, heading: &str) -> Vec<Vec<String>> {
    let below = page.lines().skip_while(|l| l.trim_end() != heading).skip(1).take_while(|l| !l.starts_with("## "));
    let rows: Vec<Vec<String>> = below.filter_map(cells).collect();
    assert!(!rows.is_empty(), "no table below `{heading}`");
    rows
}

/// The cells of a row of a table; `None` for any other line, for a header's rule, and for the header above it.
pub(super) fn cells(line: &str) -> Option<Vec<String>> {
    let row = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    let cells: Vec<String> = row.split('|').map(|cell| cell.trim().to_string()).collect();
    // A row that a rule reads names something in code; headers and rules do not.
    (!code_spans(row).is_empty()).then_some(cells)
}

/// The texts between backticks.
pub(super) fn code_spans(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(ToString::to_string).collect()
}

/// The lines of the fenced blocks of `language` in a page.
fn fenced(page: &str, language: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut open = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), open) {
            (Some(_), Some(_)) => open = None,
            (Some(name), None) => open = Some(name.trim()),
            (None, Some(name)) if name == language => lines.push(line.to_string()),
            _ => {}
        }
    }
    lines
}

/// A line of a shell script without its comment.
fn uncommented(line: &str) -> &str {
    line.split(" #").next().unwrap_or_default().trim()
}

/// The relative targets of the links of a page, without their `#anchor`.
fn links(page: &str) -> Vec<String> {
    let targets = page.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
    let local = targets.filter(|t| !t.contains("://") && !t.starts_with("mailto:"));
    local.filter_map(|t| t.split('#').next()).filter(|t| !t.is_empty()).map(ToString::to_string).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let Some(root) = repository() else { return };
    for page in files(&root).iter().filter(|path| is(path, "md")) {
        let folder = root.join(page).parent().expect("a folder").to_path_buf();
        for target in links(&read(&root.join(page))) {
            assert!(folder.join(&target).exists(), "{page}: the link to `{target}` leads nowhere");
        }
    }
}

#[test]
fn ci_runs_the_commands_of_the_readme() {
    let Some(root) = repository() else { return };
    let ci = read(&root.join(".ci/run"));
    let readme = read(&root.join("README.md"));
    let (_, promise) = readme.split_once("\n## Two commands\n").expect("README.md has a section `## Two commands`");
    // The section's first block, without the comments behind the commands.
    let commands: Vec<String> = fenced(promise, "sh").iter().take(2).map(|l| uncommented(l).to_string()).collect();
    assert_eq!(commands.len(), 2, "README.md shows fewer than two commands");
    for command in commands {
        let runs = ci.lines().any(|line| line.starts_with("step ") && uncommented(line).ends_with(&command));
        assert!(runs, ".ci/run does not run what README.md promises: {command}");
    }
}

/// Pages of the book that belong to no module.
const NOT_CHAPTERS: [&str; 2] = ["README", "lecture"];

#[test]
fn a_chapter_is_a_module_with_the_same_word() {
    let Some(root) = repository() else { return };
    let summary = read(&root.join("docs/book/README.md"));
    for path in files(&root).iter().filter(|path| path.starts_with("docs/book/")) {
        let name = path.trim_start_matches("docs/book/");
        let Some(chapter) = name.strip_suffix(".md").filter(|page| !NOT_CHAPTERS.contains(page)) else { continue };
        assert!(floor(chapter).is_some(), "{path}: no module of the engine is called `{chapter}`");
        assert!(links(&summary).contains(&name.to_string()), "{path} is not listed in docs/book/README.md");
    }
}

mod control {
    use super::*;

    #[test]
    fn a_table_is_read_below_its_heading() {
        let page = "# A\n| x `no` |\n## B\n| name | why |\n|---|---|\n| `a`, `b` | one |\n\n## C\n| `c` | two |\n";
        assert_eq!(table(page, "## B"), [["`a`, `b`", "one"]]);
        assert_eq!(code_spans("`a`, then `b::c`"), ["a", "b::c"]);
    }

    #[test]
    fn fenced_lines_and_links_are_found() {
        let page = "```sh\ncargo test\n```\n[a](b.md#c) [d](https://e.f) [g](#h)\n```rust\nlet x = 1;\n```\n";
        assert_eq!(fenced(page, "sh"), ["cargo test"]);
        assert_eq!(links(page), ["b.md"]);
        assert_eq!(uncommented("  cargo test  # all"), "cargo test");
        assert_eq!(uncommented("# cargo test"), "# cargo test");
    }
}
