//! glTF 2: the triangles of the scene that is shown first, each mesh where its nodes put it.

use super::{Read, Triangles, read_file};
use base64::Engine as _;
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;
use gltf::scene::Transform;
use gltf::{Accessor, Document, Gltf, Node, Primitive, Semantic};
use polhode::math::{Mat3, Quat, Vec3};
use std::path::{Component, Path, PathBuf};

/// Bytes of the header of a binary file.
const GLB_HEADER: u32 = 12;

/// `folder` is where the file lies; without one, a buffer in a file of its own is refused.
pub(super) fn read(bytes: &[u8], folder: Option<&Path>) -> Read<Triangles> {
    if let (Some(b"glTF"), Some(length)) = (bytes.get(..4), bytes.get(8..12)) {
        let length = u32::from_le_bytes([length[0], length[1], length[2], length[3]]);
        // The parser subtracts the one from the other.
        if length < GLB_HEADER {
            return Err(format!("the header says that the file has {length} bytes"));
        }
    }
    let Gltf { document, mut blob } = Gltf::from_slice_without_validation(bytes).map_err(|e| e.to_string())?;
    let document = validated(document.into_json())?;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let data = match buffer.source() {
            gltf::buffer::Source::Bin => blob.take().ok_or("the binary part is missing".to_owned()),
            gltf::buffer::Source::Uri(uri) => external(uri, folder),
        };
        buffers.push(data.map_err(|e| format!("buffer {}: {e}", buffer.index()))?);
    }
    let mut triangles = Triangles::default();
    let mut seen = vec![false; document.nodes().count()];
    let mut open: Vec<(Node, Placement)> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().map(|node| (node, Placement::HERE)).collect(),
        None => return Err("there is no scene in the file".to_owned()),
    };
    while let Some((node, outer)) = open.pop() {
        if std::mem::replace(&mut seen[node.index()], true) {
            return Err(format!("node {} has two parents, or is its own", node.index()));
        }
        let placement = outer.then(&node.transform());
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            let name = || format!("node {}, primitive {}", node.index(), primitive.index());
            add_primitive(&primitive, &placement, &buffers, &mut triangles).map_err(|e| format!("{}: {e}", name()))?;
        }
        open.extend(node.children().map(|child| (child, placement)));
    }
    Ok(triangles)
}

/// The document after the library's own checks, which themselves trust the accessors of a primitive to be there.
fn validated(json: gltf::json::Root) -> Read<Document> {
    for (number, mesh) in json.meshes.iter().enumerate() {
        for accessor in mesh.primitives.iter().flat_map(|primitive| primitive.attributes.values()) {
            if accessor.value() >= json.accessors.len() {
                return Err(format!("mesh {number}: there is no accessor {}", accessor.value()));
            }
        }
    }
    Document::from_json(json).map_err(|e| e.to_string())
}

/// The bytes that a URI of a buffer stands for: base64 in the file itself, or a file beside it. Never the network.
fn external(uri: &str, folder: Option<&Path>) -> Read<Vec<u8>> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").ok_or("a data URI must be in base64")?.1;
        return base64::engine::general_purpose::STANDARD.decode(encoded).map_err(|e| format!("in the data URI: {e}"));
    }
    let shown: String = uri.chars().take(100).collect();
    let folder = folder.ok_or_else(|| format!("cannot follow {shown:?} from here"))?;
    let path = PathBuf::from(unescaped(uri).ok_or_else(|| format!("{shown:?} is not a proper URI"))?);
    let inside = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    if !inside || uri.contains([':', '\\']) {
        return Err(format!("{shown:?} leads out of the folder of the file"));
    }
    read_file(&folder.join(path)).map_err(|e| format!("{shown:?}: {e}"))
}

