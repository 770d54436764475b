//! Scenes that run: what happens in them is what mechanics says.

use polhode::math::Vec3;
use polhode_scene::recording::{FormInfo, LinkKind};
use polhode_scene::scene::Kind;
use polhode_scene::{Recording, Run, SceneFile};
use std::io::Cursor;
use std::ops::ControlFlow;

fn file(text: &str) -> SceneFile {
    SceneFile::parse(concat!(env!("CARGO_MANIFEST_DIR"), "/test.toml"), text).unwrap_or_else(|e| panic!("{e}"))
}

fn run(text: &str) -> Run {
    let file = file(text);
    Run::new(&file, &file.scene.variants()[0]).unwrap_or_else(|e| panic!("{e}"))
}

fn finished(text: &str) -> Run {
    let mut run = run(text);
    run.finish();
    run
}

fn recorded(text: &str) -> Recording {
    let bytes = run(text).record(Cursor::new(Vec::new()), |_, _| ControlFlow::Continue(())).expect("memory takes all");
    Recording::read(&bytes.into_inner()).unwrap_or_else(|e| panic!("{e}"))
}

fn refusal(text: &str) -> String {
    let file = file(text);
    let variants = file.scene.variants();
    let refused = variants.iter().find_map(|variant| Run::new(&file, variant).err());
    refused.expect("the scene cannot run").to_string()
}

fn body<'a>(run: &'a Run, name: &str) -> polhode::world::BodyRef<'a> {
    run.world().bodies().find(|body| body.name() == Some(name)).expect("the body is there")
}

/// A box 1 × 2 × 3 m of 12 kg: moments 13, 10 and 5 kg·m².
const BOX: &str = "[[body]]\nname = 'box'\nshape = { type = 'cuboid', size = [1, 2, 3], mass = 12 }\n";

#[test]
fn a_recording_is_of_the_run() {
    let text = format!(
        "title = 'Racket'\ngravity = 0\ntime = 2\ndt = 0.01\nframe_interval = 0.03\nshow = ['omega']\nfollow = 'box'\n\
         {BOX}angular_velocity = [0.01, 3, 0.02]\ncolor = '#123456'\n"
    );
    let recording = recorded(&text);
    let header = &recording.header;
    assert_eq!(
        (header.title.as_str(), header.label.as_str(), header.integrator.as_str()),
        ("Racket", "pdmv6", "pdmv6")
    );
    assert_eq!((header.follow, header.show.as_deref()), (Some(0), Some(&["omega".to_owned()][..])));
    let info = &header.bodies[0];
    assert_eq!((info.kind, info.mass, info.color.as_deref()), (Kind::Dynamic, Some(12.0), Some("#123456")));
    assert_eq!(info.shapes[0].form, FormInfo::Cuboid { size: [1.0, 2.0, 3.0] });
    // 200 steps, every third recorded, and the last.
    assert_eq!(recording.n_frames(), 1 + 67);
    assert_eq!(recording.frame(67).time, 2.0);
    // The pDMV map keeps L to the bit and E to rounding: a few roundings for each of 200 steps.
    let largest =
        |name: &str| recording.series(name).expect("it is recorded").into_iter().map(f64::abs).fold(0.0, f64::max);
    assert!(largest("energy-drift") < 1e-13, "{}", largest("energy-drift"));
    assert_eq!(largest("angular-momentum-drift"), 0.0);
    assert_eq!(largest("momentum"), 0.0);
    let first = recording.frame(0).channel(header, 0, "angular_velocity").expect("it is recorded").to_vec();
    // Components of f32.
    assert!((first[1] - 3.0).abs() < 1e-6, "{first:?}");
    // It turned: the middle axis is not the one that stays.
    assert_ne!(recording.frame(67).channel(header, 0, "rotation"), recording.frame(0).channel(header, 0, "rotation"));
}

