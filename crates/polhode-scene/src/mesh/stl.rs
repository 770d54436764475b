//! STL, ASCII and binary.

use super::{Read, Triangles};
use polhode::math::Vec3;
use std::io::Cursor;

/// Bytes of a binary file before its triangles, and of one triangle.
const HEADER: u64 = 84;
const TRIANGLE: u64 = 50;

pub(super) fn read(bytes: &[u8]) -> Read<Triangles> {
    let count = bytes.get(80..84).map(|b| u64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])));
    // Many binary files begin with "solid" all the same, so the length decides first.
    match count.map(|count| (count, HEADER + TRIANGLE * count)) {
        Some((_, length)) if length == bytes.len() as u64 => read_binary(bytes),
        _ if is_ascii(bytes) => read_ascii(bytes),
        Some((count, length)) => Err(format!(
            "a binary STL of {count} triangles has {length} bytes, this file has {}; an ASCII one begins with `solid`",
            bytes.len()
        )),
        None => Err(format!("{} bytes are too few for a binary STL; an ASCII one begins with `solid`", bytes.len())),
    }
}

fn is_ascii(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

fn read_binary(bytes: &[u8]) -> Read<Triangles> {
    let mut triangles = Triangles::default();
    if is_ascii(bytes) {
        // The reader would take it for an ASCII file.
        let mut renamed = bytes.to_vec();
        renamed[..80].fill(0);
        add_all(&renamed, &mut triangles)?;
    } else {
        add_all(bytes, &mut triangles)?;
    }
    Ok(triangles)
}

/// A file may hold several solids, one after another; all their triangles make the mesh.
fn read_ascii(bytes: &[u8]) -> Read<Triangles> {
    let mut triangles = Triangles::default();
    let mut rest = bytes.trim_ascii_start();
    while !rest.is_empty() {
        let end = end_of_solid(rest);
        // The name of a solid means nothing here, and a line without one is as good.
        let body = rest[..end].iter().position(|&b| b == b'\n').map_or(end, |i| i + 1);
        if !is_ascii(rest) {
            return Err(format!("after triangle {}: expected `solid` or the end", triangles.corners.len()));
        }
        let solid = [b"solid _\n", &rest[body..end]].concat();
        add_all(&solid, &mut triangles)?;
        rest = rest[end..].trim_ascii_start();
    }
    Ok(triangles)
}

/// The length of the text up to and with the line `endsolid`, or of all of it.
fn end_of_solid(text: &[u8]) -> usize {
    let mut end = 0;
    for line in text.split_inclusive(|&b| b == b'\n') {
        end += line.len();
        if line.trim_ascii_start().starts_with(b"endsolid") {
            return end;
        }
    }
    end
}

fn add_all(file: &[u8], triangles: &mut Triangles) -> Read<()> {
    let mut file = Cursor::new(file);
    let at = |triangles: &Triangles, e: std::io::Error| format!("triangle {}: {e}", triangles.corners.len());
    for triangle in stl_io::create_stl_reader(&mut file).map_err(|e| at(triangles, e))? {
        let triangle = triangle.map_err(|e| at(triangles, e))?;
        triangles.add(triangle.vertices.map(|v| Vec3::from(v.0.map(f64::from))))?;
    }
    Ok(())
}
