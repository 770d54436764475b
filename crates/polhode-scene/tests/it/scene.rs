//! Scenes: what is read, what is refused, and how the refusal reads.

use polhode_scene::Run;
use polhode_scene::scene::{Field, Form, Inertia, Kind, SceneFile, Slide};

fn parse(text: &str) -> SceneFile {
    SceneFile::parse("scenes/test.toml", text).unwrap_or_else(|e| panic!("{e}"))
}

fn refusal(text: &str) -> String {
    SceneFile::parse("scenes/test.toml", text).expect_err("the scene is wrong").to_string()
}

const RACKET: &str = r##"
title = "Tennis racket"
explanation = "Spun about its middle axis, it turns over and over."
look_for = "the handle"
row = [36]
time = 20
dt = "1/120"
gravity = 0
integrator = "pdmv10"
show = ["omega", "polhode"]
follow = "racket"

[[body]]
name = "racket"
shape = [
    { type = "cuboid", size = [0.3, 0.25, 0.03], density = 300, position = [0.3, 0, 0] },
    { type = "cylinder", radius = 0.02, length = 0.35, mass = 0.1, rotation = { axis = [0, 1, 0], degrees = 90 } },
]
angular_velocity_degrees = [0.1, 360, 0.1]
color = "#4f8fd0"

[[body]]
name = "dust"
particles = [[0, 0, 0, 1], [1, 0, 0, 2]]
repeat = { count = [2, 2, 2] }

[[body]]
name = "floor"
kind = "fixed"
shape = { type = "half_space" }

[[force]]
body = "racket"
impulse = [0, 0, 1]
at = [0.3, 0, 0]
time = 1

[[field]]
type = "spring"
a = "racket"
b = "dust.7"
stiffness = 10

[[pin]]
body = "dust.0"

[[compare]]
label = "right"

[[compare]]
label = "slides"
integrator = "rk4"
slides = ["explicit-r", "inertia-33"]
force = []
"##;

#[test]
fn a_scene_is_read() {
    let file = parse(RACKET);
    let scene = &file.scene;
    assert_eq!((scene.title.as_str(), scene.row.as_slice()), ("Tennis racket", &[36][..]));
    let racket = &scene.parts.body[0];
    assert_eq!(racket.shape.len(), 2);
    assert!(matches!(&racket.shape[1].form, Form::Cylinder(c) if c.length == 0.35));
    assert_eq!(scene.parts.body[2].kind, Kind::Fixed);
    assert!(
        matches!(&scene.parts.field[0], Field::Spring(s) if s.rest_length.is_none() && s.b.as_deref() == Some("dust.7"))
    );
    let variants = scene.variants();
    assert_eq!(variants.len(), 2);
    assert_eq!(variants[0].settings.integrator, "pdmv10");
    assert_eq!(variants[0].settings.dt, 1.0 / 120.0);
    assert_eq!(variants[0].settings.gravity.to_array(), [0.0, 0.0, 0.0]);
    assert_eq!(variants[0].parts.force.len(), 1);
    assert_eq!(variants[1].settings.integrator, "rk4");
    assert_eq!(variants[1].settings.slides, [Slide::ExplicitR, Slide::Inertia33]);
    assert_eq!(variants[1].parts.force.len(), 0);
}

#[test]
fn an_empty_scene_has_the_documented_defaults() {
    let file = parse("");
    let variants = file.scene.variants();
    let settings = &variants[0].settings;
    assert_eq!(settings.gravity.to_array(), [0.0, 0.0, -9.81]);
    assert_eq!((settings.time, settings.dt, settings.frame_interval), (10.0, 1.0 / 60.0, 1.0 / 60.0));
    assert_eq!(variants[0].label, "pdmv6");
}

