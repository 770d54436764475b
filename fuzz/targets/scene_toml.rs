#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode_scene::SceneFile;

fuzz_target!(|text: &str| match SceneFile::parse("fuzz.toml", text) {
    Ok(file) => assert!(!file.scene.variants().is_empty()),
    Err(error) => assert!(!error.to_string().is_empty()),
});
