//! The scenes that ship with polhode, and the page that goes through the lecture row by row.

use polhode::world::BodyRef;
use polhode_scene::{Run, SceneFile};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn is_scene(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|extension| extension == "toml")
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
                assert!(is_scene(&shown), "{shown} is no scene");
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
        for path in named.iter().filter(|name| is_scene(name)) {
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

#[test]
fn every_scene_runs_to_its_end() {
    for (path, file) in scenes() {
        for variant in file.scene.variants() {
            let mut run = Run::new(&file, &variant).unwrap_or_else(|e| panic!("{e}"));
            let summary = run.finish();
            assert!(summary.quarantined.is_empty() && !summary.stalled, "{path}, {}: {summary:?}", variant.label);
            assert!(run.world().energy().total().is_finite(), "{path}, {}: the energy is no number", variant.label);
        }
    }
}

/// The variants of a scene of the lecture, run to the end.
fn ends(scene: &str) -> Vec<Run> {
    let file = SceneFile::load(repository().join("scenes/lecture").join(scene)).unwrap_or_else(|e| panic!("{e}"));
    let run = |variant| {
        let mut run = Run::new(&file, &variant).unwrap_or_else(|e| panic!("{e}"));
        run.finish();
        run
    };
    file.scene.variants().into_iter().map(run).collect()
}

fn body<'a>(run: &'a Run, name: &str) -> BodyRef<'a> {
    run.world().bodies().find(|body| body.name() == Some(name)).expect("the scene has the body")
}

/// A sum of n terms, each of which rounds at half an epsilon of it, is this close.
fn near(value: f64, right: f64, n: u32) -> bool {
    (value - right).abs() <= f64::from(n) * f64::EPSILON * right.abs().max(1.0)
}

#[test]
fn a_push_off_the_centre_moves_the_centre_but_not_by_the_slide() {
    let runs = ends("40-kicked-puck.toml");
    // J = 0.6 N·s on 1 kg and 0.045 kg·m²: ω = −y J / I. The slide's J (J·r) knows only the part along the lever, −0.18.
    for (name, spin, literal) in
        [("centre", 0.0, 0.0), ("half", -2.0, 0.0), ("rim", -4.0, 0.0), ("behind", 0.0, 0.6 * -0.18)]
    {
        let [right, slide] = [0, 1].map(|i| body(&runs[i], name));
        assert!(near(right.velocity().x, 0.6, 4) && near(slide.velocity().x, literal, 4), "{name}");
        let [w, w_slide] = [right, slide].map(|puck| puck.angular_velocity().z);
        assert!(near(w, spin, 8) && near(w_slide, -spin, 8), "{name} {w} {w_slide}");
    }
}

#[test]
fn the_slides_last_moment_is_thirteen_fifths_of_the_right_one() {
    let runs = ends("50-inertia.toml");
    // 0.2 N·m for 10 s on m(a² + b²)/12 and on m(b² + c²)/12, of a box of 0.4 × 0.8 × 1.2 m and 6 kg; 1200 steps are summed.
    let [right, slide] = [0, 1].map(|i| body(&runs[i], "blue").angular_velocity().z);
    assert!(near(right, 2.0 / 0.4, 1200) && near(slide, 2.0 / 1.04, 1200), "{right} {slide}");
}

#[test]
fn the_slides_r_grows_3713_times() {
    let runs = ends("42-drift-of-r.toml");
    let slab = body(&runs[0], "slab").id();
    let r = runs[0].world().drifting_matrix(slab).expect("the slide's scheme keeps a matrix");
    let growth = r.cols[0].length();
    // 600 factors √(1 + 1/36), each of a few roundings.
    let right = (0..300).fold(1.0, |product, _| product * (1.0 + 1.0 / 36.0));
    assert!(
        (growth / right - 1.0).abs() < 600.0 * 4.0 * f64::EPSILON && (3713.0..3714.0).contains(&growth),
        "{growth}"
    );
}

#[test]
fn the_slides_pendulum_leaves_the_bottom() {
    let runs = ends("56-pendulum.toml");
    // It starts at rest, 30° from the bottom: E = −F l cos 30° lets it no farther up, and with the other sign no farther down.
    let lowest = |run: &Run| body(run, "wheel").axes().cols[2].z;
    let start = (3.0_f64).sqrt() / 2.0;
    // Verlet's energy is off by less than a share h²ω² of its swing (1/8 of that on a linear oscillator), with ω² = F l / I.
    let off = 5.0 * 0.5 / 0.5 / (240.0 * 240.0);
    assert!(lowest(&runs[0]) > start - off && lowest(&runs[1]) < start + off);
}
