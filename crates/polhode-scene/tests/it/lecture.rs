//! The scenes that ship with polhode, and the page that goes through the lecture row by row.

use polhode_scene::SceneFile;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every scene below `scenes/`, by its path from the root of the repository.
fn scenes() -> BTreeMap<String, SceneFile> {
    let root = repository();
    let mut found = BTreeMap::new();
    let mut folders = vec![root.join("scenes")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the folder is there") {
            let path = entry.expect("the folder can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let shown = path.strip_prefix(&root).expect("it is below the root").display().to_string();
                assert!(shown.ends_with(".toml"), "{shown} is no scene");
                found.insert(shown, SceneFile::load(&path).unwrap_or_else(|e| panic!("{e}")));
            }
        }
    }
    found
}

/// The rows of the page's tables: number, and what the last cell has between backticks.
fn rows() -> Vec<(u32, Vec<String>)> {
    let page = fs::read_to_string(repository().join("docs/book/lecture.md")).expect("the page is there");
    let table = page.lines().filter_map(|line| {
        let cells: Vec<&str> = line.strip_prefix('|')?.split('|').map(str::trim).collect();
        let number = cells.first()?.parse().ok()?;
        assert_eq!(cells.len(), 6, "row {number} has as many cells as the header");
        let spans = cells[4].split('`').skip(1).step_by(2);
        Some((number, spans.map(str::to_owned).collect()))
    });
    table.collect()
}

#[test]
fn every_scene_is_read_and_explains_itself() {
    let scenes = scenes();
    assert!(scenes.len() > 40, "only {} scenes", scenes.len());
    for (path, file) in scenes {
        let scene = &file.scene;
        for (key, text) in [("title", &scene.title), ("explanation", &scene.explanation), ("look_for", &scene.look_for)]
        {
            assert!(!text.trim().is_empty(), "{path} has no {key}");
        }
        assert!(scene.explanation.trim().lines().count() <= 2, "{path}: the explanation is longer than two lines");
        assert_eq!(
            path.starts_with("scenes/lecture/"),
            path != "scenes/mesh.toml" && !scene.row.is_empty(),
            "{path}: row"
        );
    }
}

#[test]
fn the_page_has_every_row_of_the_lecture_once() {
    let numbers: Vec<u32> = rows().into_iter().map(|(number, _)| number).collect();
    assert_eq!(numbers, (1..=57).collect::<Vec<u32>>());
}

/// `path/to/file.rs::test` is a test of that file, and another path is there.
#[test]
fn what_the_page_names_is_there() {
    let root = repository();
    for (number, named) in rows() {
        for name in named.iter().filter(|name| name.contains('/')) {
            let (path, test) = name.split_once("::").unwrap_or((name, ""));
            let text = fs::read_to_string(root.join(path)).ok().or_else(|| root.join(path).is_dir().then(String::new));
            let text = text.unwrap_or_else(|| panic!("row {number}: there is no {path}"));
            assert!(test.is_empty() || text.contains(&format!("fn {test}(")), "row {number}: {path} has no {test}");
        }
    }
}

/// A row names the scenes that show it, and those say that they do.
#[test]
fn rows_and_scenes_name_each_other() {
    let scenes = scenes();
    let rows = rows();
    for (number, named) in &rows {
        for path in named.iter().filter(|name| name.ends_with(".toml")) {
            let file = scenes.get(path).unwrap_or_else(|| panic!("row {number}: there is no {path}"));
            assert!(file.scene.row.contains(number), "row {number} names {path}, which does not name the row");
        }
    }
    for (path, file) in &scenes {
        for number in &*file.scene.row {
            let (_, named) = rows.iter().find(|(row, _)| row == number).expect("the lecture has the row");
            assert!(named.contains(path), "{path} names row {number}, which does not name it");
        }
    }
}
