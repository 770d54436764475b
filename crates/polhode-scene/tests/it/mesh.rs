//! Meshes: one cube in every format, and what is refused.

use base64::Engine as _;
use polhode::math::Vec3;
use polhode::shape::TriangleMesh;
use polhode_scene::mesh::{self, Format};
use std::fmt::Write as _;

/// Corners and outward quadrilaterals of the cube [0, 2]³.
const CORNERS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 2.0],
    [2.0, 0.0, 2.0],
    [2.0, 2.0, 2.0],
    [0.0, 2.0, 2.0],
];
const QUADS: [[u32; 4]; 6] = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

fn triangles() -> Vec<[u32; 3]> {
    QUADS.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

fn cube_obj() -> String {
    let mut text = "# a cube\r\nmtllib none.mtl\no cube\n".to_owned();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").expect("a string takes all");
    }
    text += "vn 0 0 1\nusemtl stone\n";
    for [a, b, c, d] in QUADS {
        writeln!(text, "f {}//1 {}//1 \\\n {}//1 {}//1 # a side", a + 1, b + 1, c + 1, i64::from(d) - 8)
            .expect("a string takes all");
    }
    text
}

fn cube_stl_ascii() -> String {
    let mut text = "solid\n".to_owned();
    for (i, triangle) in triangles().into_iter().enumerate() {
        if i == 6 {
            text += "endsolid\nsolid second half\n";
        }
        text += "facet normal 0 0 0\n outer loop\n";
        for corner in triangle {
            let [x, y, z] = CORNERS[corner as usize];
            writeln!(text, "  vertex {x:e} {y:e} {z:e}").expect("a string takes all");
        }
        text += " endloop\nendfacet\n";
    }
    text + "endsolid second half\n"
}

