//! Triangle meshes from files: OBJ, STL, PLY, glTF.
//!
//! Coordinates are taken as the file has them (glTF: after the transforms of its nodes); no axis is swapped and no unit
//! assumed. Corners with equal coordinates become one vertex, because STL shares none and the others split theirs where
//! normals or colours differ, while a closed surface needs them shared.
//!
//! A file is believed in nothing: counts are compared with its length before memory is taken, and every index is checked.

mod gltf;
mod obj;
mod ply;
mod stl;

use polhode::math::Vec3;
use polhode::shape::TriangleMesh;
use std::fmt;
use std::path::Path;

/// A mesh file was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshError {
    file: String,
    message: String,
}

impl MeshError {
    /// The file.
    pub fn file(&self) -> &str {
        &self.file
    }
    /// What is wrong with it, and where in it.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.message)
    }
}

impl std::error::Error for MeshError {}

/// The formats that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ, `.obj`.
    Obj,
    /// STL, ASCII or binary, `.stl`.
    Stl,
    /// PLY, ASCII or binary, `.ply`.
    Ply,
    /// glTF 2, JSON or binary, `.gltf` or `.glb`.
    Gltf,
}

/// The largest mesh file that is read: 512 MiB.
const MOST_BYTES: u64 = 512 << 20;
/// The most triangles of a mesh. Only glTF can ask for more than its file is long, by drawing one mesh many times.
const MOST_TRIANGLES: usize = 10_000_000;

impl Format {
    /// The format that the ending of a file's name stands for.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "ply" => Some(Self::Ply),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }
}

/// Reads a mesh from a file; a `.gltf` may name buffers in its own folder or below. `scale` is how many metres one unit of
/// the file is.
///
/// # Errors
/// If the file cannot be read, its name has an ending of no known format, or for all that [`parse`] refuses.
pub fn load(path: impl AsRef<Path>, scale: f64) -> Result<TriangleMesh, MeshError> {
    let path = path.as_ref();
    let wrong = |message: String| MeshError { file: path.display().to_string(), message };
    let format = Format::of(path)
        .ok_or_else(|| wrong("not a mesh that polhode reads: .obj, .stl, .ply, .gltf or .glb".to_owned()))?;
    let bytes = read_file(path).map_err(wrong)?;
    let triangles = match format {
        Format::Gltf => gltf::read(&bytes, path.parent()),
        _ => read(format, &bytes),
    };
    triangles.and_then(|triangles| triangles.finish(scale)).map_err(wrong)
}

/// Reads a mesh from the bytes of a file called `name`, which only errors use. No other file is opened. `scale` is how many
/// metres one unit of the file is.
///
/// # Errors
/// If the bytes are not of that format, a count, index or coordinate in them is wrong, or there is no triangle.
pub fn parse(name: &str, format: Format, bytes: &[u8], scale: f64) -> Result<TriangleMesh, MeshError> {
    let mesh = read(format, bytes).and_then(|triangles| triangles.finish(scale));
    mesh.map_err(|message| MeshError { file: name.to_owned(), message })
}

/// Messages of this module have no file name; [`load`] puts it in front.
type Read<T> = Result<T, String>;

fn read(format: Format, bytes: &[u8]) -> Read<Triangles> {
    match format {
        Format::Obj => obj::read(bytes),
        Format::Stl => stl::read(bytes),
        Format::Ply => ply::read(bytes),
        Format::Gltf => gltf::read(bytes, None),
    }
}

fn read_file(path: &Path) -> Read<Vec<u8>> {
    let cannot = |e: std::io::Error| format!("cannot read the file: {e}");
    let size = std::fs::metadata(path).map_err(cannot)?.len();
    if size > MOST_BYTES {
        return Err(format!("the file has {size} bytes; the limit is {MOST_BYTES}"));
    }
    std::fs::read(path).map_err(cannot)
}

/// Triangles as a file gives them, each with corners of its own.
#[derive(Default)]
struct Triangles {
    corners: Vec<[Vec3; 3]>,
}

impl Triangles {
    fn add(&mut self, corners: [Vec3; 3]) -> Read<()> {
        let number = self.corners.len();
        self.polygon(&corners).map_err(|e| format!("triangle {number}: {e}"))
    }

    /// Adds a polygon as a fan of triangles around its first corner.
    fn polygon(&mut self, corners: &[Vec3]) -> Read<()> {
        if corners.len() < 3 {
            return Err(format!("{} corners do not make a face", corners.len()));
        }
        if let Some(p) = corners.iter().find(|p| !p.is_finite()) {
            return Err(format!("a corner at ({}, {}, {}) is not finite", p.x, p.y, p.z));
        }
        self.corners.extend(corners.windows(2).skip(1).map(|pair| [corners[0], pair[0], pair[1]]));
        if self.corners.len() > MOST_TRIANGLES {
            return Err(format!("more than {MOST_TRIANGLES} triangles"));
        }
        Ok(())
    }

    fn finish(self, scale: f64) -> Read<TriangleMesh> {
        if self.corners.is_empty() {
            return Err("the file holds no triangle".to_owned());
        }
        let positions = self.corners.iter().flatten().map(|&p| p * scale).collect();
        let triangles = (0..self.corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = TriangleMesh::new(positions, triangles).map_err(|e| e.to_string())?.merged();
        if mesh.triangles().is_empty() {
            return Err("every triangle of the file has two corners in one point".to_owned());
        }
        Ok(mesh)
    }
}
