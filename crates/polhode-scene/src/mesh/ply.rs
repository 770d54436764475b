//! PLY, ASCII and binary.

use super::{Read, Triangles};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use polhode::math::Vec3;

pub(super) fn read(bytes: &[u8]) -> Read<Triangles> {
    let parser = Parser::<Element>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(|e| brief(&e))?;
    check_sizes(&header, reader.get_ref().len() as u64)?;
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for element in header.elements.values() {
        let read = parser.read_payload_for_element(&mut reader, element, &header).map_err(|e| brief(&e))?;
        match element.name.as_str() {
            "vertex" => vertices = read,
            "face" => faces = read,
            _ => {}
        }
    }
    let mut triangles = Triangles::default();
    for (number, face) in faces.iter().enumerate() {
        let corner = |&i: &i64| {
            let vertex = usize::try_from(i).ok().and_then(|i| vertices.get(i));
            let vertex =
                vertex.ok_or_else(|| format!("face {number}: vertex {i} does not exist, of {}", vertices.len()));
            vertex.map(|vertex| Vec3::from(vertex.position))
        };
        let corners: Vec<Vec3> = face.corners.iter().map(corner).collect::<Read<_>>()?;
        triangles.polygon(&corners).map_err(|e| format!("face {number}: {e}"))?;
    }
    Ok(triangles)
}

/// The parser's message without the copy of the whole line that it carries.
fn brief(error: &ply_rs_bw::parser::ParseError) -> String {
    let text = error.to_string();
    text.split('\n').next().unwrap_or_default().chars().take(200).collect()
}

/// Refuses a header that announces more than the file can hold, and one without what a surface needs.
fn check_sizes(header: &Header, available: u64) -> Read<()> {
    for element in header.elements.values() {
        let row = smallest_row(element, header.encoding);
        let needed = row.saturating_mul(element.count as u64);
        // The last line of an ASCII file may do without its end.
        if (row == 0 && element.count > 0) || needed > available + 1 {
            return Err(format!(
                "the header announces {} of element `{}`; the file has {available} bytes left for them",
                element.count, element.name
            ));
        }
    }
    let has = |element: &str, properties: &[&str]| {
        let found = header.elements.get(element);
        found.is_some_and(|found| properties.iter().any(|name| found.properties.contains_key(*name)))
    };
    if !(has("vertex", &["x"]) && has("vertex", &["y"]) && has("vertex", &["z"])) {
        return Err("no element `vertex` with the properties x, y and z".to_owned());
    }
    if !has("face", &LISTS) {
        return Err("no element `face` with a list `vertex_indices`".to_owned());
    }
    Ok(())
}

/// The fewest bytes that a row of an element takes.
fn smallest_row(element: &ElementDef, encoding: Encoding) -> u64 {
    let sizes = element.properties.values().map(|property| {
        let (PropertyType::Scalar(kind) | PropertyType::List(kind, _)) = &property.data_type;
        match (encoding, kind) {
            (Encoding::BinaryLittleEndian | Encoding::BinaryBigEndian, ScalarType::Char | ScalarType::UChar) => 1,
            // In ASCII a digit and what parts it from the next.
            (Encoding::Ascii, _) | (_, ScalarType::Short | ScalarType::UShort) => 2,
            (_, ScalarType::Int | ScalarType::UInt | ScalarType::Float) => 4,
            (_, ScalarType::Double) => 8,
        }
    });
    sizes.sum()
}

/// The names of the list of a face's corners, both in use.
const LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// A vertex or a face; all else of the file is passed over.
#[derive(Default)]
struct Element {
    position: [f64; 3],
    corners: Vec<i64>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        if let Some(axis) = axis {
            let Some(number) = scalar(&value) else { return PropertyAccessResult::UnsupportedType };
            self.position[axis] = number;
            return PropertyAccessResult::Set;
        }
        if LISTS.contains(&name) {
            let Some(corners) = indices(&value) else { return PropertyAccessResult::UnsupportedType };
            self.corners = corners;
            return PropertyAccessResult::Set;
        }
        PropertyAccessResult::Ignored
    }
}

fn scalar(value: &Property) -> Option<f64> {
    match *value {
        Property::Char(x) => Some(x.into()),
        Property::UChar(x) => Some(x.into()),
        Property::Short(x) => Some(x.into()),
        Property::UShort(x) => Some(x.into()),
        Property::Int(x) => Some(x.into()),
        Property::UInt(x) => Some(x.into()),
        Property::Float(x) => Some(x.into()),
        Property::Double(x) => Some(x),
        _ => None,
    }
}

fn indices(value: &Property) -> Option<Vec<i64>> {
    fn all<T: Copy + Into<i64>>(list: &[T]) -> Vec<i64> {
        list.iter().map(|&i| i.into()).collect()
    }
    match value {
        Property::ListChar(list) => Some(all(list)),
        Property::ListUChar(list) => Some(all(list)),
        Property::ListShort(list) => Some(all(list)),
        Property::ListUShort(list) => Some(all(list)),
        Property::ListInt(list) => Some(all(list)),
        Property::ListUInt(list) => Some(all(list)),
        _ => None,
    }
}
