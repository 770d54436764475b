//! What one table cannot know: names that refer to each other, and keys that exclude each other.

use super::{Body, Buoyancy, Central, Field, Force, Kind, LinearDrag, Parts, QuadraticDrag, Scene, Settings, Variant};
use crate::error::nearest;
use crate::run::Quantity;
use polhode::integrate::Integrator;
use std::collections::BTreeMap;

/// A path in the scene, what is wrong there, and what would be right.
pub(crate) type Finding = (String, String, Option<String>);

/// The most bodies that one scene may hold, copies included.
pub(crate) const MOST_BODIES: u64 = 1_000_000;
/// The most steps of one run, and the most recorded frames.
const MOST_STEPS: f64 = 1e10;
const MOST_FRAMES: f64 = 1e6;

pub(crate) fn scene(scene: &Scene) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut labels = BTreeMap::new();
    for (i, compare) in scene.compare.iter().enumerate() {
        if let Some(first) = labels.insert(compare.label.as_str(), i) {
            let message = format!("{:?} is also the label of compare[{first}]", compare.label);
            found.push((format!("compare[{i}].label"), message, None));
        }
    }
    check_integrators(&scene.settings, "", &mut found);
    for (i, compare) in scene.compare.iter().enumerate() {
        check_integrators(&compare.settings, &format!("compare[{i}]"), &mut found);
    }
    // The scene's own parts are looked at once, and again with the parts that a variant replaces.
    check_parts(&scene.parts, &Default::default(), &mut found);
    for (i, variant) in scene.variants().iter().enumerate() {
        let path = if scene.compare.is_empty() { String::new() } else { format!("compare[{i}]") };
        check_times(variant, &path, &mut found);
        if variant.places.iter().any(|place| !place.is_empty()) {
            let before = found.len();
            check_parts(&variant.parts, &variant.places, &mut found);
            for (_, _, help) in &mut found[before..] {
                *help = help.take().or_else(|| Some(format!("in the variant {:?}", variant.label)));
            }
        }
        if let Some(follow) = &scene.follow {
            Names::of(&variant.parts).refer(follow, "follow", true, &mut found);
        }
    }
    for (i, plot) in scene.plot.iter().enumerate() {
        if plot.series.is_empty() {
            found.push((format!("plot[{i}].series"), "a plot needs a series".to_owned(), None));
        }
        for (k, name) in plot.series.iter().enumerate() {
            check_series(scene, name, &format!("plot[{i}].series[{k}]"), &mut found);
        }
    }
    found.dedup();
    found
}

/// `outer.inner`, or the one of them that is not empty.
fn under(outer: &str, inner: &str) -> String {
    match (outer, inner) {
        ("", path) | (path, "") => path.to_owned(),
        _ => format!("{outer}.{inner}"),
    }
}

fn check_series(scene: &Scene, name: &str, path: &str, found: &mut Vec<Finding>) {
    match Quantity::parse(name) {
        Err((message, help)) => found.push((path.to_owned(), message, help)),
        Ok(Quantity::Body(body, _)) => {
            let before = found.len();
            for variant in scene.variants() {
                Names::of(&variant.parts).refer(&body, path, true, found);
                // Once is enough: the variants mostly have the same bodies.
                if found.len() > before {
                    break;
                }
            }
        }
        Ok(Quantity::Scene(_)) => {}
    }
}

fn check_integrators(settings: &Settings, path: &str, found: &mut Vec<Finding>) {
    for (key, name) in [("integrator", &settings.integrator), ("reference", &settings.reference)] {
        let Some(name) = name else { continue };
        let Err(e) = name.parse::<Integrator>() else { continue };
        let (prefix, base) = name.split_once(':').map_or(("", name.as_str()), |(prefix, base)| (prefix, base));
        let guess = nearest(base, Integrator::names().map(|(known, _)| known)).filter(|guess| *guess != base);
        let help = guess.map(|guess| {
            let colon = if prefix.is_empty() { "" } else { ":" };
            format!("did you mean \"{prefix}{colon}{guess}\"?")
        });
        found.push((under(path, key), e.message().chars().take(600).collect(), help));
    }
}