#[test]
fn rotations_may_be_written_in_three_ways() {
    let rotation = |text: &str| {
        let file = parse(&format!("[[body]]\nname = 'b'\nkind = 'fixed'\nrotation = {text}\n"));
        file.scene.parts.body[0].rotation.0
    };
    let quarter = rotation("[1, 0, 0, 1]");
    // All three pass through one sine and cosine: a few roundings.
    for same in ["{ axis = [0, 0, 3], degrees = 90 }", "{ euler_degrees = [0, 0, 90] }"] {
        assert!(rotation(same).angle_to(quarter) < 1e-15, "{same}");
    }
    // First about x, then about y: the body's y ends along the world's z.
    let turned = rotation("{ euler_degrees = [90, 90, 0] }").rotate([0.0, 1.0, 0.0].into());
    assert!((turned - [1.0, 0.0, 0.0].into()).length() < 1e-15, "{turned:?}");
}

#[test]
fn inertia_may_be_moments_or_a_matrix() {
    let inertia = |text: &str| {
        let file = parse(&format!("[[body]]\nname = 'b'\nmass = 1\ninertia = {text}\n"));
        file.scene.parts.body[0].inertia.expect("it is given")
    };
    assert!(matches!(inertia("2"), Inertia::Planar(2.0)));
    assert!(matches!(inertia("[1, 2, 2.5]"), Inertia::Moments(m) if m.y == 2.0));
    assert!(matches!(inertia("[[1, 0.1, 0], [0.1, 2, 0], [0, 0, 2.5]]"), Inertia::Tensor(t) if t.at(0, 1) == 0.1));
}

#[test]
fn an_unknown_key_names_its_neighbour() {
    let shown = refusal("[[body]]\nname = \"top\"\nshape = { type = \"cuboid\", size = [1, 2, 3], densty = 1000 }\n");
    assert_eq!(
        shown,
        "error: unknown key `densty` in a shape of type `cuboid`, did you mean `density`?\n\
         \x20--> scenes/test.toml:3:46 (body[0].shape.densty)\n\
         \x20 |\n\
         3 | shape = { type = \"cuboid\", size = [1, 2, 3], densty = 1000 }\n\
         \x20 |                                              ^^^^^^"
    );
}