/// Row 40: v = P/m wherever the puck is hit, ω = J⁻¹ (r × P), and the recoil is as long as the kick.
#[test]
fn a_kick_off_centre_moves_the_centre_as_any_other() {
    let kick = |slides: &str, at: &str| {
        let text = format!(
            "gravity = 0\ntime = 0.1\nslides = [{slides}]\n{BOX}\n[[force]]\nbody = 'box'\nimpulse = [0, 6, 0]\nat = {at}\n"
        );
        let run = finished(&text);
        let body = body(&run, "box");
        (body.velocity().to_array(), body.angular_momentum().to_array())
    };
    assert_eq!(kick("", "[0, 0, 0]"), ([0.0, 0.5, 0.0], [0.0, 0.0, 0.0]));
    assert_eq!(kick("", "[0.5, 0, 0]"), ([0.0, 0.5, 0.0], [0.0, 0.0, 3.0]));
    // Literally: the torque has the other sign, and a kick across the lever does not move the puck at all.
    assert_eq!(kick("'torque-sign'", "[0.5, 0, 0]"), ([0.0, 0.5, 0.0], [0.0, 0.0, -3.0]));
    assert_eq!(kick("'force-projection'", "[0.5, 0, 0]"), ([0.0, 0.0, 0.0], [0.0, 0.0, 3.0]));
    // Along the lever it moves it by P²r/m.
    assert_eq!(kick("'force-projection'", "[0, 0.5, 0]"), ([0.0, 1.5, 0.0], [0.0, 0.0, 0.0]));
}

/// Row 50: the last moment becomes y² + z², the first.
#[test]
fn the_slides_tensor_has_its_first_moment_twice() {
    let moments = |slides: &str| {
        let run = run(&format!("slides = [{slides}]\n{BOX}"));
        body(&run, "box").principal_inertia().to_array()
    };
    // 12 kg/12 (4 + 9, 1 + 9, 1 + 4); each is a few roundings from the whole number.
    let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13);
    assert!(near(moments(""), [13.0, 10.0, 5.0]));
    assert!(near(moments("'inertia-33'"), [13.0, 10.0, 13.0]), "{:?}", moments("'inertia-33'"));
}

/// Row 42: each column across ω grows by √(1+h²ω²) a step; at ω = 10, h = 1/60 that is (37/36)^300 = 3.71e3 in 10 s.
#[test]
fn the_slides_matrix_grows() {
    let scene = |slides: &str| {
        format!(
            "gravity = 0\ntime = 10\nslides = [{slides}]\n{BOX}angular_velocity = [0, 0, 10]\n[[plot]]\ntitle = 'd'\nseries = ['determinant', 'orthogonality']\n"
        )
    };
    let last =
        |recording: &Recording, name: &str| *recording.series(name).expect("is there").last().expect("has frames");
    let literal = recorded(&scene("'explicit-r'"));
    let growth = libm::exp(300.0 * libm::log(37.0 / 36.0));
    // 600 products of numbers that are right to a rounding; ω itself is read from the growing matrix.
    assert!(
        (last(&literal, "determinant") / (growth * growth) - 1.0).abs() < 1e-10,
        "{}",
        last(&literal, "determinant")
    );
    assert!(literal.header.channel("matrix").is_some());
    let right = recorded(&scene(""));
    assert!(last(&right, "orthogonality") < 1e-14);
    assert!(right.header.channel("matrix").is_none());
}

