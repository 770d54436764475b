//! `polhode lab`: every scene as a page to play with, and an index of them.
//!
//! The scenes and meshes are part of the program. They are laid out in a folder, so that they can be changed and run, and
//! each becomes one self-contained page; the pages need no server, but one is started for comfort.

mod index;
mod serve;

use crate::run::{create, page_of_scene, save, scene_error};
use crate::{Outcome, Progress, Refusal, Terminal};
use include_dir::{Dir, DirEntry, include_dir};
use index::Entry;
use polhode_scene::SceneFile;
use polhode_scene::recording::{Link, PageInfo};
use std::path::{Path, PathBuf};

static SCENES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../scenes");
static ASSETS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../assets");

/// See the lecture: an index of scenes, each as a page to play with
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The folder for the pages; pages that are there are written anew
    #[arg(long, value_name = "DIR", default_value = "out/lab")]
    out: PathBuf,
    /// Only the scenes whose path contains this
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Write the pages and stop, without serving them
    #[arg(long)]
    no_serve: bool,
    /// The port on this machine; a free one if absent
    #[arg(long, value_name = "N", default_value_t = 0)]
    port: u16,
    /// Do not open a browser
    #[arg(long)]
    no_open: bool,
}

impl Arguments {
    /// Writes the pages and serves them until it is stopped.
    pub(crate) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        lay_out(&SCENES, &self.out.join("scenes"))?;
        lay_out(&ASSETS, &self.out.join("assets"))?;
        let wanted: Vec<PathBuf> = scenes()
            .into_iter()
            .filter(|path| self.only.as_ref().is_none_or(|text| path.to_string_lossy().contains(text.as_str())))
            .collect();
        if wanted.is_empty() {
            let text = self.only.clone().unwrap_or_default();
            return Err(Refusal::Input(format!("no scene's path contains `{text}`")));
        }
        let entries = self.write_pages(&wanted)?;
        let (path, file) = create(self.out.join("index.html"))?;
        save(&path, file, index::html(&entries).as_bytes())?;
        writeln!(terminal.out, "{} pages, and their index {}", entries.len(), path.display())?;
        if self.no_serve {
            return Ok(Outcome::Done);
        }
        serve::folder(&self.out, self.port, !self.no_open, terminal)?;
        Ok(Outcome::Done)
    }

    fn write_pages(&self, wanted: &[PathBuf]) -> Result<Vec<Entry>, Refusal> {
        let bar = Progress::new(wanted.len() as u64);
        let mut entries = Vec::with_capacity(wanted.len());
        for scene in wanted {
            bar.say(scene.display().to_string());
            let file = SceneFile::load(self.out.join("scenes").join(scene)).map_err(scene_error)?;
            let page = scene.with_extension("html");
            let up = "../".repeat(scene.components().count());
            let info = PageInfo {
                row: index::rows(&file.scene.row.0),
                links: vec![
                    Link { href: format!("{up}index.html"), text: "All scenes".into() },
                    Link { href: format!("{up}scenes/{}", slashes(scene)), text: "The scene's file".into() },
                ],
                ..PageInfo::default()
            };
            let (path, out) = create(self.out.join("pages").join(&page))?;
            save(&path, out, page_of_scene(&file, &info)?.as_bytes())?;
            entries.push(Entry {
                group: slashes(scene.parent().unwrap_or(Path::new(""))),
                href: format!("pages/{}", slashes(&page)),
                scene: format!("scenes/{}", slashes(scene)),
                title: file.scene.title.clone(),
                explanation: file.scene.explanation.clone(),
                rows: file.scene.row.0.clone(),
            });
            bar.advance(1);
        }
        Ok(entries)
    }
}

/// A path with forward slashes, as a page names it.
fn slashes(path: &Path) -> String {
    path.components().map(|c| c.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// The scenes of the program, in the order of their paths.
pub(crate) fn scenes() -> Vec<PathBuf> {
    fn collect(dir: &Dir, into: &mut Vec<PathBuf>) {
        for entry in dir.entries() {
            match entry {
                DirEntry::Dir(dir) => collect(dir, into),
                DirEntry::File(file) => {
                    if file.path().extension().is_some_and(|e| e == "toml") {
                        into.push(file.path().to_path_buf());
                    }
                }
            }
        }
    }
    let mut paths = Vec::new();
    collect(&SCENES, &mut paths);
    paths.sort();
    paths
}

/// Writes the files of the program to a folder.
fn lay_out(dir: &Dir, folder: &Path) -> Result<(), Refusal> {
    for entry in dir.entries() {
        match entry {
            DirEntry::Dir(inner) => lay_out(inner, folder)?,
            DirEntry::File(file) => {
                let (path, out) = create(folder.join(file.path()))?;
                save(&path, out, file.contents())?;
            }
        }
    }
    Ok(())
}
