//! A scene runs: the world it describes, step by step, and the recording of it.
//!
//! ```
//! use polhode_scene::{Run, SceneFile};
//!
//! let file = SceneFile::parse("ball.toml", "time = 1\n[[body]]\nname = \"ball\"\nshape = { type = \"sphere\", radius = 0.1 }\n")?;
//! let mut run = Run::new(&file, &file.scene.variants()[0])?;
//! run.finish();
//! // Velocity Verlet is exact for a constant force: half of 9.81 m, to rounding.
//! assert!((run.world().bodies().next().unwrap().position().z + 0.5 * 9.81).abs() < 1e-13);
//! # Ok::<(), polhode_scene::SceneError>(())
//! ```

mod body;
mod push;
mod quantity;
mod sampler;
mod setup;

pub(crate) use quantity::Quantity;
pub use quantity::{BodyQuantity, SceneQuantity};

use crate::error::SceneError;
use crate::recording::{ChannelInfo, Header, Layout, PlotInfo, Writer};
use crate::scene::{Channel, SceneFile, Show, Variant};
use polhode::integrate::Integrator;
use polhode::math::Vec3;
use polhode::record::state_hash;
use polhode::{Error, World};
use sampler::{Amounts, PathFrame, Sight};
use setup::Setup;
use std::io::{self, Seek, Write};
use std::ops::ControlFlow;

/// A run of one variant of a scene.
#[derive(Debug)]
pub struct Run {
    setup: Setup,
    /// The same scene by another integrator, at a fraction of the step.
    reference: Option<Setup>,
    header: Header,
    /// The series, each with the place of its body.
    series: Vec<(Quantity, usize)>,
    start: Amounts,
    /// Followed where the path's frame is asked for; otherwise empty.
    paths: Vec<PathFrame>,
    dt: f64,
    n_steps: u64,
    steps_per_frame: u64,
    summary: Summary,
}

/// What a run did.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Summary {
    /// Steps taken.
    pub steps: u64,
    /// Simulated time \[s\].
    pub time: f64,
    /// Bodies that forces move.
    pub bodies: usize,
    /// Change of the energy since the start, as a share of it or of the kinetic energy, whichever is larger; 0 where all is at
    /// rest. Meaningful where energy is conserved.
    pub energy_drift: f64,
    /// Change of Σ p since the start, as a share of Σ |p|.
    pub momentum_drift: f64,
    /// Change of the angular momentum about the origin since the start, as a share of the sum of all bodies' amounts of it.
    pub angular_momentum_drift: f64,
    /// Largest angle to the reference run at the end \[rad\], if there is one.
    pub attitude_error: Option<f64>,
    /// A number that tells whether two runs ended in the same state, to the last bit.
    pub hash: u64,
    /// Names of bodies on which a force was not finite and was dropped, at most ten.
    pub quarantined: Vec<String>,
    /// Whether an adaptive integrator's step vanished before the end.
    pub stalled: bool,
}

/// The reference run takes this many steps to one of the run.
const REFERENCE_STEPS: u32 = 10;
/// Scenes of more bodies are recorded without the channels that only arrows need.
const FEW_BODIES: usize = 200;
/// Further away than this \[m\], positions of 32 bits are coarser than a millimetre, and an origin is needed.
const FAR: f64 = 1e4;

impl Run {
    /// Builds the world of a variant.
    ///
    /// # Errors
    /// What the scene describes and the engine refuses, at its place in the file: a mesh that is not there or not closed, an
    /// inertia that no body has, an integrator that does not close pins.
    pub fn new(file: &SceneFile, variant: &Variant) -> Result<Self, SceneError> {
        Self::build(file, variant).map_err(|e| file.error(&e))
    }

