//! A scene together with the text it was read from.

use super::{Scene, check};
use crate::decode::{At, Decode, Item, Sink};
use crate::error::{SceneError, Source};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};

/// A scene and its text, so that a problem found later can still be shown where it stands.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The scene.
    pub scene: Scene,
    name: String,
    text: String,
}

/// The largest scene file that is read: 16 MiB. Meshes are files of their own.
const MOST_BYTES: u64 = 16 << 20;

impl SceneFile {
    /// Reads a scene from a file.
    ///
    /// # Errors
    /// If the file cannot be read, is no UTF-8 or larger than 16 MiB, and for all that [`SceneFile::parse`] refuses.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, SceneError> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let whole = |message: String| SceneError::whole(&name, message);
        let size = std::fs::metadata(path).map_err(|e| whole(format!("cannot read the scene: {e}")))?.len();
        if size > MOST_BYTES {
            return Err(whole(format!("a scene file of {size} bytes; the limit is {MOST_BYTES}")));
        }
        let bytes = std::fs::read(path).map_err(|e| whole(format!("cannot read the scene: {e}")))?;
        let text = String::from_utf8(bytes).map_err(|e| whole(format!("the scene is not UTF-8: {e}")))?;
        Self::parse(&name, &text)
    }

    /// Reads a scene from its text. `name` is the path of its file, from which meshes are found and which errors print.
    ///
    /// # Errors
    /// If the text is not TOML, has an unknown key, lacks a needed one, has a value of the wrong type or out of range,
    /// or names a body that is not there: all such places, at most twenty.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        let source = Source { text };
        let table = DeTable::parse(text).map_err(|e| {
            let span = e.span().unwrap_or(0..0);
            SceneError::new(name, vec![source.problem(span, String::new(), e.message().to_owned(), None)])
        })?;
        let span = table.span();
        let root = DeValue::Table(table.into_inner());
        let mut out = Sink::new(source);
        let item = Item { value: &root, span: first_line(text, span), at: At::Root };
        let scene = Scene::decode(&item, &mut out);
        if let Some(scene) = scene.filter(|_| out.problems.is_empty()) {
            for (path, message, help) in check::scene(&scene) {
                out.note(locate(&root, &item.span, &path), path, message, help);
            }
            if out.problems.is_empty() {
                return Ok(Self { scene, name: name.to_owned(), text: text.to_owned() });
            }
        }
        out.problems.sort_by_key(|problem| (problem.line, problem.column));
        Err(SceneError::new(name, out.problems))
    }

    /// The path of the file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The folder that the paths in the scene are relative to.
    pub fn folder(&self) -> PathBuf {
        Path::new(&self.name).parent().map_or_else(PathBuf::new, Path::to_path_buf)
    }

    /// The same error, shown at the place in the file that its path names (`body[3].inertia`), or at the nearest one.
    pub fn error(&self, error: &polhode::Error) -> SceneError {
        let source = Source { text: &self.text };
        let span = DeTable::parse(&self.text).map_or(0..0, |table| {
            let whole = first_line(&self.text, table.span());
            locate(&DeValue::Table(table.into_inner()), &whole, error.path())
        });
        let problem = source.problem(span, error.path().to_owned(), error.message().to_owned(), None);
        SceneError::new(&self.name, vec![problem])
    }
}

/// A problem of the whole file is shown at its first line.
fn first_line(text: &str, span: Range<usize>) -> Range<usize> {
    span.start.min(text.len())..text.find('\n').unwrap_or(text.len())
}

/// The bytes of the value at `path`, or of the innermost table on the way that exists.
fn locate(root: &DeValue, whole: &Range<usize>, path: &str) -> Range<usize> {
    let mut value = root;
    let mut span = whole.clone();
    for step in path.split(['.', '[']).filter(|step| !step.is_empty()) {
        let next = match step.strip_suffix(']') {
            Some(index) => match (value, index.parse::<usize>()) {
                (DeValue::Array(items), Ok(index)) => items.get(index),
                // A single shape may stand without its list.
                (DeValue::Table(_), Ok(0)) => continue,
                _ => None,
            },
            None => value.as_table().and_then(|table| table.get(step)),
        };
        let Some(next) = next else { break };
        value = next.get_ref();
        span = next.span();
    }
    span
}