/// Row 56: a bob on a spring swings back with r × F; with F × r the same spring turns it away.
#[test]
fn the_slides_torque_turns_the_other_way() {
    let spin = |slides: &str| {
        let text = format!(
            "gravity = 0\ntime = 0.02\ndt = 0.001\nslides = [{slides}]\n{BOX}[[field]]\ntype = 'spring'\na = 'box'\n\
             point_a = [0.5, 0, 0]\npoint_b = [0.5, 2, 0]\nstiffness = 10\nrest_length = 1\n"
        );
        let run = finished(&text);
        (body(&run, "box").velocity().y, body(&run, "box").angular_momentum().z)
    };
    let (v, l) = spin("");
    let (v_literal, l_literal) = spin("'torque-sign'");
    // The force is the same, up to what 20 ms of turning do to it: (ω t)² of 10 N·0.5 m/5 kg·m²·(20 ms)².
    assert!((v - v_literal).abs() < 1e-3 * v && (l + l_literal).abs() < 1e-3 * l, "{v} {v_literal} {l} {l_literal}");
    let both = refusal(&format!(
        "slides = ['torque-sign']\n{BOX}[[body]]\nname = 'b'\nkind = 'fixed'\n[[field]]\ntype = 'spring'\na = 'box'\nb = 'b'\nstiffness = 1\n"
    ));
    assert!(both.contains("springs to the world only") && both.contains("(field[0].b)"), "{both}");
}

/// A force that lasts from one step to another gives F·Δt.
#[test]
fn forces_last_as_long_as_they_say() {
    let text = format!(
        "gravity = 0\ntime = 4\ndt = 0.25\n{BOX}[[force]]\nbody = 'box'\nforce = [0, 12, 0]\nfrom = 1\nuntil = 3\n\
         [[force]]\nbody = 'box'\ntorque = [0, 0, 10]\nuntil = 2\n"
    );
    let run = finished(&text);
    let body = body(&run, "box");
    // Sums of quarters: exact.
    assert_eq!(body.momentum().y, 12.0 * 2.0);
    assert_eq!(body.angular_momentum().z, 10.0 * 2.0);
}

#[test]
fn a_pinned_body_starts_where_its_pin_is_and_stays_there() {
    let text = format!(
        "time = 1\ndt = 0.01\n{BOX}rotation = {{ axis = [1, 0, 0], degrees = 30 }}\nangular_velocity_body = [0, 0, 20]\n\
         [[pin]]\nbody = 'box'\npoint = [0, 0, -1.5]\nat = [5, 6, 7]\n[[plot]]\ntitle = 'gap'\nseries = ['pin-gap', 'box.tilt']\n"
    );
    let recording = recorded(&text);
    let gap = recording.series("pin-gap").expect("it is plotted").into_iter().fold(0.0, f64::max);
    // RATTLE closes the pin to its tolerance each step: roundings of coordinates of 10 m.
    assert!(gap < 1e-12, "{gap}");
    let tilt = recording.series("box.tilt").expect("it is plotted");
    assert!((tilt[0].to_degrees() - 30.0).abs() < 1e-12);
    let pin = &recording.header.links[0];
    assert_eq!((pin.kind, pin.a, pin.b, pin.point_b), (LinkKind::Pin, Some(0), None, [5.0, 6.0, 7.0]));
    let shown = refusal(&format!(
        "{BOX}[[pin]]\nbody = 'box'\nat = [0, 0, 0]\n[[pin]]\nbody = 'box'\npoint = [1, 0, 0]\nat = [3, 0, 0]\n"
    ));
    assert!(shown.contains("leaves the point 2 m off") && shown.contains("(pin[1].at)"), "{shown}");
    let shown = refusal(&format!("integrator = 'rk4'\n{BOX}[[pin]]\nbody = 'box'\n"));
    assert!(shown.contains("does not close pinned points") && shown.contains("test.toml:1:14 (integrator)"), "{shown}");
}

#[test]
fn a_grid_is_of_bodies_of_their_own() {
    let text = "gravity = 0\ntime = 1\ndt = 0.125\n[[body]]\nname = 'b'\nposition = [1, 0, 0]\nshape = { type = 'sphere', radius = 0.1, mass = 2 }\n\
                repeat = { count = [2, 3, 2], spacing = [1, 10, 100] }\n[[force]]\nbody = 'b'\nforce = [2, 0, 0]\n\
                [[force]]\nbody = 'b.7'\nforce = [0, 4, 0]\n[[field]]\ntype = 'linear-drag'\nlinear = 0\nonly = ['b.1']\n";
    let run = finished(text);
    assert_eq!(run.world().len(), 12);
    // The fourth of x, y, z is 1 + 2·(0 + 3·1): x runs fastest. Each falls ½ a t² = 0.5 m along x.
    let place = body(&run, "b.7").position();
    assert_eq!(place.to_array(), [1.0 + 1.0 + 0.5, 1.0, 100.0]);
    assert_eq!(body(&run, "b.11").position().to_array(), [2.5, 20.0, 100.0]);
}