    fn build(file: &SceneFile, variant: &Variant) -> Result<Self, Error> {
        let settings = &variant.settings;
        let setup = Setup::new(file, variant)?;
        let reference = settings.reference.as_ref().map(|name| reference(file, variant, name)).transpose()?;
        let series = series(file, variant, &setup)?;
        let header = header(file, variant, &setup, &series);
        let needs_path = ["tangent", "normal", "parallel"].iter().any(|name| header.channel(name).is_some())
            || series.iter().any(|(quantity, _)| {
                matches!(quantity, Quantity::Body(_, BodyQuantity::Curvature | BodyQuantity::Torsion))
            });
        let n_steps = (settings.time / settings.dt).round().max(1.0) as u64;
        let steps_per_frame = (settings.frame_interval / settings.dt).round().clamp(1.0, n_steps as f64) as u64;
        let mut run = Self {
            start: Amounts::of(&setup.world),
            paths: vec![PathFrame::default(); if needs_path { setup.bodies.len() } else { 0 }],
            dt: settings.dt,
            summary: Summary::default(),
            setup,
            reference,
            header,
            series,
            n_steps,
            steps_per_frame,
        };
        run.follow_paths();
        Ok(run)
    }

    /// The world as it is now.
    pub fn world(&self) -> &World {
        &self.setup.world
    }

    /// The world, to choose threads or lanes; bodies must be neither added nor removed.
    pub fn world_mut(&mut self) -> &mut World {
        &mut self.setup.world
    }

    /// What a recording of this run says of itself.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// How many steps the whole run takes: the whole number nearest to time/dt, at least one.
    pub fn n_steps(&self) -> u64 {
        self.n_steps
    }

    /// How many frames a recording has: one at the start, one each `frame_interval`, and one at the end.
    pub fn n_frames(&self) -> u64 {
        1 + self.n_steps.div_ceil(self.steps_per_frame)
    }

    /// About how many bytes a recording of the whole run takes.
    pub fn recording_bytes(&self) -> u64 {
        let frame = Layout::of(&self.header).map_or(u64::MAX, |layout| layout.frame as u64);
        frame.saturating_mul(self.n_frames())
    }

    /// Goes to the end without a recording.
    pub fn finish(&mut self) -> Summary {
        while self.setup.world.steps() < self.n_steps {
            self.step();
        }
        self.summary()
    }

    /// Goes to the end, or until `progress` breaks, and writes a recording. `progress` is called after each frame with the
    /// steps taken and the steps in all.
    ///
    /// # Errors
    /// If `out` does.
    pub fn record<W: Write + Seek>(
        &mut self,
        out: W,
        mut progress: impl FnMut(u64, u64) -> ControlFlow<()>,
    ) -> io::Result<W> {
        let mut writer = Writer::new(out, &self.header)?;
        let (mut numbers, mut values) = (Vec::new(), Vec::new());
        loop {
            let sight = self.sight();
            numbers.clear();
            numbers.extend(self.series.iter().map(|(quantity, place)| sight.number(quantity, *place)));
            sight.channels(&self.header, &mut values);
            let (time, steps) = (self.setup.world.time(), self.setup.world.steps());
            writer.frame(time, &numbers, &values)?;
            if progress(steps, self.n_steps).is_break() || steps >= self.n_steps {
                return writer.finish();
            }
            for _ in 0..self.steps_per_frame.min(self.n_steps - steps) {
                self.step();
            }
        }
    }

    /// What the run did so far.
    pub fn summary(&self) -> Summary {
        let world = &self.setup.world;
        let now = Amounts::of(world);
        let error = self.sight().number(&Quantity::Scene(SceneQuantity::AttitudeError), 0);
        Summary {
            steps: world.steps(),
            time: world.time(),
            bodies: world.model().n_dynamic(),
            energy_drift: now.energy_drift(&self.start),
            momentum_drift: now.momentum_drift(&self.start),
            angular_momentum_drift: now.angular_momentum_drift(&self.start),
            attitude_error: self.reference.as_ref().map(|_| error),
            hash: state_hash(world),
            ..self.summary.clone()
        }
    }