/// Every way to be wrong, and the words that must be in the answer.
#[test]
fn refusals_say_what_is_wrong_and_where() {
    let body = |keys: &str| format!("[[body]]\nname = 'b'\n{keys}\n");
    let shape = |keys: &str| body(&format!("shape = {{ type = 'sphere', {keys} }}"));
    let solid = body("mass = 1\ninertia = [1, 1, 1]");
    let cases = [
        ("time = [".to_owned(), "test.toml:1:9", ""),
        ("tiem = 3".to_owned(), "unknown key `tiem` in a scene, did you mean `time`?", "test.toml:1:1"),
        ("zzz = 3".to_owned(), "the keys are `gravity`, `time`", "unknown key `zzz`"),
        ("time = -1".to_owned(), "must be positive, found -1", "`time`: How long the run is [s]"),
        ("time = nan".to_owned(), "a finite number, found the number nan", "test.toml:1:8"),
        ("time = 1e999".to_owned(), "a finite number, found the number 1e999", ""),
        ("time = '10 s'".to_owned(), "numbers are in SI units, written without the unit", "[s]"),
        ("dt = 'fast'".to_owned(), "a quotient such as \"1/60\"", ""),
        ("dt = '1/0'".to_owned(), "must be positive and finite, found inf", ""),
        ("dt = 1e-12".to_owned(), "1e13 steps", "(dt)"),
        ("frame_interval = 1e-7".to_owned(), "1e8 frames", "(frame_interval)"),
        ("gravity = [0, 0]".to_owned(), "expected an array of 3, found an array of 2", "(gravity)"),
        ("integrator = 'pdvm6'".to_owned(), "`pdvm6` is not one of pdmv6", "did you mean \"pdmv6\"?"),
        ("reference = 'suzuki4:rk4'".to_owned(), "is not symmetric", "(reference)"),
        ("[[compare]]\nlabel = 'a'\nintegrator = 'x'".to_owned(), "`x` is not one of", "(compare[0].integrator)"),
        ("slides = ['torque-sing']".to_owned(), "did you mean \"torque-sign\"?", "slides[0]"),
        ("[[body]]\nshape = { type = 'sphere', radius = 1 }".to_owned(), "missing key `name` in a body", "test.toml:1"),
        (body(""), "a dynamic body needs a mass", "(body[0])"),
        (body("kind = 'dynamc'"), "did you mean \"dynamic\"?", "(body[0].kind)"),
        (body("shape = 3"), "expected a table, a shape, found the integer 3", ""),
        (body("shape = { radius = 1 }"), "missing key `type` in a shape", "one of `sphere`, `cuboid`"),
        (body("shape = { type = 'cubiod', size = [1,1,1] }"), "did you mean \"cuboid\"?", "(body[0].shape.type)"),
        (shape(""), "missing key `radius` in a shape of type `sphere`", "`radius`: Radius [m]."),
        (shape("radius = 0"), "must be positive, found 0", "(body[0].shape.radius)"),
        (shape("radius = 1, mass = -2"), "must be positive, found -2", "(body[0].shape.mass)"),
        (shape("radius = 1, mass = 2, density = 3"), "give a density or a mass, not both", "shape[0].mass"),
        (body("shape = { type = 'cuboid', size = [1, -1, 1] }"), "found -1", "(body[0].shape.size[1])"),
        (body("inertia = [1, 1, 1]"), "needs a `mass` beside it", ""),
        (body("particles = [[0, 0, 0, 0]]"), "particle must be positive", "(body[0].particles[0][3])"),
        (body("color = 'blue'\nparticles = [[0, 0, 0, 1]]"), "a colour such as \"#4f8fd0\"", ""),
        (body("colour = '#000000'\nparticles = [[0, 0, 0, 1]]"), "did you mean `color`?", ""),
        (body("rotation = [0, 0, 0, 0]\nkind = 'fixed'"), "a quaternion must not be zero", ""),
        (body("rotation = { axis = [0, 0, 0], degrees = 1 }\nkind = 'fixed'"), "must not be zero", ""),
        (body("rotation = { axis = [0, 0, 1] }\nkind = 'fixed'"), "as `degrees` or as `radians`", ""),
        (
            body("mass = 1\ninertia = [1, 1, 1]\nangular_velocity = [1, 0, 0]\nangular_momentum = [1, 0, 0]"),
            "already given by `angular_velocity`",
            "(body[0].angular_momentum)",
        ),
        (body("kind = 'fixed'\nrepeat = { count = [0, 1, 1] }"), "must be positive, found 0", "repeat.count[0]"),
        (body("kind = 'fixed'\nrepeat = { count = [1000, 1000, 1000] }"), "1000000000 bodies", "(body)"),
        (format!("{solid}{solid}"), "\"b\" is also the name of body[0]", "(body[1].name)"),
        (format!("{solid}[[force]]\nbody = 'c'\nforce = [1, 0, 0]"), "no body named \"c\"", "(force[0].body)"),
        (
            "[[body]]\nname = 'wheel'\nkind = 'fixed'\n[[force]]\nbody = 'whele'\nforce = [1, 0, 0]".to_owned(),
            "no body named \"whele\", did you mean \"wheel\"?",
            "",
        ),
        (
            format!("{solid}[[pin]]\nbody = 'b'\n[[compare]]\nlabel = 'x'\nbody = []"),
            "no body named \"b\"",
            "in the variant \"x\"",
        ),
        (format!("{solid}[[force]]\nbody = 'b'"), "a force needs one of", "(force[0])"),
        (format!("{solid}[[force]]\nbody = 'b'\ntorque = [1,0,0]\nat = [0,0,0]"), "no point at which it acts", ""),
        (format!("{solid}[[force]]\nbody = 'b'\nimpulse = [1,0,0]\nfrom = 1"), "given at one `time`", ""),
        (format!("{solid}[[force]]\nbody = 'b'\nforce = [1,0,0]\nfrom = 2\nuntil = 1"), "ends before it begins", ""),
        (format!("{solid}[[field]]\nstiffness = 1"), "missing key `type` in a field", "`torsion-spring`"),
        (format!("{solid}[[field]]\ntype = 'spring'\na = 'b'\nb = 'b'\nstiffness = 1"), "to itself", "(field[0].b)"),
        (format!("{solid}[[pin]]\nbody = 'b.3'"), "\"b\" has no copy \"3\"", "(pin[0].body)"),
        (body("kind = 'fixed'\nrepeat = { count = [2, 1, 1] }\n[[pin]]\nbody = 'b'"), "is a grid of 2 bodies", "b.1"),
        ("[[compare]]\nlabel = 'a'\n[[compare]]\nlabel = 'a'".to_owned(), "also the label of compare[0]", ""),
        ("[[compare]]\nlabel = 'a'\n[[compare.body]]\nname = 'x'".to_owned(), "needs a mass", "compare[0].body[0]"),
        ("[[plot]]\ntitle = 'a'\nseries = []".to_owned(), "a plot needs a series", ""),
        ("follow = 'b'".to_owned(), "there is no body named \"b\"", "(follow)"),
        ("show = ['frent']".to_owned(), "did you mean \"frenet\"?", "(show[0])"),
        ("title = 3".to_owned(), "expected a string, found the integer 3", ""),
        ("planar = 1".to_owned(), "expected true or false, found the integer 1", ""),
        ("row = -3".to_owned(), "a whole number from 0", ""),
        ("body = 3".to_owned(), "expected an array, found the integer 3", ""),
        ("time = 1979-05-27".to_owned(), "found a date", ""),
    ];
    for (text, words, place) in cases {
        let shown = refusal(&text);
        assert!(shown.contains(words) && shown.contains(place), "{text}\n{words} {place}\n{shown}");
    }
}