/// A URI with its `%20` and the like resolved.
fn unescaped(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let digits = [rest.next()?, rest.next()?];
            bytes.push(u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok().filter(|path| !path.contains('\0'))
}

/// x ↦ linear x + origin.
#[derive(Clone, Copy)]
struct Placement {
    linear: Mat3,
    origin: Vec3,
}

impl Placement {
    const HERE: Self = Self { linear: Mat3::IDENTITY, origin: Vec3::ZERO };

    fn point(&self, p: Vec3) -> Vec3 {
        self.linear * p + self.origin
    }

    fn then(&self, inner: &Transform) -> Self {
        let wide = |v: [f32; 3]| Vec3::from(v.map(f64::from));
        let inner = match inner {
            Transform::Matrix { matrix: [a, b, c, d] } => {
                let column = |v: &[f32; 4]| wide([v[0], v[1], v[2]]);
                Self { linear: Mat3::from_cols(column(a), column(b), column(c)), origin: column(d) }
            }
            // In f64, because f32 quaternions are units to seven digits only.
            &Transform::Decomposed { translation, rotation: [x, y, z, w], scale } => {
                let turn = Quat::new(f64::from(w), f64::from(x), f64::from(y), f64::from(z)).normalized().to_mat3();
                Self { linear: turn * Mat3::diagonal(wide(scale)), origin: wide(translation) }
            }
        };
        Self { linear: self.linear * inner.linear, origin: self.point(inner.origin) }
    }
}

fn add_primitive(primitive: &Primitive, place: &Placement, buffers: &[Vec<u8>], triangles: &mut Triangles) -> Read<()> {
    let mode = primitive.mode();
    if !matches!(mode, Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
        return Ok(());
    }
    let accessor = primitive.get(&Semantic::Positions).ok_or("it has no positions")?;
    let positions = Values::new(&accessor, buffers)?;
    if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
        return Err("its positions are not three numbers of 32 bits".to_owned());
    }
    let indices =
        primitive.indices().map(|accessor| Values::new(&accessor, buffers).map(|v| (v, accessor.data_type())));
    let indices = indices.transpose()?;
    let count = indices.as_ref().map_or(positions.count, |(indices, _)| indices.count);
    let corner = |i: usize| -> Read<Vec3> {
        let vertex = match &indices {
            Some((indices, kind)) => indices.index(i, *kind).ok_or("its indices are no whole numbers")?,
            None => i,
        };
        let missing = || format!("vertex {vertex} does not exist, of {}", positions.count);
        positions.vector(vertex).map(|p| place.point(p)).ok_or_else(missing)
    };
    // A mirror turns the surface inside out; the other order of corners turns it back.
    let mirrored = place.linear.determinant() < 0.0;
    let n_triangles = match mode {
        Mode::Triangles => count / 3,
        _ => count.saturating_sub(2),
    };
    for i in 0..n_triangles {
        let [a, b, c] = match mode {
            Mode::Triangles => [3 * i, 3 * i + 1, 3 * i + 2],
            Mode::TriangleStrip if i % 2 == 1 => [i + 1, i, i + 2],
            Mode::TriangleStrip => [i, i + 1, i + 2],
            _ => [0, i + 1, i + 2],
        };
        let [a, b, c] = [corner(a)?, corner(b)?, corner(c)?];
        triangles.add(if mirrored { [a, c, b] } else { [a, b, c] })?;
    }
    Ok(())
}

/// The values of an accessor, all inside the buffer.
struct Values<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
}

impl<'a> Values<'a> {
    fn new(accessor: &Accessor, buffers: &'a [Vec<u8>]) -> Read<Self> {
        let number = accessor.index();
        if accessor.sparse().is_some() {
            return Err(format!("accessor {number} is sparse, which polhode does not read"));
        }
        let view = accessor.view().ok_or_else(|| format!("accessor {number} has no data (is the mesh compressed?)"))?;
        let stride = view.stride().unwrap_or(accessor.size());
        let count = accessor.count();
        let outside = || format!("accessor {number} reaches outside its buffer");
        let buffer = buffers.get(view.buffer().index()).ok_or_else(outside)?;
        let end = view.offset().checked_add(view.length()).ok_or_else(outside)?;
        let bytes =
            buffer.get(view.offset()..end).and_then(|bytes| bytes.get(accessor.offset()..)).ok_or_else(outside)?;
        let needed = match count {
            0 => Some(0),
            _ => stride.checked_mul(count - 1).and_then(|bytes| bytes.checked_add(accessor.size())),
        };
        match needed {
            Some(needed) if needed <= bytes.len() && (stride > 0 || count <= 1) => Ok(Self { bytes, stride, count }),
            _ => Err(outside()),
        }
    }

    fn get<const N: usize>(&self, i: usize) -> Option<[u8; N]> {
        let start = (i < self.count).then(|| self.stride * i)?;
        self.bytes.get(start..start + N)?.try_into().ok()
    }

    fn vector(&self, i: usize) -> Option<Vec3> {
        let bytes: [u8; 12] = self.get(i)?;
        let at = |k: usize| f64::from(f32::from_le_bytes([bytes[k], bytes[k + 1], bytes[k + 2], bytes[k + 3]]));
        Some(Vec3::new(at(0), at(4), at(8)))
    }

    fn index(&self, i: usize, kind: DataType) -> Option<usize> {
        match kind {
            DataType::U8 => self.get(i).map(|b: [u8; 1]| usize::from(b[0])),
            DataType::U16 => self.get(i).map(|b| usize::from(u16::from_le_bytes(b))),
            DataType::U32 => self.get(i).map(|b| u32::from_le_bytes(b) as usize),
            _ => None,
        }
    }
}