    fn sight(&self) -> Sight<'_> {
        Sight {
            world: &self.setup.world,
            reference: self.reference.as_ref().map(|reference| &reference.world),
            bodies: &self.setup.bodies,
            start: &self.start,
            paths: &self.paths,
        }
    }

    fn step(&mut self) {
        let report = self.setup.step(self.dt);
        for id in report.quarantined.iter().take(10 - self.summary.quarantined.len()) {
            let name = self.setup.world.body(*id).name().unwrap_or_default().to_owned();
            if !self.summary.quarantined.contains(&name) {
                self.summary.quarantined.push(name);
            }
        }
        self.summary.stalled |= report.stalled;
        if let Some(reference) = &mut self.reference {
            for _ in 0..REFERENCE_STEPS {
                reference.step(self.dt / f64::from(REFERENCE_STEPS));
            }
        }
        self.follow_paths();
    }

    fn follow_paths(&mut self) {
        let world = &self.setup.world;
        for (path, id) in self.paths.iter_mut().zip(&self.setup.bodies) {
            path.follow(world.time(), &world.body(*id));
        }
    }
}

/// The setup of the reference run.
fn reference(file: &SceneFile, variant: &Variant, integrator: &str) -> Result<Setup, Error> {
    let mut variant = variant.clone();
    integrator.parse::<Integrator>().map_err(|e| Error::new("reference", e.message()))?;
    integrator.clone_into(&mut variant.settings.integrator);
    variant.settings.slides.clear();
    Setup::new(file, &variant)
}

/// What is always recorded, and what the plots ask for.
fn series(file: &SceneFile, variant: &Variant, setup: &Setup) -> Result<Vec<(Quantity, usize)>, Error> {
    use SceneQuantity::{
        AngularMomentum, AngularMomentumDrift, AttitudeError, Energy, EnergyDrift, Momentum, MomentumDrift,
        Orthogonality, Potential, Rotation, Translation,
    };
    let always = [
        Energy,
        Translation,
        Rotation,
        Potential,
        EnergyDrift,
        Momentum,
        MomentumDrift,
        AngularMomentum,
        AngularMomentumDrift,
    ];
    let mut series: Vec<(Quantity, usize)> = always.into_iter().map(|of| (Quantity::Scene(of), 0)).collect();
    if variant.settings.reference.is_some() {
        series.push((Quantity::Scene(AttitudeError), 0));
    }
    if setup.world.integrator().keeps_matrix() {
        series.push((Quantity::Scene(Orthogonality), 0));
    }
    for (i, plot) in file.scene.plot.iter().enumerate() {
        for (k, name) in plot.series.iter().enumerate() {
            let wrong = |message: String| Error::new(format!("plot[{i}].series[{k}]"), message);
            let quantity = Quantity::parse(name).map_err(|(message, _)| wrong(message))?;
            let place = match &quantity {
                Quantity::Scene(_) => 0,
                Quantity::Body(body, _) => match setup.named(body) {
                    found if found.len() == 1 => found.start,
                    _ => return Err(wrong(format!("there is no one body {body:?}"))),
                },
            };
            if !series.iter().any(|(known, _)| *known == quantity) {
                series.push((quantity, place));
            }
        }
    }
    Ok(series)
}

fn header(file: &SceneFile, variant: &Variant, setup: &Setup, series: &[(Quantity, usize)]) -> Header {
    let (scene, settings, world) = (&file.scene, &variant.settings, &setup.world);
    let channels = channels(file, setup);
    let mut links = setup.links.clone();
    let origin = origin(world);
    for link in &mut links {
        for (body, point) in [(link.a, &mut link.point_a), (link.b, &mut link.point_b)] {
            if body.is_none() {
                *point = (Vec3::from(*point) - origin).to_array();
            }
        }
    }
    Header {
        title: scene.title.clone(),
        explanation: scene.explanation.clone(),
        look_for: scene.look_for.clone(),
        label: variant.label.clone(),
        integrator: world.integrator().to_string(),
        dt: settings.dt,
        frame_interval: settings.frame_interval,
        gravity: world.gravity().to_array(),
        planar: scene.planar,
        origin: origin.to_array(),
        bodies: setup.infos.clone(),
        channels,
        series: series.iter().map(|(quantity, _)| quantity.info()).collect(),
        plots: plots(file, series),
        links,
        show: scene.show.as_ref().map(|show| show.iter().map(|show| show.word().to_owned()).collect()),
        follow: scene.follow.as_ref().and_then(|name| setup.named(name).next()),
    }
}