#[test]
fn all_problems_are_shown_in_the_order_of_the_file() {
    let error = SceneFile::parse("f", "time = -1\ngravity = 'strong'\n[[body]]\nnam = 'b'\n").expect_err("it is wrong");
    let lines: Vec<usize> = error.problems().iter().map(|problem| problem.line).collect();
    assert_eq!(lines, [1, 2, 3, 4], "{error}");
}

#[test]
fn a_later_error_is_shown_at_its_place() {
    let file = parse(RACKET);
    let error = polhode::Error::new("density", "is too much").inside("body[0].shape[1]");
    let shown = file.error(&error).to_string();
    assert!(shown.contains("test.toml:17:5 (body[0].shape[1].density)"), "{shown}");
    let error = polhode::Error::new("nowhere", "is lost");
    assert!(file.error(&error).to_string().contains("test.toml:1:1 (nowhere)"));
}

#[test]
fn a_missing_file_is_an_error() {
    let error = SceneFile::load("no/such/scene.toml").expect_err("there is no such file");
    assert!(error.to_string().contains("cannot read the scene") && error.to_string().contains("no/such/scene.toml"));
}

/// Every key of every table has a description, and every table of the schema closes itself to other keys.
#[test]
fn every_key_is_documented() {
    let schema = polhode_scene::schema();
    let mut keys = 0;
    visit(&schema["$defs"], &mut |table| {
        assert_eq!(table["additionalProperties"], false);
        let properties = table["properties"].as_object().expect("a table has properties");
        for (key, property) in properties {
            let described = property["description"].as_str().is_some_and(|text| text.len() > 5);
            assert!(described || key == "type", "{key} has no description");
            keys += 1;
        }
    });
    assert!(keys > 100, "{keys} keys");

    fn visit(value: &serde_json::Value, at_table: &mut impl FnMut(&serde_json::Value)) {
        if value.get("additionalProperties").is_some() {
            at_table(value);
        }
        match value {
            serde_json::Value::Object(entries) => entries.values().for_each(|inner| visit(inner, at_table)),
            serde_json::Value::Array(items) => items.iter().for_each(|inner| visit(inner, at_table)),
            _ => {}
        }
    }
}

/// The fuzzer starts from scenes that run; one that does not would leave most of the code untouched.
#[test]
fn the_seeds_of_the_fuzzer_run() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fuzz/seeds/scene_toml");
    let mut runs = 0;
    for entry in std::fs::read_dir(folder).expect("the seeds are there") {
        let path = entry.expect("can be listed").path();
        if path.file_name().is_some_and(|name| name == "wrong.toml") {
            continue;
        }
        let file = SceneFile::load(&path).unwrap_or_else(|e| panic!("{e}"));
        for variant in file.scene.variants() {
            Run::new(&file, &variant).unwrap_or_else(|e| panic!("{e}"));
            runs += 1;
        }
    }
    assert!(runs >= 2);
}