fn check_times(variant: &Variant, path: &str, found: &mut Vec<Finding>) {
    let settings = &variant.settings;
    let steps = settings.time / settings.dt;
    let frames = settings.time / settings.frame_interval;
    if steps > MOST_STEPS {
        let message = format!("{:e} s in steps of {:e} s are {steps:e} steps", settings.time, settings.dt);
        found.push((under(path, "dt"), message, Some(format!("at most {MOST_STEPS:e} steps"))));
    }
    if frames > MOST_FRAMES {
        let message = format!("{:e} s at {:e} s a frame are {frames:e} frames", settings.time, settings.frame_interval);
        let help = format!("at most {MOST_FRAMES:e} frames; give a longer `frame_interval`");
        found.push((under(path, "frame_interval"), message, Some(help)));
    }
}

fn check_parts(parts: &Parts, [bodies, forces, fields, pins]: &[String; 4], found: &mut Vec<Finding>) {
    let mut names = Names::default();
    for (i, body) in parts.body.iter().enumerate() {
        let path = under(bodies, &format!("body[{i}]"));
        names.declare(body, &path, found);
        check_body(body, &path, found);
    }
    if names.total > MOST_BODIES {
        let message = format!("the scene has {} bodies; the limit is {MOST_BODIES}", names.total);
        found.push((under(bodies, "body"), message, None));
    }
    for (i, force) in parts.force.iter().enumerate() {
        let path = under(forces, &format!("force[{i}]"));
        names.refer(&force.body, &format!("{path}.body"), false, found);
        check_force(force, &path, found);
    }
    for (i, field) in parts.field.iter().enumerate() {
        let path = under(fields, &format!("field[{i}]"));
        match field {
            Field::Central(Central { only, .. })
            | Field::LinearDrag(LinearDrag { only, .. })
            | Field::QuadraticDrag(QuadraticDrag { only, .. })
            | Field::Buoyancy(Buoyancy { only, .. }) => names.refer_all(only.as_deref(), &path, found),
            Field::Spring(spring) => names.refer_pair(&spring.a, spring.b.as_deref(), &path, found),
            Field::TorsionSpring(spring) => names.refer_pair(&spring.a, spring.b.as_deref(), &path, found),
            Field::MutualGravity(_) => {}
        }
    }
    for (i, pin) in parts.pin.iter().enumerate() {
        names.refer(&pin.body, &format!("{}.body", under(pins, &format!("pin[{i}]"))), true, found);
    }
}

/// The names of the bodies: how many copies each has, and where it stands.
#[derive(Default)]
struct Names<'a> {
    copies: BTreeMap<&'a str, (u64, String)>,
    total: u64,
}

impl<'a> Names<'a> {
    fn of(parts: &'a Parts) -> Self {
        let mut names = Self::default();
        parts.body.iter().for_each(|body| names.declare(body, "", &mut Vec::new()));
        names
    }

    fn declare(&mut self, body: &'a Body, path: &str, found: &mut Vec<Finding>) {
        let count = body.copies();
        self.total = self.total.saturating_add(count);
        if body.name.is_empty() || body.name.contains(['.', '[', ']']) {
            let message = "the name of a body must not be empty or hold `.`, `[` or `]`".to_owned();
            found.push((format!("{path}.name"), message, None));
        }
        if let Some((_, first)) = self.copies.get(body.name.as_str()) {
            found.push((format!("{path}.name"), format!("{:?} is also the name of {first}", body.name), None));
        } else {
            self.copies.insert(&body.name, (count, path.to_owned()));
        }
    }

    /// Checks that `name` is a body, or a copy `name.7` of one; with `single`, that it is not a whole grid.
    fn refer(&self, name: &str, path: &str, single: bool, found: &mut Vec<Finding>) {
        let (base, copy) = match name.split_once('.') {
            Some((base, copy)) => (base, Some(copy)),
            None => (name, None),
        };
        let problem = match (self.copies.get(base), copy) {
            (None, _) => {
                let guess = nearest(base, self.copies.keys().copied());
                let guess = guess.map_or(String::new(), |guess| format!(", did you mean \"{guess}\"?"));
                let shown: String = name.chars().take(64).collect();
                (format!("there is no body named {shown:?}{guess}"), None)
            }
            (Some((1, _)), None) => return,
            (Some((count, _)), None) if single => {
                let help = format!("name one of them: \"{base}.0\" to \"{base}.{}\"", count - 1);
                (format!("{base:?} is a grid of {count} bodies"), Some(help))
            }
            (Some(_), None) => return,
            (Some((count, _)), Some(copy)) => match copy.parse::<u64>() {
                Ok(copy) if copy < *count && *count > 1 => return,
                _ => (format!("{base:?} has no copy {:?}", copy.chars().take(64).collect::<String>()), None),
            },
        };
        found.push((path.to_owned(), problem.0, problem.1));
    }

