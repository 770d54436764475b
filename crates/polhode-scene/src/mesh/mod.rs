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
use std::collections::HashMap;
use std::fmt;
use std::path::Path;

/// A surface of triangles.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct TriMesh {
    /// Vertices, in the unit of the file, no two equal, in the order in which the triangles first use them.
    pub positions: Vec<Vec3>,
    /// Corners of each triangle, counterclockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

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

impl TriMesh {
    /// Reads a mesh from a file; a `.gltf` may name buffers in its own folder or below.
    ///
    /// # Errors
    /// If the file cannot be read, its name has an ending of no known format, or for all that [`TriMesh::parse`] refuses.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, MeshError> {
        let path = path.as_ref();
        let wrong = |message: String| MeshError { file: path.display().to_string(), message };
        let format = Format::of(path)
            .ok_or_else(|| wrong("not a mesh that polhode reads: .obj, .stl, .ply, .gltf or .glb".to_owned()))?;
        let bytes = read_file(path).map_err(wrong)?;
        let mesh = match format {
            Format::Gltf => gltf::read(&bytes, path.parent()),
            _ => read(format, &bytes),
        };
        mesh.map_err(wrong)
    }

    /// Reads a mesh from the bytes of a file called `name`, which only errors use. No other file is opened.
    ///
    /// # Errors
    /// If the bytes are not of that format, a count, index or coordinate in them is wrong, or there is no triangle.
    pub fn parse(name: &str, format: Format, bytes: &[u8]) -> Result<Self, MeshError> {
        read(format, bytes).map_err(|message| MeshError { file: name.to_owned(), message })
    }

    /// The same surface with every coordinate multiplied by `scale`, metres in one unit of the file.
    pub fn scaled(mut self, scale: f64) -> Self {
        for position in &mut self.positions {
            *position *= scale;
        }
        self
    }
}

/// Messages of this module have no file name; [`TriMesh::load`] puts it in front.
type Read<T> = Result<T, String>;

fn read(format: Format, bytes: &[u8]) -> Read<TriMesh> {
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

/// Collects triangles and gives equal corners one index.
#[derive(Default)]
struct Builder {
    mesh: TriMesh,
    index_of: HashMap<[u64; 3], u32>,
}

impl Builder {
    fn triangle(&mut self, corners: [Vec3; 3]) -> Read<()> {
        let number = self.mesh.triangles.len();
        self.polygon(&corners).map_err(|e| format!("triangle {number}: {e}"))
    }

    /// Adds a polygon as a fan of triangles around its first corner.
    fn polygon(&mut self, corners: &[Vec3]) -> Read<()> {
        if corners.len() < 3 {
            return Err(format!("{} corners do not make a face", corners.len()));
        }
        let mut indices = Vec::with_capacity(corners.len());
        for &corner in corners {
            indices.push(self.corner(corner)?);
        }
        self.mesh.triangles.extend(indices.windows(2).skip(1).map(|pair| [indices[0], pair[0], pair[1]]));
        if self.mesh.triangles.len() > MOST_TRIANGLES {
            return Err(format!("more than {MOST_TRIANGLES} triangles"));
        }
        Ok(())
    }

    fn corner(&mut self, p: Vec3) -> Read<u32> {
        if !p.is_finite() {
            return Err(format!("a corner at ({}, {}, {}) is not finite", p.x, p.y, p.z));
        }
        // Adding zero turns −0 into +0, which equals it.
        let key = p.to_array().map(|x| (x + 0.0).to_bits());
        let next = self.mesh.positions.len() as u32;
        let index = *self.index_of.entry(key).or_insert(next);
        if index == next {
            self.mesh.positions.push(p);
        }
        Ok(index)
    }

    fn finish(self) -> Read<TriMesh> {
        if self.mesh.triangles.is_empty() {
            return Err("the file holds no triangle".to_owned());
        }
        Ok(self.mesh)
    }
}