fn cube_stl_binary(header: [u8; 5]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes[..5].copy_from_slice(&header);
    bytes.extend((triangles().len() as u32).to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0; 12]);
        for corner in triangle {
            bytes.extend(CORNERS[corner as usize].iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn cube_ply(format: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {format} 1.0\ncomment a cube\nelement vertex 8\nproperty double x\nproperty float y\nproperty float z\n\
         property uchar red\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let big = format == "binary_big_endian";
    for [x, y, z] in CORNERS {
        if format == "ascii" {
            bytes.extend(format!("{x} {y} {z} 255\n").bytes());
        } else if big {
            bytes.extend(f64::from(x).to_be_bytes());
            bytes.extend([y, z].iter().flat_map(|v| v.to_be_bytes()).chain([255]));
        } else {
            bytes.extend(f64::from(x).to_le_bytes());
            bytes.extend([y, z].iter().flat_map(|v| v.to_le_bytes()).chain([255]));
        }
    }
    for quad in QUADS {
        if format == "ascii" {
            bytes.extend(format!("4 {} {} {} {}\n", quad[0], quad[1], quad[2], quad[3]).bytes());
        } else {
            bytes.push(4);
            bytes.extend(quad.iter().flat_map(|i| if big { i.to_be_bytes() } else { i.to_le_bytes() }));
        }
    }
    bytes
}

/// Corners as f32 and indices as u16, both in one buffer.
fn cube_buffer() -> Vec<u8> {
    let mut bytes: Vec<u8> = CORNERS.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(triangles().iter().flatten().flat_map(|&i| (i as u16).to_le_bytes()));
    bytes
}

fn cube_json(buffer: &serde_json::Value, nodes: &serde_json::Value) -> serde_json::Value {
    serde_json::json!({
        "asset": { "version": "2.0" },
        "scenes": [{ "nodes": [0] }],
        "nodes": nodes,
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [2, 2, 2] },
            { "bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 96 },
            { "buffer": 0, "byteOffset": 96, "byteLength": 72 },
        ],
        "buffers": [buffer],
    })
}

fn data_uri() -> serde_json::Value {
    let base64 = base64::engine::general_purpose::STANDARD.encode(cube_buffer());
    serde_json::json!({ "byteLength": 168, "uri": format!("data:application/octet-stream;base64,{base64}") })
}

fn cube_gltf(nodes: &serde_json::Value) -> String {
    cube_json(&data_uri(), nodes).to_string()
}

fn cube_glb() -> Vec<u8> {
    let json = cube_json(&serde_json::json!({ "byteLength": 168 }), &serde_json::json!([{ "mesh": 0 }]));
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = cube_buffer();
    let mut bytes = b"glTF".to_vec();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((12 + 8 + json.len() as u32 + 8 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

fn parse(format: Format, bytes: impl AsRef<[u8]>) -> TriangleMesh {
    mesh::parse("mesh", format, bytes.as_ref(), 1.0).unwrap_or_else(|e| panic!("{e}"))
}

fn refusal(format: Format, bytes: impl AsRef<[u8]>) -> String {
    mesh::parse("mesh", format, bytes.as_ref(), 1.0).expect_err("the mesh is wrong").to_string()
}

/// Six times the signed volume, by the divergence theorem.
fn volume_6(mesh: &TriangleMesh) -> f64 {
    let corner = |i: u32| mesh.positions()[i as usize];
    mesh.triangles().iter().map(|&[a, b, c]| corner(a).dot(corner(b).cross(corner(c)))).sum()
}

#[test]
fn one_cube_is_the_same_mesh_in_every_format() {
    let expected = parse(Format::Obj, cube_obj());
    assert_eq!((expected.positions().len(), expected.triangles().len()), (8, 12));
    // Small integers: exact.
    assert_eq!(volume_6(&expected), 6.0 * 8.0);
    assert_eq!(parse(Format::Stl, cube_stl_ascii()), expected);
    assert_eq!(parse(Format::Stl, cube_stl_binary(*b"mesh ")), expected);
    assert_eq!(parse(Format::Stl, cube_stl_binary(*b"solid")), expected);
    assert_eq!(parse(Format::Ply, cube_ply("ascii")), expected);
    assert_eq!(parse(Format::Ply, cube_ply("binary_little_endian")), expected);
    assert_eq!(parse(Format::Ply, cube_ply("binary_big_endian")), expected);
    assert_eq!(parse(Format::Gltf, cube_gltf(&serde_json::json!([{ "mesh": 0 }]))), expected);
    assert_eq!(parse(Format::Gltf, cube_glb()), expected);
}

#[test]
fn a_gltf_mesh_stands_where_its_nodes_put_it() {
    // A quarter turn about z, stretched and moved, inside a node that mirrors x.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let nodes = serde_json::json!([
        { "children": [1], "scale": [-1, 1, 1] },
        { "mesh": 0, "rotation": [0, 0, half, half], "scale": [1, 2, 3], "translation": [10, 0, 0] },
    ]);
    let mesh = parse(Format::Gltf, cube_gltf(&nodes));
    // One quaternion of f32 was normalised in f64: the parts of the turn are right to the f32 rounding of two equal
    // components, which cancels, so only f64 roundings of lengths up to 10 remain.
    let near = |p: Vec3| mesh.positions().iter().any(|q| (*q - p).max_abs() < 1e-14);
    for [x, y, z] in CORNERS.map(|c| c.map(f64::from)) {
        assert!(near(Vec3::new(-(10.0 - 2.0 * y), x, 3.0 * z)), "{:?}", mesh.positions());
    }
    // Outside is still outside: 6 times the volume 8·6, positive.
    assert!((volume_6(&mesh) - 6.0 * 48.0).abs() < 1e-10, "{}", volume_6(&mesh));
}

#[test]
fn a_mesh_is_loaded_from_its_folder_and_no_further() {
    let folder = std::env::temp_dir().join(format!("polhode-mesh-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("parts")).expect("the folder can be made");
    let gltf = |uri: &str| {
        let buffer = serde_json::json!({ "byteLength": 168, "uri": uri });
        let path = folder.join("cube.gltf");
        std::fs::write(&path, cube_json(&buffer, &serde_json::json!([{ "mesh": 0 }])).to_string()).expect("is written");
        mesh::load(path, 1.0)
    };
    std::fs::write(folder.join("parts/cu be.bin"), cube_buffer()).expect("is written");
    assert_eq!(gltf("parts/cu%20be.bin").expect("is read").triangles().len(), 12);
    for uri in
        ["../cube.bin", "/etc/passwd", "parts/../../x", "https://example.org/x.bin", "file:///x", "..\\x", "%2e%2e/x"]
    {
        let e = gltf(uri).expect_err("leads out").to_string();
        assert!(e.contains("leads out of the folder") && e.contains("cube.gltf: buffer 0"), "{uri}: {e}");
    }
    assert!(gltf("none.bin").expect_err("is missing").to_string().contains("\"none.bin\": cannot read the file"));
    std::fs::write(folder.join("cube.step"), "").expect("is written");
    assert!(mesh::load(folder.join("cube.step"), 1.0).expect_err("unknown").to_string().contains("not a mesh that"));
    assert!(
        mesh::load(folder.join("none.obj"), 1.0).expect_err("missing").to_string().contains("cannot read the file")
    );
    std::fs::remove_dir_all(&folder).expect("can be removed");
}

#[test]
fn refusals_say_what_is_wrong_and_where() {
    let ply = |header: &str| format!("ply\nformat ascii 1.0\n{header}end_header\n");
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let faces = "property list uchar int vertex_indices\n";
    let cube = String::from_utf8(cube_ply("ascii")).expect("is ASCII");
    let gltf = |change: fn(&mut serde_json::Value)| {
        let mut json = cube_json(&data_uri(), &serde_json::json!([{ "mesh": 0 }]));
        change(&mut json);
        json.to_string()
    };
    let cases = [
        (Format::Obj, String::new(), "holds no triangle"),
        (Format::Obj, "v 0 0\n".into(), "line 1"),
        (Format::Obj, "# c\nv 0 0 0\nv 1 x 0\n".into(), "line 3"),
        (Format::Obj, "v 0 0 0\n\nf 1 1 2\n".into(), "line 3: vertex 2 does not exist, of 1"),
        (Format::Obj, "v 0 0 0\nf 1 1 -2\n".into(), "line 2: vertex -2 does not exist"),
        (Format::Obj, "v 0 0 0\nf 1 0 1\n".into(), "line 2: vertex 0 does not exist"),
        (Format::Obj, "v nan 0 0\nf 1 1 1\n".into(), "triangle 0: a corner at (NaN, 0, 0) is not finite"),
        (Format::Obj, "v 0 0 0\nf\n".into(), "a face has no corners"),
        (Format::Stl, "hello".into(), "too few for a binary STL"),
        (
            Format::Stl,
            "x".repeat(200),
            "a binary STL of 2021161080 triangles has 101058054084 bytes, this file has 200",
        ),
        (Format::Stl, "solid a\nendsolid a\n".into(), "holds no triangle"),
        (Format::Stl, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n".into(), "triangle 0"),
        (Format::Stl, "solid a\nendsolid a\nrubbish".into(), "expected `solid` or the end"),
        (Format::Ply, "plyx".into(), "Expected magic number"),
        (Format::Ply, ply(""), "no element `vertex`"),
        (Format::Ply, ply(&format!("element vertex 0\n{xyz}")), "no element `face`"),
        (Format::Ply, ply(&format!("element vertex 99999999999\n{xyz}")), "announces 99999999999 of element `vertex`"),
        (Format::Ply, ply("element vertex 5\n"), "announces 5 of element `vertex`"),
        (Format::Ply, ply(&format!("element vertex 0\n{xyz}element face 0\n{faces}")), "holds no triangle"),
        (Format::Ply, cube.replace("4 0 3 2 1", "4 0 3 2 8"), "face 0: vertex 8 does not exist, of 8"),
        (Format::Ply, cube.replace("4 4 5 6 7", "2 4 5"), "face 1: 2 corners do not make a face"),
        (Format::Gltf, "{".into(), "EOF"),
        (Format::Gltf, "glTF\x02\0\0\0\x03\0\0\0".into(), "says that the file has 3 bytes"),
        (Format::Gltf, gltf(|j| j["scenes"] = serde_json::json!([])), "no scene"),
        (Format::Gltf, gltf(|j| j["nodes"][0]["children"] = serde_json::json!([0])), "node 0 has two parents"),
        (Format::Gltf, gltf(|j| j["accessors"] = serde_json::json!([])), "mesh 0: there is no accessor 0"),
        (Format::Gltf, gltf(|j| j["accessors"][1]["count"] = 37.into()), "accessor 1 reaches outside its buffer"),
        (Format::Gltf, gltf(|j| j["accessors"][0]["count"] = 7.into()), "vertex 7 does not exist, of 7"),
        (Format::Gltf, gltf(|j| j["bufferViews"][0]["byteOffset"] = u64::MAX.into()), "reaches outside its buffer"),
        (Format::Gltf, gltf(|j| j["buffers"][0]["uri"] = "cube.bin".into()), "buffer 0: cannot follow \"cube.bin\""),
        (
            Format::Gltf,
            gltf(|j| drop(j["accessors"][0].as_object_mut().map(|a| a.remove("bufferView")))),
            "bufferView: Missing data",
        ),
    ];
    for (format, bytes, words) in cases {
        let shown = refusal(format, &bytes);
        assert!(shown.starts_with("mesh: ") && shown.contains(words), "{bytes}\nwanted {words}\n{shown}");
    }
}

/// The mesh that ships is a closed surface: each edge is walked once in each direction.
#[test]
fn the_shipped_mesh_is_closed() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/projection.stl");
    let mesh = mesh::load(path, 1.0).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((mesh.positions().len(), mesh.triangles().len()), (2084, 4160));
    let edges = |turn: fn([u32; 3]) -> [(u32, u32); 3]| {
        let mut edges: Vec<_> = mesh.triangles().iter().flat_map(|&t| turn(t)).collect();
        edges.sort_unstable();
        edges
    };
    let forth = edges(|[a, b, c]| [(a, b), (b, c), (c, a)]);
    let back = edges(|[a, b, c]| [(b, a), (c, b), (a, c)]);
    assert_eq!(forth, back);
    assert!(forth.windows(2).all(|pair| pair[0] != pair[1]));
    // Euler: two surfaces without a handle, the outer one and that of the hollow.
    assert_eq!(mesh.positions().len() + mesh.triangles().len(), forth.len() / 2 + 4);
}