/// Zero, unless the bodies are so far away that f32 would show it.
fn origin(world: &World) -> Vec3 {
    let far = world.bodies().map(|body| body.position().max_abs()).fold(0.0, f64::max);
    if far < FAR {
        return Vec3::ZERO;
    }
    let sum: Vec3 = world.bodies().map(|body| body.position()).sum();
    let mean = sum / world.len() as f64;
    if mean.is_finite() { mean } else { Vec3::ZERO }
}

/// What the scene asks for, what its pictures need, and in a small scene all that arrows are made of.
fn channels(file: &SceneFile, setup: &Setup) -> Vec<ChannelInfo> {
    let scene = &file.scene;
    let shows = |wanted: Show| scene.show.as_ref().is_some_and(|show| show.contains(&wanted));
    let small = setup.bodies.len() <= FEW_BODIES;
    let off_centre = setup.bodies.iter().any(|&id| setup.world.body(id).principal_frame().x != Vec3::ZERO);
    let needed = |channel: Channel| match channel {
        Channel::Center => small && off_centre,
        Channel::Velocity => small || shows(Show::Velocity),
        Channel::AngularVelocity => small || shows(Show::Omega) || shows(Show::Polhode) || shows(Show::Herpolhode),
        Channel::AngularMomentum => small || shows(Show::Momentum),
        Channel::Force => small || shows(Show::Force),
        Channel::Torque => small || shows(Show::Torque),
        Channel::Tangent => shows(Show::Frenet) || shows(Show::Parallel),
        Channel::Normal => shows(Show::Frenet),
        Channel::Parallel => shows(Show::Parallel),
        Channel::Matrix => small && setup.world.integrator().keeps_matrix(),
    };
    let chosen = Channel::ALL.iter().filter(|channel| scene.record.contains(channel) || needed(**channel));
    let names = ["position", "rotation"].into_iter().chain(chosen.map(|channel| channel.word()));
    names.filter_map(ChannelInfo::named).collect()
}

/// The plots of the scene, or those that suit any.
fn plots(file: &SceneFile, series: &[(Quantity, usize)]) -> Vec<PlotInfo> {
    let named = |plot: &crate::scene::Plot| PlotInfo {
        title: plot.title.clone(),
        unit: if plot.unit.is_empty() { common_unit(&plot.series) } else { plot.unit.clone() },
        series: plot.series.clone(),
        log: plot.log,
    };
    if !file.scene.plot.is_empty() {
        return file.scene.plot.iter().map(named).collect();
    }
    let plot = |title: &str, names: &[SceneQuantity], log: bool| {
        let series: Vec<String> = names.iter().map(|name| name.word().to_owned()).collect();
        PlotInfo { title: title.to_owned(), unit: common_unit(&series), series, log }
    };
    use SceneQuantity as S;
    let mut plots = vec![
        plot("Energy", &[S::Energy, S::Translation, S::Rotation, S::Potential], false),
        plot("Energy drift", &[S::EnergyDrift], false),
        plot("Momentum", &[S::Momentum], false),
        plot("Angular momentum", &[S::AngularMomentum], false),
    ];
    let recorded = |wanted: S| series.iter().any(|(quantity, _)| *quantity == Quantity::Scene(wanted));
    if recorded(S::AttitudeError) {
        plots.push(plot("Attitude error", &[S::AttitudeError], true));
    }
    if recorded(S::Orthogonality) {
        plots.push(plot("Distance from a rotation", &[S::Orthogonality], true));
    }
    plots
}

/// The unit of the series if they have one unit.
fn common_unit(names: &[String]) -> String {
    let mut units = names.iter().filter_map(|name| Quantity::parse(name).ok()).map(|quantity| quantity.info().unit);
    let first = units.next().unwrap_or_default();
    if units.all(|unit| unit == first) { first } else { String::new() }
}