    fn refer_all(&self, bodies: Option<&[String]>, path: &str, found: &mut Vec<Finding>) {
        for (i, name) in bodies.unwrap_or_default().iter().enumerate() {
            self.refer(name, &format!("{path}.only[{i}]"), false, found);
        }
    }

    fn refer_pair(&self, a: &str, b: Option<&str>, path: &str, found: &mut Vec<Finding>) {
        self.refer(a, &format!("{path}.a"), true, found);
        if let Some(b) = b {
            self.refer(b, &format!("{path}.b"), true, found);
            if a == b {
                found.push((format!("{path}.b"), format!("the spring goes from {a:?} to itself"), None));
            }
        }
    }
}

impl Body {
    /// How many bodies this entry makes; saturates.
    pub(crate) fn copies(&self) -> u64 {
        self.repeat.as_ref().map_or(1, |repeat| {
            repeat.count.iter().fold(1_u64, |product, &count| product.saturating_mul(u64::from(count)))
        })
    }
}

fn check_body(body: &Body, path: &str, found: &mut Vec<Finding>) {
    let mut refuse = |key: &str, message: &str, help: Option<&str>| {
        found.push((under(path, key), message.to_owned(), help.map(str::to_owned)));
    };
    let spins = [
        ("angular_velocity", body.angular_velocity.is_some()),
        ("angular_velocity_degrees", body.angular_velocity_degrees.is_some()),
        ("angular_velocity_body", body.angular_velocity_body.is_some()),
        ("angular_momentum", body.angular_momentum.is_some()),
    ];
    let given: Vec<&str> = spins.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect();
    if let [first, second, ..] = given[..] {
        refuse(second, &format!("the rotation is already given by `{first}`"), None);
    }
    if body.inertia.is_some() && body.mass.is_none() {
        refuse("inertia", "an inertia needs a `mass` beside it", None);
    }
    if body.center.is_some() && body.inertia.is_none() {
        refuse("center", "a centre of mass is given together with `mass` and `inertia`", None);
    }
    if body.particles.iter().any(|particle| particle[3] <= 0.0) {
        let which = body.particles.iter().position(|particle| particle[3] <= 0.0).unwrap_or(0);
        refuse(&format!("particles[{which}][3]"), "the mass of a particle must be positive", None);
    }
    let massless = body.shape.is_empty() && body.particles.is_empty() && body.inertia.is_none();
    if massless && body.kind == Kind::Dynamic {
        let help = "give it a `shape`, `particles`, or `mass` and `inertia`";
        refuse("", "a dynamic body needs a mass", Some(help));
    }
    for (i, shape) in body.shape.iter().enumerate() {
        if shape.density.is_some() && shape.mass.is_some() {
            refuse(&format!("shape[{i}].mass"), "give a density or a mass, not both", None);
        }
    }
}

fn check_force(force: &Force, path: &str, found: &mut Vec<Finding>) {
    let mut refuse = |key: &str, message: &str| found.push((under(path, key), message.to_owned(), None));
    let lasts = force.force.is_some() || force.torque.is_some();
    let strikes = force.impulse.is_some() || force.angular_impulse.is_some();
    match (lasts, strikes) {
        (false, false) => refuse("", "a force needs one of `force`, `torque`, `impulse`, `angular_impulse`"),
        (true, true) => refuse("impulse", "an impulse is an entry of its own, apart from `force` and `torque`"),
        (true, false) if force.time.is_some() => {
            refuse("time", "`time` is for impulses; a force has `from` and `until`");
        }
        (false, true) if force.from.is_some() => refuse("from", "an impulse is given at one `time`"),
        (false, true) if force.until.is_some() => refuse("until", "an impulse is given at one `time`"),
        _ => {}
    }
    if let Some(until) = force.until
        && until <= force.from.unwrap_or(0.0)
    {
        refuse("until", "the force ends before it begins");
    }
    if force.at.is_some() && force.force.is_none() && force.impulse.is_none() {
        refuse("at", "a torque has no point at which it acts");
    }
}