/// The mesh that ships, at 1 cm a unit: volume by the divergence theorem 3023.905 units.
#[test]
fn a_mesh_has_its_mass() {
    let text = "gravity = 0\n[[body]]\nname = 'm'\nshape = { type = 'mesh', file = '../../assets/projection.stl', scale = 0.01, density = 500 }\n";
    let recording = run(text);
    let mass = recording.header().bodies[0].mass.expect("it is dynamic");
    // The file has f32 coordinates with 7 digits, and the volume is quoted with as many.
    assert!((mass - 3023.905e-6 * 500.0).abs() < 1e-6 * mass, "{mass}");
    assert!(
        matches!(&recording.header().bodies[0].shapes[0].form, FormInfo::Mesh { indices, .. } if indices.len() == 3 * 4160)
    );
    let missing = refusal(&text.replace("projection", "projektion"));
    assert!(
        missing.contains("projektion.stl: cannot read the file") && missing.contains("(body[0].shape[0].file)"),
        "{missing}"
    );
    assert!(missing.contains("test.toml:4:33"), "{missing}");
}

#[test]
fn what_no_body_can_be_is_refused_at_its_place() {
    let cases = [
        ("[[body]]\nname = 'b'\nmass = 1\ninertia = [1, 1, 3]\n", "(body[0].inertia)", "test.toml:4:11"),
        ("[[body]]\nname = 'b'\nmass = 1\ninertia = 2\n", "planar scene only", "(body[0].inertia)"),
        ("[[body]]\nname = 'b'\nparticles = [[0, 0, 0, 1], [1, 0, 0, 1]]\n", "(body[0].particles)", "test.toml:3:13"),
        ("[[body]]\nname = 'b'\nshape = [{ type = 'torus', major = 1, minor = 2 }]\n", "(body[0].shape[0]", "minor"),
        ("[[body]]\nname = 'b'\nshape = { type = 'half_space' }\n", "has no mass", "(body[0].shape"),
        (
            "planar = true\n[[body]]\nname = 'b'\nmass = 1\ninertia = 1\nposition = [0, 0, 1]\n",
            "plane z = 0",
            "(body[0].position)",
        ),
        (
            "[[body]]\nname = 'b'\nkind = 'fixed'\n[[force]]\nbody = 'b'\nforce = [1, 0, 0]\n",
            "dynamic bodies only",
            "(force[0].body)",
        ),
        ("[[body]]\nname = 'b'\nkind = 'fixed'\nvelocity = [1, 0, 0]\n", "does not move", "(body[0].velocity)"),
        (
            "slides = ['inertia-33']\n[[body]]\nname = 'b'\nshape = { type = 'cuboid', size = [9, 1, 1] }\n",
            "the slides' J₃₃ = y² + z² is in it",
            "(body[0].inertia)",
        ),
        (
            "[[compare]]\nlabel = 'x'\n[[compare.body]]\nname = 'b'\nmass = 1\ninertia = [1, 1, 3]\n",
            "(compare[0].body[0].inertia)",
            "test.toml:6:11",
        ),
    ];
    for (text, words, place) in cases {
        let shown = refusal(text);
        assert!(shown.contains(words) && shown.contains(place), "{text}\nwanted {words} {place}\n{shown}");
    }
}

