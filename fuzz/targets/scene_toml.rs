#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode_scene::scene::{Form, Parts, SceneFile};
use polhode_scene::{Recording, Run};
use std::io::Cursor;
use std::ops::ControlFlow;

// What can be read is also built and goes a few steps, unless it is large or would read a file.
fuzz_target!(|text: &str| match SceneFile::parse("fuzz.toml", text) {
    Ok(file) => {
        for variant in file.scene.variants().iter().take(2).filter(|variant| is_small(&variant.parts)) {
            match Run::new(&file, variant) {
                Ok(mut run) => {
                    let out = Cursor::new(Vec::new());
                    let few = |steps, _| if steps < 2 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
                    // A frame may hold many steps.
                    if run.n_steps() / run.n_frames() < 100 {
                        let bytes = run.record(out, few).expect("memory takes all").into_inner();
                        Recording::read(&bytes).expect("it was just written");
                    }
                    run.summary();
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
    Err(error) => assert!(!error.to_string().is_empty()),
});

fn is_small(parts: &Parts) -> bool {
    let copies = |count: [u32; 3]| count.iter().fold(1_u64, |product, &n| product.saturating_mul(n.into()));
    let bodies: u64 = parts.body.iter().map(|body| body.repeat.as_ref().map_or(1, |grid| copies(grid.count))).sum();
    let meshes = parts.body.iter().flat_map(|body| body.shape.iter()).any(|shape| matches!(shape.form, Form::Mesh(_)));
    bodies <= 50 && !meshes
}
