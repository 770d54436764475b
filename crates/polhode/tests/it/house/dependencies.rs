//! Dependencies of the engine: a closed list, each with its sentence in `ARCHITECTURE.md`.

use super::documents::{code_spans, table};
use super::source::{engine, read, repository};
use std::collections::BTreeMap;
use toml::{Table, Value};

/// What the engine may depend on, and whether only as an option that a user asks for.
const ALLOWED: [(&str, bool); 7] = [
    ("fearless_simd", false),
    ("libm", false),
    ("rayon", false),
    ("robust", false),
    ("glam", true),
    ("mint", true),
    ("serde", true),
];

/// The tables of normal and build dependencies in a manifest, also those of single targets.
fn tables(manifest: &Table) -> Vec<&Table> {
    let targets = manifest.get("target").and_then(Value::as_table).into_iter().flat_map(Table::values);
    let holders = std::iter::once(manifest).chain(targets.filter_map(Value::as_table));
    let kinds = |holder| ["dependencies", "build-dependencies"].map(|kind| Table::get(holder, kind));
    holders.flat_map(kinds).flatten().filter_map(Value::as_table).collect()
}

/// The dependencies of a manifest by the name of their package, and whether each is optional.
fn dependencies(manifest: &Table) -> BTreeMap<String, bool> {
    let mut found = BTreeMap::new();
    for (key, value) in tables(manifest).into_iter().flatten() {
        let package = value.get("package").and_then(Value::as_str).unwrap_or(key);
        let optional = value.get("optional").and_then(Value::as_bool).unwrap_or(false);
        found.insert(package.to_string(), optional);
    }
    found
}

/// Complaints about a manifest.
fn complaints(manifest: &str) -> Vec<String> {
    let manifest: Table = manifest.parse().expect("a manifest is TOML");
    let judge = |(name, optional): (String, bool)| match ALLOWED.iter().find(|(allowed, _)| *allowed == name) {
        None => Some(format!("`{name}` is not among the allowed dependencies of the engine")),
        Some((_, true)) if !optional => Some(format!("`{name}` may only be an optional dependency")),
        Some((_, false)) if optional => Some(format!("`{name}` may not be optional: no feature changes a result")),
        Some(_) => None,
    };
    dependencies(&manifest).into_iter().filter_map(judge).collect()
}

#[test]
fn the_engine_depends_on_nothing_else() {
    let complaints = complaints(&read(&engine().join("Cargo.toml")));
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn each_dependency_has_its_sentence() {
    let Some(root) = repository() else { return };
    let mut explained = Vec::new();
    for row in table(&read(&root.join("ARCHITECTURE.md")), "## Dependencies of the engine") {
        assert!(row[1].ends_with('.') && row[1].len() > 20, "ARCHITECTURE.md: no sentence for {}", row[0]);
        let optional = row[0].ends_with(", optional");
        explained.extend(code_spans(&row[0]).into_iter().map(|name| (name, optional)));
    }
    let allowed = ALLOWED.map(|(name, optional)| (name.to_string(), optional));
    assert_eq!(explained, allowed, "explained in ARCHITECTURE.md (left) and allowed (right)");
}

mod control {
    use super::*;

    #[test]
    fn a_further_dependency_fails_wherever_it_hides() {
        for text in [
            "[dependencies]\nhashbrown = \"1\"",
            "[dependencies.hashbrown]\nversion = \"1\"",
            "[dependencies]\nlibm = { package = \"hashbrown\", version = \"1\" }",
            "[build-dependencies]\ncc = \"1\"",
            "[target.'cfg(unix)'.dependencies]\nlibc = \"1\"",
            "[dependencies]\nglam = \"1\"",
            "[dependencies]\nrayon = { version = \"1\", optional = true }",
        ] {
            assert_eq!(complaints(text).len(), 1, "{text}");
        }
        assert!(
            complaints("[dependencies]\nlibm.workspace = true\nmint = { version = \"1\", optional = true }").is_empty()
        );
        assert!(complaints("[dev-dependencies]\nproptest = \"1\"").is_empty());
    }
}