/// In the plane one number is the inertia, from given moments, particles and shapes alike.
#[test]
fn a_planar_scene_turns_about_z() {
    let text = "planar = true\ngravity = 0\ntime = 1\n[[body]]\nname = 'a'\nmass = 2\ninertia = 3\nangular_momentum = [0, 0, 6]\n\
                [[body]]\nname = 'b'\nparticles = [[1, 0, 0, 1], [-1, 0, 0, 1]]\nangular_momentum = [0, 0, 6]\n\
                [[body]]\nname = 'c'\nshape = { type = 'disc', radius = 1, mass = 4 }\nangular_momentum = [0, 0, 6]\n";
    let run = finished(text);
    for (name, w) in [("a", 2.0), ("b", 3.0), ("c", 3.0)] {
        assert!((body(&run, name).angular_velocity().z - w).abs() < 1e-14, "{name}");
    }
    // Gravity as one number pulls along −y there.
    let run = run_planar_fall();
    assert!((run.z, run.x) == (0.0, 0.0) && run.y < -4.0, "{run:?}");

    fn run_planar_fall() -> Vec3 {
        let run = finished("planar = true\ngravity = 10\ntime = 1\n[[body]]\nname = 'a'\nmass = 2\ninertia = 3\n");
        body(&run, "a").position()
    }
}

#[test]
fn every_field_of_a_scene_acts() {
    let text = "time = 0.1\ndt = 0.01\n[[body]]\nname = 'a'\nposition = [0, 0, 2]\nvelocity = [1, 0, 0]\nshape = { type = 'sphere', radius = 0.5, mass = 1 }\n\
                [[body]]\nname = 'b'\nposition = [3, 0, 0]\nshape = { type = 'cuboid', size = [1, 1, 1], mass = 1 }\n";
    let still = finished(text);
    let moved = |field: &str| {
        let run = finished(&format!("{text}[[field]]\n{field}\n"));
        (body(&run, "a").position() - body(&still, "a").position()).length()
    };
    for field in [
        "type = 'central'\nmu = 10",
        "type = 'linear-drag'\nlinear = 1",
        "type = 'quadratic-drag'\nlinear = 1\nonly = ['a']",
        "type = 'buoyancy'\nlevel = 5",
        "type = 'spring'\na = 'a'\nb = 'b'\nstiffness = 10\nrest_length = 0.5\ndamping = 1",
        "type = 'spring'\na = 'a'\nstiffness = 10\nrest_length = 0.5",
        "type = 'mutual-gravity'\nconstant = 10",
    ] {
        assert!(moved(field) > 1e-3, "{field}");
    }
    // At its own length and in its own orientation a spring does nothing.
    assert!(moved("type = 'torsion-spring'\na = 'a'\nb = 'b'\nstiffness = 10") < 1e-15);
    let at_rest = "gravity = 0\ntime = 1\n[[body]]\nname = 'a'\nposition = [3, 4, 0]\nmass = 1\ninertia = [1, 1, 1]\n[[field]]\ntype = 'spring'\na = 'a'\nstiffness = 10\n";
    assert_eq!(body(&finished(at_rest), "a").position().to_array(), [3.0, 4.0, 0.0]);
}

#[test]
fn variants_run_side_by_side_against_a_reference() {
    let text = format!(
        "gravity = 0\ntime = 5\ndt = 0.02\nreference = 'exact'\n{BOX}angular_velocity = [1, 3, 0.5]\n\
         [[compare]]\nlabel = 'default'\n[[compare]]\nlabel = 'coarse'\nintegrator = 'verlet'\n"
    );
    let file = file(&text);
    let errors: Vec<f64> = file
        .scene
        .variants()
        .iter()
        .map(|variant| {
            let mut run = Run::new(&file, variant).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(run.header().label, variant.label);
            assert!(run.header().plots.iter().any(|plot| plot.series == ["attitude-error"]));
            run.finish().attitude_error.expect("there is a reference")
        })
        .collect();
    // Order 6 at h|ω| = 0.06: 250 steps of about (hω)⁷; order 1 is off by h ω times the angle of precession.
    assert!(errors[0] < 1e-8 && errors[1] > 1e-3, "{errors:?}");
}

