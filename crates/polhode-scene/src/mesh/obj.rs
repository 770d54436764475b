//! Wavefront OBJ.

use super::{Read, Triangles};
use polhode::math::Vec3;
use std::cell::Cell;
use std::io::BufRead;
use tobj::{LoadError, LoadOptions};

pub(super) fn read(bytes: &[u8]) -> Read<Triangles> {
    let text = String::from_utf8_lossy(bytes);
    let line = Cell::new(0);
    let mut statements = Statements { rest: &text, buffer: Vec::new(), read: 0, line: &line };
    let options = LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (models, _) = tobj::load_obj_buf(&mut statements, &options, no_materials).map_err(|e| match e {
        // These two are found at the end, when the line is no longer known.
        LoadError::FaceVertexOutOfBounds => missing_vertex(&text),
        LoadError::InvalidPolygon => "a face has no corners".to_owned(),
        e => format!("line {}: {e}", line.get()),
    })?;
    let mut triangles = Triangles::default();
    for model in &models {
        let mesh = &model.mesh;
        let corner = |i: u32| match mesh.positions.get(3 * i as usize..3 * i as usize + 3) {
            Some(&[x, y, z]) => Ok(Vec3::new(x, y, z)),
            _ => Err(missing_vertex(&text)),
        };
        for triangle in mesh.indices.chunks_exact(3) {
            triangles.add([corner(triangle[0])?, corner(triangle[1])?, corner(triangle[2])?])?;
        }
    }
    Ok(triangles)
}

/// The lines of the file that make the surface, `v` and `f`, one at a time, with continued lines joined.
///
/// The rest stays away from the parser: materials would be other files, and texture and normal indices are nothing to us.
struct Statements<'a> {
    rest: &'a str,
    buffer: Vec<u8>,
    read: usize,
    line: &'a Cell<usize>,
}

impl Statements<'_> {
    fn next(&mut self) {
        self.read = 0;
        self.buffer.clear();
        let mut continued = false;
        while !self.rest.is_empty() {
            let (line, rest) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
            self.rest = rest;
            self.line.set(self.line.get() + 1);
            let line = line.trim();
            if continued || matches!(line.split_whitespace().next(), Some("v" | "f")) {
                let (part, more) = line.strip_suffix('\\').map_or((line, false), |part| (part, true));
                self.buffer.extend_from_slice(without_attributes(part).as_bytes());
                self.buffer.push(if more { b' ' } else { b'\n' });
                continued = more;
                if !more {
                    return;
                }
            }
        }
    }
}

/// A statement without its comment, and a face without the indices after `/`.
fn without_attributes(line: &str) -> String {
    let line = line.split('#').next().unwrap_or_default();
    line.split_whitespace().map(|word| word.split('/').next().unwrap_or_default()).collect::<Vec<_>>().join(" ")
}

impl std::io::Read for Statements<'_> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        let n = std::io::Read::read(&mut self.fill_buf()?, out)?;
        self.consume(n);
        Ok(n)
    }
}

impl BufRead for Statements<'_> {
    fn fill_buf(&mut self) -> std::io::Result<&[u8]> {
        if self.read >= self.buffer.len() {
            self.next();
        }
        Ok(&self.buffer[self.read..])
    }
    fn consume(&mut self, n: usize) {
        self.read = self.buffer.len().min(self.read + n);
    }
}

/// Which face names a vertex that is not there. Negative indices count back from the face.
fn missing_vertex(text: &str) -> String {
    let total = text.lines().filter(|line| line.split_whitespace().next() == Some("v")).count();
    let mut before = 0_usize;
    for (i, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => before += 1,
            Some("f") => {
                for word in words {
                    let index: i64 = word.split('/').next().and_then(|word| word.parse().ok()).unwrap_or(0);
                    let known = if index < 0 { before } else { total };
                    if index == 0 || index.unsigned_abs() > known as u64 {
                        return format!("line {}: vertex {index} does not exist, of {total}", i + 1);
                    }
                }
            }
            _ => {}
        }
    }
    "a face names a vertex that does not exist".to_owned()
}
