//! Tumbling cuboids that nothing touches: the cost of a body and step.

use crate::check::{Table, draw};
use crate::random::Random;
use crate::{Outcome, Progress, Refusal, Terminal};
use polhode::integrate::Integrator;
use polhode::integrate::lanes::Lanes;
use polhode::math::Vec3;
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::{Error, World};
use serde_json::json;
use std::time::Instant;

/// The size of the scene, and what steps it.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Number of bodies
    #[arg(long, default_value_t = 50_000, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    bodies: u32,
    /// Number of threads
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: u32,
    /// Only this integrator, such as pdmv6, which is the default of a world; otherwise a table of several
    #[arg(long, value_name = "NAME")]
    integrator: Option<Integrator>,
    /// Steps in a run; by default as many as make a million steps of a body
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    steps: Option<u32>,
    /// Report for a machine
    #[arg(long)]
    json: bool,
}

/// The integrators of the table.
const INTEGRATORS: [&str; 8] = ["pdmv6", "dmv", "pdmv4", "pdmv8", "pdmv10", "verlet", "splitting", "exact"];
/// Steps a second of simulated time.
const RATE: f64 = 60.0;
/// Runs of a case, of which the median and the best count.
const REPEATS: usize = 9;
/// Body-steps in a run: some 20 to 50 ms of work for the fast integrators.
const BODY_STEPS: u32 = 1_000_000;

/// One line of the table.
struct Figure {
    integrator: Integrator,
    gravity: f64,
    lanes: Lanes,
    /// Time a body and step \[ns\].
    median: f64,
    best: f64,
}

impl Arguments {
    pub(super) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        let integrators = match self.integrator {
            Some(one) => vec![one],
            None => INTEGRATORS.iter().map(|name| name.parse()).collect::<Result<Vec<Integrator>, Error>>()?,
        };
        let mut cases = Vec::new();
        for (i, &integrator) in integrators.iter().enumerate() {
            cases.push((integrator, 0.0, Lanes::Native));
            if i == 0 {
                cases.extend([
                    (integrator, 9.81, Lanes::Native),
                    (integrator, 0.0, Lanes::One),
                    (integrator, 9.81, Lanes::One),
                ]);
            }
        }
        let progress = Progress::new(cases.len() as u64);
        let mut figures = Vec::new();
        for (integrator, gravity, lanes) in cases {
            progress.say(integrator.to_string());
            figures.push(self.measure(integrator, gravity, lanes)?);
            progress.advance(1);
        }
        drop(progress);
        if self.json {
            self.write_json(terminal, &figures)?;
        } else {
            self.write_table(terminal, &figures)?;
        }
        Ok(Outcome::Done)
    }

    fn measure(&self, integrator: Integrator, gravity: f64, lanes: Lanes) -> Result<Figure, Error> {
        let mut world = self.world(gravity)?;
        world.set_integrator(integrator)?;
        world.set_lanes(lanes);
        let n_steps = self.steps.unwrap_or(BODY_STEPS.div_ceil(self.bodies));
        let mut run = || {
            let start = Instant::now();
            for _ in 0..n_steps {
                world.step(1.0 / RATE);
            }
            start.elapsed().as_secs_f64() * 1e9 / (f64::from(n_steps) * f64::from(self.bodies))
        };
        // The first run fills the caches and wakes the processor.
        run();
        let mut times: Vec<f64> = (0..REPEATS).map(|_| run()).collect();
        times.sort_by(f64::total_cmp);
        Ok(Figure { integrator, gravity, lanes, median: times[REPEATS / 2], best: times[0] })
    }

    /// Cuboids of all proportions, each turning at up to 7 rad/s about some axis.
    fn world(&self, gravity: f64) -> Result<World, Error> {
        let mut random = Random::new(1);
        let mut world = World::new();
        world.set_gravity([0.0, 0.0, -gravity])?;
        world.set_threads(self.threads as usize)?;
        for _ in 0..self.bodies {
            let size = random.vector(0.45) + Vec3::splat(0.55);
            let body = Body::dynamic().shape(Shape::cuboid(size).density(1000.0)).position(random.vector(100.0));
            world.add(body.velocity(random.vector(1.0)).angular_velocity(random.vector(4.0)))?;
        }
        Ok(world)
    }

    fn write_table(&self, terminal: &mut Terminal, figures: &[Figure]) -> std::io::Result<()> {
        let (s, lanes) = (if self.threads == 1 { "" } else { "s" }, Lanes::Native.count());
        writeln!(
            terminal.out,
            "{} free cuboids, {RATE} Hz, {} thread{s}, up to {lanes} lanes",
            self.bodies, self.threads
        )?;
        let row = |f: &Figure| {
            vec![
                f.integrator.to_string(),
                f.gravity.to_string(),
                f.lanes.count().to_string(),
                format!("{:.1}", f.median),
                format!("{:.1}", f.best),
            ]
        };
        let table = Table {
            columns: vec!["integrator", "gravity [m/s²]", "lanes", "median [ns]", "best [ns]"],
            rows: figures.iter().map(row).collect(),
            note: "Time a body and step, of nine runs. Only the pDMV family uses the lanes.",
        };
        draw(terminal.out, &table)
    }

    fn write_json(&self, terminal: &mut Terminal, figures: &[Figure]) -> std::io::Result<()> {
        let figure = |f: &Figure| {
            json!({
                "integrator": f.integrator.to_string(),
                "gravity": f.gravity,
                "lanes": f.lanes.count(),
                "median_ns": f.median,
                "best_ns": f.best,
            })
        };
        let report = json!({
            "scene": "free",
            "bodies": self.bodies,
            "threads": self.threads,
            "rate": RATE,
            "repeats": REPEATS,
            "figures": figures.iter().map(figure).collect::<Vec<_>>(),
        });
        writeln!(terminal.out, "{report:#}")
    }
}
