#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode_scene::mesh::{Format, parse};

fuzz_target!(|bytes: &[u8]| match parse("fuzz", Format::Gltf, bytes, 1.0) {
    Ok(mesh) => {
        assert!(mesh.positions().iter().all(|p| p.is_finite()));
        assert!(mesh.triangles().iter().flatten().all(|&i| (i as usize) < mesh.positions().len()));
    }
    Err(error) => assert!(!error.to_string().is_empty()),
});