/// A run is the same to the last bit when it is run again, recorded or not, and with two threads.
#[test]
fn a_run_is_the_same_again() {
    let text = format!(
        "time = 3\n{BOX}angular_velocity = [1, 3, 0.5]\n[[force]]\nbody = 'box'\nforce = [1, 0, 0]\nat = [0, 1, 0]\nframe = 'body'\n"
    );
    let hash = run(&text).finish().hash;
    let mut again = run(&text);
    again.world_mut().set_threads(2).expect("two threads are to be had");
    again.record(Cursor::new(Vec::new()), |_, _| ControlFlow::Continue(())).expect("memory takes all");
    assert_eq!(again.summary().hash, hash);
    assert_eq!(again.summary().steps, 180);
    // A run that is broken off has the frames up to there.
    let mut cut = run(&text);
    let bytes = cut.record(Cursor::new(Vec::new()), |steps, all| {
        assert_eq!(all, 180);
        if steps >= 10 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let recording = Recording::read(&bytes.expect("memory takes all").into_inner()).expect("it is whole");
    assert_eq!((recording.n_frames(), cut.summary().steps), (11, 10));
}

/// A force in body axes turns with the body: a spinning body pushed across its axis goes round in a circle of radius
/// F/(mω²), and with a velocity bω along the axis in a helix with k = R/(R²+b²) and τ = b/(R²+b²).
#[test]
fn a_helix_has_its_curvature_and_torsion() {
    let text = "gravity = 0\ntime = 2\ndt = 0.001\nshow = ['frenet', 'parallel']\n[[body]]\nname = 'b'\nposition = [2, 0, 0]\n\
                velocity = [0, 4, 2]\nangular_velocity = [0, 0, 2]\nmass = 1\ninertia = [1, 1, 1]\n[[force]]\nbody = 'b'\n\
                force = [-8, 0, 0]\nframe = 'body'\n[[plot]]\ntitle = 'k'\nseries = ['b.curvature', 'b.torsion']\n";
    let recording = recorded(text);
    let last = |name: &str| *recording.series(name).expect("is plotted").last().expect("has frames");
    // Velocity Verlet is off by (hω)²/12 = 3e-7 of the radius; the jerk is a difference of the first order, off by hω/2 = 1e-3.
    assert!((last("b.curvature") - 0.4).abs() < 1e-6, "{}", last("b.curvature"));
    assert!((last("b.torsion") - 0.2).abs() < 1e-3, "{}", last("b.torsion"));
    let frame = recording.frame(recording.n_frames() - 1);
    let channel = |name: &str| frame.channel(&recording.header, 0, name).expect("is recorded").to_vec();
    let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
    let (tangent, normal, parallel) = (channel("tangent"), channel("normal"), channel("parallel"));
    // Unit vectors of f32, normal to the tangent.
    for n in [&normal, &parallel] {
        assert!(dot(n, &tangent).abs() < 1e-6 && (dot(n, n) - 1.0).abs() < 1e-6);
    }
    // N points to the axis.
    let inwards = channel("position")[..2].iter().map(|x| -0.5 * x).collect::<Vec<f32>>();
    assert!((dot(&normal, &inwards) - 1.0).abs() < 1e-5, "{normal:?} {inwards:?}");
}

/// Far from the origin, positions are recorded relative to a point among the bodies.
#[test]
fn far_away_positions_keep_their_millimetres() {
    let text = "gravity = 0\ntime = 0.1\n[[body]]\nname = 'a'\nposition = [1e8, 0, 0]\nmass = 1\ninertia = [1, 1, 1]\n\
                [[body]]\nname = 'b'\nposition = [100000001, 0, 0]\nmass = 1\ninertia = [1, 1, 1]\n";
    let recording = recorded(text);
    assert_eq!(recording.header.origin, [1e8 + 0.5, 0.0, 0.0]);
    let frame = recording.frame(0);
    assert_eq!(frame.channel(&recording.header, 0, "position"), Some(&[-0.5, 0.0, 0.0][..]));
}
